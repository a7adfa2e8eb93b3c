//! `bellcrank`: from a model file to motion, forces and a report.
//!
//! One file a command in `commands/`. A command answers with an [`Exit`] or a [`Refusal`](exit::Refusal); both
//! become an exit code here and nowhere else.

mod args;
mod cache;
mod commands;
mod config;
mod console;
mod exit;
mod fault;
mod improvement;
mod interrupt;
mod loading;
mod progress;
mod staging;

use std::process::ExitCode;

use clap::Parser;

use args::{Args, Command};
use console::Console;
use exit::Exit;

fn main() -> ExitCode {
    fault::install_hook();
    fault::guarded(start).into()
}

fn start() -> Exit {
    match Args::try_parse() {
        Ok(args) => run(&args),
        Err(message) => show_usage(&message),
    }
}

/// Help and version are answers; everything else that clap says is about a wrong command line.
fn show_usage(message: &clap::Error) -> Exit {
    // Nothing can be done about a terminal that has gone away.
    let _ = message.print();
    if message.use_stderr() { Exit::CommandLine } else { Exit::Done }
}

fn run(args: &Args) -> Exit {
    let console = Console::new(args.color);
    let outcome = match &args.command {
        Command::Run(run) => config::RunConfig::new(run).and_then(|config| commands::run::run(&config, &console)),
        Command::Check(check) => {
            config::CheckConfig::new(check).and_then(|config| commands::check::run(&config, &console))
        }
        Command::Solids(solids) => {
            config::SolidsConfig::new(solids).and_then(|config| commands::solids::run(&config, &console))
        }
        Command::Converge(converge) => {
            config::ConvergeConfig::new(converge).and_then(|config| commands::converge::run(&config, &console))
        }
        Command::Schema => commands::schema::run(&console),
        Command::New(new) => config::NewConfig::new(new).and_then(|config| commands::new::run(&config, &console)),
        Command::Completions { shell } => commands::completions::run(*shell, &console),
    };
    outcome.unwrap_or_else(|refusal| console.refuse(&refusal))
}
