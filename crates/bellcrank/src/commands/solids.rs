//! `bellcrank solids`: the solids of a model for other programs, and what they weigh.

use std::path::Path;

use bellcrank_model::{Model, PartFile, solid_table};
use serde_json::json;

use crate::config::SolidsConfig;
use crate::console::Console;
use crate::exit::{Exit, Refusal};
use crate::loading::{Shown, open};
use crate::staging::Staging;

/// Writes each solid and, as STEP, all of them where the starts put them.
pub(crate) fn run(config: &SolidsConfig, console: &Console) -> Result<Exit, Refusal> {
    let shown = if config.json { Shown::Json } else { Shown::All };
    let model = open(&config.model, &config.settings, shown, console)?;
    let solids = model.solids();
    if solids.is_empty() {
        return Err(Refusal::command_line(format!("`{}` has no bodies with solids", config.model.display()))
            .hint("`[solids.NAME]` describes one, `solid = \"NAME\"` in a body uses it: docs/solids.md"));
    }
    let mut files = model.part_files(config.formats);
    let exit = if config.formats.step { assembly(&model, &mut files, console) } else { Exit::Done };
    let out = config.out.clone().unwrap_or_else(|| Path::new("results").join(model.name()).join("solids"));
    let count = Staging::prepare(&out)?.put(&files)?;
    console.print(&if config.json {
        let solids: Vec<_> = solids.iter().map(bellcrank_model::SolidFact::json).collect();
        format!("{:#}\n", json!({ "model": model.name(), "solids": solids }))
    } else {
        format!(
            "{}\n{count} {} in {}\n",
            solid_table(&solids),
            if count == 1 { "file" } else { "files" },
            out.display()
        )
    })?;
    Ok(exit)
}

/// The parts are written even where they cannot be put together.
fn assembly(model: &Model, files: &mut Vec<PartFile>, console: &Console) -> Exit {
    match model.assembly() {
        Ok(Some(bytes)) => files.push(PartFile { path: "assembly.step".into(), bytes }),
        Ok(None) => {}
        Err(failure) => {
            console.error(&failure.message, &failure.hints);
            return Exit::Mathematics;
        }
    }
    Exit::Done
}
