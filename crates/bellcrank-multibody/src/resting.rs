//! Generalized forces of a machine at rest: the residual of statics, over any scalar.

use crate::attitude::{quaternion_of, quaternion_product};
use crate::dynamics;
use crate::forces::{Output, Present, apply_all};
use crate::kinematics;
use crate::mechanism::{Mechanism, Source};
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::{Real, Space};

/// Buffers for one scalar.
pub(crate) struct Resting<S: Space> {
    pub(crate) q: Vec<S::T>,
    pub(crate) inputs: Vec<S::T>,
    x: Vec<NodeState<S>>,
    rest: Vec<S::T>,
    efforts: Vec<S::T>,
    outputs: Vec<Output<S>>,
    /// `Q + Jᵀλ`, nv.
    pub(crate) force: Vec<S::T>,
}

impl<S: Space> Resting<S> {
    pub(crate) fn new(mech: &Mechanism<S>) -> Self {
        let o = S::T::zero();
        Self {
            q: vec![o; mech.nq],
            inputs: vec![o; mech.inputs],
            x: vec![NodeState::default(); mech.nodes.len()],
            rest: vec![o; mech.nv],
            efforts: vec![o; mech.nv],
            outputs: vec![Output::default(); mech.elements.len()],
            force: vec![o; mech.nv],
        }
    }

    /// `Q(q) + Jᵀλ` along the tree's coordinates (N, N·m): weights, elements at rest, multipliers `lambda` of
    /// all rows and efforts `held` along prescribed coordinates.
    pub(crate) fn generalized_force(&mut self, mech: &Mechanism<S>, lambda: &[f64], held: &[(Source, f64)]) {
        kinematics::positions(mech, &self.q, &mut self.x);
        let now = Present { mech, q: &self.q, v: &self.rest, inputs: &self.inputs };
        apply_all(&now, &mut self.x, &mut self.efforts, &mut self.outputs);
        self.apply_multipliers(mech, lambda, held);
        dynamics::own_wrenches(mech, &mut self.x);
        for x in &mut self.x {
            (x.f, x.n) = (x.own_f, x.own_n);
        }
        dynamics::gather(mech, &mut self.x);
        dynamics::project(mech, &self.x, &mut self.force);
        for (f, e) in self.force.iter_mut().zip(&self.efforts) {
            *f = *e - *f;
        }
    }

    fn apply_multipliers(&mut self, mech: &Mechanism<S>, lambda: &[f64], held: &[(Source, f64)]) {
        for &k in &mech.closing {
            let link = &mech.links[k];
            let pose = link.pose(&self.x);
            for (i, kind) in link.rows.iter().enumerate() {
                let g = link.row(*kind, &pose);
                let l = S::T::from_f64(lambda[link.first_row + i]);
                self.x[link.ends[1].0].apply(pose.p[1], g.f * l, g.n * l);
                self.x[link.ends[0].0].apply(pose.p[1], -(g.f * l), -(g.n * l));
            }
        }
        for (i, c) in mech.couplings.iter().enumerate() {
            let l = S::T::from_f64(lambda[mech.link_rows + i]);
            self.push(mech, c.b, l);
            self.push(mech, c.a, -(c.ratio * l));
        }
        for (source, effort) in held {
            self.push(mech, *source, S::T::from_f64(*effort));
        }
    }

    fn push(&mut self, mech: &Mechanism<S>, source: Source, e: S::T) {
        crate::forces::push(mech, &mut self.x, &mut self.efforts, source, e);
    }

    /// Positions `q` moved by `step` along velocity component `k`.
    pub(crate) fn displace(&mut self, mech: &Mechanism<S>, q: &[f64], k: usize, step: S::T) {
        for (x, q) in self.q.iter_mut().zip(q) {
            *x = S::T::from_f64(*q);
        }
        for node in &mech.nodes[1..] {
            if !(node.v..node.v + node.motion.dofs()).contains(&k) {
                continue;
            }
            if matches!(node.motion, Motion::Ball) {
                let mut turn = [S::T::zero(); 3];
                turn[k - node.v] = step;
                let old = std::array::from_fn(|i| self.q[node.q + i]);
                let new = quaternion_product(&quaternion_of(&turn), &old);
                self.q[node.q..node.q + 4].copy_from_slice(&new);
            } else {
                self.q[node.q] += step;
            }
        }
    }
}
