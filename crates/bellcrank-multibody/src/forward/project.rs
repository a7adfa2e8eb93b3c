//! Back onto the constraints: positions that close every loop, velocities that keep them closed.
//!
//! Corrections are the least in the metric of the masses, by the factors at hand: they are near enough for a
//! correction that is small.

use super::flight::Flight;
use crate::kinematics;
use crate::solver::{Machine, Prescribed};
use bellcrank_math::Space;

/// Corrections of a position before it is given up.
const MOST_CORRECTIONS: usize = 8;
/// Closure (machine sizes, rad) that counts as closed.
const CLOSED: f64 = 1e-14;

impl<S: Space<T = f64>> Machine<S> {
    /// Closes the loops at the present position. The sum of the largest corrections is returned (m, rad), or `None`
    /// where the loops do not close.
    pub(crate) fn project_positions(&mut self, f: &mut Flight<S>) -> Option<f64> {
        if f.saddle.rows == 0 {
            self.update_positions();
            return Some(0.0);
        }
        f.effort.projections += 1;
        let size = self.mech.size.max(1e-9);
        let (mut moved, mut before) = (0.0_f64, f64::INFINITY);
        for _ in 0..MOST_CORRECTIONS {
            self.update_positions();
            self.rows.residuals(&self.mech, &self.q, &self.x);
            let error = self.fill_closure(f) / size;
            if !error.is_finite() {
                return None;
            }
            if error <= CLOSED || error > 0.5 * before && error < 1e-11 {
                return Some(moved);
            }
            if error > 2.0 * before {
                return None;
            }
            before = error;
            self.scratch.delta.fill(0.0);
            f.saddle.least_motion(&f.gamma, &mut self.scratch.delta);
            moved += self.scratch.delta.iter().fold(0.0, |m: f64, d| m.max(d.abs()));
            self.step(1.0);
        }
        self.update_positions();
        (before < 1e-9).then_some(moved)
    }

    /// `gamma = −g` of all rows; the largest entry is returned.
    pub(crate) fn fill_closure(&mut self, f: &mut Flight<S>) -> f64 {
        let mut largest = 0.0_f64;
        for (gamma, value) in f.gamma.iter_mut().zip(&self.rows.value) {
            *gamma = -value;
            largest = if value.is_nan() { f64::INFINITY } else { largest.max(value.abs()) };
        }
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, source) = p {
                let error = self.row_error(*source, k, &f.target);
                f.gamma[*row] = -error;
                largest = if error.is_nan() { f64::INFINITY } else { largest.max(error.abs()) };
            }
        }
        largest
    }

    /// Velocities that keep the loops closed and the drives at their rates, by the factors at hand; poses and rows
    /// must be those of the present position.
    pub(crate) fn project_velocities(&mut self, f: &mut Flight<S>, times: usize) {
        if f.saddle.rows == 0 {
            return;
        }
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        f.saddle.fill(&self.mech, &self.rows, &f.mass, &self.x);
        for _ in 0..times {
            self.correct_velocities(f);
        }
    }

    /// The least change of velocities that meets constraints and drives, by the factors at hand.
    pub(crate) fn correct_velocities(&mut self, f: &mut Flight<S>) {
        self.fill_rates(f);
        self.scratch.delta.fill(0.0);
        f.saddle.least_motion(&f.gamma, &mut self.scratch.delta);
        self.v.iter_mut().zip(&self.scratch.delta).for_each(|(v, d)| *v += d);
    }

    /// `gamma = ṡ − J v` of all rows.
    pub(crate) fn fill_rates(&mut self, f: &mut Flight<S>) {
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        for &k in &self.mech.closing {
            let link = &self.mech.links[k];
            let pose = link.pose_for_rows(&self.x);
            let motion = link.motion(&self.x, &pose);
            for (i, kind) in link.rows.iter().enumerate() {
                f.gamma[link.first_row + i] = -link.row_rates(*kind, &pose, &motion).0;
            }
        }
        for (i, c) in self.mech.couplings.iter().enumerate() {
            f.gamma[self.mech.link_rows + i] = c.ratio * self.rate_of_source(c.a) - self.rate_of_source(c.b);
        }
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, source) = p {
                let target = self.row_target(*source, k, &f.velocity, &f.acceleration).0;
                f.gamma[*row] = target - self.rate_of_source(*source);
            }
        }
    }

    /// Rate of a coordinate; of an attitude that of the spin about an axis of the first frame.
    pub(crate) fn rate_of_source(&self, source: crate::mechanism::Source) -> f64 {
        use crate::constraint::Measure;
        use crate::mechanism::Source;
        match source {
            Source::Node(n) => self.v[self.mech.nodes[n].v],
            Source::Measured { link, measure } => {
                let link = &self.mech.links[link];
                let pose = link.pose(&self.x);
                let motion = link.motion(&self.x, &pose);
                match measure {
                    Measure::Attitude(i) => motion.spin_rates(&pose, i).0,
                    _ => link.measure_rates(measure, &pose, &motion).0,
                }
            }
        }
    }
}
