//! What forward dynamics asks for and answers: the door that other crates use.
//!
//! After [`crate::Engine::assemble`] comes [`crate::Forward::begin`], then [`crate::Forward::advance`] from output to
//! output. Whatever the steps of the integrator, the readings are those of the time that `advance` tells: positions
//! and velocities that meet every constraint, and the accelerations and forces that go with them.

use crate::{Coordinate, ForceId, MechanismError, Reading, Readings, Seeded};

/// How a machine is let go.
#[derive(Clone, Debug)]
pub struct Dynamics {
    /// Coordinates whose motion is given by [`Surroundings::drives`]; their efforts are found. The rest is free.
    pub driven: Vec<Coordinate>,
    /// Velocities at time 0, SI. Those of the other coordinates of the tree are as small as constraints and drives
    /// allow (least squares, rad/s and machine sizes a second).
    pub velocities: Vec<(Coordinate, f64)>,
    /// Local error of a step that is put up with: relative to positions and velocities, and absolute with 1 rad or
    /// the machine's size as unit.
    pub tolerance: f64,
    /// How time is stepped.
    pub method: Method,
    /// Step, s, taken throughout (cut only at outputs of no step, breaks and events); `None` lets the error choose it.
    pub fixed_step: Option<f64>,
    /// No step is longer, s.
    pub largest_step: f64,
    /// Times at which drives or forces are not smooth, ascending, s: no step passes over them. The last one should be
    /// the end of the run.
    pub breaks: Vec<f64>,
    /// How many [`Surroundings::switches`] are watched.
    pub switches: usize,
}

/// How time is stepped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Explicit until the machine turns out stiff, generalized-α from then on.
    Automatic,
    /// Runge–Kutta of order 8 (Dormand & Prince; Hairer, Nørsett & Wanner 1993) with projection on the constraints.
    Explicit,
    /// Generalized-α on the Lie group of the joint coordinates (Arnold & Brüls 2007), stabilized index 2.
    GeneralizedAlpha {
        /// Spectral radius at infinite frequency, 0 (strong damping of what is not resolved) to 1 (none).
        spectral_radius: f64,
    },
}

/// What the machine is surrounded by: it answers for numbers that others own.
pub trait Surroundings {
    /// Values of [`crate::Value::Input`]; positions and velocities may be read.
    fn inputs(&mut self, at: &dyn Readings<f64>, values: &mut [f64]);
    /// The same with derivatives.
    fn exact_inputs(&mut self, at: &dyn Readings<Seeded>, values: &mut [Seeded]);
    /// Motion of the driven coordinates at a time, in the order of [`Dynamics::driven`].
    fn drives(&mut self, time: f64, motion: &mut [Reading]);
    /// Functions whose change of sign is an event; positions, velocities, accelerations and forces may be read.
    fn switches(&mut self, at: &dyn Readings<f64>, values: &mut [f64]);
}

/// Where a machine begins.
#[derive(Clone, Debug, Default)]
pub struct Begun {
    /// Degrees of freedom that the drives leave.
    pub freedom: usize,
    /// Equations that depend on others.
    pub redundant: Vec<crate::Redundancy>,
    /// Energy at the start, J.
    pub energy: f64,
}

/// How far an advance got; the readings are those of there.
#[derive(Clone, Debug, PartialEq)]
pub enum Advance {
    /// The time asked for.
    Reached,
    /// An event lies before it; the readings are those right after.
    Event(Event),
    /// Work for a while was done and the time is not reached: ask again.
    Working,
}

/// Something happened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Event {
    /// s.
    pub time: f64,
    /// What.
    pub kind: EventKind,
}

/// What happened.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EventKind {
    /// A function of [`Surroundings::switches`] changed its sign.
    Switch {
        /// Which.
        index: usize,
        /// From negative to positive.
        rising: bool,
    },
    /// A hard stop was hit and thrown back.
    Impact {
        /// The stop.
        force: ForceId,
        /// At its upper limit.
        upper: bool,
        /// Speed against the stop before, m/s or rad/s.
        speed: f64,
        /// Impulse of the stop, N·s or N·m·s.
        impulse: f64,
    },
    /// A stop is touched and stays touched (hard), or begins to push (soft).
    Contact {
        /// The stop.
        force: ForceId,
        /// At its upper limit.
        upper: bool,
    },
    /// A stop is left.
    Release {
        /// The stop.
        force: ForceId,
        /// At its upper limit.
        upper: bool,
    },
    /// Friction holds the coordinate from now on.
    Stick {
        /// The friction.
        force: ForceId,
    },
    /// Friction gives way, or the slip turns round.
    Slip {
        /// The friction.
        force: ForceId,
        /// The coordinate goes up.
        rising: bool,
    },
}

/// Work done since [`crate::Forward::begin`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SolverEffort {
    /// Accepted steps.
    pub steps: usize,
    /// Steps taken back.
    pub rejected: usize,
    /// Accelerations from forces.
    pub evaluations: usize,
    /// Newton iterations of the implicit method.
    pub newton_iterations: usize,
    /// Matrices factored.
    pub factorizations: usize,
    /// Jacobians of the forces.
    pub jacobians: usize,
    /// Projections on the constraints.
    pub projections: usize,
    /// Steps of the implicit method among the accepted ones.
    pub implicit_steps: usize,
}

/// A mode of the machine, linearized about its present position.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Real and imaginary part of the eigenvalue, 1/s; imaginary part not negative.
    pub eigenvalue: [f64; 2],
    /// Undamped natural frequency, Hz: the eigenvalue's size over 2π.
    pub frequency: f64,
    /// Damping ratio: −Re/|λ|; 1 and more is not told apart.
    pub damping: f64,
}

/// The machine linearized about its present position.
#[derive(Clone, Debug, Default)]
pub struct Linearized {
    /// Degrees of freedom that the drives leave.
    pub freedom: usize,
    /// Slowest first. A machine with n degrees of freedom has 2n eigenvalues; of a conjugate pair one is kept.
    pub modes: Vec<Mode>,
    /// Largest generalized force left unbalanced, N or N·m: a linearization is one about equilibrium where this is 0.
    pub unbalanced: f64,
}

impl Dynamics {
    /// Freely from rest with the tolerance 1e-6.
    pub fn free() -> Self {
        Self {
            driven: Vec::new(),
            velocities: Vec::new(),
            tolerance: 1e-6,
            method: Method::Automatic,
            fixed_step: None,
            largest_step: f64::INFINITY,
            breaks: Vec::new(),
            switches: 0,
        }
    }
}

/// A machine that can be let go.
pub trait Forward {
    /// Consistent velocities, accelerations and multipliers at time 0, from the assembled position.
    ///
    /// # Errors
    /// Where drives conflict, velocities do not fit the constraints, or a mass is missing.
    fn begin(&mut self, dynamics: &Dynamics, around: &mut dyn Surroundings) -> Result<Begun, MechanismError>;
    /// On to a time, or to the next event before it.
    ///
    /// # Errors
    /// Where the step size collapses, a number is not finite, or friction does not settle.
    fn advance(&mut self, until: f64, around: &mut dyn Surroundings) -> Result<Advance, MechanismError>;
    /// Work done since [`Forward::begin`].
    fn solver_effort(&self) -> SolverEffort;
    /// Natural frequencies and damping about the present position (best an equilibrium), the driven coordinates held.
    ///
    /// # Errors
    /// Where the position is singular or a free coordinate carries no mass.
    fn linearize(&mut self, driven: &[Coordinate], around: &mut dyn Surroundings)
    -> Result<Linearized, MechanismError>;
    /// Puts the shape of a mode into the velocities: those of coordinates, points and bodies are its amplitudes then
    /// (largest coordinate 1), at a phase of the oscillation, rad.
    fn show_mode(&mut self, mode: usize, phase: f64);
}
