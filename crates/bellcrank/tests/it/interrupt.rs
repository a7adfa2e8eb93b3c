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
