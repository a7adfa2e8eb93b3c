//! A machine that was let go: what is prescribed, what is locked, and where the integrator stands.

use super::articulated::Articulated;
use super::door::{Dynamics, Event, Mode, SolverEffort};
use super::implicit::Alpha;
use super::locks::Act;
use super::mixing::Mixing;
use super::saddle::Saddle;
use super::step::Step;
use super::stiffness::Jacobian;
use super::watch::Watching;
use crate::Reading;
use crate::mass_matrix::MassMatrix;
use crate::mechanism::Source;
use bellcrank_math::Space;

/// A coordinate that an element holds still: by friction, or at a stop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lock {
    /// The element.
    pub(crate) element: usize,
    pub(crate) source: Source,
    /// Where it is held.
    pub(crate) at: f64,
}

/// State of a run in time.
#[derive(Debug)]
pub(crate) struct Flight<S: Space<T = f64>> {
    pub(crate) dynamics: Dynamics,
    pub(crate) mass: MassMatrix<S>,
    pub(crate) saddle: Saddle,
    /// Takes the place of `mass` and `saddle` in long trees that nothing constrains.
    pub(crate) tree: Option<Articulated>,
    /// Equations depend on each other.
    pub(crate) redundant: bool,
    /// Driven coordinates, and their motion at the present time.
    pub(crate) driven: Vec<Source>,
    pub(crate) drive: Vec<Reading>,
    pub(crate) locks: Vec<Lock>,
    /// What each force element does.
    pub(crate) acts: Vec<Act>,
    /// Whether the drives leave the coordinate of each stop and friction free to move.
    pub(crate) movable: Vec<bool>,
    pub(crate) watching: Watching,
    pub(crate) storm: Storm,
    pub(crate) jacobian: Jacobian<S>,
    pub(crate) alpha: Alpha,
    /// Positions, velocities and accelerations of all that is prescribed: driven, then locked.
    pub(crate) target: Vec<f64>,
    pub(crate) velocity: Vec<f64>,
    pub(crate) acceleration: Vec<f64>,
    /// Right sides and multipliers, one a row.
    pub(crate) gamma: Vec<f64>,
    pub(crate) mu: Vec<f64>,
    /// Friction efforts on their way to consistency, and before the last iteration.
    pub(crate) mixing: Mixing,
    pub(crate) before: Vec<f64>,
    /// Right side over velocity components.
    pub(crate) load: Vec<f64>,
    /// The step at hand.
    pub(crate) step: Step,
    /// Events at the end of the step that were not told yet, the next one last.
    pub(crate) pending: Vec<Event>,
    pub(crate) effort: SolverEffort,
    /// Modes of the last linearization, with their shapes over velocity components.
    pub(crate) modes: Vec<(Mode, Vec<[f64; 2]>)>,
}

/// Events within a short time.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Storm {
    since: f64,
    count: usize,
}

impl Storm {
    /// So many events that are too many.
    const MOST: usize = 300;
    /// Within so many seconds.
    const WITHIN: f64 = 1e-9;

    /// Counts events at a time; true where there are too many.
    pub(crate) fn count(&mut self, time: f64, events: usize) -> bool {
        if time - self.since > Self::WITHIN {
            *self = Self { since: time, count: 0 };
        }
        self.count += events;
        self.count > Self::MOST
    }
}
