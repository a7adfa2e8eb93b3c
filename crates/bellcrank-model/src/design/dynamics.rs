//! Studies of a machine that is let go, and of how it rings.

use std::sync::Arc;

use bellcrank_doc::{Comparison, Span};

use super::{Hold, Quantity};
use crate::signals::Signal;

/// Motion in time from forces, with some coordinates driven.
#[derive(Clone, Debug)]
pub(crate) struct Dynamics {
    pub(crate) duration: Quantity,
    /// From row to row; a [`ROWS`]th of the duration unless given.
    pub(crate) output_step: Option<Quantity>,
    pub(crate) tolerance: Option<Quantity>,
    pub(crate) method: Stepping,
    pub(crate) spectral_radius: Option<Quantity>,
    /// A fixed step of the integration.
    pub(crate) step: Option<Quantity>,
    pub(crate) largest_step: Option<Quantity>,
    pub(crate) motions: Vec<usize>,
    pub(crate) holds: Vec<Hold>,
    /// Any of them ends the study.
    pub(crate) stop_when: Vec<StopWhen>,
    /// Signals in the conditions: an expression's signal `i` is the i-th.
    pub(crate) signals: Arc<[Signal]>,
}

/// Rows of a study without `output_step`, less one.
pub(crate) const ROWS: usize = 500;

/// How time is stepped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Stepping {
    Automatic,
    Explicit,
    GeneralizedAlpha,
}

/// A comparison at an instant.
#[derive(Clone, Debug)]
pub(crate) struct StopWhen {
    pub(crate) left: Quantity,
    pub(crate) comparison: Comparison,
    pub(crate) right: Quantity,
    pub(crate) written: String,
    pub(crate) span: Span,
}

/// Natural frequencies about a position.
#[derive(Clone, Debug)]
pub(crate) struct Modes {
    /// At equilibrium, or where assembly puts the machine.
    pub(crate) equilibrium: bool,
    pub(crate) holds: Vec<Hold>,
    pub(crate) motions: Vec<usize>,
    /// At each position of a held coordinate.
    pub(crate) sweep: Option<super::Sweep>,
    /// So many are told, the slowest first.
    pub(crate) count: Option<usize>,
}

impl Stepping {
    /// The method of a name of the format.
    pub(crate) fn named(word: &str) -> Stepping {
        match word {
            "explicit" => Stepping::Explicit,
            "generalized-alpha" => Stepping::GeneralizedAlpha,
            _ => Stepping::Automatic,
        }
    }
}

impl Dynamics {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        let Dynamics { output_step, tolerance, spectral_radius, step, largest_step, .. } = self;
        visit(&self.duration);
        [output_step, tolerance, spectral_radius, step, largest_step].into_iter().flatten().for_each(&mut *visit);
        self.holds.iter().filter_map(|hold| hold.at.as_ref()).for_each(&mut *visit);
        self.stop_when.iter().flat_map(|stop| [&stop.left, &stop.right]).for_each(visit);
    }
}
