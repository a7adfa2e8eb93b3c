//! `bellcrank run` when all goes well.

use std::process::Stdio;

use serde_json::Value;

use crate::sandbox::{Sandbox, text};
use crate::snapshot;

#[test]
fn the_lift() {
    let sandbox = Sandbox::with_lift("run-lift");
    snapshot::check("run-lift", &sandbox, &["run", "lift.toml"]);
    for file in ["report.html", "lift/series.csv", "lift/summary.json", "massless/series.csv", "massless/summary.json"]
    {
        assert!(sandbox.exists(&format!("results/lift/{file}")), "{file}");
    }
    assert!(sandbox.files().iter().any(|file| file.starts_with("results/lift/lift/plots/") && file.ends_with(".svg")));
    assert!(!sandbox.files().iter().any(|file| file.contains(".bellcrank")), "a room for unfinished files is left");
}

#[test]
fn one_study_with_other_values_elsewhere() {
    let sandbox = Sandbox::with_lift("run-set");
    let arguments =
        ["run", "lift.toml", "lift", "--set", "l31=600mm", "--set", "l32 = \"200 mm\"", "--set", "l5=800mm"];
    let output = sandbox.run(&[&arguments[..], &["--out", "deep/er", "--json"]].concat());
    let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
    let peak = printed.pointer("/studies/lift/signals/drive.slide.force/max/value").and_then(Value::as_f64).unwrap();
    assert!((peak - 4423.5).abs() < 0.05, "{peak}");
    assert!(printed.pointer("/studies/massless").is_none());
    assert!(sandbox.exists("deep/er/lift/series.csv"));
    assert!(!sandbox.exists("results"));
}

#[test]
fn json_is_all_that_is_printed() {
    let sandbox = Sandbox::with_lift("run-json");
    let output = sandbox.run(&["run", "lift.toml", "lift", "massless", "--json"]);
    assert_eq!(output.status.code(), Some(0));
    assert_eq!(text(&output.stderr), "");
    let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(printed["model"], "lift");
    let peak = |study: &str| printed["studies"][study]["signals"]["drive.slide.force"]["max"].clone();
    assert!((peak("lift")["value"].as_f64().unwrap() - 6473.6).abs() < 0.05);
    assert!((peak("massless")["value"].as_f64().unwrap() - 4844.5).abs() < 0.05);
    assert_eq!(peak("lift")["at"]["joint.B.position"], -30.0);
    let kept: Value = serde_json::from_str(&sandbox.read("results/lift/lift/summary.json")).unwrap();
    assert_eq!(kept, printed["studies"]["lift"]);
}

#[test]
fn the_series_has_units_in_its_header() {
    let sandbox = Sandbox::with_lift("run-series");
    sandbox.run(&["run", "lift.toml", "lift", "--quiet"]);
    let series = sandbox.read("results/lift/lift/series.csv");
    let header = series.lines().next().unwrap();
    assert!(header.contains("joint.B.position [deg]") && header.contains("drive.slide.force [N]"), "{header}");
    assert_eq!(series.lines().count(), 602);
}

#[test]
fn more_files_for_those_who_ask() {
    let sandbox = Sandbox::with_lift("run-export");
    sandbox.run(&["run", "lift.toml", "lift", "--quiet", "--export", "gltf,parquet,csv"]);
    let bytes = |file: &str| std::fs::read(sandbox.folder.join("results/lift/lift").join(file)).unwrap();
    assert!(bytes("motion.glb").starts_with(b"glTF") && bytes("series.parquet").ends_with(b"PAR1"));
    assert!(bytes("series.csv").starts_with(b"joint."));
    sandbox.run(&["run", "lift.toml", "massless", "--quiet"]);
    assert!(!sandbox.exists("results/lift/massless/motion.glb"));
}

#[test]
fn quiet_says_nothing() {
    let sandbox = Sandbox::with_lift("run-quiet");
    snapshot::check("run-quiet", &sandbox, &["run", "lift.toml", "lift", "--quiet"]);
    assert!(sandbox.exists("results/lift/report.html"));
}

#[test]
fn colour_only_when_asked_for_or_on_a_terminal() {
    let sandbox = Sandbox::with_lift("run-color");
    let colored = |arguments: &[&str]| {
        let output = sandbox.run(&[&["run", "lift.toml", "lift"], arguments].concat());
        text(&output.stdout).contains('\u{1b}')
    };
    assert!(!colored(&[]));
    assert!(!colored(&["--color", "never"]));
    assert!(colored(&["--color", "always"]));
}

#[test]
fn a_second_run_replaces_the_first() {
    let sandbox = Sandbox::with_lift("run-twice");
    sandbox.run(&["run", "lift.toml", "lift", "--quiet"]);
    let first = sandbox.read("results/lift/lift/series.csv");
    sandbox.run(&["run", "lift.toml", "lift", "--quiet", "--set", "load=900N"]);
    assert_ne!(first, sandbox.read("results/lift/lift/series.csv"));
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let sandbox = Sandbox::with_lift("run-pipe");
    let mut child = sandbox.command(&["run", "lift.toml", "--json"]).stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}
