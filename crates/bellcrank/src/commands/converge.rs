//! `bellcrank converge`: how many modes and how fine a mesh a study needs.

use bellcrank_model::{Converge, RunOptions};
use bellcrank_report::terminal_convergence;
use bellcrank_results::Convergence;

use crate::config::{ConvergeConfig, Printed};
use crate::console::Console;
use crate::exit::{Exit, Refusal};
use crate::interrupt::Interrupt;
use crate::loading::{Shown, open};
use crate::progress::Watch;

/// Runs the study with finer and finer settings; what did not converge is a finding, not a failure.
pub(crate) fn run(config: &ConvergeConfig, console: &Console) -> Result<Exit, Refusal> {
    let shown = if config.json { Shown::Json } else { Shown::All };
    let mut model = open(&config.model, &config.settings, shown, console)?;
    let interrupt = Interrupt::listen();
    let printed = if config.json { Printed::Json } else { Printed::Summary };
    let mut watch = Watch::new(interrupt.clone(), printed, *console);
    let options = RunOptions { threads: config.threads, cache: config.cache.clone(), ..RunOptions::default() };
    let how = Converge { tolerance: config.tolerance, options };
    let found = model.converge(&config.study, &how, &mut watch);
    watch.finish();
    let found =
        found.map_err(|error| Refusal { exit: Exit::CommandLine, message: error.to_string(), hints: error.hints() })?;
    console.print(&if config.json {
        format!("{:#}\n", found.json())
    } else {
        terminal_convergence(&found, &console.style())
    })?;
    if let Some(why) = found.failure.as_ref().filter(|_| !interrupt.pressed()) {
        console.error(&why.message, &why.hints);
    }
    Ok(exit(&found, &interrupt))
}

fn exit(found: &Convergence, interrupt: &Interrupt) -> Exit {
    let mut rungs = found.ladders.iter().flat_map(|ladder| &ladder.rungs);
    if interrupt.pressed() {
        Exit::Interrupted
    } else if found.failure.is_some() || rungs.any(|rung| rung.failure.is_some()) {
        Exit::Mathematics
    } else {
        Exit::Done
    }
}
