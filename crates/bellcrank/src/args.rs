//! The command line as it is typed. Nothing in here has been checked beyond its shape; [`crate::config`] does that.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

/// From a model file to motion, forces and a report, for any closed-loop mechanism.
#[derive(Debug, Parser)]
#[command(name = "bellcrank", version, arg_required_else_help = true, after_help = EXIT_CODES)]
pub(crate) struct Args {
    /// When to use colour.
    #[arg(long, value_name = "WHEN", default_value = "auto", global = true)]
    pub(crate) color: When,
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

const EXIT_CODES: &str = "Exit codes: 0 done, 1 the model file is wrong, 2 the command line is wrong, \
    3 the mathematics failed, 70 a fault of bellcrank, 130 stopped by Ctrl-C.";

/// When to use colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum When {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Also into files and pipes.
    Always,
    /// Nowhere.
    Never,
}

/// Formats of what a study leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// The motion as binary glTF 2.0.
    Gltf,
    /// All signals as Parquet.
    Parquet,
    /// All signals as CSV; always written.
    Csv,
    /// Solids of bodies as STEP, and assembled at the first row.
    Step,
    /// Solids of bodies as STL.
    Stl,
    /// Meshes of parts with their results, and flexible bodies row by row, for ParaView.
    Vtu,
    /// Meshes of parts as whole input files of CalculiX.
    Inp,
    /// Meshes of parts, for Gmsh.
    Msh,
}

/// Formats of solids.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum SolidFormat {
    /// Exact surfaces, for CAD programs.
    Step,
    /// Triangles, for printers and viewers.
    Stl,
}

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run the studies of a model; write CSV, JSON, plots and a report.
    Run(RunArgs),
    /// Check a model file; show bodies, joints, degrees of freedom, loops, redundant equations.
    Check(CheckArgs),
    /// Write the solids of a model as STEP and STL; show their masses.
    Solids(SolidsArgs),
    /// Run a study with more modes and finer meshes of its flexible bodies; show what is enough.
    Converge(ConvergeArgs),
    /// Print the JSON Schema of the model file, for editors.
    Schema,
    /// Write a commented model file to start from.
    New(NewArgs),
    /// Print a completion script for a shell.
    Completions {
        /// The shell.
        shell: Shell,
    },
}

/// Arguments of `run`.
#[derive(Debug, clap::Args)]
pub(crate) struct RunArgs {
    /// The model file.
    pub(crate) model: PathBuf,
    /// Studies to run; all unless given.
    #[arg(value_name = "STUDY")]
    pub(crate) studies: Vec<String>,
    /// Another value for a parameter, as `l31=700mm` (again for more).
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,
    /// Where to write; `results/<model name>` unless given.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// What else to write, comma between: for each study `gltf` is motion.glb, `parquet` series.parquet, `step`
    /// assembly.step at its first row, `vtu`, `inp` and `msh` the mesh of a part with its results (of flexible bodies
    /// `vtu` is motion.pvd with a file a row); `step` and `stl` also write each solid into `solids`.
    #[arg(long, value_name = "FORMATS", value_enum, value_delimiter = ',')]
    pub(crate) export: Vec<Format>,
    /// Write the model with the values that its `optimize` study found into a new file.
    #[arg(long, value_name = "FILE")]
    pub(crate) write: Option<PathBuf>,
    /// Let `--write` replace a file that is already there.
    #[arg(long, requires = "write")]
    pub(crate) force: bool,
    /// Threads for studies over many designs; one a core unless given. Results do not depend on it.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(0..=1024))]
    pub(crate) threads: Option<u16>,
    /// Begin interrupted sweeps anew, instead of going on behind their last design.
    #[arg(long)]
    pub(crate) fresh: bool,
    /// The cache.
    #[command(flatten)]
    pub(crate) kept: CacheArgs,
    /// Print the summaries as one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
    /// Print nothing but errors: no summary, no iterations.
    #[arg(long, short, conflicts_with = "json")]
    pub(crate) quiet: bool,
}

/// Where reductions outlive a run.
#[derive(Debug, clap::Args)]
pub(crate) struct CacheArgs {
    /// Where reductions of flexible bodies are kept from run to run; `BELLCRANK_CACHE`, or the folder for caches of the
    /// platform, unless given.
    #[arg(long, value_name = "DIR", conflicts_with = "no_cache")]
    pub(crate) cache: Option<PathBuf>,
    /// Keep no reductions, and use none that are kept.
    #[arg(long)]
    pub(crate) no_cache: bool,
}

/// Arguments of `converge`.
#[derive(Debug, clap::Args)]
pub(crate) struct ConvergeArgs {
    /// The model file.
    pub(crate) model: PathBuf,
    /// The study; it has flexible bodies and rows of its own.
    pub(crate) study: String,
    /// Another value for a parameter, as `l31=700mm` (again for more).
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,
    /// Largest change against the finest setting that counts as none.
    #[arg(long, value_name = "SHARE", default_value = "1%")]
    pub(crate) tolerance: String,
    /// Threads of reductions; one a core unless given. Results do not depend on it.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(0..=1024))]
    pub(crate) threads: Option<u16>,
    /// The cache.
    #[command(flatten)]
    pub(crate) kept: CacheArgs,
    /// Print the numbers as one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of `check`.
#[derive(Debug, clap::Args)]
pub(crate) struct CheckArgs {
    /// The model file.
    pub(crate) model: PathBuf,
    /// Another value for a parameter, as `l31=700mm` (again for more).
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,
    /// Print the findings as one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of `solids`.
#[derive(Debug, clap::Args)]
pub(crate) struct SolidsArgs {
    /// The model file.
    pub(crate) model: PathBuf,
    /// Another value for a parameter, as `l31=700mm` (again for more).
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,
    /// Where to write; `results/<model name>/solids` unless given.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// What to write, comma between; both unless given.
    #[arg(long, value_name = "FORMATS", value_enum, value_delimiter = ',')]
    pub(crate) format: Vec<SolidFormat>,
    /// Print the masses as one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Arguments of `new`.
#[derive(Debug, clap::Args)]
pub(crate) struct NewArgs {
    /// Name of the machine; the file is NAME.toml.
    pub(crate) name: PathBuf,
    /// Replace a file that is already there.
    #[arg(long)]
    pub(crate) force: bool,
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_definitions_do_not_contradict_each_other() {
        super::Args::command().debug_assert();
    }
}
