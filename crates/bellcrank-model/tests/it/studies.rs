//! Studies: what they do when all is well, and what they say when not.

use bellcrank_model::{Progress, RunError, RunOptions, Silent};

use crate::support::{Scratch, model, model_of, run, value};

const PENDULUM: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]

[ground.points]
O = [0, 0]

[bodies.arm]
mass = "2 kg"
center = ["0.5 m", 0]
inertia = "0.1 kg*m^2"
points = { O = [0, 0], P = ["1 m", 0] }

[bodies.hand]
mass = "1 kg"
inertia = "0.01 kg*m^2"
points = { O = [0, 0] }

[joints]
hinge = { kind = "revolute", connects = ["ground.O", "arm.O"], start = "10 deg" }
wrist = { kind = "revolute", connects = ["arm.P", "hand.O"], start = "0 deg" }
"#;

fn pendulum(name: &str, studies: &str) -> bellcrank_model::Model {
    model(name, &format!("{PENDULUM}{studies}"))
}

#[test]
fn an_under_driven_study_says_what_can_still_move() {
    let sweep = "sweep = { joint = \"hinge\", from = \"0 deg\", to = \"90 deg\", points = 4 }";
    let model = pendulum(
        "under",
        &format!("[studies.a]\nkind = \"inverse-dynamics\"\n{sweep}\n[studies.b]\nlike = \"a\"\nhold = [\"wrist\"]\n"),
    );
    let failure = run(&model, "a").failure.expect("a failure");
    assert!(failure.message.contains("2 degrees of freedom, 1 driven: `wrist` can still move"), "{}", failure.message);
    assert!(failure.hints[0].contains("hold"));
    let held = run(&model, "b");
    assert!(held.failure.is_none());
    assert!((value(&held, "drive.wrist.force", 0)).abs() < 1e-12);
    assert!((value(&held, "drive.hinge.force", 0) - 3.0 * 9.81 * 2.0 / 3.0).abs() < 1e-9);
}

#[test]
fn an_over_driven_study_says_which_drives_fight() {
    let text = std::fs::read_to_string(crate::support::lift()).expect("the lift");
    let text = format!("{text}\n[studies.both]\nlike = \"lift\"\nhold = {{ A = \"0 deg\" }}\n");
    let failure = run(&model("over", &text), "both").failure.expect("a failure");
    assert!(failure.message.contains("1 degree of freedom, 2 driven"), "{}", failure.message);
}

#[test]
fn a_sweep_that_cannot_reach_its_end_keeps_its_rows() {
    let text = std::fs::read_to_string(crate::support::lift()).expect("the lift");
    let text = format!(
        "{text}\n[studies.far]\nlike = \"lift\"\nsweep = {{ joint = \"slide\", from = \"732 mm\", to = \"1200 mm\", points = 40 }}\n"
    );
    let result = run(&model("far", &text), "far");
    let failure = result.failure.expect("a failure");
    assert!(failure.message.contains("`slide` cannot go on"), "{}", failure.message);
    assert!(result.table.rows() > 5 && result.table.rows() < 40);
}

#[test]
fn a_mechanism_that_cannot_be_assembled_says_which_joints_stay_open() {
    let text = std::fs::read_to_string(crate::support::lift()).expect("the lift");
    let text = text.replace("E = [0, 0], H = [0, \"l62\"]", "E = [0, 0], H = [0, \"9 m\"]");
    let model = model("open", &text);
    let check = model.check();
    assert!(check.degrees.is_none());
    assert!(check.failure.expect("a failure").message.contains("cannot be assembled"));
    let failure = run(&model, "lift").failure.expect("a failure");
    assert!(failure.message.contains("study `lift`") && failure.message.contains("open joints"), "{}", failure.message);
}

#[test]
fn motions_prescribe_time_and_carry_efforts() {
    let model = pendulum(
        "time",
        r#"
[motions.up]
joint = "hinge"
segments = [{ to = "90 deg", over = "1 s" }, { hold = "0.5 s" }]
[studies.a]
kind = "inverse-dynamics"
duration = "1.5 s"
step = "0.1 s"
hold = ["wrist"]
"#,
    );
    let result = run(&model, "a");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    assert_eq!(result.table.rows(), 16);
    assert_eq!(result.axis, ["time"]);
    assert!((value(&result, "joint.hinge.position", 0) - 10f64.to_radians()).abs() < 1e-12);
    assert_eq!(value(&result, "joint.hinge.position", 15), 90f64.to_radians());
    assert!((value(&result, "time", 15) - 1.5).abs() < 1e-15);
    assert!(value(&result, "check.balance", 5) < 1e-9);
}

#[test]
fn tables_are_read_beside_the_model() {
    let scratch = Scratch::new("table");
    scratch.write("lift.csv", "time [ms],angle [deg]\n0,0\n500,20\n1000,45\n1500,60\n");
    let text = format!(
        "{PENDULUM}[motions.m]\njoint = \"hinge\"\ntable = \"lift.csv\"\n\
         [studies.a]\nkind = \"kinematics\"\nduration = \"1.5 s\"\nstep = \"0.5 s\"\nhold = [\"wrist\"]\n"
    );
    let result = run(&model_of(&scratch.write("model.toml", text)), "a");
    assert!((value(&result, "joint.hinge.position", 2) - 45f64.to_radians()).abs() < 1e-12);
    assert!(result.table.column("drive.hinge.force").is_none(), "kinematics has no forces");
    assert!(value(&result, "check.closure", 2) < 1e-12);
}

#[test]
fn statics_finds_the_hanging_position() {
    let model = pendulum("rest", "[studies.a]\nkind = \"statics\"\nhold = [\"wrist\"]\n");
    let result = run(&model, "a");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    assert!((value(&result, "point.arm.P.y", 0) + 1.0).abs() < 1e-9);
    assert!(result.scalars.iter().any(|(name, value, _)| name == "equilibrium.stable" && *value == 1.0));
}

#[test]
fn statics_can_sweep_a_held_coordinate() {
    let study = "[studies.a]\nkind = \"statics\"\nhold = [\"wrist\"]\n\
                 sweep = { joint = \"hinge\", from = \"0 deg\", to = \"90 deg\", points = 3 }\n";
    let result = run(&pendulum("rest-sweep", study), "a");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    let level = 2.0 * 9.81 * 0.5 + 9.81;
    for row in 0..3 {
        let angle = value(&result, "joint.hinge.position", row);
        assert!((value(&result, "drive.hinge.force", row) - level * angle.cos()).abs() < 1e-9);
    }
}

#[test]
fn dead_positions_leave_gaps_and_warnings() {
    let text = bellcrank_model::starter("dead");
    let text = format!(
        "{text}\n[studies.gas]\nkind = \"inverse-dynamics\"\n\
         sweep = {{ joint = \"O\", from = \"0 deg\", to = \"360 deg\", points = 9 }}\n\
         drive = {{ joint = \"guide\", velocity = \"1 m/s\" }}\n"
    );
    let result = run(&model("dead", &text), "gas");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    assert_eq!(result.table.rows(), 9);
    assert!(value(&result, "drive.guide.force", 0).is_nan() && value(&result, "drive.guide.force", 4).is_nan());
    assert!(value(&result, "drive.guide.force", 1).is_finite());
    let told = result.warnings.join("; ");
    assert!(told.contains("dead position") && told.contains("joint.O.position = 0 deg"), "{told}");
}

#[test]
fn later_kinds_are_left_out_of_a_whole_run_and_refused_by_name() {
    let later = "[studies.fall]\nkind = \"dynamics\"\nduration = \"1 s\"\n[studies.reach]\nkind = \"workspace\"\nof = \"a\"\n\
                 [studies.a]\nkind = \"kinematics\"\nhold = [\"wrist\"]\n\
                 sweep = { joint = \"hinge\", from = 0, to = \"10 deg\", points = 3 }\n\
                 [parameters]\nl = \"1 m\"\n\
                 [studies.how]\nkind = \"sensitivity\"\nof = \"fall\"\nresponse = \"max(point.arm.P.y)\"\n";
    let model = pendulum("later", later);
    let whole = model.run_all(&[], &RunOptions::default(), &mut Silent).expect("a run");
    assert_eq!(whole.studies.len(), 2);
    let left_out = |what: &str| whole.warnings.iter().filter(|w| w.contains("left out") && w.contains(what)).count();
    assert_eq!([left_out("`workspace`"), left_out("`sensitivity` of a study of kind `dynamics`")], [1, 1]);
    let refused = |name: &str| model.run(name, &mut Silent).expect_err("no run");
    assert!(matches!(refused("reach"), RunError::NotAvailable { .. }));
    assert!(matches!(refused("reach").hints().as_slice(), [hint] if hint.contains("optimize")));
    // Not every question is answered for dynamics.
    assert!(matches!(refused("how"), RunError::NotAsked { kind, .. } if kind == "sensitivity"));
    assert!(matches!(refused("how").hints().as_slice(), [hint] if hint.contains("inverse-dynamics")));
    assert!(matches!(refused("fal"), RunError::UnknownStudy { nearest: Some(_), .. }));
}

struct StopAt(f64, bool);

impl Progress for StopAt {
    fn at(&mut self, fraction: f64, _message: &str) {
        self.1 = fraction >= self.0;
    }
    fn cancelled(&self) -> bool {
        self.1
    }
}

#[test]
fn a_cancelled_run_keeps_its_rows() {
    let model = model_of(&crate::support::lift());
    let result = model.run("lift", &mut StopAt(0.3, false)).expect("a run");
    assert!(result.failure.expect("a failure").message.contains("stopped on request"));
    assert!(result.table.rows() > 100 && result.table.rows() < 400);
}

#[test]
fn a_hinge_in_the_plane_may_count_backwards() {
    let sweep = |to: &str| {
        format!(
            "[studies.a]\nkind = \"inverse-dynamics\"\nhold = [\"wrist\"]\n\
             sweep = {{ joint = \"hinge\", from = 0, to = \"{to}\", points = 4 }}\n\
             drive = {{ velocity = \"{to}/(1 s)\" }}\n"
        )
    };
    let forwards = model("forwards", &(PENDULUM.to_owned() + &sweep("60 deg")));
    let hinge = "connects = [\"ground.O\", \"arm.O\"]";
    for (name, axis) in [("minus-z", "\"-z\""), ("vector", "[0, 0, -2]")] {
        let turned = PENDULUM.replace(hinge, &format!("{hinge}, axis = {axis}"));
        let backwards = model(name, &(turned + &sweep("-60 deg")));
        let (a, b) = (run(&forwards, "a"), run(&backwards, "a"));
        for signal in ["point.arm.P.x", "point.arm.P.vy", "joint.hinge.reaction.fx", "drive.hinge.power"] {
            let (a, b) = (value(&a, signal, 2), value(&b, signal, 2));
            assert!((a - b).abs() < 1e-9 * a.abs().max(1.0), "{name} {signal}: {a} and {b}");
        }
        assert!((value(&a, "drive.hinge.force", 2) + value(&b, "drive.hinge.force", 2)).abs() < 1e-9);
    }
}

#[test]
fn a_sweep_out_of_reach_from_its_first_position_says_where_the_machine_gets_to() {
    let text = std::fs::read_to_string(crate::support::lift()).expect("the lift");
    let study = "[studies.far]\nkind = \"kinematics\"\n\
                 sweep = { joint = \"slide\", from = \"500 mm\", to = \"700 mm\", points = 3 }\n";
    let result = run(&model("far", &format!("{text}\n{study}")), "far");
    let failure = result.failure.expect("a failure");
    assert_eq!(result.table.rows(), 0);
    assert!(failure.hints[0].contains("within its reach"), "{:?}", failure.hints);
}

#[test]
fn a_body_that_nothing_holds_is_named() {
    let text = format!(
        "{PENDULUM}\n[bodies.lost]\npoints = {{ O = [0, 0] }}\n[studies.a]\nkind = \"kinematics\"\nhold = [\"wrist\"]\n\
         sweep = {{ joint = \"hinge\", from = 0, to = \"10 deg\", points = 3 }}\n"
    );
    let failure = run(&model("lost", &text), "a").failure.expect("a failure");
    assert!(failure.message.contains("no joint holds `lost`"), "{}", failure.message);
}
