//! Accelerations and multipliers from forces: `M a + h − Q = Jᵀ λ`, `J a = γ`.

use super::door::Surroundings;
use super::flight::Flight;
use super::locks::Act;
use crate::forces::{Element, Present, friction_direction, friction_effort, read};
use crate::solver::{Demands, Machine, Prescribed, Stage, turn_attitude_drives};
use crate::{Coordinate, JointId, MechanismError, dynamics, kinematics};
use bellcrank_math::Space;

/// Friction is settled when no effort changes by more than this part of the largest.
const SETTLED: f64 = 1e-11;
/// Closure (machine sizes, rad) at which a position is taken.
const CLOSED: f64 = 1e-12;
/// Iterations before a joint is said to jam.
const MOST_ITERATIONS: usize = 400;

impl<S: Space<T = f64>> Machine<S> {
    /// Accelerations at the present time, positions and velocities. Driven and locked coordinates are set first.
    pub(crate) fn accelerate(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        f.effort.evaluations += 1;
        self.take_drives(f, around)?;
        self.update_positions();
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        self.stage = Stage::Rates;
        self.ask_inputs(&mut |at, values| around.inputs(at, values))?;
        self.apply_forces();
        self.accelerate_here(f)
    }

    /// The same from a state that the constraints may have been left by a little: positions go back onto them by the
    /// factors at hand, velocities by those of the new position, and accelerations follow from the same ones.
    pub(crate) fn accelerate_on_constraints(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        f.effort.evaluations += 1;
        self.take_drives(f, around)?;
        self.scratch.saved.copy_from_slice(&self.q);
        if self.project_positions(f).is_none() {
            // The factors are too old: those of here.
            self.q.copy_from_slice(&self.scratch.saved);
            self.refactor(f)?;
            self.project_positions(f);
        }
        self.factor_position(f)?;
        if self.closure() > CLOSED * self.mech.size {
            // Slow for the same reason.
            self.project_positions(f);
            self.factor_position(f)?;
        }
        self.correct_velocities(f);
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        self.stage = Stage::Rates;
        self.ask_inputs(&mut |at, values| around.inputs(at, values))?;
        self.apply_forces();
        self.accelerate_with(f)
    }

    /// Masses, constraints and their factors at the present poses.
    fn factor_position(&mut self, f: &mut Flight<S>) -> Result<(), MechanismError> {
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        self.factor_masses(f)
    }

    /// The same where positions, velocities and applied forces are known.
    pub(crate) fn accelerate_here(&mut self, f: &mut Flight<S>) -> Result<(), MechanismError> {
        self.factor_masses(f)?;
        self.accelerate_with(f)
    }

    /// The same with the factors at hand.
    fn accelerate_with(&mut self, f: &mut Flight<S>) -> Result<(), MechanismError> {
        self.fill_gamma(f);
        self.solve_accelerations(f);
        if self.has_friction {
            self.settle_slip(f)?;
        }
        Ok(())
    }

    /// Masses and constraints of the present position, factored.
    pub(crate) fn factor_masses(&mut self, f: &mut Flight<S>) -> Result<(), MechanismError> {
        f.effort.factorizations += 1;
        let regular = if let Some(tree) = &mut f.tree {
            tree.factor(&self.mech, &self.x)
        } else {
            f.mass.evaluate(&self.mech, &self.x);
            f.saddle.fill(&self.mech, &self.rows, &f.mass, &self.x);
            f.saddle.factor()
        };
        if regular { Ok(()) } else { Err(self.missing_mass(f)) }
    }

    /// Positions and velocities of driven and locked tree coordinates, and the targets of all.
    pub(crate) fn take_drives(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        if !f.driven.is_empty() {
            around.drives(self.time, &mut f.drive);
        }
        let finite =
            |r: &crate::Reading| r.position.is_finite() && r.velocity.is_finite() && r.acceleration.is_finite();
        if !f.drive.iter().all(finite) {
            return Err(MechanismError::NotFinite("a prescribed motion"));
        }
        for (k, r) in f.drive.iter().enumerate() {
            (f.target[k], f.velocity[k], f.acceleration[k]) = (r.position, r.velocity, r.acceleration);
        }
        for (k, lock) in f.locks.iter().enumerate() {
            let k = k + f.drive.len();
            (f.target[k], f.velocity[k], f.acceleration[k]) = (lock.at, 0.0, 0.0);
        }
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                let node = &self.mech.nodes[*n];
                (self.q[node.q], self.v[node.v]) = (f.target[k], f.velocity[k]);
            }
        }
        Ok(())
    }

    /// Prescribed tree accelerations into `a`, zero elsewhere, and what velocities and they make of the rows.
    fn fill_gamma(&mut self, f: &mut Flight<S>) {
        self.known_accelerations(f);
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        self.fill_bias();
        for (gamma, bias) in f.gamma.iter_mut().zip(&self.scratch.rhs[..self.mech.rows()]) {
            *gamma = -bias;
        }
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, source) = p {
                let target = self.row_target(*source, k, &f.velocity, &f.acceleration).1;
                f.gamma[*row] = target - self.row_bias(*source);
            }
        }
    }

    fn known_accelerations(&mut self, f: &Flight<S>) {
        self.a.fill(0.0);
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                self.a[self.mech.nodes[*n].v] = f.acceleration[k];
            }
        }
    }

    /// One solution with the present friction; `x` holds the accelerations of the prescribed coordinates alone.
    fn solve_accelerations(&mut self, f: &mut Flight<S>) {
        dynamics::own_wrenches(&self.mech, &mut self.x);
        self.passes(&f.saddle.prescribed).gather_own();
        dynamics::project(&self.mech, &self.x, &mut self.tau);
        self.tau.iter_mut().zip(&self.efforts).for_each(|(t, e)| *t -= e);
        self.subtract_tree_friction();
        f.load.iter_mut().zip(&self.tau).for_each(|(l, t)| *l = -t);
        if let Some(tree) = &mut f.tree {
            tree.solve(&self.mech, &self.x, &f.load, &mut self.a);
            return;
        }
        f.saddle.solve(&f.load, &f.gamma, &mut self.a, &mut f.mu);
        self.lambda.iter_mut().zip(&f.mu).for_each(|(l, m)| *l = -m);
    }

    /// Friction depends on the reaction that it changes: iterate to consistency.
    fn settle_slip(&mut self, f: &mut Flight<S>) -> Result<(), MechanismError> {
        let mut worst = (JointId(0), f64::INFINITY);
        f.mixing.begin();
        for _ in 0..MOST_ITERATIONS {
            self.reactions_here(f);
            f.before.copy_from_slice(&self.friction);
            worst = self.update_slip(f);
            if worst.1 <= SETTLED {
                return Ok(());
            }
            let Flight { mixing, before, .. } = f;
            mixing.next(before, &self.friction);
            self.friction.copy_from_slice(before);
            self.known_accelerations(f);
            kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
            self.solve_accelerations(f);
        }
        Err(MechanismError::Jammed { joint: worst.0, change: worst.1 })
    }

    /// Joint wrenches of the present accelerations and multipliers.
    pub(crate) fn reactions_here(&mut self, f: &Flight<S>) {
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        dynamics::own_wrenches(&self.mech, &mut self.x);
        self.gather_with_loops(&f.saddle.prescribed, Demands::All);
    }

    /// New friction efforts from the present reactions; the joint that changed most, relative to the largest.
    pub(crate) fn update_slip(&mut self, f: &Flight<S>) -> (JointId, f64) {
        let mut change = (JointId(0), 0.0_f64);
        let mut largest = f64::MIN_POSITIVE;
        for i in 0..self.mech.elements.len() {
            let Element::Friction(law) = self.mech.elements[i].clone() else { continue };
            let effort = match f.acts[i] {
                Act::Stick => 0.0,
                act => self.slip_effort(f, &law, act),
            };
            let step = (effort - self.friction[i]).abs();
            largest = largest.max(effort.abs());
            if step.is_nan() || step > change.1 {
                change = (law.coordinate.joint, step);
            }
            self.friction[i] = effort;
        }
        (change.0, change.1 / largest)
    }

    fn slip_effort(&mut self, f: &Flight<S>, law: &crate::forces::Friction<f64>, act: Act) -> f64 {
        let normal = self.passes(&f.saddle.prescribed).normal_force(law);
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        let rate = read(&self.mech, &self.x, &self.q, &self.v, law.source).1;
        let direction = match act {
            Act::Slip { up } => {
                if up {
                    1.0
                } else {
                    -1.0
                }
            }
            _ => friction_direction(&now, law, rate),
        };
        friction_effort(&now, law, rate, direction, normal)
    }

    /// After [`Machine::accelerate`]: drive efforts, reactions, and the elements' own outputs.
    pub(crate) fn answer_forces(&mut self, f: &mut Flight<S>) {
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        dynamics::own_wrenches(&self.mech, &mut self.x);
        let null = f.saddle.self_stresses();
        if !null.is_empty() {
            self.choose_least_norm(&f.saddle.prescribed, &null);
        }
        self.read_flight_drives(f);
        self.gather_with_loops(&f.saddle.prescribed, Demands::All);
        for (out, e) in self.outputs.iter_mut().zip(&self.friction) {
            out.effort += e;
        }
        let driven = f.drive.len();
        for (k, lock) in f.locks.iter().enumerate() {
            self.outputs[lock.element].effort = self.drive[driven + k];
        }
        self.stage = Stage::Forces;
    }

    /// Tree drives carry what is left along their coordinates, measured ones are multipliers.
    fn read_flight_drives(&mut self, f: &mut Flight<S>) {
        self.drive.resize(f.saddle.prescribed.len(), 0.0);
        if f.saddle.prescribed.is_empty() {
            return;
        }
        let mut left = std::mem::take(&mut self.tau);
        let efforts = std::mem::take(&mut self.efforts);
        self.passes(&f.saddle.prescribed).residual(&efforts, &mut left);
        self.efforts = efforts;
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            self.drive[k] = match p {
                Prescribed::Node(n) => left[self.mech.nodes[*n].v],
                Prescribed::Row(row, _) => self.lambda[*row],
            };
        }
        self.tau = left;
        turn_attitude_drives(&self.mech, &self.x, &f.saddle.prescribed, &mut self.drive);
    }

    /// Coordinates that move without mass.
    pub(crate) fn missing_mass(&mut self, f: &mut Flight<S>) -> MechanismError {
        self.use_masses(f);
        let (masses, jacobian) = (f.saddle.dense_masses(), f.saddle.dense_jacobian());
        let n = f.saddle.columns.len();
        let mut motion = vec![0.0; self.mech.nv];
        if n <= crate::solver::LARGE {
            let mut all: Vec<Vec<f64>> = masses.into_iter().chain(jacobian).collect();
            all.resize(all.len().max(n), vec![0.0; n]);
            if let Some(svd) = bellcrank_math::linalg::dense::svd(&all, n) {
                let top = svd.values.first().copied().unwrap_or(0.0);
                let null = svd.values.iter().zip(&svd.right).filter(|(s, _)| **s <= 1e-9 * top);
                for (_, right) in null {
                    f.saddle.columns.iter().zip(right).for_each(|(v, r)| motion[*v] += r * r);
                }
            }
        }
        let mobile: Vec<Coordinate> = self.coordinates_by_motion(&motion);
        MechanismError::NoMass { mobile }
    }
}
