//! Velocities and accelerations: `J v = [0; ṡ]`, `J a = [−ġ_v; s̈ − ḋ_v]`.

use super::machine::{Machine, Prepared, Stage};
use super::system::{LinearSystem, SINGULAR};
use super::unknowns::Prescribed;
use crate::attitude::spin_of_rpy;
use crate::constraint::Measure;
use crate::kinematics;
use crate::mechanism::Source;
use crate::{MechanismError, Moved, System};
use bellcrank_math::{Space, rpy_from_matrix};

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn solve_rates(&mut self, velocity: &[f64], acceleration: &[f64]) -> Result<Moved, MechanismError> {
        let Some(mut prepared) = self.prepared.take() else {
            return Err(MechanismError::NotFinite("no actuation prepared"));
        };
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        let Prepared { position, rate, rate_sign, .. } = &mut *prepared;
        let own = rate.is_some();
        let system = rate.as_mut().unwrap_or(position);
        let result = self.rates_with(system, velocity, acceleration);
        let sign = system.determinant_sign();
        let mut moved = Moved::default();
        if own && sign != 0.0 {
            moved.passed_dead_position = *rate_sign * sign < 0.0;
            *rate_sign = sign;
        }
        self.prepared = Some(prepared);
        result.map(|()| moved)
    }

    fn rates_with(
        &mut self,
        system: &mut LinearSystem,
        velocity: &[f64],
        acceleration: &[f64],
    ) -> Result<(), MechanismError> {
        if velocity.iter().chain(acceleration).any(|x| !x.is_finite()) {
            return Err(MechanismError::NotFinite("a prescribed velocity or acceleration"));
        }
        if system.factor(&self.mech, &self.rows, &self.x) < SINGULAR {
            let (singular_value, mobile) = self.weakest(system);
            self.void_rates();
            return Err(MechanismError::Singular { system: System::Drive, singular_value, mobile });
        }
        self.velocities_with(system, velocity, acceleration);
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        kinematics::accelerations(&self.mech, &self.v, None, &mut self.x);
        self.accelerations_with(system, velocity, acceleration);
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        self.stage = Stage::Rates;
        Ok(())
    }

    /// Rates that nothing determines read as NaN, and so does all that follows from them.
    fn void_rates(&mut self) {
        self.v.fill(f64::NAN);
        self.a.fill(f64::NAN);
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        self.void_forces();
        self.stage = Stage::Forces;
    }

    fn velocities_with(&mut self, system: &mut LinearSystem, velocity: &[f64], acceleration: &[f64]) {
        self.v.fill(0.0);
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                self.v[self.mech.nodes[*n].v] = velocity[k];
            }
        }
        system.multiply_known(&self.rows, &self.v, &mut self.scratch.product);
        for r in 0..system.rows {
            self.scratch.rhs[r] = -self.scratch.product[r];
        }
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, source) = p {
                self.scratch.rhs[*row] += self.row_target(*source, k, velocity, acceleration).0;
            }
        }
        system.solve(&self.scratch.rhs, &mut self.v);
    }

    fn accelerations_with(&mut self, system: &mut LinearSystem, velocity: &[f64], acceleration: &[f64]) {
        self.a.fill(0.0);
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                self.a[self.mech.nodes[*n].v] = acceleration[k];
            }
        }
        system.multiply_known(&self.rows, &self.a, &mut self.scratch.product);
        self.fill_bias();
        for r in 0..self.mech.rows() {
            self.scratch.rhs[r] = -self.scratch.rhs[r] - self.scratch.product[r];
        }
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, source) = p {
                let target = self.row_target(*source, k, velocity, acceleration).1;
                self.scratch.rhs[*row] = target - self.row_bias(*source) - self.scratch.product[*row];
            }
        }
        system.solve(&self.scratch.rhs, &mut self.a);
    }

    /// Second derivatives of all rows with the accelerations that velocities alone cause, into `rhs`.
    pub(crate) fn fill_bias(&mut self) {
        for &k in &self.mech.closing {
            let link = &self.mech.links[k];
            let pose = link.pose_for_rows(&self.x);
            let motion = link.motion(&self.x, &pose);
            for (i, kind) in link.rows.iter().enumerate() {
                self.scratch.rhs[link.first_row + i] = link.row_rates(*kind, &pose, &motion).1;
            }
        }
        for (i, c) in self.mech.couplings.iter().enumerate() {
            self.scratch.rhs[self.mech.link_rows + i] = self.row_bias(c.b) - c.ratio * self.row_bias(c.a);
        }
    }

    pub(crate) fn row_bias(&self, source: Source) -> f64 {
        let Source::Measured { link, measure } = source else { return 0.0 };
        let link = &self.mech.links[link];
        let pose = link.pose(&self.x);
        let motion = link.motion(&self.x, &pose);
        match measure {
            Measure::Attitude(i) => motion.spin_rates(&pose, i).1,
            _ => link.measure_rates(measure, &pose, &motion).1,
        }
    }

    /// What a prescribed row's first and second derivative should be.
    pub(crate) fn row_target(&self, source: Source, k: usize, velocity: &[f64], acceleration: &[f64]) -> (f64, f64) {
        let Source::Measured { link, measure: Measure::Attitude(i) } = source else {
            return (velocity[k], acceleration[k]);
        };
        let three = |x: &[f64]| -> [f64; 3] { std::array::from_fn(|c| x[k + c - i]) };
        let rpy = rpy_from_matrix(&self.mech.links[link].pose(&self.x).relative());
        let (w, wd) = spin_of_rpy(&rpy, &three(velocity), &three(acceleration));
        (w[i], wd[i])
    }
}
