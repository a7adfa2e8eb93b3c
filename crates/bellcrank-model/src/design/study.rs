//! Studies of a checked model.

use bellcrank_doc::{ParameterSet, Span};
use bellcrank_multibody::Coordinate;

use super::{Ask, Quantity, Values};
use crate::schema::AVAILABLE;

/// A study.
#[derive(Debug)]
pub(crate) struct Study {
    pub(crate) name: String,
    pub(crate) span: Span,
    /// As in the file.
    pub(crate) kind: &'static str,
    pub(crate) task: Task,
    /// The main file's parameters in this study.
    pub(crate) parameters: ParameterSet,
    /// Parameters that differ from the model's.
    pub(crate) changed: Vec<usize>,
    /// Parameters that it names or uses otherwise (`parameters`, `variables`, `response`).
    pub(crate) named: Vec<usize>,
    pub(crate) values: Values,
}

/// What a study does.
#[derive(Clone, Debug)]
pub(crate) enum Task {
    /// Motion, with forces when asked.
    Motion { forces: bool, over: Over, holds: Vec<Hold> },
    /// Equilibrium, at each position of a held coordinate when swept.
    Statics { sweep: Option<Sweep>, holds: Vec<Hold>, motions: Vec<usize> },
    /// Something asked of another study.
    Ask(Box<Ask>),
    /// Checked, not run in this version: a study of a later kind, or one that asks such a study.
    Later,
}

/// A swept coordinate.
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    pub(crate) coordinate: Coordinate,
    pub(crate) from: Quantity,
    pub(crate) to: Quantity,
    pub(crate) points: usize,
}

/// What the rows of a study run over.
#[derive(Clone, Debug)]
pub(crate) enum Over {
    Positions { sweep: Sweep, drive: Coordinate, velocity: Option<Quantity>, acceleration: Option<Quantity> },
    Time { duration: Quantity, step: Quantity, motions: Vec<usize>, drives: Option<Vec<Coordinate>> },
}

/// A coordinate that rests, at its start unless a place is given.
#[derive(Clone, Debug)]
pub(crate) struct Hold {
    pub(crate) coordinate: Coordinate,
    pub(crate) at: Option<Quantity>,
}

impl Study {
    /// The swept coordinate; none where the rows run over time, or there is one.
    pub(crate) fn axis(&self) -> Option<Coordinate> {
        match &self.task {
            Task::Motion { over: Over::Positions { sweep, .. }, .. } | Task::Statics { sweep: Some(sweep), .. } => {
                Some(sweep.coordinate)
            }
            _ => None,
        }
    }

    /// The kind that this version would have to run for this study, but does not: its own, or that of the study it
    /// asks.
    pub(crate) fn missing_kind(&self) -> Option<&'static str> {
        let asks = AVAILABLE.contains(&self.kind);
        // Of the kinds that can be asked, one is missing.
        matches!(self.task, Task::Later).then_some(if asks { "dynamics" } else { self.kind })
    }
}

impl Sweep {
    fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        visit(&self.from);
        visit(&self.to);
    }
}

impl Task {
    /// The motions that act, by their places in the design.
    pub(crate) fn motions(&self) -> &[usize] {
        match self {
            Task::Motion { over: Over::Time { motions, .. }, .. } | Task::Statics { motions, .. } => motions,
            _ => &[],
        }
    }

    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        match self {
            Task::Motion { over, holds, .. } => {
                over.each_quantity(visit);
                holds.iter().filter_map(|hold| hold.at.as_ref()).for_each(visit);
            }
            Task::Statics { sweep, holds, .. } => {
                if let Some(sweep) = sweep {
                    sweep.each_quantity(visit);
                }
                holds.iter().filter_map(|hold| hold.at.as_ref()).for_each(visit);
            }
            // Its expressions are over the main file's parameters; `Study::named` has them.
            Task::Ask(_) | Task::Later => {}
        }
    }
}

impl Over {
    fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        match self {
            Over::Positions { sweep, velocity, acceleration, .. } => {
                sweep.each_quantity(visit);
                [velocity, acceleration].into_iter().flatten().for_each(visit);
            }
            Over::Time { duration, step, .. } => [duration, step].into_iter().for_each(visit),
        }
    }
}
