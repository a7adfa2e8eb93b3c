//! `bellcrank completions`: a script that lets a shell complete our commands.

use clap::CommandFactory;
use clap_complete::{Shell, generate};

use crate::args::Args;
use crate::console::Console;
use crate::exit::{Exit, Refusal};

/// Prints the script.
pub(crate) fn run(shell: Shell, console: &Console) -> Result<Exit, Refusal> {
    // Into memory first: `generate` panics on a reader that has gone away.
    let mut script = Vec::new();
    generate(shell, &mut Args::command(), "bellcrank", &mut script);
    console.print(&String::from_utf8_lossy(&script))?;
    Ok(Exit::Done)
}
