//! Models made of models.

use bellcrank_model::load;

use crate::support::{Scratch, model_of, rendered, run, value};

const ARM: &str = include_str!("../suite/parts/arm.toml");

/// Two arms of one file: the second sits on the end of the first.
const CHAIN: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]

[parameters]
reach = "500 mm"

[subsystems.lower]
file = "arm.toml"
set = { length = "reach" }

[subsystems.upper]
file = "arm.toml"
ground = "lower.arm.P"

[forces]
tip = { kind = "force", on = "upper.arm.P", vector = [0, "-10 N"] }

[studies.turn]
kind = "inverse-dynamics"
sweep = { joint = "lower.hinge", from = "0 deg", to = "90 deg", points = 4 }
hold = { "upper.hinge" = "0 deg" }
"#;

#[test]
fn a_file_can_be_used_twice() {
    let scratch = Scratch::new("chain");
    scratch.write("arm.toml", ARM);
    let model = model_of(&scratch.write("chain.toml", CHAIN));
    assert_eq!(model.bodies(), ["lower.arm", "upper.arm"]);
    let names: Vec<String> = model.parameters().into_iter().map(|p| format!("{}={}", p.name, p.value)).collect();
    assert_eq!(names, ["reach=0.5", "lower.length=0.5", "upper.length=0.3"]);
    let result = run(&model, "turn");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    assert!((value(&result, "point.upper.arm.P.x", 0) - 0.8).abs() < 1e-12);
    // Level at row 0: moments of both weights and of the load about the lower hinge.
    let moment = 2.0 * 9.81 * 0.25 + 2.0 * 9.81 * 0.65 + 10.0 * 0.8;
    assert!((value(&result, "drive.lower.hinge.force", 0) - moment).abs() < 1e-9);
}

#[test]
fn faults_point_into_the_file_they_are_in() {
    let scratch = Scratch::new("inner-fault");
    scratch.write("arm.toml", ARM.replace("300 mm", "300 mmm"));
    let loaded = load(&scratch.write("chain.toml", CHAIN), &[]);
    assert!(rendered(&loaded).contains("arm.toml:6:"), "{}", rendered(&loaded));
}

#[test]
fn the_command_line_reaches_into_subsystems() {
    let scratch = Scratch::new("inner-set");
    scratch.write("arm.toml", ARM);
    let loaded = load(&scratch.write("chain.toml", CHAIN), &[("upper.length".to_owned(), "200 mm".to_owned())]);
    let model = loaded.model.expect("a model");
    assert!(model.parameters().iter().any(|p| p.name == "upper.length" && p.value == 0.2));
}

/// A machine that mounts a column twice, which mounts two arms, the upper on the ground of the lower one's carrier.
const DEEP: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]

[parameters]
size = "2 m"

[ground.points]
O = [0, 0]
R = { at = ["3 m", 0], rotate = { angle = "90 deg" } }

[subsystems.left]
file = "column.toml"
ground = "ground.O"
set = { height = "size/4" }

[subsystems.right]
file = "column.toml"
ground = "right_base.ground.O"
set = { height = "size/2 + 0.1 m", arm = "0.2 m" }

[subsystems.right_base]
file = "arm.toml"
ground = "ground.R"

[studies.turn]
kind = "kinematics"
sweep = { joint = "left.low.hinge", from = "0 deg", to = "90 deg", points = 4 }
hold = ["left.high.hinge", "right.low.hinge", "right.high.hinge", "right_base.hinge"]
"#;

const COLUMN: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, 0]

[parameters]
height = "1 m"
arm = "height/2"

[ground.points]
top = [0, "height"]

[subsystems.low]
file = "arm.toml"

[subsystems.high]
file = "arm.toml"
ground = "ground.top"
set = { length = "arm" }
"#;

fn deep(scratch: &Scratch) -> std::path::PathBuf {
    scratch.write("arm.toml", ARM.replace("arm.O\"] }", "arm.O\"], start = 0 }"));
    scratch.write("column.toml", COLUMN);
    scratch.write("deep.toml", DEEP)
}

#[test]
fn grounds_and_parameters_follow_from_file_to_file() {
    let scratch = Scratch::new("deep");
    let model = model_of(&deep(&scratch));
    let value_of = |name: &str| model.parameters().into_iter().find(|p| p.name == name).map(|p| p.value);
    for (name, expected) in [
        ("left.height", 0.5),
        ("left.high.length", 0.25),
        ("left.low.length", 0.3),
        ("right.height", 1.1),
        ("right.high.length", 0.2),
    ] {
        assert!(value_of(name).is_some_and(|value| (value - expected).abs() < 1e-15), "{name}: {:?}", value_of(name));
    }
    let result = run(&model, "turn");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    // The right column lies on its side; what has no `ground` of its own sits where the file that mounts it does.
    for (point, x, y) in [
        ("left.low.arm.P", 0.3, 0.0),
        ("left.high.arm.P", 0.25, 0.5),
        ("right.low.arm.P", 3.0, 0.3),
        ("right.high.arm.P", 3.0 - 1.1, 0.2),
        ("right_base.arm.P", 3.0, 0.3),
    ] {
        let at = ["x", "y"].map(|axis| value(&result, &format!("point.{point}.{axis}"), 0));
        assert!((at[0] - x).abs() < 1e-12 && (at[1] - y).abs() < 1e-12, "{point}: {at:?}");
    }
}

#[test]
fn the_command_line_comes_before_what_a_file_sets() {
    let scratch = Scratch::new("deep-set");
    let set = |name: &str, value: &str| (name.to_owned(), value.to_owned());
    let loaded = load(&deep(&scratch), &[set("left.height", "0.8 m"), set("right.high.length", "0.15 m")]);
    let model = loaded.model.expect("a model");
    let value_of = |name: &str| model.parameters().into_iter().find(|p| p.name == name).map(|p| p.value);
    assert_eq!(value_of("left.height"), Some(0.8));
    assert_eq!(value_of("left.high.length"), Some(0.4), "follows the height");
    assert_eq!(value_of("right.high.length"), Some(0.15));
}

#[test]
fn a_fault_of_a_file_is_told_once_with_the_chain_of_its_mounts() {
    let scratch = Scratch::new("deep-fault");
    let main = deep(&scratch);
    scratch.write("arm.toml", ARM.replace("300 mm", "300 mmm"));
    let loaded = load(&main, &[]);
    let told = rendered(&loaded);
    assert_eq!(loaded.diagnostics.errors(), 1, "{told}");
    for part in ["arm.toml:6:", "mounted as `left.low`", "mounted as `left`", "mounted as `right_base`", "column.toml:"]
    {
        assert!(told.contains(part), "{part} in {told}");
    }
}
