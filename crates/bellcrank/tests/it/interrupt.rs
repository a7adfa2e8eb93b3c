//! Ctrl-C: the rows so far are kept.
#![cfg(unix)]

use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::sandbox::{LIFT, Sandbox};

#[test]
fn the_rows_so_far_are_kept() {
    let sandbox = Sandbox::new("interrupt");
    sandbox.write("long.toml", LIFT.replacen("points = 601", "points = 1000000", 1));
    let mut child = sandbox.command(&["run", "long.toml", "lift", "--quiet"]).stderr(Stdio::null()).spawn().unwrap();
    wait_for_start(&sandbox, &mut child);
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let rows = sandbox.read("results/long/lift/series.csv").lines().count();
    assert!(rows < 1_000_001, "{rows}");
    assert!(sandbox.exists("results/long/report.html"));
}

#[test]
fn an_optimization_keeps_its_best_design_and_writes_no_model() {
    let sandbox = Sandbox::new("interrupt-search");
    let lift = LIFT.replacen("points = 601", "points = 3", 1);
    sandbox.write("long.toml", format!("{lift}\n[studies.many]\nlike = \"shorter\"\nstarts = 1000000\n"));
    let arguments = ["run", "long.toml", "many", "--quiet", "--write", "better.toml"];
    let mut child = sandbox.command(&arguments).stderr(Stdio::piped()).spawn().unwrap();
    wait_for_start(&sandbox, &mut child);
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("the best design so far is kept"), "{said}");
    assert!(said.contains("`better.toml` was not written"), "{said}");
    assert!(!sandbox.exists("better.toml"));
    assert!(sandbox.read("results/long/many/summary.json").contains("\"interrupted\""));
}

/// Ctrl-C is listened to before the room for unfinished files appears.
fn wait_for_start(sandbox: &Sandbox, child: &mut Child) {
    let room = format!("results/long/.bellcrank-{}", child.id());
    let start = Instant::now();
    while !sandbox.exists(&room) {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        assert!(start.elapsed() < Duration::from_secs(60), "it did not start");
        std::thread::yield_now();
    }
}
