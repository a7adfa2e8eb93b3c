//! Bodies that have their mass from a solid.

use bellcrank_model::{Check, Model, SolidFact};

use crate::support::{Scratch, model, model_of, run, value};

/// A crank of a plate with a hole and a boss on it, turned by hand.
fn crank(properties: &str) -> String {
    format!(
        r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[parameters]
long = "300 mm"
[ground.points]
O = [0, 0]
[materials.steel]
density = "7850 kg/m^3"
[solids.plate]
material = "steel"
[solids.plate.plates.all]
thickness = "12 mm"
outline = [["-25 mm", "-20 mm"], ["long", "-20 mm"], ["long", "20 mm"], ["-25 mm", "20 mm"]]
[solids.plate.cuts.bore]
kind = "hole"
at = "O"
diameter = "18 mm"
[solids.bush]
material = "steel"
revolved = {{ profile = [["9 mm", "-20 mm"], ["14 mm", "-20 mm"], ["14 mm", "20 mm"], ["9 mm", "20 mm"]] }}
[bodies.bush]
solid = "bush"
points = {{ O = [0, 0] }}
[bodies.crank]
{properties}
points = {{ O = [0, 0] }}
[joints]
O = {{ kind = "revolute", connects = ["ground.O", "crank.O"] }}
W = {{ kind = "weld", connects = ["crank.O", "bush.O"] }}
[studies.turn]
kind = "inverse-dynamics"
sweep = {{ joint = "O", from = "-20 deg", to = "70 deg", points = 7 }}
drive = {{ joint = "O", velocity = "7 rad/s", acceleration = "11 rad/s^2" }}
[studies.by]
kind = "sensitivity"
of = "turn"
response = "first(drive.O.force)"
parameters = ["long"]
"#
    )
}

fn solid(check: &Check, body: &str) -> SolidFact {
    let found = check.bodies.iter().find(|one| one.name == body).expect("a body");
    found.solid.clone().expect("a solid")
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

#[test]
fn a_plate_with_a_hole_weighs_what_formulas_say() {
    let found = solid(&model("solid-plate", &crank("solid = \"plate\"")).check(), "crank");
    let (rho, t, a, b, r) = (7850.0, 0.012, 0.325, 0.04, 0.009_f64);
    let (plate, hole) = (rho * t * a * b, rho * t * std::f64::consts::PI * r * r);
    let mass = plate - hole;
    let center = plate * 0.1375 / mass;
    let about_z = plate * (a * a + b * b) / 12.0 + plate * (0.1375 - center).powi(2)
        - hole * r * r / 2.0
        - hole * center * center;
    let about_x = plate * (b * b + t * t) / 12.0 - hole * (r * r / 4.0 + t * t / 12.0);
    assert!(close(found.mass, mass), "{} {mass}", found.mass);
    assert!(close(found.volume * rho, mass));
    assert!(close(found.center[0], center) && found.center[1].abs() < 1e-15 && found.center[2].abs() < 1e-15);
    assert!(close(found.inertia[2][2], about_z), "{} {about_z}", found.inertia[2][2]);
    assert!(close(found.inertia[0][0], about_x), "{} {about_x}", found.inertia[0][0]);
    assert_eq!((found.solid.as_str(), found.material.as_str()), ("plate", "steel"));
}

#[test]
fn a_turned_bush_weighs_what_formulas_say() {
    let found = solid(&model("solid-bush", &crank("solid = \"plate\"")).check(), "bush");
    let (outer, inner) = (0.014_f64, 0.009_f64);
    let mass = 7850.0 * std::f64::consts::PI * (outer * outer - inner * inner) * 0.04;
    assert!(close(found.mass, mass), "{} {mass}", found.mass);
    assert!(close(found.inertia[2][2], mass * (outer * outer + inner * inner) / 2.0));
}

/// The same motion and forces with the numbers of the solid typed in.
#[test]
fn a_body_with_a_solid_is_the_body_with_its_numbers() {
    let with = model("solid-with", &crank("solid = \"plate\""));
    let of = solid(&with.check(), "crank");
    let typed = format!(
        "mass = \"{:.17e} kg\"\ncenter = [\"{:.17e} m\", 0]\ninertia = \"{:.17e} kg*m^2\"",
        of.mass, of.center[0], of.inertia[2][2]
    );
    let without = model("solid-without", &crank(&typed));
    let (a, b) = (run(&with, "turn"), run(&without, "turn"));
    for signal in ["drive.O.force", "joint.O.reaction.fx", "joint.O.reaction.fy"] {
        for row in 0..7 {
            assert!(close(value(&a, signal, row), value(&b, signal, row)), "{signal} {row}");
        }
    }
}

/// Exact derivatives by a length of the geometry against differences of whole runs.
#[test]
fn masses_carry_derivatives() {
    let text = crank("solid = \"plate\"");
    let exact = match run(&model("solid-by", &text), "by").findings {
        Some(bellcrank_results::Findings::Sensitivity(found)) => found.parameters[0].clone(),
        other => panic!("{other:?}"),
    };
    let at = |long: &str| {
        let model = model("solid-at", &text.replace("long = \"300 mm\"", &format!("long = \"{long}\"")));
        value(&run(&model, "turn"), "drive.O.force", 0)
    };
    let difference = (at("300.03 mm") - at("299.97 mm")) / 6e-5;
    assert!((exact.derivative - difference).abs() < 1e-6 * difference.abs(), "{} {difference}", exact.derivative);
}

fn spatial(plane: &str, points: &str) -> String {
    format!(
        r#"
bellcrank = 1
space = "spatial"
gravity = [0, 0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0, 0]
[materials.steel]
density = "7850 kg/m^3"
[solids.arm]
material = "steel"
thickness = "10 mm"
plane = "{plane}"
[solids.arm.eyes]
A = {{ bore = "20 mm", outer = "50 mm" }}
B = {{ bore = "10 mm", outer = "30 mm", offset = "3 mm" }}
[solids.arm.webs]
w = {{ between = ["A", "B"], width = ["30 mm", "20 mm"] }}
[bodies.arm]
solid = "arm"
points = {points}
[joints]
j = {{ kind = "spherical", connects = ["ground.O", "arm.A"] }}
"#
    )
}

#[test]
fn a_link_lies_in_the_plane_that_is_asked_for() {
    let flat =
        solid(&model("solid-xy", &spatial("xy", "{ A = [0, 0, 0], B = [\"200 mm\", \"30 mm\", 0] }")).check(), "arm");
    for (plane, points, axes) in [
        ("yz", "{ A = [0, 0, 0], B = [0, \"200 mm\", \"30 mm\"] }", [1, 2, 0]),
        ("zx", "{ A = [0, 0, 0], B = [\"30 mm\", 0, \"200 mm\"] }", [2, 0, 1]),
    ] {
        let turned = solid(&model("solid-plane", &spatial(plane, points)).check(), "arm");
        for (i, &axis) in axes.iter().enumerate() {
            assert!((turned.center[axis] - flat.center[i]).abs() < 1e-15, "{plane}");
            for (j, &other) in axes.iter().enumerate() {
                assert!((turned.inertia[axis][other] - flat.inertia[i][j]).abs() < 1e-15, "{plane}");
            }
        }
    }
}

/// Solids and materials of a subsystem have its prefix, and its parameters as set by the file around it.
#[test]
fn subsystems_have_solids() {
    let scratch = Scratch::new("solid-parts");
    scratch.write("part.toml", crank("solid = \"plate\"").replace("[studies.by]", "[studies.other]"));
    let whole = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[ground.points]
P = ["1 m", 0]
[subsystems.one]
file = "part.toml"
set = { long = "400 mm" }
[bodies.twin]
solid = "one.plate"
points = { O = [0, 0] }
[joints]
P = { kind = "revolute", connects = ["ground.P", "twin.O"] }
"#;
    let check = model_of(&scratch.write("whole.toml", whole)).check();
    let (inner, twin) = (solid(&check, "one.crank"), solid(&check, "twin"));
    assert_eq!((inner.solid.as_str(), inner.material.as_str()), ("one.plate", "one.steel"));
    assert_eq!((twin.mass, twin.center), (inner.mass, inner.center));
    let alone = solid(&model("solid-alone", &crank("solid = \"plate\"")).check(), "crank");
    assert!(close(inner.mass - alone.mass, 7850.0 * 0.012 * 0.04 * 0.1), "{} {}", inner.mass, alone.mass);
}

/// One solid on the points of two bodies.
#[test]
fn a_solid_is_laid_on_the_points_of_each_body() {
    let text = spatial("xy", "{ A = [0, 0, 0], B = [\"200 mm\", 0, 0] }")
        + r#"
[bodies.long]
solid = "arm"
points = { A = [0, 0, 0], B = ["300 mm", 0, 0] }
"#;
    let text = text.replace("[bodies.long]", "\n[bodies.long]");
    let loaded: Model = model("solid-two", &text);
    let check = loaded.check();
    assert!(solid(&check, "long").mass > 1.2 * solid(&check, "arm").mass);
}

/// What an optimizer changes in the geometry is in the masses it weighs.
#[test]
fn an_optimizer_sees_masses_change() {
    let text = crank("solid = \"plate\"")
        + r#"
[studies.best]
kind = "optimize"
of = "turn"
minimize = "max(drive.O.force)"
variables = { long = { min = "200 mm", max = "350 mm" } }
"#;
    let result = run(&model("solid-best", &text), "best");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    match result.findings {
        Some(bellcrank_results::Findings::Optimization(found)) => {
            assert!((found.variables[0].value - 0.2).abs() < 1e-6, "{found:?}");
        }
        other => panic!("{other:?}"),
    }
}

/// A brick of 20 x 30 x 50 mm, as CalculiX reads it.
const BRICK: &str = "*NODE
1, 0, 0, 0
2, 20, 0, 0
3, 20, 30, 0
4, 0, 30, 0
5, 0, 0, 50
6, 20, 0, 50
7, 20, 30, 50
8, 0, 30, 50
*ELEMENT, TYPE=C3D8, ELSET=ALL
1, 1, 2, 3, 4, 5, 6, 7, 8
";

fn of_file(keys: &str) -> String {
    format!(
        r#"
bellcrank = 1
space = "spatial"
gravity = [0, 0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0, 0]
[materials.steel]
density = "7850 kg/m^3"
[solids.brick]
material = "steel"
{keys}
[bodies.brick]
solid = "brick"
points = {{ O = [0, 0, 0] }}
[joints]
j = {{ kind = "spherical", connects = ["ground.O", "brick.O"] }}
"#
    )
}

#[test]
fn a_mesh_weighs_what_its_elements_do() {
    let scratch = Scratch::new("solid-mesh");
    scratch.write("brick.inp", BRICK);
    let model = model_of(&scratch.write("model.toml", of_file("file = \"brick.inp\"\nunit = \"mm\"")));
    let found = solid(&model.check(), "brick");
    let mass = 7850.0 * 0.02 * 0.03 * 0.05;
    assert!(close(found.mass, mass), "{}", found.mass);
    assert!(close(found.center[2], 0.025) && close(found.inertia[0][0], mass * (9e-4 + 25e-4) / 12.0), "{found:?}");
    let drawn = model.drawing().bodies[1].surface.clone().expect("a surface");
    assert_eq!((drawn.points.len(), drawn.triangles.len()), (8, 12));
}

#[test]
fn a_mesh_cut_in_half_is_told_with_its_place() {
    let scratch = Scratch::new("solid-half");
    scratch.write("brick.inp", &BRICK[..BRICK.len() - 14]);
    let loaded =
        bellcrank_model::load(&scratch.write("model.toml", of_file("file = \"brick.inp\"\nunit = \"mm\"")), &[]);
    let told = crate::support::rendered(&loaded);
    assert!(loaded.model.is_none() && told.contains("brick.inp`:") && told.contains("model.toml:11:8"), "{told}");
}

/// An inverted element and an absent file, too.
#[test]
fn meshes_that_are_not_sound_are_refused() {
    let scratch = Scratch::new("solid-inverted");
    scratch.write("brick.inp", BRICK.replace("1, 1, 2, 3, 4, 5, 6, 7, 8", "1, 5, 6, 7, 8, 1, 2, 3, 4"));
    for (file, wanted) in [("brick.inp", "inverted"), ("none.msh", "cannot read"), ("none.step", "no mesh of")] {
        let unit = if file.ends_with("step") { "" } else { "unit = \"mm\"" };
        let keys = format!("file = \"{file}\"\n{unit}");
        let loaded = bellcrank_model::load(&scratch.write("model.toml", of_file(&keys)), &[]);
        let told = crate::support::rendered(&loaded);
        assert!(loaded.model.is_none() && told.contains(wanted), "{told}");
    }
}

/// A part of another program comes back with the mass that it was written with; only where Gmsh is there.
#[test]
fn a_step_file_weighs_what_its_solid_does() {
    if std::process::Command::new("gmsh").arg("--version").output().is_err() {
        return;
    }
    let scratch = Scratch::new("solid-step");
    let own = model("solid-own", &spatial("xy", "{ A = [0, 0, 0], B = [\"200 mm\", 0, 0] }"));
    let files = own.part_files(bellcrank_model::PartFormat { step: true, stl: false });
    scratch.write("brick.step", &files[0].bytes);
    let read = solid(&model_of(&scratch.write("model.toml", of_file("file = \"brick.step\""))).check(), "brick");
    let of = solid(&own.check(), "arm");
    assert!((read.mass - of.mass).abs() < 1e-4 * of.mass, "{} {}", read.mass, of.mass);
    assert!((read.inertia[2][2] - of.inertia[2][2]).abs() < 1e-4 * of.inertia[2][2]);
}
