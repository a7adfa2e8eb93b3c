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
