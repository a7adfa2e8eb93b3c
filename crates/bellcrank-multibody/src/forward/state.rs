//! The state as one vector y = (q, v) and its slope ẏ = (q̇, v̇).

use super::flight::Flight;
use crate::attitude::normalize;
use crate::solver::Machine;
use crate::topology::Motion;
use bellcrank_math::Space;

impl<S: Space<T = f64>> Machine<S> {
    /// Takes positions and velocities over from `f.step.y`; quaternions are made units.
    #[inline]
    pub(crate) fn load(&mut self, f: &Flight<S>) {
        let (q, v) = f.step.y.split_at(self.mech.nq);
        self.q.copy_from_slice(q);
        self.v.copy_from_slice(v);
        for node in self.mech.nodes.iter().filter(|n| n.motion == Motion::Ball) {
            normalize(&mut self.q[node.q..node.q + 4]);
        }
    }

    /// Positions and velocities into `y`.
    pub(crate) fn store(&self, y: &mut [f64]) {
        let (q, v) = y.split_at_mut(self.mech.nq);
        q.copy_from_slice(&self.q);
        v.copy_from_slice(&self.v);
    }

    /// Slope of the present state: q̇ from v (of a ball `½ (0, v) ∘ Q`), v̇ from `a`.
    #[inline]
    pub(crate) fn slope_into(&self, slope: &mut [f64]) {
        let (qd, vd) = slope.split_at_mut(self.mech.nq);
        vd.copy_from_slice(&self.a);
        for node in &self.mech.nodes[1..] {
            match node.motion {
                Motion::Fixed => {}
                Motion::Ball => {
                    let w = &self.v[node.v..node.v + 3];
                    let half = [0.0, 0.5 * w[0], 0.5 * w[1], 0.5 * w[2]];
                    let q = std::array::from_fn(|i| self.q[node.q + i]);
                    qd[node.q..node.q + 4].copy_from_slice(&crate::attitude::quaternion_product(&half, &q));
                }
                _ => qd[node.q] = self.v[node.v],
            }
        }
    }

    /// Units of the error of each number of y: 1 rad, the machine's size, and they a second; of deformations those of a
    /// strained body; 0 for what is prescribed.
    pub(crate) fn error_units(&self, f: &mut Flight<S>) {
        let nq = self.mech.nq;
        for node in &self.mech.nodes[1..] {
            let unit = if node.motion == Motion::Slide { self.mech.size.max(1e-9) } else { 1.0 };
            f.step.unit[node.q..node.q + node.motion.numbers()].fill(unit);
            f.step.unit[nq + node.v..nq + node.v + node.motion.dofs()].fill(unit);
        }
        for body in &self.mech.flexible {
            for (e, &node) in body.nodes.iter().enumerate() {
                let node = &self.mech.nodes[node];
                [f.step.unit[node.q], f.step.unit[nq + node.v]] = body.error_units(e, self.mech.size);
            }
        }
        for p in &f.saddle.prescribed {
            if let crate::solver::Prescribed::Node(n) = p {
                let node = &self.mech.nodes[*n];
                f.step.unit[node.q] = 0.0;
                f.step.unit[nq + node.v] = 0.0;
            }
        }
    }
}

/// Root mean square of `values`, each measured by its unit and the tolerance; velocities (from `nq` on) relative to
/// their size as well.
pub(crate) fn error_norm(
    values: impl Iterator<Item = f64>,
    unit: &[f64],
    y: [&[f64]; 2],
    nq: usize,
    tolerance: f64,
) -> f64 {
    let (mut sum, mut count) = (0.0, 0);
    for (i, value) in values.enumerate() {
        if unit[i] > 0.0 {
            let size = if i >= nq { y[0][i].abs().max(y[1][i].abs()) } else { 0.0 };
            let scaled = value / (tolerance * (unit[i] + size));
            sum += scaled * scaled;
            count += 1;
        }
    }
    if count > 0 { (sum / f64::from(count)).sqrt() } else { 0.0 }
}

/// The number of y whose error is the largest.
pub(crate) fn worst_number(values: impl Iterator<Item = f64>, unit: &[f64]) -> usize {
    let mut worst = (0, -1.0);
    for (i, value) in values.enumerate() {
        let scaled = if unit[i] > 0.0 { value.abs() / unit[i] } else { 0.0 };
        if scaled > worst.1 || scaled.is_nan() {
            worst = (i, scaled);
        }
    }
    worst.0
}
