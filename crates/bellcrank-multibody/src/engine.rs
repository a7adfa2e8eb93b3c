//! What a mechanism in motion answers, in plain numbers: the door that other crates use.
//!
//! The order of calls is that of the mathematics: [`Engine::assemble`], [`Engine::prepare`], then for
//! each position [`Engine::move_to`], [`Engine::set_rates`], [`Engine::solve_forces`]. Asking for a
//! stage that was not computed is a debug failure.

use crate::{Blueprint, BodyId, BuildError, Coordinate, ForceId, Forward, JointId, MechanismError};
use bellcrank_math::Dual;

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
    /// Coordinates whose efforts balance the machine, in the order of [`Readings::drive`].
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
pub struct Reading<T = f64> {
    /// m or rad.
    pub position: T,
    /// m/s or rad/s.
    pub velocity: T,
    /// m/s² or rad/s².
    pub acceleration: T,
}

/// Motion of a point, world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointMotion<T = f64> {
    /// m.
    pub position: [T; 3],
    /// m/s.
    pub velocity: [T; 3],
    /// m/s².
    pub acceleration: [T; 3],
}

/// Motion of a body, world axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyMotion<T = f64> {
    /// Origin of the body frame, m.
    pub origin: [T; 3],
    /// Rotation matrix (rows), body to world.
    pub rotation: [[T; 3]; 3],
    /// Angular velocity, rad/s.
    pub omega: [T; 3],
    /// Angular acceleration, rad/s².
    pub alpha: [T; 3],
    /// Motion of the centre of mass.
    pub center: PointMotion<T>,
}

/// Force and moment, world axes, N and N·m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wrench<T = f64> {
    /// N.
    pub force: [T; 3],
    /// N·m.
    pub moment: [T; 3],
}

/// A force element's own outputs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ForceOutput<T = f64> {
    /// Length of a spring, coordinate of a joint element, m or rad; `NaN` where there is none.
    pub length: T,
    /// Its rate; `NaN` where there is none.
    pub rate: T,
    /// Effort: along the length or coordinate; the magnitude for forces, torques and bushings, N or N·m.
    pub effort: T,
    /// Force (N, or N·m for a torque) on the point or body it acts on (the second of two), world axes.
    pub vector: [T; 3],
}

/// Energies, J. Potential energy counts weights and springs with constant data.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy<T = f64> {
    /// Kinetic.
    pub kinetic: T,
    /// Potential.
    pub potential: T,
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
    /// Coordinates of flexible bodies; they are in no other number here but the rank.
    pub shapes: usize,
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
    /// Coordinates that nothing held: with the held ones they take all freedom, and their efforts are zero.
    pub free: Vec<Coordinate>,
}

/// Derivatives carried at once.
pub const SEEDS: usize = 4;

/// A number with its derivatives with respect to as many seeds.
pub type Seeded = Dual<SEEDS>;

/// What a solved position answers: plain numbers, or numbers with exact derivatives ([`Seeded`]).
pub trait Readings<T> {
    /// Present time, s.
    fn time(&self) -> T;
    /// Number of coordinates that a joint shows.
    fn coordinates_of(&self, joint: JointId) -> usize;
    /// Motion of a joint coordinate.
    fn coordinate(&self, c: Coordinate) -> Reading<T>;
    /// Motion of a point given in body axes, m.
    fn point(&self, body: BodyId, at: [T; 3]) -> PointMotion<T>;
    /// Motion of a body.
    fn body(&self, body: BodyId) -> BodyMotion<T>;
    /// What the first body puts on the second through the joint, about the origin of the second place.
    /// A coupler answers its effort on b as the first component of the force.
    fn reaction(&self, joint: JointId) -> Wrench<T>;
    /// Effort along effort coordinate `i`, positive when it pushes the coordinate up, N or N·m.
    fn drive(&self, i: usize) -> T;
    /// A force element's outputs.
    fn force(&self, force: ForceId) -> ForceOutput<T>;
    /// Energies.
    fn energy(&self) -> Energy<T>;
    /// Trust.
    fn checks(&self) -> Checks;
}

/// Asked at a position whose rates are known for the values of [`crate::Value::Input`].
pub type Inputs<'a, T> = &'a mut dyn FnMut(&dyn Readings<T>, &mut [T]);

/// What is prescribed at a position, with its derivatives; in the order of the [`Actuation`].
#[derive(Clone, Copy, Debug)]
pub struct Prescription<'a> {
    /// s.
    pub time: Seeded,
    /// m or rad.
    pub position: &'a [Seeded],
    /// m/s or rad/s.
    pub velocity: &'a [Seeded],
    /// m/s² or rad/s².
    pub acceleration: &'a [Seeded],
}

/// A mechanism in motion.
pub trait Engine: Readings<f64> + Forward + Send {
    /// Finds a position that closes all loops near the starts; coordinates in `hold` are met exactly.
    fn assemble(&mut self, hold: &[(Coordinate, f64)]) -> Result<Assembled, MechanismError>;
    /// Degrees of freedom at the present position.
    fn freedom(&mut self) -> Freedom;
    /// The same machine with other numbers: what joins what must not differ. Every coordinate goes to its start;
    /// then comes [`Engine::assemble`] as for a new machine. [`Engine::prepare`] for what was prepared before takes
    /// the degrees of freedom on trust, so a family of designs pays for its ranks once; assembly gives up after fewer
    /// random restarts than for a new machine.
    fn renew(&mut self, blueprint: &Blueprint<f64>) -> Result<(), BuildError>;
    /// Chooses what is prescribed; checks that it takes every degree of freedom, no more. Shapes of flexible bodies are
    /// not to be named: they follow, quasi-statically, from what the bodies carry at [`Engine::solve_forces`].
    fn prepare(&mut self, actuation: &Actuation) -> Result<(), MechanismError>;
    /// Moves the position coordinates to `targets` (SI), keeping the branch; stops where it cannot go on.
    fn move_to(&mut self, time: f64, targets: &[f64]) -> Result<Moved, MechanismError>;
    /// Velocities and accelerations from those of the rate coordinates (SI).
    fn set_rates(&mut self, velocity: &[f64], acceleration: &[f64]) -> Result<Moved, MechanismError>;
    /// From now on [`Engine::solve_forces`] finds the drive efforts, and reactions only as far as they come along:
    /// [`Readings::reaction`] has no meaning then.
    fn only_drives(&mut self, only: bool);
    /// Drive efforts and reactions. `inputs` is asked once, after the rates are known, for the values of
    /// [`crate::Value::Input`].
    fn solve_forces(&mut self, inputs: Inputs<'_, f64>) -> Result<(), MechanismError>;
    /// Equilibrium at rest with the coordinates in `hold` fixed; afterwards the position is there and the
    /// reactions are solved.
    fn equilibrium(
        &mut self,
        hold: &[(Coordinate, f64)],
        inputs: Inputs<'_, f64>,
    ) -> Result<Equilibrium, MechanismError>;
    /// For each joint, whether fx, fy, fz, mx, my, mz of its reaction are determined by equilibrium alone.
    fn uniqueness(&mut self) -> Vec<[bool; 6]>;

    /// The same machine with the derivatives of its numbers: what [`Engine::differentiate`] carries through the
    /// loops. Its plain values must be those of the machine.
    fn seed(&mut self, blueprint: &Blueprint<Seeded>) -> Result<(), BuildError>;
    /// Exact derivatives at the present position, solved before up to the rates or the forces: no factorization in
    /// dual numbers, but one right-hand side a seed for the matrices of the position (implicit function theorem).
    ///
    /// # Errors
    /// Where the position is singular, an input is not finite, or friction does not settle.
    fn differentiate(&mut self, at: &Prescription<'_>, inputs: Inputs<'_, Seeded>) -> Result<(), MechanismError>;
    /// What [`Engine::differentiate`] found last; `None` before [`Engine::seed`].
    fn derivatives(&self) -> Option<&dyn Readings<Seeded>>;
}
