//! Sweeps over designs as their users see them: threads, and going on after an end of any kind.

use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::sandbox::{LIFT, Sandbox, text};
use crate::snapshot;

const STUDIES: &str = r#"
[studies.few]
like = "lift"
sweep = { joint = "B", from = "-30 deg", to = "30 deg", points = 9 }

[studies.designs]
kind = "sweep"
of = "few"
responses = { peak = "max(abs(drive.slide.force))", stroke = "range(joint.slide.position)" }
vary = { l31 = 3, l32 = ["120 mm", "160 mm"], l62 = ["200 mm", "1 m"] }
pareto = { peak = "min", stroke = "max" }

[studies.many]
like = "designs"
vary = ["l31", "l32", "l5"]
method = "sobol"
samples = 30000
"#;

fn sandbox(name: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("m.toml", format!("{LIFT}{STUDIES}"));
    sandbox
}

#[test]
fn a_sweep_in_words() {
    let sandbox = sandbox("sweep");
    snapshot::check("sweep", &sandbox, &["run", "m.toml", "designs", "--threads", "2"]);
    let files = sandbox.files();
    for file in ["designs.csv", "designs.parquet", "designs.state.json", "summary.json"] {
        assert!(files.contains(&format!("results/m/designs/{file}")), "{file} of {files:?}");
    }
    assert!(!files.iter().any(|file| file.contains(".lock") || file.contains(".part")), "{files:?}");
}

#[test]
fn threads_do_not_change_results() {
    let sandbox = sandbox("sweep-threads");
    let rows = |threads: &str| {
        let output = sandbox.run(&["run", "m.toml", "designs", "-q", "--threads", threads, "--out", threads]);
        assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), String::new()));
        sandbox.read(&format!("{threads}/designs/designs.csv"))
    };
    assert!(["1", "2", "3"].iter().all(|threads| rows(threads) == rows("0")));
    for wrong in ["-1", "two", "100000"] {
        assert_eq!(sandbox.run(&["run", "m.toml", &format!("--threads={wrong}")]).status.code(), Some(2), "{wrong}");
    }
}

/// Waits until some rows are on disk.
fn wait_for_rows(sandbox: &Sandbox, child: &mut Child) {
    let start = Instant::now();
    let rows = sandbox.folder.join("results/m/many/designs.csv");
    while std::fs::metadata(&rows).map_or(0, |about| about.len()) < 10_000 {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        assert!(start.elapsed() < Duration::from_secs(60), "it did not start");
        std::thread::yield_now();
    }
}

fn start(sandbox: &Sandbox) -> Child {
    let mut command = sandbox.command(&["run", "m.toml", "many", "-q"]);
    let mut child = command.stderr(Stdio::piped()).spawn().unwrap();
    wait_for_rows(sandbox, &mut child);
    child
}

#[test]
fn a_killed_sweep_goes_on_to_the_same_files() {
    let sandbox = sandbox("sweep-killed");
    assert_eq!(sandbox.run(&["run", "m.toml", "many", "-q", "--out", "whole"]).status.code(), Some(0));
    for _ in 0..2 {
        let mut child = start(&sandbox);
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(!sandbox.exists("results/m/many/designs.parquet"));
    }
    let output = sandbox.run(&["run", "m.toml", "many", "--json"]);
    assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), String::new()));
    let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
    let found = &printed["studies"]["many"];
    assert!(found["resumed"].as_u64().is_some_and(|rows| (1..30_000).contains(&rows)), "{found:#}");
    assert_eq!(found["done"], 30_000);
    for file in ["designs.csv", "designs.parquet", "designs.state.json"] {
        let bytes = |out: &str| std::fs::read(sandbox.folder.join(out).join("many").join(file)).unwrap();
        assert!(bytes("whole") == bytes("results/m"), "{file} differs");
    }
    let files = sandbox.files();
    assert!(!files.iter().any(|file| file.contains(".lock") || file.contains(".part")), "{files:?}");
    let rooms = std::fs::read_dir(sandbox.folder.join("results/m")).unwrap().flatten();
    assert!(rooms.into_iter().all(|entry| !entry.file_name().to_string_lossy().starts_with('.')), "a room is left");
}

#[test]
fn an_interrupted_sweep_of_another_machine_is_refused() {
    let sandbox = sandbox("sweep-changed");
    let mut child = start(&sandbox);
    // Nobody else writes there meanwhile.
    let second = sandbox.run(&["run", "m.toml", "many", "-q"]);
    let said = text(&second.stderr);
    assert!(second.status.code() == Some(3) && said.contains(&format!("process {}", child.id())), "{said}");
    child.kill().unwrap();
    child.wait().unwrap();
    let rows = sandbox.read("results/m/many/designs.csv");
    let output = sandbox.run(&["run", "m.toml", "many", "-q", "--set", "l62=210mm"]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(3));
    assert!(said.contains("parameter `l62` was 200 mm and is 210 mm") && said.contains("--fresh"), "{said}");
    assert_eq!(sandbox.read("results/m/many/designs.csv"), rows);
    let model = format!("{LIFT}{STUDIES}").replace("samples = 30000", "samples = 300");
    sandbox.write("m.toml", model);
    let fresh = sandbox.run(&["run", "m.toml", "many", "-q", "--fresh"]);
    assert_eq!((fresh.status.code(), text(&fresh.stderr)), (Some(0), String::new()));
    assert_eq!(sandbox.read("results/m/many/designs.csv").lines().count(), 301);
}

#[cfg(unix)]
#[test]
fn a_sweep_stopped_by_ctrl_c_says_how_to_go_on() {
    let sandbox = sandbox("sweep-stopped");
    let child = start(&sandbox);
    std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let said = text(&output.stderr);
    assert!(said.contains("which are kept") && said.contains("the same command goes on"), "{said}");
    assert!(sandbox.exists("results/m/report.html"));
    let rows = sandbox.read("results/m/many/designs.csv");
    assert!(rows.ends_with('\n') && said.contains(&format!("after {} of 30000", rows.lines().count() - 1)), "{said}");
}
