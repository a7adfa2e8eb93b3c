//! Studies of bodies as elastic parts: stress with its error, and natural frequencies.
//!
//! Reading order: [`acting`] (what a machine puts on a body, row by row), [`meshing`] (from its solid to a mesh),
//! [`regions`] (where stress is looked for), [`problem`] (both together, for the solver), [`worst`] (the row that
//! counts), [`stress`] (solutions on finer and finer meshes), [`modes`].

mod acting;
mod faults;
mod files;
mod memory;
mod meshing;
mod modes;
mod pictures;
mod problem;
mod regions;
mod spots;
mod stress;
pub(crate) mod stroke;
mod vector;
mod watched;
mod worst;

use std::time::Instant;

use bellcrank_results::{Failure, Findings, StudyResult};

use crate::design::{Design, PartQuestion, Parts, Study};
use crate::model::parameter_row;
use crate::progress::Progress;
use crate::{MeshFormats, RunOptions};

pub(crate) use faults::Words;
pub(crate) use memory::{allowed, most_nodes};
pub(crate) use meshing::{ENDS, Solid};
pub(crate) use problem::{material_of, near};
pub(crate) use watched::watched;

/// Why a study ends early.
pub(crate) type End = Box<Failure>;

/// A study of parts with everything around it.
#[derive(Clone, Copy)]
struct Asked<'d> {
    design: &'d Design,
    study: &'d Study,
    parts: &'d Parts,
    /// Threads to use.
    threads: usize,
    /// Files that were asked for.
    meshes: MeshFormats,
}

/// Runs a study of parts; `studies` are all of the model.
pub(crate) fn run(
    design: &Design,
    studies: &[Study],
    study: &Study,
    parts: &Parts,
    options: &RunOptions,
    progress: &mut dyn Progress,
) -> StudyResult {
    let begun = Instant::now();
    let changed = study.changed.iter().filter_map(|&i| parameter_row(design, &study.parameters, i, "")).collect();
    let mut result =
        StudyResult { name: study.name.clone(), kind: study.kind.to_owned(), changed, ..StudyResult::default() };
    let threads = match options.threads {
        0 => std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
        threads => threads,
    };
    let asked = Asked { design, study, parts, threads, meshes: options.meshes };
    let end = match &parts.question {
        PartQuestion::Stress(form) => {
            let of = form.of.as_ref().and_then(|name| studies.iter().find(|other| &other.name == name));
            stress::run(&asked, form, of, &mut result, progress)
        }
        PartQuestion::Modes(form) => modes::run(&asked, form, &mut result, progress),
    };
    if let Err(failure) = end {
        result.failure = Some(named(study, *failure));
    }
    result.seconds = begun.elapsed().as_secs_f64();
    result
}

fn named(study: &Study, failure: Failure) -> Failure {
    let named = failure.message.starts_with("study `");
    let message = if named { failure.message } else { format!("study `{}`: {}", study.name, failure.message) };
    Failure { message, hints: failure.hints }
}

pub(crate) fn ended(message: impl Into<String>, hint: impl Into<String>) -> End {
    let hint: String = hint.into();
    let hints = if hint.is_empty() { Vec::new() } else { vec![hint] };
    Box::new(Failure { message: message.into(), hints })
}

/// What ends a study when its reader has had enough.
fn cancelled(done: &str) -> End {
    ended(format!("stopped by the user {done}"), "")
}

/// The finding of a study of stress, made when there is a first body.
fn stress_finding(
    result: &mut StudyResult,
    new: impl FnOnce() -> bellcrank_results::Stress,
) -> &mut bellcrank_results::Stress {
    if !matches!(result.findings, Some(Findings::Stress(_))) {
        result.findings = Some(Findings::Stress(new()));
    }
    match &mut result.findings {
        Some(Findings::Stress(found)) => found,
        _ => unreachable!("it was made above"),
    }
}
