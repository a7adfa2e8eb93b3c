//! Planar files as parts of spatial machines: what they do alone they do in any plane.

use bellcrank_results::StudyResult;

use crate::support::{Scratch, model_of, rendered, run, value};
use bellcrank_model::{Model, load};

/// A planar machine with every kind of joint and force that the plane has: a crank and a rod to a slider, a cylinder
/// without bodies on a rod that nothing else keeps in the plane, a puck on springs.
const PLANAR: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[parameters]
crank = "50 mm"
[ground.points]
O = [0, 0]
C = { at = ["-120 mm", "40 mm"], rotate = { angle = "30 deg" } }
D = ["-200 mm", "200 mm"]
[bodies.crank]
mass = "1.2 kg"
center = ["crank/3", 0]
inertia = "8e-4 kg*m^2"
points = { O = [0, 0], A = ["crank", 0], P = ["10 mm", "30 mm"] }
[bodies.rod]
mass = "0.7 kg"
center = ["2*crank", 0]
inertia = ["1e-4 kg*m^2", "6e-3 kg*m^2", "6e-3 kg*m^2"]
points = { A = [0, 0], B = ["4*crank", 0] }
[bodies.piston]
mass = "0.9 kg"
inertia = 0
points = { B = [0, 0] }
[bodies.bar]
mass = "0.4 kg"
inertia = "1e-3 kg*m^2"
points = { U = ["-80 mm", 0], V = ["60 mm", 0], W = [0, "50 mm"] }
[joints]
O = { kind = "revolute", connects = ["ground.O", "crank.O"], start = "40 deg" }
A = { kind = "revolute", connects = ["crank.A", "rod.A"] }
B = { kind = "revolute", connects = ["rod.B", "piston.B"] }
slide = { kind = "prismatic", connects = ["ground.O", "piston.B"], axis = "x", start = "4*crank" }
line = { kind = "point-on-line", connects = ["ground.C", "bar.U"], axis = "x", start = "20 mm" }
cylinder = { kind = "distance", connects = ["ground.D", "bar.W"], start = "150 mm" }
tie = { kind = "distance", connects = ["crank.P", "bar.V"], length = "90 mm" }
[forces]
gas = { kind = "force", on = "piston.B", vector = ["-200 N*(1 + time/(1 s))", "3 N"] }
turned = { kind = "force", on = "rod.B", vector = ["5 N", "7 N"], axes = "body" }
twist = { kind = "torque", on = "bar", value = "0.4 N*m" }
coil = { kind = "spring", between = ["ground.D", "rod.B"], stiffness = "300 N/m", free_length = "100 mm", damping = "3 N*s/m" }
mount = { kind = "bushing", between = ["ground.C", "bar.V"], stiffness = ["90 N/m", "70 N/m", "2 N*m/rad"], damping = ["1 N*s/m", "2 N*s/m", "0.1 N*m*s/rad"] }
drag = { kind = "effort", joint = "slide", value = "-(4 N*s/m)*joint.slide.velocity + (2 N/m)*force.coil.length" }
[motions.turn]
joint = "O"
segments = [{ by = "200 deg", over = "1 s" }]
[motions.pull]
joint = "cylinder"
segments = [{ by = "10 mm", over = "1 s" }]
[studies.alone]
kind = "inverse-dynamics"
duration = "1 s"
step = "0.05 s"
"#;

/// On a table that is turned and tilted and stands still; y of the plane points up.
const WHOLE: &str = r#"
bellcrank = 1
space = "spatial"
gravity = [0, 0, "-9.81 m/s^2"]
[ground.points]
Z = { at = ["1 m", "-2 m", "0.3 m"], rotate = { axis = "z", angle = "33 deg" } }
[bodies.table]
mass = "5 kg"
inertia = ["0.1 kg*m^2", "0.1 kg*m^2", "0.1 kg*m^2"]
points = { O = [0, 0, 0], M = { at = ["0.2 m", "0.1 m", "0.4 m"], rotate = { axis = "x", angle = "90 deg" } } }
[joints]
yaw = { kind = "revolute", connects = ["ground.Z", "table.O"], start = "20 deg" }
[subsystems.part]
file = "planar.toml"
ground = "table.M"
[studies.whole]
kind = "inverse-dynamics"
duration = "1 s"
step = "0.05 s"
hold = ["yaw"]
"#;

fn both(scratch: &str) -> (Model, Model) {
    let scratch = Scratch::new(scratch);
    let planar = scratch.write("planar.toml", PLANAR);
    (model_of(&planar), model_of(&scratch.write("whole.toml", WHOLE)))
}

/// Asserts that a signal of the machine alone is that of the part.
fn same(alone: &StudyResult, whole: &StudyResult, signal: &str) {
    let (family, rest) = signal.split_once('.').expect("a signal of something");
    for row in 0..alone.table.rows() {
        let (a, b) = (value(alone, signal, row), value(whole, &format!("{family}.part.{rest}"), row));
        assert!((a - b).abs() <= 1e-8 * a.abs().max(1.0), "{signal}, row {row}: {a} alone, {b} in the machine");
    }
}

#[test]
fn a_planar_file_in_space_does_what_it_does_alone() {
    let (alone, whole) = both("planar-in-space");
    let (alone, whole) = (run(&alone, "alone"), run(&whole, "whole"));
    assert!(alone.failure.is_none() && whole.failure.is_none(), "{:?} {:?}", alone.failure, whole.failure);
    assert_eq!([alone.table.rows(), whole.table.rows()], [21; 2]);
    for joint in ["O", "A", "B", "slide", "line", "cylinder"] {
        for kind in ["position", "velocity", "acceleration"] {
            same(&alone, &whole, &format!("joint.{joint}.{kind}"));
        }
    }
    for signal in ["drive.O.force", "drive.cylinder.force", "drive.O.power", "force.coil.length", "force.coil.effort"] {
        same(&alone, &whole, signal);
    }
    assert!(value(&alone, "drive.O.force", 3).abs() > 0.1 && value(&alone, "drive.cylinder.force", 3).abs() > 0.1);
    // The table turns nothing: what the plane does has no moment about its vertical but that of forces out of it.
    let row = 4;
    let up = value(&whole, "joint.yaw.reaction.fz", row);
    assert!((up - 9.81 * 8.2).abs() > 1.0, "gas and inertia are in it: {up}");
    assert!(value(&whole, "check.balance", row) < 1e-8 && value(&whole, "check.closure", row) < 1e-9);
}

#[test]
fn what_keeps_a_body_in_its_plane_and_what_is_assumed_is_told() {
    let (_, whole) = both("planar-in-space-notes");
    let check = whole.check();
    assert!(check.joints.iter().any(|joint| joint.name == "part.bar.plane" && joint.kind == "planar"));
    assert_eq!(check.joints.iter().filter(|joint| joint.name.ends_with(".plane")).count(), 1);
    let note = check.notes.iter().find(|note| note.contains("round disc")).expect("a note");
    assert!(note.ends_with("otherwise: part.crank, part.bar"), "{note}");
}

#[test]
fn the_lift_keeps_its_forces_on_a_carriage_that_turns_and_travels() {
    let scratch = Scratch::new("lift-in-space");
    let lift = std::fs::read_to_string(crate::support::lift()).expect("the lift");
    let alone = model_of(&scratch.write("lift.toml", lift.replace("points = 601", "points = 61")));
    let text = r#"
bellcrank = 1
space = "spatial"
gravity = [0, 0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0, 0]
[bodies.car]
mass = "30 kg"
inertia = ["1 kg*m^2", "1 kg*m^2", "1 kg*m^2"]
points = { O = [0, 0, 0] }
[bodies.column]
mass = "20 kg"
inertia = ["1 kg*m^2", "1 kg*m^2", "1 kg*m^2"]
points = { O = [0, 0, 0], mount = { at = [0, 0, "1 m"], rotate = { axis = "x", angle = "90 deg" } } }
[joints]
rail = { kind = "prismatic", connects = ["ground.O", "car.O"], axis = "x", start = "0 m" }
yaw = { kind = "revolute", connects = ["car.O", "column.O"], start = "50 deg" }
[subsystems.lift]
file = "lift.toml"
ground = "column.mount"
[studies.lift]
kind = "inverse-dynamics"
sweep = { joint = "lift.B", from = "-30 deg", to = "30 deg", points = 61 }
drive = { joint = "lift.slide", velocity = "20 mm/s" }
hold = ["rail", "yaw"]
"#;
    let whole = model_of(&scratch.write("whole.toml", text));
    let (alone, whole) = (run(&alone, "lift"), run(&whole, "lift"));
    assert!(whole.failure.is_none(), "{:?}", whole.failure);
    for row in 0..61 {
        let (a, b) = (value(&alone, "drive.slide.force", row), value(&whole, "drive.lift.slide.force", row));
        assert!((a - b).abs() < 1e-7 * a.abs(), "row {row}: {a} alone, {b} on the carriage");
    }
}

#[test]
fn a_planar_file_does_not_know_the_axes_of_the_world() {
    let scratch = Scratch::new("planar-signals");
    let planar = PLANAR.replace(
        "[motions.turn]",
        "up = { kind = \"effort\", joint = \"O\", value = \"(1 N)*point.rod.B.y\" }\n[motions.turn]",
    );
    let loaded = load(&scratch.write("planar.toml", planar), &[]);
    assert!(loaded.model.is_some(), "{}", rendered(&loaded));
    let told = rendered(&load(&scratch.write("whole.toml", WHOLE), &[]));
    assert!(told.contains("`point.rod.B.y` is along world axes") && told.contains("planar.toml:"), "{told}");
}
