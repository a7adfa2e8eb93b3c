//! From a recipe to a reduction: mesh, take hold, reduce, leave out what the machine cannot feel.

use bellcrank_fem::reduce;
use bellcrank_fem::{CouplingKind, Interface, Keep, Part, Reduction, Region, Settings};
use bellcrank_mesh::Mesh;

use super::recipe::Recipe;
use super::{Reduced, plane};
use crate::design::Design;
use crate::elastic::{End, Words, allowed, ended, most_nodes, near, watched};
use crate::measure::Measure;
use crate::progress::Progress;
use crate::run::shown;

/// Rounds of asking for more modes, as many of them leave the plane.
const ROUNDS: usize = 4;
/// A surface further from an interface than this share of the size of the part is not meant.
const FAR: f64 = 0.5;

/// Makes a reduction; progress counts from 0 to 1.
pub(super) fn reduced(
    recipe: &Recipe,
    name: &str,
    design: &Design,
    threads: usize,
    progress: &mut dyn Progress,
) -> Result<Reduced, End> {
    progress.at(0.0, &format!("{name}: meshing"));
    let mesh = recipe.solid.mesh(None, most_nodes())?;
    let mut notes = Vec::new();
    let interfaces = interfaces(recipe, name, design, &mesh, &mut notes)?;
    let part = Part {
        mesh: &mesh,
        materials: vec![recipe.material.clone(); mesh.blocks.len()],
        supports: Vec::new(),
        couplings: Vec::new(),
    };
    let words = Words::of_interfaces(design, name, recipe.interfaces.iter().map(|(name, _)| name.as_str()));
    let message = format!("{name}: reducing, {} nodes", mesh.nodes.len());
    let mut round = |keep: &Keep, share: [f64; 2]| {
        let made = watched(progress, share, &message, |tell| {
            let settings = Settings { threads, memory: allowed(), progress: tell };
            Reduction::craig_bampton(&part, &interfaces, keep, &settings)
        });
        made.map_err(|faults| words.refused(&mesh, &faults))
    };
    let (reduction, modes, left_out) = chosen(recipe, &mut round)?;
    let reduction = plane::with_modes(reduction, &modes);
    progress.at(1.0, &format!("{name}: stress of {} shapes", reduction.coordinates()));
    let stress = reduce::stress(&part, &reduction, threads);
    let of = |reference| reduce::shortenings(&part, &reduction, reference, threads);
    let shortenings = recipe.stiffening.map(of).unwrap_or_default();
    Ok(Reduced { shortenings, left_out, notes, ..Reduced::new(mesh, reduction, stress) })
}

type Round<'r> = dyn FnMut(&Keep, [f64; 2]) -> Result<Reduction, End> + 'r;

/// A reduction with enough modes, the places of those that are wanted, and the frequencies of those that are not felt.
fn chosen(recipe: &Recipe, round: &mut Round<'_>) -> Result<(Reduction, Vec<usize>, Vec<f64>), End> {
    let wanted = recipe.keep.count.unwrap_or(0);
    if !recipe.planar || wanted == 0 {
        let reduction = round(&recipe.keep, [0.0, 1.0])?;
        let all = (0..reduction.modes).collect();
        return Ok((reduction, all, Vec::new()));
    }
    // A plate has three modes across its plane for each one in it, and another round costs as much as the first.
    let mut asked = (4 * wanted).min(2 * wanted + 32);
    for at in 0.. {
        let share = [at, at + 1].map(|done| f64::from(done) / ROUNDS as f64);
        let reduction = round(&Keep { count: Some(asked), ..recipe.keep }, share)?;
        let felt = plane::felt(&reduction.inertia, reduction.points.len(), true);
        let modes: Vec<usize> = (0..reduction.modes).filter(|&mode| felt[mode]).take(wanted).collect();
        let all_there = modes.len() == wanted || reduction.modes < asked;
        if all_there || at as usize + 1 >= ROUNDS {
            let last = modes.last().copied().unwrap_or(0);
            let left_out = (0..last).filter(|&mode| !felt[mode]).map(|mode| reduction.frequencies[mode]).collect();
            return Ok((reduction, modes, left_out));
        }
        asked *= 2;
    }
    unreachable!("the last round ends it")
}

/// What each interface takes hold of: the bore round its point, or the faces nearest to it.
fn interfaces(
    recipe: &Recipe,
    name: &str,
    design: &Design,
    mesh: &Mesh,
    notes: &mut Vec<String>,
) -> Result<Vec<Interface>, End> {
    let mut found = Vec::with_capacity(recipe.interfaces.len());
    for (point, at) in &recipe.interfaces {
        if let Some((faces, _)) = recipe.solid.bore_at(mesh, *at) {
            found.push(Interface { region: Region::Faces(faces), point: *at, kind: recipe.kind });
            continue;
        }
        let faces = near(mesh, *at);
        let nodes = mesh.nodes_of_faces(&faces);
        let away = nodes.iter().map(|&node| distance(mesh.nodes[node as usize], *at)).fold(f64::INFINITY, f64::min);
        if away.is_nan() || away > FAR * size(mesh) {
            let unit = design.units.of(Measure::Length);
            let message =
                format!("interface `{point}` of body `{name}` is {} from the surface of its solid", shown(away, &unit));
            return Err(ended(message, "an eye there, or a point that is on the solid"));
        }
        notes.push(format!(
            "body `{name}` has no bore at point `{point}`: the interface takes hold of the faces nearest to it"
        ));
        let kind = CouplingKind::Distributing;
        found.push(Interface { region: Region::Faces(faces), point: *at, kind });
    }
    Ok(found)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

/// Longest side of the box round it.
fn size(mesh: &Mesh) -> f64 {
    let side = |axis: usize| {
        let along = mesh.nodes.iter().map(|node| node[axis]);
        let [low, high] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
        high - low
    };
    (0..3).map(side).fold(0.0, f64::max)
}
