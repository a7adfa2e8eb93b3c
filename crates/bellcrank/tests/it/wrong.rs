//! What goes wrong: each kind with its exit code.

use serde_json::Value;

use crate::sandbox::{LIFT, Sandbox, text};
use crate::snapshot;

/// Four slips in one file.
fn slips() -> String {
    let text = LIFT.replace("l32 = { value = \"160 mm\"", "l32 = { value = \"160 mmm\"");
    let text = text.replace("m3  = \"20.8 kg\"", "m3  = \"20.8 kg + 2 mm\"");
    let text = text.replace("\"link3.N\", \"link2.N\"", "\"link3.M\", \"link2.N\"");
    text.replace("kind  = \"inverse-dynamics\"", "kind  = \"inverse-dynamic\"")
}

#[test]
fn every_error_of_a_file_is_shown() {
    let sandbox = Sandbox::new("wrong-slips");
    sandbox.write("slips.toml", slips());
    snapshot::check("wrong-slips", &sandbox, &["run", "slips.toml"]);
    assert!(!sandbox.exists("results"), "nothing is written for a wrong file");
}

#[test]
fn errors_as_data() {
    let sandbox = Sandbox::new("wrong-json");
    sandbox.write("slips.toml", slips());
    for command in ["run", "check"] {
        let output = sandbox.run(&[command, "slips.toml", "--json"]);
        assert_eq!(output.status.code(), Some(1));
        let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
        let diagnostics = printed["diagnostics"].as_array().unwrap();
        assert_eq!(diagnostics.len(), 4, "{printed:#}");
        assert!(diagnostics.iter().all(|found| found["line"].is_u64() && found["code"].is_string()), "{printed:#}");
    }
}

#[test]
fn files_that_are_no_models() {
    let sandbox = Sandbox::new("wrong-files");
    sandbox.write("empty.toml", "");
    sandbox.write("binary.toml", [0x7f, b'E', b'L', b'F', 0, 1, 2, 3]);
    snapshot::check("wrong-empty", &sandbox, &["run", "empty.toml"]);
    snapshot::check("wrong-binary", &sandbox, &["run", "binary.toml"]);
    let missing = sandbox.run(&["run", "missing.toml"]);
    assert_eq!(missing.status.code(), Some(1));
    assert!(text(&missing.stderr).contains("missing.toml"));
}

#[test]
fn command_lines() {
    let sandbox = Sandbox::with_lift("wrong-lines");
    snapshot::check("wrong-study", &sandbox, &["run", "lift.toml", "lif"]);
    let later = Sandbox::with_lift("wrong-kind");
    let lift = later.read("lift.toml");
    later.write("later.toml", format!("{lift}\n[studies.ringing]\nkind = \"workspace\"\nof = \"lift\"\n"));
    snapshot::check("wrong-study-kind", &later, &["run", "later.toml", "ringing"]);
    let dynamics = "[studies.fall]\nkind = \"dynamics\"\nduration = \"1 s\"\n";
    let asking = "[studies.how]\nkind = \"sensitivity\"\nof = \"fall\"\nresponse = \"last(joint.B.position)\"\n";
    later.write("asking.toml", format!("{lift}\n{dynamics}{asking}"));
    snapshot::check("wrong-asking-dynamics", &later, &["run", "asking.toml", "how"]);
    snapshot::check("wrong-set-syntax", &sandbox, &["run", "lift.toml", "--set", "l31"]);
    snapshot::check("wrong-export", &sandbox, &["run", "lift.toml", "--export", "gltf,iges"]);
    snapshot::check("wrong-set-name", &sandbox, &["run", "lift.toml", "--set", "l33=700mm"]);
    snapshot::check("wrong-set-unit", &sandbox, &["check", "lift.toml", "--set", "l31=700 deg"]);
    snapshot::check("wrong-set-twice", &sandbox, &["run", "lift.toml", "--set", "l31=1 m", "--set", "l31=2 m"]);
    snapshot::check("wrong-ending", &sandbox, &["run", "lift"]);
    snapshot::check("wrong-folder", &sandbox, &["run", "."]);
    snapshot::check("wrong-option", &sandbox, &["run", "lift.toml", "--jsn"]);
    snapshot::check("wrong-nothing", &sandbox, &[]);
    assert!(!sandbox.exists("results"), "nothing is written for a wrong command line");
}

#[test]
fn a_directory_that_cannot_be_written() {
    let sandbox = Sandbox::with_lift("wrong-out");
    sandbox.write("taken", "a file");
    snapshot::check("wrong-out", &sandbox, &["run", "lift.toml", "--out", "taken"]);
}

#[test]
fn a_sweep_that_cannot_reach_its_end_keeps_what_it_has() {
    let sandbox = Sandbox::new("wrong-sweep");
    sandbox.write("lift.toml", LIFT.to_owned() + TOO_SHORT);
    snapshot::check("wrong-sweep", &sandbox, &["run", "lift.toml", "retract", "short"]);
    let rows = sandbox.read("results/lift/retract/series.csv").lines().count();
    assert!((140..233).contains(&rows), "{rows} lines");
    assert_eq!(sandbox.read("results/lift/short/series.csv").lines().count(), 4);
    for way in ["--quiet", "--json"] {
        let output = sandbox.run(&["run", "lift.toml", "retract", way]);
        assert_eq!(output.status.code(), Some(3));
        assert!(text(&output.stderr).contains("study `retract`"), "{way}");
    }
}

/// A cylinder that cannot be as short as asked, and beside it a study that gets through.
const TOO_SHORT: &str = r#"
[studies.retract]
kind = "inverse-dynamics"
sweep = { joint = "slide", from = "732 mm", to = "500 mm", points = 233 }

[studies.short]
kind = "kinematics"
sweep = { joint = "B", from = 0, to = "10 deg", points = 3 }
"#;
