//! `schema`, `new`, `completions`, help.

use serde_json::Value;

use crate::sandbox::{Sandbox, text};
use crate::snapshot;

#[test]
fn help() {
    let sandbox = Sandbox::new("help");
    for (name, arguments) in [
        ("help", &["--help"][..]),
        ("help-run", &["run", "--help"]),
        ("help-check", &["check", "--help"]),
        ("help-new", &["new", "--help"]),
        ("help-solids", &["solids", "--help"]),
        ("help-converge", &["converge", "--help"]),
    ] {
        snapshot::check(name, &sandbox, arguments);
    }
    let version = text(&sandbox.run(&["--version"]).stdout);
    assert_eq!(version, format!("bellcrank {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn the_schema_is_json() {
    let output = Sandbox::new("schema").run(&["schema"]);
    assert_eq!(output.status.code(), Some(0));
    let schema: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

#[test]
fn a_new_model_runs_and_is_not_overwritten() {
    let sandbox = Sandbox::new("new");
    snapshot::check("new", &sandbox, &["new", "crane"]);
    assert_eq!(sandbox.run(&["run", "crane.toml", "--quiet"]).status.code(), Some(0));
    sandbox.write("crane.toml", "mine");
    snapshot::check("new-again", &sandbox, &["new", "crane.toml"]);
    assert_eq!(sandbox.read("crane.toml"), "mine");
    assert_eq!(sandbox.run(&["new", "crane", "--force"]).status.code(), Some(0));
    assert_ne!(sandbox.read("crane.toml"), "mine");
}

#[test]
fn a_new_model_runs_whatever_its_name() {
    let sandbox = Sandbox::new("new-names");
    for name in ["my crane", "say \"hi\"", "back\\slash", "Kurbelschwinge Ü", "a.b"] {
        assert_eq!(sandbox.run(&["new", name]).status.code(), Some(0), "{name}");
        let output = sandbox.run(&["run", &format!("{name}.toml"), "--quiet"]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", text(&output.stderr));
    }
}

#[test]
fn completions_for_each_shell() {
    let sandbox = Sandbox::new("completions");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = sandbox.run(&["completions", shell]);
        assert_eq!(output.status.code(), Some(0), "{shell}");
        assert!(text(&output.stdout).contains("bellcrank"), "{shell}");
    }
}
