//! Studies that ask something of another study: each kind is a file that answers a [`Question`](crate::design::Question)
//! with trials of designs.

mod active;
mod asking;
mod designs;
mod optimize;
mod sensitivity;
mod sizing;
mod tolerance;

use std::time::Instant;

use bellcrank_results::{Failure, StudyResult};

use crate::design::{Ask, Design, Question, Study};
use crate::flex;
use crate::model::parameter_row;
use crate::progress::Progress;
use crate::{RunOptions, trial::Undefined};

pub(crate) use asking::Asking;
pub(crate) use optimize::terms;

/// Runs an asking study; `studies` are all of the model.
pub(crate) fn run(
    design: &Design,
    studies: &[Study],
    study: &Study,
    ask: &Ask,
    options: &RunOptions,
    progress: &mut dyn Progress,
) -> StudyResult {
    let begun = Instant::now();
    let changed = study.changed.iter().filter_map(|&i| parameter_row(design, &study.parameters, i, "")).collect();
    let mut result =
        StudyResult { name: study.name.clone(), kind: study.kind.to_owned(), changed, ..StudyResult::default() };
    match studies.iter().find(|other| other.name == ask.of) {
        Some(of) => {
            let asking = Asking { design, study, of, ask, options };
            if let Err(why) = answer(&asking, &mut result, progress) {
                result.failure = Some(failed(study, why));
            }
            result.warnings.extend(differences(&asking));
        }
        None => result.failure = Some(failed(study, missing(ask))),
    }
    result.seconds = begun.elapsed().as_secs_f64();
    result
}

fn answer(asking: &Asking<'_>, result: &mut StudyResult, progress: &mut dyn Progress) -> Result<(), Undefined> {
    match &asking.ask.question {
        Question::Sensitivity(question) => sensitivity::run(asking, question, result, progress),
        Question::Optimize(question) => optimize::run(asking, question, result, progress),
        Question::Designs(question) => designs::run(asking, question, result, progress),
        Question::Tolerance(question) => tolerance::run(asking, question, result, progress),
        Question::Sizing(question) => sizing::run(asking, question, result, progress),
    }
}

/// What is said where derivatives are differences.
fn differences(asking: &Asking<'_>) -> Option<String> {
    let (design, study) = (asking.design, asking.study);
    let derives =
        matches!(asking.ask.question, Question::Sensitivity(_) | Question::Optimize(_) | Question::Tolerance(_));
    if !derives || !flex::applies(design, study) {
        return None;
    }
    let changes = |index: &usize| flex::changes(design, &study.parameters, *index);
    let names: Vec<String> = asking
        .ask
        .parameters()
        .into_iter()
        .filter(changes)
        .map(|index| format!("`{}`", asking.parameter(index).name))
        .collect();
    (!names.is_empty()).then(|| {
        format!(
            "derivatives by {} are differences over 2 % of the value: each makes another mesh of a flexible body",
            names.join(", ")
        )
    })
}

/// A model that was checked has the study; a fault of the program is told like any other.
fn missing(ask: &Ask) -> Undefined {
    Undefined { message: format!("there is no study `{}`", ask.of), hints: Vec::new() }
}

fn failed(study: &Study, why: Undefined) -> Failure {
    let named = why.message.starts_with("study `");
    let message = if named { why.message } else { format!("study `{}`: {}", study.name, why.message) };
    Failure { message, hints: why.hints }
}

/// What ends a study when its reader has had enough.
fn cancelled(done: &str) -> Undefined {
    Undefined { message: format!("stopped by the user {done}"), hints: Vec::new() }
}
