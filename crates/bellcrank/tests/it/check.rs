//! `bellcrank check`.

use serde_json::Value;

use crate::sandbox::Sandbox;
use crate::snapshot;

#[test]
fn the_lift() {
    let sandbox = Sandbox::with_lift("check-lift");
    snapshot::check("check-lift", &sandbox, &["check", "lift.toml"]);
}

#[test]
fn as_data() {
    let sandbox = Sandbox::with_lift("check-json");
    let output = sandbox.run(&["check", "lift.toml", "--json"]);
    assert_eq!(output.status.code(), Some(0));
    let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(printed["degrees_of_freedom"]["computed"], 1, "{printed:#}");
}

#[test]
fn a_mechanism_that_cannot_be_assembled() {
    let sandbox = Sandbox::new("check-open");
    let apart = crate::sandbox::LIFT.replace("A = [0, \"l61 + l62\"]", "A = [\"9 m\", \"l61 + l62\"]");
    sandbox.write("apart.toml", apart);
    snapshot::check("check-apart", &sandbox, &["check", "apart.toml"]);
}
