//! `bellcrank check`: what a model is made of, and what is wrong with it.

use crate::config::CheckConfig;
use crate::console::Console;
use crate::exit::{Exit, Refusal};
use crate::loading::{Shown, open};

/// Prints the facts; a mechanism that cannot be assembled is failed mathematics.
pub(crate) fn run(config: &CheckConfig, console: &Console) -> Result<Exit, Refusal> {
    let shown = if config.json { Shown::Json } else { Shown::All };
    let check = open(&config.model, &config.settings, shown, console)?.check();
    console.print(&if config.json { format!("{:#}\n", check.json()) } else { check.text() })?;
    Ok(if check.failure.is_some() { Exit::Mathematics } else { Exit::Done })
}
