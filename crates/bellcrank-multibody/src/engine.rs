//! What a mechanism in motion answers, in plain numbers: the door that other crates use.
//!
//! The order of calls is that of the mathematics: [`Engine::assemble`], [`Engine::prepare`], then for
//! each position [`Engine::move_to`], [`Engine::set_rates`], [`Engine::solve_forces`]. Asking for a
//! stage that was not computed is a debug failure.

use crate::{BodyId, Coordinate, ForceId, JointId, MechanismError};

/// Which coordinates are prescribed in position, which in rate, and which carry the efforts.
///
/// A sweep by θ₃ with the drive at the cylinder has `position = [θ₃]`, `rate = effort = [slide]`.
/// Each list has as many members as the mechanism has degrees of freedom.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Actuation {
    /// Prescribed positions, in the order of the targets of [`Engine::move_to`].
    pub position: Vec<Coordinate>,
    /// Prescribed velocities and accelerations, in the order of [`Engine::set_rates`].
    pub rate: Vec<Coordinate>,
    /// Coordinates whose efforts balance the machine, in the order of [`Engine::drive`].
    pub effort: Vec<Coordinate>,
}

/// What assembly found.
#[derive(Clone, Debug)]
pub struct Assembled {
    /// Largest loop-closure error, m (angles times the machine's size).
    pub closure: f64,
    /// Newton iterations taken.
    pub iterations: usize,
    /// Random restarts that were needed.
    pub restarts: usize,
}

/// How a move went.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moved {
    /// Newton iterations.
    pub iterations: usize,
    /// Substeps (1 when the step was taken whole).
    pub steps: usize,
    /// The sign of the position system's determinant changed: a change point was passed.
    pub passed_change_point: bool,
    /// The sign of the drive system's determinant changed at the last `set_rates`: a dead position lies between.
    pub passed_dead_position: bool,
}

/// Position, velocity and acceleration of a coordinate, SI.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    /// m or rad.
    pub position: f64,
    /// m/s or rad/s.
    pub velocity: f64,
    /// m/s² or rad/s².
    pub acceleration: f64,
}

/// Motion of a point, world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointMotion {
    /// m.
    pub position: [f64; 3],
    /// m/s.
    pub velocity: [f64; 3],
    /// m/s².
    pub acceleration: [f64; 3],
}

/// Motion of a body, world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyMotion {
    /// Origin of the body frame, m.
    pub origin: [f64; 3],
    /// Rotation matrix (rows), body to world.
    pub rotation: [[f64; 3]; 3],
    /// Angular velocity, rad/s.
    pub omega: [f64; 3],
    /// Angular acceleration, rad/s².
    pub alpha: [f64; 3],
    /// Motion of the centre of mass.
    pub center: PointMotion,
}

/// Force and moment, world axes, N and N·m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench {
    /// N.
    pub force: [f64; 3],
    /// N·m.
    pub moment: [f64; 3],
}

/// A force element's own outputs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ForceOutput {
    /// Length of a spring, coordinate of a joint element, m or rad; `NaN` where there is none.
    pub length: f64,
    /// Its rate; `NaN` where there is none.
    pub rate: f64,
    /// Effort: along the length or coordinate; the magnitude for forces, torques and bushings, N or N·m.
    pub effort: f64,
    /// Force (N, or N·m for a torque) on the point or body it acts on (the second of two), world axes.
    pub vector: [f64; 3],
}

/// Energies, J. Potential energy counts weights and springs with constant data.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Kinetic.
    pub kinetic: f64,
    /// Potential.
    pub potential: f64,
}

/// Trust in the present solution.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Checks {
    /// Largest loop-closure error, m (angles times the machine's size).
    pub closure: f64,
    /// Power-balance residual relative to the sum of forces times speeds in it; `NaN` before the forces are solved.
    pub balance: f64,
}

/// Degrees of freedom, counted and computed.
#[derive(Clone, Debug, Default)]
pub struct Freedom {
    /// Coordinates of the spanning tree.
    pub coordinates: usize,
    /// Equations of the loops and couplings.
    pub equations: usize,
    /// Independent ones among them at the present position.
    pub rank: usize,
    /// Joint freedoms counted (Grübler/Kutzbach): `coordinates − equations`; may be negative.
    pub counted: i64,
    /// Degrees of freedom: `coordinates − rank`.
    pub degrees: usize,
    /// Loops.
    pub loops: usize,
    /// Joints that close them.
    pub closing: Vec<JointId>,
    /// Equations that depend on others.
    pub redundant: Vec<Redundancy>,
    /// Rank at a nearby position differs: the present position is special.
    pub special: bool,
    /// Coordinates able to move, most mobile first.
    pub mobile: Vec<Coordinate>,
}

/// A constraint equation that takes part in a dependency.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Redundancy {
    /// The joint it belongs to.
    pub joint: JointId,
    /// Which of the joint's equations, in words (`"along x"`, `"turning about y"`, ...).
    pub equation: &'static str,
}

/// An equilibrium and its stability.
#[derive(Clone, Debug)]
pub struct Equilibrium {
    /// Newton iterations.
    pub iterations: usize,
    /// Largest unbalanced generalized force left, N or N·m.
    pub residual: f64,
    /// Eigenvalues (real parts) of the stiffness in the free directions, SI; all positive is stable.
    pub stiffness: Vec<f64>,
    /// All eigenvalues positive.
    pub stable: bool,
}

/// A mechanism in motion.
pub trait Engine: Send {
    /// Finds a position that closes all loops near the starts; coordinates in `hold` are met exactly.
    fn assemble(&mut self, hold: &[(Coordinate, f64)]) -> Result<Assembled, MechanismError>;
    /// Degrees of freedom at the present position.
    fn freedom(&mut self) -> Freedom;
    /// Chooses what is prescribed; checks that it takes every degree of freedom, no more.
    fn prepare(&mut self, actuation: &Actuation) -> Result<(), MechanismError>;
    /// Moves the position coordinates to `targets` (SI), keeping the branch; stops where it cannot go on.
    fn move_to(&mut self, time: f64, targets: &[f64]) -> Result<Moved, MechanismError>;
    /// Velocities and accelerations from those of the rate coordinates (SI).
    fn set_rates(&mut self, velocity: &[f64], acceleration: &[f64]) -> Result<Moved, MechanismError>;
    /// Drive efforts and reactions. `inputs` is asked once, after the rates are known, for the values of
    /// [`crate::Value::Input`].
    fn solve_forces(&mut self, inputs: &mut dyn FnMut(&dyn Engine, &mut [f64])) -> Result<(), MechanismError>;
    /// Equilibrium at rest with the coordinates in `hold` fixed; afterwards the position is there and the
    /// reactions are solved.
    fn equilibrium(
        &mut self,
        hold: &[(Coordinate, f64)],
        inputs: &mut dyn FnMut(&dyn Engine, &mut [f64]),
    ) -> Result<Equilibrium, MechanismError>;
    /// For each joint, whether fx, fy, fz, mx, my, mz of its reaction are determined by equilibrium alone.
    fn uniqueness(&mut self) -> Vec<[bool; 6]>;

    /// Present time, s.
    fn time(&self) -> f64;
    /// Number of coordinates that a joint shows.
    fn coordinates_of(&self, joint: JointId) -> usize;
    /// Motion of a joint coordinate.
    fn coordinate(&self, c: Coordinate) -> Reading;
    /// Motion of a point given in body axes, m.
    fn point(&self, body: BodyId, at: [f64; 3]) -> PointMotion;
    /// Motion of a body.
    fn body(&self, body: BodyId) -> BodyMotion;
    /// What the first body puts on the second through the joint, about the origin of the second place.
    /// A coupler answers its effort on b as the first component of the force.
    fn reaction(&self, joint: JointId) -> Wrench;
    /// Effort along effort coordinate `i`, positive when it pushes the coordinate up, N or N·m.
    fn drive(&self, i: usize) -> f64;
    /// A force element's outputs.
    fn force(&self, force: ForceId) -> ForceOutput;
    /// Energies.
    fn energy(&self) -> Energy;
    /// Trust.
    fn checks(&self) -> Checks;
}
