//! Elastic forces: `−K e − D ḋ` with the strained coordinates `e_k = d_k + ½ dᵀ C_k d`.
//!
//! The energy is `½ eᵀ K e`: bending that brings an interface nearer strains the body along, so that tension stiffens
//! and compression softens it, without the membrane locking that a full quartic energy of few shapes has.

use super::Deforming;
use crate::mechanism::Mechanism;
use crate::workspace::NodeState;
use bellcrank_math::{Real, Space};

/// Adds the elastic efforts along the coordinates of flexible bodies to `efforts` (nv).
pub(crate) fn add_efforts<S: Space>(mech: &Mechanism<S>, x: &mut [NodeState<S>], efforts: &mut [S::T]) {
    for body in &mech.flexible {
        body.shorten(x);
        for i in 0..body.count() {
            efforts[mech.nodes[body.nodes[i]].v] -= body.stress(x, i) + body.damped(x, i);
        }
        for shortening in &body.data.shortenings {
            let force = body.stress(x, shortening.along);
            for i in 0..body.count() {
                efforts[mech.nodes[body.nodes[i]].v] -= force * body.row(x, &shortening.matrix, i);
            }
        }
    }
}

impl<S: Space> Deforming<S> {
    /// Second-order displacements of the interfaces.
    fn shorten(&self, x: &mut [NodeState<S>]) {
        let half = S::T::from_f64(0.5);
        for shortening in &self.data.shortenings {
            let mut sum = S::T::zero();
            for i in 0..self.count() {
                sum += self.motion(x, i)[0] * self.row(x, &shortening.matrix, i);
            }
            x[self.nodes[shortening.along]].shortening = sum * half;
        }
    }

    /// `Σ_j C_ij d_j`.
    #[inline]
    fn row(&self, x: &[NodeState<S>], matrix: &[S::T], i: usize) -> S::T {
        let n = self.count();
        (0..n).fold(S::T::zero(), |sum, j| sum + matrix[i * n + j] * self.motion(x, j)[0])
    }

    /// `Σ_j K_ij e_j`.
    #[inline]
    fn stress(&self, x: &[NodeState<S>], i: usize) -> S::T {
        let n = self.count();
        let bent = self.data.shortenings.iter().fold(S::T::zero(), |sum, s| {
            sum + self.data.stiffness[i * n + s.along] * x[self.nodes[s.along]].shortening
        });
        bent + self.row(x, &self.data.stiffness, i)
    }

    #[inline]
    fn damped(&self, x: &[NodeState<S>], i: usize) -> S::T {
        let n = self.count();
        (0..n).fold(S::T::zero(), |sum, j| sum + self.data.damping[i * n + j] * self.motion(x, j)[1])
    }

    /// Elastic energy, J, with the second-order displacements of the last [`add_efforts`].
    pub(crate) fn elastic(&self, x: &[NodeState<S>]) -> S::T {
        let strained = |i: usize| {
            let bends = self.data.shortenings.iter().any(|s| s.along == i);
            let d = self.motion(x, i)[0];
            if bends { d + x[self.nodes[i]].shortening } else { d }
        };
        let twice = (0..self.count()).fold(S::T::zero(), |sum, i| sum + strained(i) * self.stress(x, i));
        twice * S::T::from_f64(0.5)
    }
}
