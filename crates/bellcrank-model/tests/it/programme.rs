//! Motions one after another, in studies and in what is asked of them.

use bellcrank_model::load;

use crate::support::{Scratch, model, model_of, rendered, run, value};

/// A carriage that goes out, an arm that is lifted then, and the carriage that comes back with it.
const CYCLE: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]

[parameters]
t_out = "2 s"
t_up = "1 s"
reach = "400 mm"

[ground.points]
O = [0, 0]

[bodies.car]
mass = "10 kg"
inertia = "0.1 kg*m^2"
points = { O = [0, 0] }

[bodies.arm]
mass = "2 kg"
center = ["0.5 m", 0]
inertia = "0.1 kg*m^2"
points = { O = [0, 0], P = ["1 m", 0] }

[joints]
rail = { kind = "prismatic", connects = ["ground.O", "car.O"], axis = "x", start = "100 mm" }
hinge = { kind = "revolute", connects = ["car.O", "arm.O"], start = "0 deg" }

[motions.back]
joint = "rail"
start = "after lift"
delay = "0.5 s"
segments = [{ by = "-reach", over = "t_out" }]

[motions.out]
joint = "rail"
segments = [{ by = "reach", over = "t_out" }]

[motions.lift]
joint = "hinge"
start = "after out"
segments = [{ to = "60 deg", over = "t_up", profile = "poly5" }]

[studies.cycle]
kind = "inverse-dynamics"
duration = "6 s"
step = "0.25 s"

[studies.slow]
like = "cycle"
set = { t_up = "1.5 s" }
"#;

#[test]
fn a_cycle_runs_in_its_order() {
    let model = model("cycle", CYCLE);
    let result = run(&model, "cycle");
    assert!(result.failure.is_none() && result.warnings.is_empty(), "{:?} {:?}", result.failure, result.warnings);
    let at = |name: &str, time: f64| value(&result, name, (time / 0.25).round() as usize);
    for (time, rail, hinge) in [(0.0, 0.1, 0.0), (1.0, 0.3, 0.0), (2.5, 0.5, 30.0), (3.25, 0.5, 60.0), (6.0, 0.1, 60.0)]
    {
        assert!((at("joint.rail.position", time) - rail).abs() < 1e-12, "rail at {time}");
        assert!((at("joint.hinge.position", time) - f64::to_radians(hinge)).abs() < 1e-12, "hinge at {time}");
    }
    // Two drives for two coordinates, though three motions move them.
    assert!(at("check.balance", 2.5) < 1e-9 && at("drive.rail.force", 1.25).abs() > 1.0);
    assert_eq!(result.table.columns.iter().filter(|c| c.name.starts_with("drive.rail")).count(), 2);
    let slow = run(&model, "slow");
    assert!((value(&slow, "joint.rail.position", 16) - 0.5).abs() < 1e-12, "still at rest at 4 s");
}

#[test]
fn a_programme_answers_questions_with_exact_derivatives() {
    let text = format!(
        "{CYCLE}\n[studies.influence]\nkind = \"sensitivity\"\nof = \"cycle\"\nresponse = \"at(joint.rail.position, 4.75 s)\"\n\
         parameters = [\"t_up\", \"reach\"]\npoints = 0\n"
    );
    let result = run(&model("cycle-ask", &text), "influence");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    // At the middle third of the way back: its rate there, and what is left of the way.
    let since: f64 = (4.75 - 3.5) / 2.0;
    let rate = 0.4 / 2.0 * (1.0 - (std::f64::consts::TAU * since).cos());
    let left = 1.0 - (since - (std::f64::consts::TAU * since).sin() / std::f64::consts::TAU);
    let found = format!("{:?}", result.findings);
    for expected in [rate, left] {
        assert!(found.contains(&format!("{expected:.9}")[..10]), "{expected}: {found}");
    }
}

#[test]
fn a_design_whose_motions_overlap_has_no_answer() {
    let text = CYCLE.replace("start = \"after lift\"", "start = \"3 s\"").replace("delay = \"0.5 s\"", "");
    let text = format!(
        "{text}\n[studies.designs]\nkind = \"sweep\"\nof = \"cycle\"\nresponses = {{ x = \"max(joint.rail.position)\" }}\n\
         vary = {{ t_out = [\"1 s\", \"2 s\", \"4 s\"] }}\n"
    );
    let text = text.replace("[studies.slow]\nlike = \"cycle\"\nset = { t_up = \"1.5 s\" }", "");
    let result = run(&model("cycle-overlap", &text), "designs");
    assert!(format!("{:?}", result.findings).contains("at once"), "{:?}", result.findings);
}

#[test]
fn a_motion_beyond_the_end_of_a_study_is_told() {
    let text = CYCLE.replace("duration = \"6 s\"", "duration = \"3 s\"");
    let warnings = run(&model("cycle-late", &text), "cycle").warnings;
    assert_eq!(warnings, ["motion `back` begins at 3.5 s: the study ends at 3 s, before it moves"]);
}

#[test]
fn motions_wait_across_subsystems_and_a_name_of_two_things_is_refused() {
    let scratch = Scratch::new("programme-parts");
    scratch.write("cycle.toml", CYCLE);
    let text = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0]
[bodies.hand]
points = { O = [0, 0] }
[subsystems.lift]
file = "cycle.toml"
[joints]
wrist = { kind = "revolute", connects = ["lift.arm.P", "hand.O"], start = "0 deg" }
[motions.grip]
joint = "wrist"
start = "after lift.lift"
segments = [{ to = "1 rad", over = "1 s" }]
[studies.all]
kind = "kinematics"
duration = "6 s"
step = "0.5 s"
"#;
    let result = run(&model_of(&scratch.write("whole.toml", text)), "all");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    assert!((value(&result, "joint.wrist.position", 7) - 0.5).abs() < 1e-12);
    let twice = format!(
        "{text}\n[motions.lift]\njoint = \"wrist\"\nstart = \"8 s\"\nsegments = [{{ to = \"0 rad\", over = \"1 s\", name = \"lift\" }}]\n"
    );
    let told = rendered(&load(&scratch.write("twice.toml", twice), &[]));
    assert!(
        told.contains("`lift.lift` is a motion of a subsystem, and also the segment `lift` of motion `lift`"),
        "{told}"
    );
    assert!(told.contains("cycle.toml:") && told.contains("this segment"), "{told}");
}

#[test]
fn the_programme_can_be_read() {
    let model = model("cycle-read", CYCLE);
    let moves: Vec<String> = run(&model, "cycle")
        .programme
        .expect("a programme")
        .moves
        .iter()
        .map(|one| format!("{} {} {:?} {} {:?}", one.motion, one.joint, one.segment, one.start, one.end))
        .collect();
    assert_eq!(moves, ["out rail None 0 Some(2.0)", "lift hinge None 2 Some(3.0)", "back rail None 3.5 Some(5.5)"]);
    let text = model.check().text();
    let listed = "\
programme of cycle
  0 s to 2 s      rail   100 mm -> 500 mm  out (cycloidal)
  2 s to 3 s      hinge  0 deg -> 60 deg   lift (poly5)
  3.5 s to 5.5 s  rail   500 mm -> 100 mm  back (cycloidal)
programme of slow
  0 s to 2 s    rail   100 mm -> 500 mm  out (cycloidal)
  2 s to 3.5 s  hinge  0 deg -> 60 deg   lift (poly5)
  4 s to 6 s    rail   500 mm -> 100 mm  back (cycloidal)
";
    assert!(text.contains(listed), "{text}");
}
