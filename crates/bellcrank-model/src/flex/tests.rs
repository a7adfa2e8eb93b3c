use std::path::{Path, PathBuf};

use super::recipe::{Recipe, changes};
use super::{Origin, Reduced, file};
use crate::design::{Design, Values};
use crate::load::load_text;
use crate::progress::Silent;
use crate::{Model, RunOptions};

const LEVER: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[parameters]
long = "130 mm"
thick = "8 mm"
limit = "40 mm"
hard = "70 GPa"
[ground.points]
O = [0, 0]
[bodies.lever]
solid = "lever"
flexible = { modes = 2, stiffening = true, mesh = { size = "12 mm" } }
points = { A = ["7 mm", "-4 mm"], B = ["long", "21 mm"], C = ["limit", 0] }
[bodies.load]
mass = "limit * 2 kg/m"
inertia = "1 kg*cm^2"
points = { B = [0, 0] }
[joints]
A = { kind = "revolute", connects = ["ground.O", "lever.A"], start = "20 deg" }
B = { kind = "revolute", connects = ["lever.B", "load.B"], start = 0 }
[materials.aluminium]
density = "2700 kg/m^3"
young = "hard"
poisson = 0.33
[solids.lever]
material = "aluminium"
thickness = "thick"
eyes = { A = { bore = "12 mm", outer = "26 mm" }, B = { bore = "9 mm", outer = "22 mm" } }
webs = { w = { between = ["A", "B"], width = "13 mm" } }
"#;

fn lever(settings: &[(&str, &str)]) -> Model {
    let settings: Vec<(String, String)> =
        settings.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
    load_text(Path::new("lever.toml"), LEVER, &settings).model.expect("a model")
}

fn values(design: &Design) -> Values {
    Values::new(&design.scopes, &design.scopes[0].parameters)
}

fn recipe(model: &Model) -> Recipe {
    let design = model.design();
    let form = design.bodies[1].flexible.as_ref().expect("it deforms");
    Recipe::new(design, &values(design), 1, form).expect("a recipe")
}

/// A folder of its own that goes away.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("bellcrank-{name}-{}", std::process::id()));
        drop(std::fs::remove_dir_all(&path));
        Folder(path)
    }

    fn files(&self) -> Vec<PathBuf> {
        std::fs::read_dir(&self.0).map_or(Vec::new(), |all| all.flatten().map(|entry| entry.path()).collect())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        drop(std::fs::remove_dir_all(&self.0));
    }
}

/// As a run with this cache: what is noted, and where the reduction comes from.
fn run(folder: &Folder) -> (Vec<String>, Origin, Reduced) {
    let model = lever(&[]);
    let design = model.design();
    design.reductions.set(&RunOptions { cache: Some(folder.0.clone()), threads: 1, ..RunOptions::default() });
    let form = design.bodies[1].flexible.as_ref().expect("it deforms");
    let found = design.reductions.get(design, &values(design), 1, form, &mut Silent).expect("a reduction");
    let again = design.reductions.get(design, &values(design), 1, form, &mut Silent).expect("a reduction");
    assert!(std::sync::Arc::ptr_eq(&found.reduced, &again.reduced), "made twice in one run");
    (found.notes, found.origin, Reduced::clone(&found.reduced))
}

fn same(a: &Reduced, b: &Reduced) -> bool {
    let all = |of: &'_ Reduced| (of.mesh.clone(), of.reduction.clone(), of.stress.clone(), of.shortenings.clone());
    all(a) == all(b) && a.left_out == b.left_out
}

#[test]
fn a_second_run_finds_what_the_first_made_and_damage_is_noticed() {
    let folder = Folder::new("cache");
    let (notes, origin, first) = run(&folder);
    assert!(notes.is_empty() && origin == Origin::Made, "{notes:?}");
    let (notes, origin, second) = run(&folder);
    assert!(notes.is_empty() && origin == Origin::Cache, "{notes:?}");
    assert!(same(&first, &second) && !first.shortenings.is_empty() && !first.stress.is_empty());
    let [path] = folder.files().try_into().expect("one file, and nothing beside it");
    let whole = std::fs::read(&path).expect("a file");
    for (at, word) in [(whole.len() / 2, "damaged"), (3, "no file of reductions"), (8, "damaged")] {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x10;
        std::fs::write(&path, bytes).expect("a file");
        let (notes, origin, third) = run(&folder);
        assert!(origin == Origin::Made && notes.len() == 1 && notes[0].contains(word), "{notes:?}");
        assert!(same(&first, &third));
        assert_eq!(std::fs::read(&path).expect("a file"), whole, "it was made again");
    }
    std::fs::write(&path, &whole[..whole.len() - 9]).expect("a file");
    assert!(run(&folder).0[0].contains("damaged"));
}

/// A file of another recipe under this name, or of another version, is not taken.
#[test]
fn a_file_must_be_what_its_name_says() {
    let folder = Folder::new("names");
    let (_, _, reduced) = run(&folder);
    let [own, other] = [lever(&[]), lever(&[("thick", "9 mm")])].map(|model| recipe(&model).key());
    let bytes = file::written(&reduced, other);
    assert!(file::read(&bytes, other).is_ok_and(|read| same(&read, &reduced)));
    assert_eq!(file::read(&bytes, own).err(), Some("is the reduction of another body"));
    for length in [0, 5, 31, 32, 40, 80, bytes.len() - 1] {
        assert!(file::read(&bytes[..length], other).is_err());
    }
}

#[test]
fn every_number_of_the_recipe_is_in_the_key() {
    let key = |settings: &[(&str, &str)]| recipe(&lever(settings)).key();
    assert_eq!(key(&[]), key(&[]));
    for other in [("thick", "8.000000000001 mm"), ("hard", "71 GPa"), ("long", "131 mm")] {
        assert_ne!(key(&[]), key(&[other]), "{other:?}");
    }
    assert_eq!(key(&[]), key(&[("limit", "50 mm")]), "a point that nothing takes hold of");
}

#[test]
fn parameters_that_change_a_reduction_are_known() {
    let model = lever(&[]);
    let design = model.design();
    let main = &design.scopes[0].parameters;
    let found = main.all().iter().enumerate().filter(|(index, _)| changes(design, main, *index));
    let names: Vec<&str> = found.map(|(_, parameter)| parameter.name.as_str()).collect();
    assert_eq!(names, ["long", "thick", "hard"]);
}

/// Bending across the plane and torsion are left out, so that two modes are two that the machine can feel.
#[test]
fn modes_across_the_plane_are_left_out() {
    let model = lever(&[]);
    let design = model.design();
    let form = design.bodies[1].flexible.as_ref().expect("it deforms");
    let reduced = design.reductions.get(design, &values(design), 1, form, &mut Silent).expect("a reduction").reduced;
    assert_eq!(reduced.modes(), 2);
    assert!(!reduced.left_out.is_empty(), "a flat lever bends across its plane first");
    assert!(reduced.left_out[0] < reduced.reduction.frequencies[0]);
}
