//! Studies of a checked model.

use bellcrank_doc::{ParameterSet, Span};
use bellcrank_multibody::Coordinate;

use super::{Ask, Dynamics, Modes, Parts, Quantity, Values};
use crate::schema::AVAILABLE;

/// A study.
#[derive(Debug)]
pub(crate) struct Study {
    pub(crate) name: String,
    pub(crate) span: Span,
    /// As in the file.
    pub(crate) kind: &'static str,
    pub(crate) task: Task,
    /// Bodies that are flexible are so in it.
    pub(crate) flexible: bool,
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
    /// Motion from forces.
    Dynamics(Box<Dynamics>),
    /// How the machine rings about a position.
    Modes(Modes),
    /// Stress or natural frequencies of bodies as elastic parts.
    Parts(Box<Parts>),
    /// Something asked of another study.
    Ask(Box<Ask>),
    /// Checked, not run in this version: a study of a later kind, or one that asks such a study.
    Later,
}

/// What this version lacks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Missing {
    /// Studies of its kind.
    Kind,
    /// Its question to the study that it asks, which is one of dynamics.
    Question,
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
    /// Where the study names it.
    pub(crate) span: Span,
}

impl Study {
    /// The swept coordinate; none where the rows run over time, or there is one.
    pub(crate) fn axis(&self) -> Option<Coordinate> {
        match &self.task {
            Task::Motion { over: Over::Positions { sweep, .. }, .. } | Task::Statics { sweep: Some(sweep), .. } => {
                Some(sweep.coordinate)
            }
            Task::Modes(of) => of.sweep.as_ref().map(|sweep| sweep.coordinate),
            _ => None,
        }
    }

    /// Why this version does not run it.
    pub(crate) fn missing(&self) -> Option<Missing> {
        match self.task {
            Task::Later if AVAILABLE.contains(&self.kind) => Some(Missing::Question),
            Task::Later => Some(Missing::Kind),
            _ => None,
        }
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
        self.prescribed().0
    }

    /// The motions that act in it, and the coordinates that rest.
    pub(crate) fn prescribed(&self) -> (&[usize], &[Hold]) {
        match self {
            Task::Motion { over: Over::Time { motions, .. }, holds, .. } | Task::Statics { motions, holds, .. } => {
                (motions, holds)
            }
            Task::Motion { over: Over::Positions { .. }, holds, .. } => (&[], holds),
            Task::Dynamics(of) => (&of.motions, &of.holds),
            Task::Modes(of) => (&of.motions, &of.holds),
            Task::Parts(_) | Task::Ask(_) | Task::Later => (&[], &[]),
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
            Task::Dynamics(of) => of.each_quantity(visit),
            Task::Modes(of) => {
                if let Some(sweep) = &of.sweep {
                    sweep.each_quantity(visit);
                }
                of.holds.iter().filter_map(|hold| hold.at.as_ref()).for_each(visit);
            }
            Task::Parts(of) => of.each_quantity(visit),
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
