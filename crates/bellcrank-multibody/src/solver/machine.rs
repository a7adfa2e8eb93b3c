//! A mechanism with its state and all that is computed from it.

use super::assembly::Room;
use super::jacobian::Rows;
use super::position::History;
use super::readings::Solved;
use super::settling::Settling;
use super::system::LinearSystem;
use super::tangent::Tangent;
use crate::constraint::Measure;
use crate::forces::Output;
use crate::kinematics;
use crate::mechanism::{Mechanism, Source};
use crate::recursive::Recursions;
use crate::topology::Motion;
use crate::workspace::NodeState;
use crate::{
    Actuation, Assembled, Blueprint, BodyId, BodyMotion, BuildError, Checks, Coordinate, Energy, Engine, Equilibrium,
    ForceId, ForceOutput, Freedom, Inputs, JointId, MechanismError, Moved, PointMotion, Prescription, Reading,
    Readings, Seeded, Wrench,
};
use bellcrank_math::Space;

/// Stages of a solution, in order.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) enum Stage {
    /// Poses.
    Position,
    /// Velocities and accelerations.
    Rates,
    /// Drive efforts and reactions.
    Forces,
}

/// The systems of the present actuation. `effort` is `None` where it is the same as `position`.
#[derive(Debug)]
pub(crate) struct Prepared {
    pub(crate) actuation: Actuation,
    pub(crate) position: LinearSystem,
    /// Rates and efforts each have a system of their own only where their coordinates differ.
    pub(crate) rate: Option<LinearSystem>,
    pub(crate) effort: Option<LinearSystem>,
    pub(crate) position_sign: f64,
    pub(crate) rate_sign: f64,
    /// The position coordinates' values now.
    pub(crate) targets: Vec<f64>,
}

/// A mechanism with its state and its workspace: implements [`Engine`].
#[derive(Debug)]
pub struct Machine<S: Space<T = f64>> {
    pub(crate) mech: Mechanism<S>,
    pub(crate) blueprint: Blueprint<f64>,
    pub(crate) time: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
    pub(crate) x: Vec<NodeState<S>>,
    pub(crate) rows: Rows<S>,
    pub(crate) stage: Stage,
    /// In a box: every step takes it out and puts it back.
    pub(crate) prepared: Option<Box<Prepared>>,
    /// Systems of the machine before [`Engine::renew`], good for the same actuation.
    pub(crate) kept: Option<Box<Prepared>>,
    /// It has taken other numbers.
    pub(crate) renewed: bool,
    /// Joint reactions are left out where the drives can be had without.
    pub(crate) only_drives: bool,
    pub(crate) history: History,
    pub(crate) inputs: Vec<f64>,
    pub(crate) outputs: Vec<Output<S>>,
    /// Efforts along tree coordinates (nv): from elements, and from friction.
    pub(crate) efforts: Vec<f64>,
    pub(crate) friction: Vec<f64>,
    pub(crate) tau: Vec<f64>,
    pub(crate) lambda: Vec<f64>,
    pub(crate) drive: Vec<f64>,
    /// Wrench of each joint on its second body at P₂: N, N·m.
    pub(crate) wrench: Vec<(S::Vector, S::Angular)>,
    pub(crate) scratch: Scratch,
    /// Memory of assembly.
    pub(crate) room: Option<Room>,
    /// Turns already made by measured angles, so that they do not jump at ±180°.
    pub(crate) unwrapped: Vec<Vec<f64>>,
    /// The measured angles: joint, coordinate, link and measure.
    pub(crate) measured_angles: Vec<(usize, usize, usize, Measure)>,
    pub(crate) has_friction: bool,
    /// Recursions over the tree alone, once they were asked for.
    pub(crate) recursions: Option<Box<Recursions<S>>>,
    /// Shapes of flexible bodies that follow the motion.
    pub(crate) settling: Option<Box<Settling>>,
    /// A run in time.
    pub(crate) flight: Option<Box<crate::forward::Flight<S>>>,
    /// Derivatives, once they were asked for.
    pub(crate) tangent: Option<Box<Tangent<S::With<Seeded>>>>,
}

/// Buffers of the inner steps.
#[derive(Debug)]
pub(crate) struct Scratch {
    pub(crate) rhs: Vec<f64>,
    pub(crate) delta: Vec<f64>,
    pub(crate) product: Vec<f64>,
    pub(crate) predicted: Vec<f64>,
    pub(crate) saved: Vec<f64>,
}

impl<S: Space<T = f64>> Machine<S> {
    /// Builds the mechanism and puts every coordinate at its start (or zero).
    pub fn new(blueprint: Blueprint<f64>) -> Result<Self, BuildError> {
        let mech = Mechanism::<S>::build(&blueprint)?;
        let rows = Rows::new(&mech);
        let most = mech.rows() + mech.nv + 6;
        let zero = (S::Vector::default(), S::Angular::default());
        let mut machine = Self {
            time: 0.0,
            q: vec![0.0; mech.nq],
            v: vec![0.0; mech.nv],
            a: vec![0.0; mech.nv],
            x: vec![NodeState::default(); mech.nodes.len()],
            rows,
            stage: Stage::Position,
            prepared: None,
            kept: None,
            only_drives: false,
            renewed: false,
            history: History::new(mech.nq),
            inputs: vec![0.0; mech.inputs],
            outputs: vec![Output::default(); mech.elements.len()],
            efforts: vec![0.0; mech.nv],
            friction: vec![0.0; mech.elements.len()],
            tau: vec![0.0; mech.nv],
            lambda: vec![0.0; most],
            drive: Vec::new(),
            wrench: vec![zero; blueprint.joints.len()],
            scratch: Scratch {
                rhs: vec![0.0; most],
                delta: vec![0.0; mech.nv],
                product: vec![0.0; most],
                predicted: vec![0.0; mech.nq],
                saved: vec![0.0; mech.nq],
            },
            unwrapped: mech.sources.iter().map(|s| vec![0.0; s.len()]).collect(),
            measured_angles: measured_angles(&mech),
            has_friction: mech.elements.iter().any(|e| matches!(e, crate::forces::Element::Friction(_))),
            recursions: None,
            settling: None,
            flight: None,
            tangent: None,
            room: None,
            mech,
            blueprint,
        };
        machine.go_to_start();
        Ok(machine)
    }

    /// Other numbers in the same structure.
    pub(crate) fn take_numbers(&mut self, blueprint: &Blueprint<f64>) -> Result<(), BuildError> {
        if !crate::builder::refresh(&mut self.mech, blueprint)? {
            *self = Self::new(blueprint.clone())?;
            return Ok(());
        }
        self.blueprint.copy_from(blueprint);
        if let Some(prepared) = self.prepared.take() {
            self.kept = Some(prepared);
        }
        self.time = 0.0;
        self.tangent = None;
        self.recursions = None;
        self.settling = None;
        self.flight = None;
        self.renewed = true;
        self.go_to_start();
        Ok(())
    }

    /// Tree coordinates at their starts, everything else at zero.
    pub(crate) fn go_to_start(&mut self) {
        self.q.fill(0.0);
        for node in &self.mech.nodes {
            if node.motion == Motion::Ball {
                self.q[node.q] = 1.0;
            }
        }
        for (joint, sources) in self.blueprint.joints.iter().zip(&self.mech.sources) {
            for (start, source) in joint.start.iter().zip(sources) {
                if let (Some(value), Source::Node(n)) = (start, source) {
                    self.q[self.mech.nodes[*n].q] = *value;
                }
            }
        }
        (0..self.blueprint.joints.len()).for_each(|j| self.start_ball(j));
        self.update_positions();
    }

    /// A ball in the tree with a start given as roll, pitch, yaw.
    fn start_ball(&mut self, j: usize) {
        let Some(tree) = self.mech.tree_joint[j] else { return };
        let joint = &self.blueprint.joints[j];
        let sources = &self.mech.sources[j];
        let Some(first) =
            sources.iter().position(|s| matches!(s, Source::Measured { measure, .. } if measure.is_attitude()))
        else {
            return;
        };
        let rpy: [f64; 3] = std::array::from_fn(|i| joint.start.get(first + i).copied().flatten().unwrap_or(0.0));
        let mut r = bellcrank_math::matrix_from_rpy(&rpy);
        if tree.reversed {
            r = std::array::from_fn(|i| std::array::from_fn(|k| r[k][i]));
        }
        let ball = (1..self.mech.nodes.len())
            .find(|&n| self.mech.nodes[n].joint == Some(JointId(j)) && self.mech.nodes[n].motion == Motion::Ball);
        if let Some(n) = ball {
            let at = self.mech.nodes[n].q;
            self.q[at..at + 4].copy_from_slice(&bellcrank_math::quaternion_from_matrix(&r));
        }
    }

    /// What answers are read from.
    pub(crate) fn solved(&self) -> Solved<'_, S> {
        Solved {
            mech: &self.mech,
            q: &self.q,
            v: &self.v,
            a: &self.a,
            x: &self.x,
            lambda: &self.lambda,
            wrench: &self.wrench,
            outputs: &self.outputs,
            unwrapped: &self.unwrapped,
        }
    }

    /// What the last derivatives are read from.
    pub(crate) fn derivatives_now(&self) -> Option<&dyn Readings<Seeded>> {
        self.tangent.as_deref().map(|tangent| tangent as &dyn Readings<Seeded>)
    }

    /// Poses from `q`; later stages are void.
    #[inline]
    pub(crate) fn update_positions(&mut self) {
        kinematics::positions(&self.mech, &self.q, &mut self.x);
        self.stage = Stage::Position;
    }

    /// Moves the positions by a velocity-like step `delta` (nv): `q ⊕ k·delta`.
    #[inline]
    pub(crate) fn step(&mut self, k: f64) {
        for node in &self.mech.nodes[1..] {
            match node.motion {
                Motion::Fixed => {}
                Motion::Ball => turn_ball(&mut self.q[node.q..node.q + 4], &self.scratch.delta[node.v..node.v + 3], k),
                _ => self.q[node.q] += k * self.scratch.delta[node.v],
            }
        }
    }

    /// Size of the largest of the row values, lengths in m, turns times the machine's size.
    pub(crate) fn closure(&self) -> f64 {
        self.rows.value.iter().fold(0.0, |m: f64, v| if v.is_nan() { f64::INFINITY } else { m.max(v.abs()) })
    }

    /// Debug failure when a stage is asked for that was not computed.
    #[inline]
    pub(crate) fn need(&self, stage: Stage) {
        debug_assert!(self.stage >= stage, "asked for {stage:?} at {:?}", self.stage);
    }
}

fn measured_angles<S: Space>(mech: &Mechanism<S>) -> Vec<(usize, usize, usize, Measure)> {
    let mut found = Vec::new();
    for (j, sources) in mech.sources.iter().enumerate() {
        for (i, s) in sources.iter().enumerate() {
            if let Source::Measured { link, measure } = s
                && measure.is_angle()
            {
                found.push((j, i, *link, *measure));
            }
        }
    }
    found
}

/// `Q ← exp(k δ) Q`: velocity components of a ball are along the axes before its motion.
pub(crate) fn turn_ball(q: &mut [f64], delta: &[f64], k: f64) {
    let turn = crate::attitude::quaternion_of(&[k * delta[0], k * delta[1], k * delta[2]]);
    let new = crate::attitude::quaternion_product(&turn, &[q[0], q[1], q[2], q[3]]);
    q.copy_from_slice(&new);
    crate::attitude::normalize(q);
}

/// An engine for the plane or for space.
pub fn engine_for(planar: bool, blueprint: &Blueprint<f64>) -> Result<Box<dyn Engine>, BuildError> {
    Ok(if planar {
        Box::new(Machine::<bellcrank_math::Planar<f64>>::new(blueprint.clone())?)
    } else {
        Box::new(Machine::<bellcrank_math::Spatial<f64>>::new(blueprint.clone())?)
    })
}

impl<S: Space<T = f64>> Engine for Machine<S> {
    fn assemble(&mut self, hold: &[(Coordinate, f64)]) -> Result<Assembled, MechanismError> {
        self.assemble_near_starts(&self.hold_shapes(hold))
    }
    fn freedom(&mut self) -> Freedom {
        self.count_freedom()
    }
    fn renew(&mut self, blueprint: &Blueprint<f64>) -> Result<(), BuildError> {
        self.take_numbers(blueprint)
    }
    fn only_drives(&mut self, only: bool) {
        self.only_drives = only;
    }
    fn prepare(&mut self, actuation: &Actuation) -> Result<(), MechanismError> {
        self.prepare_bent(actuation)
    }
    fn move_to(&mut self, time: f64, targets: &[f64]) -> Result<Moved, MechanismError> {
        self.move_bent(time, targets)
    }
    fn set_rates(&mut self, velocity: &[f64], acceleration: &[f64]) -> Result<Moved, MechanismError> {
        self.rates_bent(velocity, acceleration)
    }
    fn solve_forces(&mut self, inputs: Inputs<'_, f64>) -> Result<(), MechanismError> {
        self.efforts_bent(inputs)
    }
    fn equilibrium(
        &mut self,
        hold: &[(Coordinate, f64)],
        inputs: Inputs<'_, f64>,
    ) -> Result<Equilibrium, MechanismError> {
        self.find_equilibrium(hold, inputs)
    }
    fn uniqueness(&mut self) -> Vec<[bool; 6]> {
        self.unique_components()
    }
    fn seed(&mut self, blueprint: &Blueprint<Seeded>) -> Result<(), BuildError> {
        self.tangent = Some(Box::new(Tangent::new(blueprint)?));
        Ok(())
    }
    fn differentiate(&mut self, at: &Prescription<'_>, inputs: Inputs<'_, Seeded>) -> Result<(), MechanismError> {
        self.derivatives_bent(at, inputs)
    }
    fn derivatives(&self) -> Option<&dyn Readings<Seeded>> {
        self.derivatives_now()
    }
}

impl<S: Space<T = f64>> Readings<f64> for Machine<S> {
    fn time(&self) -> f64 {
        self.time
    }
    fn coordinates_of(&self, joint: JointId) -> usize {
        self.mech.sources.get(joint.0).map_or(0, Vec::len)
    }
    fn coordinate(&self, c: Coordinate) -> Reading {
        self.solved().coordinate(c)
    }
    fn point(&self, body: BodyId, at: [f64; 3]) -> PointMotion {
        self.solved().point(body, at)
    }
    fn body(&self, body: BodyId) -> BodyMotion {
        self.solved().body(body)
    }
    fn reaction(&self, joint: JointId) -> Wrench {
        self.need(Stage::Forces);
        self.solved().reaction(joint)
    }
    fn drive(&self, i: usize) -> f64 {
        self.need(Stage::Forces);
        self.drive.get(i).copied().unwrap_or(f64::NAN)
    }
    fn force(&self, force: ForceId) -> ForceOutput {
        self.solved().force(force)
    }
    fn energy(&self) -> Energy {
        self.solved().energy()
    }
    fn checks(&self) -> Checks {
        self.read_checks()
    }
}
