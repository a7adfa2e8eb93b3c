//! Running studies: the loop, what is recorded, and what is said when something fails.

mod animation;
mod course;
mod explain;
pub(crate) mod inputs;
mod notes;
mod recorder;
mod session;
mod statics;
pub(crate) mod sweep;
pub(crate) mod time;

use std::time::Instant;

use bellcrank_results::StudyResult;

use crate::design::{Design, Over, Study, Task};
use crate::progress::Progress;
use session::Session;

pub(crate) use animation::arrows;
pub(crate) use course::{Assembly, Course, Laws, Path, Targets};
pub(crate) use explain::{Namer, failure, shown};
pub(crate) use inputs::{Evaluated, Inputs};

/// Runs a study that gives rows. What goes wrong is in the result.
pub(crate) fn run(design: &Design, study: &Study, progress: &mut dyn Progress) -> StudyResult {
    let begun = Instant::now();
    let mut result = match Session::new(design, study) {
        Ok(mut session) => {
            let end = execute(&mut session, study, progress);
            session.finish(end.err())
        }
        Err(failure) => StudyResult { failure: Some(*failure), ..StudyResult::default() },
    };
    result.name.clone_from(&study.name);
    study.kind.clone_into(&mut result.kind);
    result.seconds = begun.elapsed().as_secs_f64();
    result
}

/// Why a run ended early.
type End = Box<bellcrank_results::Failure>;

fn execute(session: &mut Session<'_>, study: &Study, progress: &mut dyn Progress) -> Result<(), End> {
    match &study.task {
        Task::Motion { over: Over::Positions { sweep, drive, velocity, acceleration }, holds, .. } => {
            let plan = sweep::Plan { sweep, drive: *drive, velocity, acceleration, holds };
            sweep::run(session, &plan, progress)
        }
        Task::Motion { over: Over::Time { duration, step, motions, drives }, holds, .. } => {
            let plan = time::Plan { duration, step, motions, drives: drives.as_deref(), holds };
            time::run(session, &plan, progress)
        }
        Task::Statics { sweep, holds, motions } => statics::run(session, sweep.as_ref(), holds, motions, progress),
        Task::Ask(_) | Task::Later => Ok(()),
    }
}
