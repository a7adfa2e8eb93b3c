//! Benchmarks, and the programs that an engineer would use instead, on the same problem in the same call.

use std::process::Command;

use crate::shell::{self, Outcome};

/// `bench [--peers] [ARGUMENT …]`: `cargo bench`, then the peers' scripts where they are installed.
pub(crate) fn run(arguments: &[String]) -> Outcome {
    let (peers, others): (Vec<&String>, Vec<&String>) = arguments.iter().partition(|a| *a == "--peers");
    shell::run(shell::cargo_command().args(["bench", "--workspace"]).args(others))?;
    if peers.is_empty() {
        return Ok(());
    }
    run_peers()
}

/// The script prints a table and says which peers it did not find.
fn run_peers() -> Outcome {
    let script = shell::root().join("benches/peers.sh");
    if !script.exists() {
        return Err(format!("{} does not exist", shell::relative(&script)));
    }
    shell::run(Command::new("bash").arg(script).current_dir(shell::root()))
}
