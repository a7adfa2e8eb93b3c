//! Solids: their masses, their files, what is wrong with them.

use std::fs;

use crate::sandbox::Sandbox;
use crate::snapshot;

const LIFT: &str = include_str!("../../../../models/assist-manipulator/lift-solids.toml");

fn with_solids(name: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("lift.toml", LIFT);
    sandbox
}

#[test]
fn checked() {
    snapshot::check("solids-check", &with_solids("solids-check"), &["check", "lift.toml"]);
}

#[test]
fn written() {
    let sandbox = with_solids("solids-written");
    snapshot::check("solids", &sandbox, &["solids", "lift.toml", "--out", "parts"]);
    let found = |name: &str| fs::read(sandbox.folder.join("parts").join(name)).unwrap();
    for name in ["link3.step", "link5.step", "assembly.step"] {
        let text = String::from_utf8(found(name)).unwrap();
        assert!(text.starts_with("ISO-10303-21;") && text.ends_with("END-ISO-10303-21;\n"), "{name}");
        assert!(text.contains("MANIFOLD_SOLID_BREP"), "{name}");
    }
    let stl = found("link3.stl");
    let count = u32::from_le_bytes(stl[80..84].try_into().unwrap()) as usize;
    assert_eq!(stl.len(), 84 + 50 * count);
}

#[test]
fn as_data() {
    let output = with_solids("solids-json").run(&["solids", "lift.toml", "--out", "parts", "--json"]);
    let printed: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(printed["solids"][0]["body"], "link3", "{printed:#}");
    assert!((printed["solids"][0]["mass"]["value"].as_f64().unwrap() - 20.747_498).abs() < 1e-6, "{printed:#}");
}

#[test]
fn with_a_run() {
    let sandbox = with_solids("solids-run");
    let output = sandbox.run(&["run", "lift.toml", "lift", "--out", "out", "--export", "step,stl,gltf", "--quiet"]);
    assert_eq!(output.status.code(), Some(0), "{}", crate::sandbox::text(&output.stderr));
    for file in ["solids/link3.step", "solids/link5.stl", "lift/assembly.step", "lift/motion.glb"] {
        assert!(sandbox.folder.join("out").join(file).is_file(), "{file}");
    }
}

#[test]
fn none_there() {
    let sandbox = Sandbox::with_lift("solids-none");
    snapshot::check("solids-none", &sandbox, &["solids", "lift.toml"]);
}

#[test]
fn wrong() {
    let sandbox = Sandbox::new("solids-wrong");
    let thin = LIFT.replace("N = { bore = \"pin\", outer = \"2*pin\" }", "N = { bore = \"pin\", outer = \"0.9*pin\" }");
    let bad = thin.replace(
        "between = [\"A\", \"H\"], width = \"width\"",
        "between = [\"A\", \"H\"], width = \"width\", offset = \"90 mm\"",
    );
    sandbox.write("wrong.toml", bad);
    snapshot::check("solids-wrong", &sandbox, &["check", "wrong.toml"]);
}
