//! `bellcrank schema`: the format for editors.

use crate::console::Console;
use crate::exit::{Exit, Refusal};

/// Prints the JSON Schema of the model file.
pub(crate) fn run(console: &Console) -> Result<Exit, Refusal> {
    console.print(&format!("{:#}\n", bellcrank_model::schema()))?;
    Ok(Exit::Done)
}
