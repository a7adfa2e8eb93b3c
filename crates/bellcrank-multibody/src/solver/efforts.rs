//! Drive efforts and reactions: `Jᵀ [λ; u] = τ`, then the inward pass with λ applied.

use super::balance::{Balance, Demands, turn_attitude_drives};
use super::machine::{Machine, Prepared, Stage};
use super::system::{LinearSystem, SINGULAR};
use super::unknowns::Prescribed;
use crate::dynamics;
use crate::forces::{Element, Friction, Present, apply_all, friction_direction, friction_effort, read};
use crate::mechanism::Source;
use crate::{Inputs, JointId, MechanismError, System};
use bellcrank_math::Space;

/// Friction is settled when no effort changes by more than this part of the largest.
const SETTLED: f64 = 1e-13;
/// Iterations before a joint is said to jam.
const MOST_ITERATIONS: usize = 400;

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn ask_inputs(&mut self, inputs: Inputs<'_, f64>) -> Result<(), MechanismError> {
        if self.inputs.is_empty() {
            return Ok(());
        }
        let mut values = std::mem::take(&mut self.inputs);
        inputs(self, &mut values);
        let finite = values.iter().all(|x| x.is_finite());
        self.inputs = values;
        if finite { Ok(()) } else { Err(MechanismError::NotFinite("the value of a force")) }
    }

    pub(crate) fn solve_efforts(&mut self) -> Result<(), MechanismError> {
        self.need(Stage::Rates);
        let Some(mut prepared) = self.prepared.take() else {
            return Err(MechanismError::NotFinite("no actuation prepared"));
        };
        let Prepared { position, rate, effort, .. } = &mut *prepared;
        let result = match effort {
            Some(system) => {
                system.factor(&self.mech, &self.rows, &self.x);
                self.efforts_with(system)
            }
            None => self.efforts_with(rate.as_mut().unwrap_or(position)),
        };
        self.prepared = Some(prepared);
        result
    }

    fn efforts_with(&mut self, system: &mut LinearSystem) -> Result<(), MechanismError> {
        if system.ratio < SINGULAR {
            let (singular_value, mobile) = self.weakest(system);
            self.void_forces();
            self.stage = Stage::Forces;
            return Err(MechanismError::Singular { system: System::Drive, singular_value, mobile });
        }
        self.apply_forces();
        dynamics::own_wrenches(&self.mech, &mut self.x);
        self.friction.fill(0.0);
        self.balance(system);
        if self.has_friction {
            self.settle_friction(system)?;
        }
        self.stage = Stage::Forces;
        Ok(())
    }

    pub(crate) fn apply_forces(&mut self) {
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        apply_all(&now, &mut self.x, &mut self.efforts, &mut self.outputs);
    }

    /// The passes of the balance over this machine.
    pub(crate) fn passes<'a>(&'a mut self, prescribed: &'a [Prescribed]) -> Balance<'a, S> {
        Balance {
            mech: &self.mech,
            x: &mut self.x,
            row_wrench: &self.rows.wrench,
            p2: &self.rows.p2,
            lambda: &self.lambda,
            friction: &self.friction,
            outputs: &self.outputs,
            prescribed,
            wrench: &mut self.wrench,
        }
    }

    /// Inward pass and joint wrenches with the present multipliers.
    pub(crate) fn gather_with_loops(&mut self, prescribed: &[Prescribed], demands: Demands) {
        let mut passes = self.passes(prescribed);
        passes.gather_with_loops(demands);
        passes.collect_wrenches();
    }

    /// One solution of the balance with the present friction efforts.
    fn balance(&mut self, system: &mut LinearSystem) {
        self.passes(&system.prescribed).gather_own();
        dynamics::project(&self.mech, &self.x, &mut self.tau);
        self.tau.iter_mut().zip(&self.efforts).for_each(|(t, e)| *t -= e);
        self.subtract_tree_friction();
        system.solve_transposed(&self.tau, &mut self.lambda);
        let only_drives = self.only_drives && !self.has_friction;
        // Self-stress changes no drive: there are as many drives as freedoms.
        if system.nullity() > 0 && !only_drives {
            let null = system.null_vectors();
            self.choose_least_norm(&system.prescribed, &null);
        }
        self.read_drives(system);
        if only_drives {
            return;
        }
        self.gather_with_loops(&system.prescribed, Demands::All);
    }

    pub(crate) fn subtract_tree_friction(&mut self) {
        for (element, e) in self.mech.elements.iter().zip(&self.friction) {
            if let Element::Friction(Friction { source: Source::Node(n), .. }) = element {
                self.tau[self.mech.nodes[*n].v] -= e;
            }
        }
    }

    fn read_drives(&mut self, system: &LinearSystem) {
        system.multiply_known_transposed(&self.rows, &self.lambda, &mut self.scratch.product[..self.mech.nv]);
        for (k, p) in system.prescribed.iter().enumerate() {
            self.drive[k] = match p {
                Prescribed::Node(n) => {
                    let v = self.mech.nodes[*n].v;
                    self.tau[v] - self.scratch.product[v]
                }
                Prescribed::Row(row, _) => self.lambda[*row],
            };
        }
        turn_attitude_drives(&self.mech, &self.x, &system.prescribed, &mut self.drive);
    }

    /// Friction depends on the reaction it changes: iterate to consistency.
    fn settle_friction(&mut self, system: &mut LinearSystem) -> Result<(), MechanismError> {
        let mut worst = (JointId(0), f64::INFINITY);
        for _ in 0..MOST_ITERATIONS {
            worst = self.update_friction(system);
            self.balance(system);
            if worst.1 <= SETTLED {
                for (out, e) in self.outputs.iter_mut().zip(&self.friction) {
                    out.effort += e;
                }
                return Ok(());
            }
        }
        self.void_forces();
        self.stage = Stage::Forces;
        Err(MechanismError::Jammed { joint: worst.0, change: worst.1 })
    }

    /// New friction efforts from the present reactions; the joint that changed most and by how much.
    fn update_friction(&mut self, system: &LinearSystem) -> (JointId, f64) {
        let mut change = (JointId(0), 0.0_f64);
        let mut largest = f64::MIN_POSITIVE;
        for i in 0..self.mech.elements.len() {
            let Element::Friction(f) = self.mech.elements[i].clone() else { continue };
            let normal = self.passes(&system.prescribed).normal_force(&f);
            let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
            let rate = read(&self.mech, &self.x, &self.q, &self.v, f.source).1;
            let direction = friction_direction(&now, &f, rate);
            let effort = friction_effort(&now, &f, rate, direction, normal);
            let step = (effort - self.friction[i]).abs();
            largest = largest.max(effort.abs());
            if step.is_nan() || step > change.1 {
                change = (f.coordinate.joint, step);
            }
            self.friction[i] = effort;
        }
        (change.0, change.1 / largest)
    }

    pub(crate) fn void_forces(&mut self) {
        self.drive.fill(f64::NAN);
        self.lambda.fill(f64::NAN);
        let mut nan = (S::Vector::default(), S::Angular::default());
        (0..S::DIM).for_each(|i| nan.0[i] = f64::NAN);
        (0..S::ANG).for_each(|i| nan.1[i] = f64::NAN);
        self.wrench.fill(nan);
    }
}
