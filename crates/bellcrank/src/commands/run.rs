//! `bellcrank run`: the studies of a model, and what they leave.

use std::path::{Path, PathBuf};

use bellcrank_model::{Model, PartFile, PartFormat, RunError, RunOptions};
use bellcrank_report::{study_folders, terminal_summary};
use bellcrank_results::{RunResult, run_summary};

use crate::config::{Printed, RunConfig};
use crate::console::Console;
use crate::exit::{Exit, Refusal};
use crate::improvement::Improvement;
use crate::interrupt::Interrupt;
use crate::loading::{Shown, open};
use crate::progress::Watch;
use crate::staging::Staging;

/// Runs the studies, writes their files, prints their summary.
pub(crate) fn run(config: &RunConfig, console: &Console) -> Result<Exit, Refusal> {
    let model = open(&config.model, &config.settings, shown(config.printed), console)?;
    refuse_unknown(&model, &config.studies)?;
    let improvement = Improvement::prepare(config, &model)?;
    let out = config.out.clone().unwrap_or_else(|| default_out(&model));
    let interrupt = Interrupt::listen();
    let staging = Staging::prepare(&out)?;
    let watch = Watch::new(interrupt.clone(), config.printed, *console);
    let mut result = compute(&model, config, &out, watch)?;
    let written = improvement.map_or(Ok(()), |improvement| improvement.write(&model, &mut result));
    let files =
        staging.publish(&result, config.exports)? + staging.put(&part_files(&model, &result, config, console))?;
    tell(&result, &out, files, config.printed, console)?;
    let exit = exit(&result, &interrupt);
    // A search that failed or was stopped has an exit code of its own.
    written.map(|()| exit).map_err(|why| if exit == Exit::Done { why } else { Refusal { exit, ..why } })
}

fn shown(printed: Printed) -> Shown {
    match printed {
        Printed::Summary => Shown::All,
        Printed::Json => Shown::Json,
        Printed::Nothing => Shown::Errors,
    }
}

fn default_out(model: &Model) -> PathBuf {
    Path::new("results").join(model.name())
}

/// Before anything is made on disk.
fn refuse_unknown(model: &Model, studies: &[String]) -> Result<(), Refusal> {
    studies.iter().try_for_each(|study| model.runs(study)).map_err(refusal)
}

fn refusal(error: RunError) -> Refusal {
    Refusal { exit: Exit::CommandLine, message: error.to_string(), hints: error.hints() }
}

fn compute(model: &Model, config: &RunConfig, out: &Path, mut watch: Watch) -> Result<RunResult, Refusal> {
    let (threads, meshes, fresh) = (config.threads, config.meshes, config.fresh);
    let options = RunOptions { threads, folder: Some(out.to_owned()), meshes, fresh, cache: config.cache.clone() };
    let result = model.run_all(&config.studies, &options, &mut watch);
    watch.finish();
    result.map_err(refusal)
}

/// The solids at the model's own parameters, and for each study their assembly at its first row.
fn part_files(model: &Model, result: &RunResult, config: &RunConfig, console: &Console) -> Vec<PartFile> {
    if config.parts == PartFormat::default() {
        return Vec::new();
    }
    let solids = Path::new("solids");
    let parts = model.part_files(config.parts).into_iter();
    let mut files: Vec<PartFile> = parts.map(|file| PartFile { path: solids.join(&file.path), ..file }).collect();
    if files.is_empty() {
        console.say("warning: no body has a solid, so there is none to export\n");
    }
    if config.parts.step {
        let assemblies = result.studies.iter().zip(study_folders(result)).filter_map(|(study, folder)| {
            let bytes = model.assembly_of(study)?;
            Some(PartFile { path: Path::new(&folder).join("assembly.step"), bytes })
        });
        files.extend(assemblies);
    }
    files
}

fn tell(result: &RunResult, out: &Path, files: usize, printed: Printed, console: &Console) -> Result<(), Refusal> {
    match printed {
        Printed::Summary => {
            let summary = terminal_summary(result, &console.style());
            console.print(&format!("{summary}\n{}\n", whereabouts(out, files)))
        }
        Printed::Json => {
            tell_failures(result, console);
            console.print(&format!("{:#}\n", run_summary(result)))
        }
        Printed::Nothing => {
            tell_failures(result, console);
            Ok(())
        }
    }
}

fn whereabouts(out: &Path, files: usize) -> String {
    let files = if files == 1 { "1 file".to_owned() } else { format!("{files} files") };
    format!("{files} in {}; open {}", out.display(), out.join("report.html").display())
}

/// The summary for people says these itself.
fn tell_failures(result: &RunResult, console: &Console) {
    for study in &result.studies {
        if let Some(failure) = &study.failure {
            console.error(&failure.message, &failure.hints);
        }
    }
}

fn exit(result: &RunResult, interrupt: &Interrupt) -> Exit {
    if interrupt.pressed() {
        Exit::Interrupted
    } else if result.studies.iter().any(|study| study.failure.is_some()) {
        Exit::Mathematics
    } else {
        Exit::Done
    }
}
