//! `bellcrank new`: a model file to start from.

use std::fs::OpenOptions;
use std::io::{self, ErrorKind, Write};

use bellcrank_model::starter;

use crate::config::NewConfig;
use crate::console::Console;
use crate::exit::{Exit, Refusal};

/// Writes the file; one that is there already is replaced only when asked to.
pub(crate) fn run(config: &NewConfig, console: &Console) -> Result<Exit, Refusal> {
    write(config).map_err(|error| refusal(config, &error))?;
    let file = config.file.display();
    console.print(&format!("wrote {file}\nnext: bellcrank run {file}\n"))?;
    Ok(Exit::Done)
}

fn write(config: &NewConfig) -> io::Result<()> {
    let mut options = OpenOptions::new();
    options.write(true).truncate(true);
    if config.force {
        options.create(true)
    } else {
        options.create_new(true)
    };
    options.open(&config.file)?.write_all(starter(&config.name).as_bytes())
}

fn refusal(config: &NewConfig, error: &io::Error) -> Refusal {
    let file = config.file.display();
    if error.kind() == ErrorKind::AlreadyExists {
        return Refusal::command_line(format!("`{file}` exists already"))
            .hint("choose another name, or replace it with `--force`");
    }
    Refusal::command_line(format!("cannot write `{file}`: {error}"))
}
