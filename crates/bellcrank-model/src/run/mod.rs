//! Running studies: the loop, what is recorded, and what is said when something fails.

mod animation;
mod course;
mod dynamics;
mod energy;
mod events;
mod explain;
pub(crate) mod inputs;
mod modes;
mod motion;
mod notes;
mod programme;
mod recorder;
mod session;
mod statics;
mod surroundings;

use std::time::Instant;

use bellcrank_results::StudyResult;

use crate::design::{Design, Study, Task};
use crate::progress::Progress;
use session::{Session, Watch};

pub(crate) use animation::arrows;
pub(crate) use course::{Assembly, Course, Laws, Path, Targets};
pub(crate) use explain::{Namer, Places, failure, shown};
pub(crate) use inputs::{Evaluated, Inputs};
pub(crate) use programme::programme;

/// Runs a study that gives rows. What goes wrong is in the result.
pub(crate) fn run(design: &Design, study: &Study, progress: &mut dyn Progress) -> StudyResult {
    run_watched(design, study, progress, Box::new(|_, _| {}))
}

/// The same, with somebody who is told of every row.
pub(crate) fn run_watched(
    design: &Design,
    study: &Study,
    progress: &mut dyn Progress,
    watch: Watch<'_>,
) -> StudyResult {
    let begun = Instant::now();
    let ready = crate::flex::prepare(design, study, progress);
    let ready = ready.and_then(|notes| Ok((notes, Session::new(design, study, study.flexible)?)));
    let mut result = match ready {
        Ok((notes, session)) => {
            let mut session = session.watched(watch);
            session.result.warnings.extend(notes);
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

fn execute<'d>(session: &mut Session<'d>, study: &'d Study, progress: &mut dyn Progress) -> Result<(), End> {
    match &study.task {
        Task::Motion { over, holds, .. } => motion::run(session, over, holds, progress),
        Task::Statics { sweep, holds, motions } => statics::run(session, sweep.as_ref(), holds, motions, progress),
        Task::Dynamics(of) => dynamics::run(session, of, progress),
        Task::Modes(of) => modes::run(session, of, progress),
        // Those that ask are run elsewhere.
        Task::Parts(_) | Task::Ask(_) | Task::Later => Ok(()),
    }
}
