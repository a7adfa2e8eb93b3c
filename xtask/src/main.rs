//! Repository chores: `cargo xtask COMMAND`.

mod bench;
mod bless;
mod check;
#[cfg(test)]
mod keys;
mod paper;
mod shell;
mod sizes;
#[cfg(test)]
mod tidy;
mod verify;

use std::process::ExitCode;

/// A chore: its name, what it does, and how.
struct Chore {
    name: &'static str,
    about: &'static str,
    run: fn(&[String]) -> shell::Outcome,
}

const CHORES: [Chore; 6] = [
    Chore { name: "check", about: "everything that CI does", run: check::run },
    Chore {
        name: "verify",
        about: "reference numbers beside computed ones; `--page` writes the page in docs",
        run: verify::run,
    },
    Chore { name: "paper", about: "write the page that compares the assist manipulator's paper", run: paper::run },
    Chore { name: "bless", about: "update snapshots and generated pages (never a reference.toml)", run: bless::run },
    Chore {
        name: "bench",
        about: "benchmarks; `bench --peers` runs the peers of the same problem beside them",
        run: bench::run,
    },
    Chore { name: "sizes", about: "the ten longest functions and files", run: sizes::run },
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some((name, rest)) = arguments.split_first() else {
        return usage();
    };
    match CHORES.iter().find(|chore| chore.name == name) {
        Some(chore) => report((chore.run)(rest)),
        None => usage(),
    }
}

fn report(outcome: shell::Outcome) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("xtask: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn usage() -> ExitCode {
    eprintln!("usage: cargo xtask COMMAND");
    for chore in &CHORES {
        eprintln!("  {:<8} {}", chore.name, chore.about);
    }
    ExitCode::from(2)
}
