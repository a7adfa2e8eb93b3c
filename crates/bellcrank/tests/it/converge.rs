//! How many modes and how fine a mesh a study needs, and what comes of life under repeats.

use serde_json::Value;

use crate::sandbox::{Sandbox, text};
use crate::snapshot;

/// One short flexible arm with a mass at its end, a coarse mesh.
const SWING: &str = include_str!("swing.toml");

fn with_swing(name: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("swing.toml", SWING);
    sandbox
}

#[test]
fn told() {
    let sandbox = with_swing("converge");
    snapshot::check("converge", &sandbox, &["converge", "swing.toml", "swing", "--tolerance", "3%", "--no-cache"]);
    assert_eq!(sandbox.files(), ["swing.toml"]);
}

#[test]
fn as_data() {
    let output = with_swing("converge-json").run(&["converge", "swing.toml", "swing", "--json", "--no-cache"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let modes = &found["ladders"][0];
    let counts: Vec<f64> =
        modes["rungs"].as_array().unwrap().iter().filter_map(|rung| rung["setting"].as_f64()).collect();
    assert_eq!((counts, &modes["over"]), (vec![0.0, 2.0, 4.0], &Value::from("modes")));
    let mesh = &found["ladders"][1];
    let nodes: Vec<u64> = mesh["rungs"].as_array().unwrap().iter().filter_map(|rung| rung["nodes"].as_u64()).collect();
    assert!(nodes.len() == 3 && nodes.is_sorted_by(|a, b| a < b), "{nodes:?}");
    // With the settings of the file both ladders say the same.
    let first = |rung: &Value| rung["values"][0]["value"]["value"].as_f64().unwrap();
    assert!((first(&modes["rungs"][1]) / first(&mesh["rungs"][0]) - 1.0).abs() < 1e-9);
    for value in mesh["rungs"][2]["values"].as_array().unwrap() {
        assert_eq!(value["change"], 0.0, "{value:#}");
    }
}

#[test]
fn wrong() {
    let sandbox = with_swing("converge-wrong");
    for (name, arguments) in [
        ("converge-unknown", &["swng"][..]),
        ("converge-rigid", &["rigid"]),
        ("converge-kind", &["ring"]),
        ("converge-tolerance", &["swing", "--tolerance", "0"]),
    ] {
        snapshot::check(name, &sandbox, &[&["converge", "swing.toml"], arguments].concat());
    }
}

/// The arm swings at 6 rad/s for a second: each hot spot says what a repeat costs, and the page what that rests on.
#[test]
fn life() {
    let output = with_swing("life").run(&["run", "swing.toml", "swing", "--json", "--no-cache", "--out", "out"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let flexible = &found["studies"]["swing"]["flexible"];
    assert_eq!(flexible["assumptions"].as_array().map(Vec::len), Some(5), "{flexible:#}");
    for spot in flexible["bodies"]["arm"]["hot_spots"].as_array().unwrap() {
        let of = |key: &str| spot["fatigue"][key]["value"].as_f64().or(spot["fatigue"][key].as_f64()).unwrap();
        let (damage, life, amplitude, mean) = (of("damage"), of("life"), of("amplitude"), of("mean"));
        assert!((damage * life - 1.0).abs() < 1e-12, "{spot:#}");
        // The largest cycle alone, after Goodman, on the line 60 MPa, 2e6 cycles, slope 5; display unit MPa.
        let largest = (amplitude / (1.0 - mean.max(0.0) / 490.0) / 60.0).powi(5) / 2e6;
        assert!(damage >= 0.999_999 * largest && damage < 10.0 * largest, "{damage} and {largest}: {spot:#}");
    }
}
