//! Everything that CI does, in one call. The tests come last: their closing lines are what one looks for.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use crate::shell::{self, Outcome, cargo, cargo_command, files, relative, root};
use crate::{sizes, verify};

/// What a step is called, and the step.
type Step = (&'static str, fn() -> Outcome);

/// Format, lints, documentation, sizes, examples, verification, tests.
pub(crate) fn run(_: &[String]) -> Outcome {
    let steps: [Step; 7] = [
        ("format", || cargo(&["fmt", "--all", "--check"])),
        ("lints", || cargo(&["clippy", "--workspace", "--all-targets", "--quiet", "--", "-D", "warnings"])),
        ("documentation", documentation),
        ("sizes", || sizes::run(&[])),
        ("examples", examples),
        ("verification", || verify::run(&[])),
        ("tests", || cargo(&["test", "--workspace"])),
    ];
    for (name, step) in steps {
        let start = Instant::now();
        step()?;
        eprintln!("xtask: {name} ok, {:.1} s\n", start.elapsed().as_secs_f64());
    }
    Ok(())
}

fn documentation() -> Outcome {
    let mut command = cargo_command();
    command.args(["doc", "--workspace", "--no-deps", "--quiet"]).env("RUSTDOCFLAGS", "-D warnings");
    shell::run(&mut command)
}

/// Every shipped machine, run by the program that users get, as they run it.
fn examples() -> Outcome {
    cargo(&["build", "--release", "--quiet", "--package", "bellcrank"])?;
    let program = target_directory()?.join("release/bellcrank");
    let out = target_directory()?.join("examples");
    for model in files(&root().join("models"), &|name| name.ends_with(".toml") && !name.ends_with("expected.toml")) {
        example(&program, &model, &out.join(model.file_stem().unwrap_or_default()))?;
    }
    Ok(())
}

fn example(program: &Path, model: &Path, out: &Path) -> Outcome {
    let start = Instant::now();
    let mut command = Command::new(program);
    command.arg("run").arg(model).arg("--quiet").arg("--out").arg(out).stdout(Stdio::null()).current_dir(root());
    shell::run(&mut command)?;
    eprintln!("xtask: {} in {:.0} ms", relative(model), 1e3 * start.elapsed().as_secs_f64());
    Ok(())
}

/// Where cargo builds: `target`, or what the environment or a configuration says.
fn target_directory() -> Result<std::path::PathBuf, String> {
    let output = cargo_command().args(["metadata", "--no-deps", "--format-version", "1"]).output();
    let text = output.map_err(|error| format!("cannot run `cargo metadata`: {error}"))?.stdout;
    let text = String::from_utf8_lossy(&text);
    let value = text.split("\"target_directory\":\"").nth(1).and_then(|rest| rest.split('"').next());
    value.map(Into::into).ok_or_else(|| "`cargo metadata` names no target directory".to_owned())
}
