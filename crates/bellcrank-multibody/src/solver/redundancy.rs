//! Redundant constraints: which reactions equilibrium determines, and the least-norm choice of the rest.
//!
//! The null space of Jᵀ holds the states of self-stress. A reaction component is unique when no self-stress
//! changes it. Among all solutions the one is taken whose joint reactions, all joints together, are
//! smallest (moments divided by the machine's size), so that the answer does not depend on which joints
//! happen to close loops.

use super::balance::Demands;
use super::machine::{Machine, Prepared};
use super::unknowns::Prescribed;
use bellcrank_math::{Space, linalg::dense};

/// A component changes with self-stress when it exceeds this part of the largest change.
const CHANGES: f64 = 1e-8;

impl<S: Space<T = f64>> Machine<S> {
    /// Adds self-stress to λ so that all joint reactions together are least.
    pub(crate) fn choose_least_norm(&mut self, prescribed: &[Prescribed], null: &[Vec<f64>]) {
        let particular = self.lambda.clone();
        self.gather_with_loops(prescribed, Demands::All);
        let base = self.weighted_wrenches();
        let stress = self.self_stresses(prescribed, null);
        let columns: Vec<&Vec<f64>> = stress.iter().map(|s| &s.1).collect();
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let normal: Vec<Vec<f64>> = columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect();
        let rhs: Vec<f64> = columns.iter().map(|a| -product(a, &base)).collect();
        self.lambda = particular;
        if let Some(z) = dense::solve(&normal, &rhs) {
            for (k, z) in z.iter().enumerate() {
                self.lambda.iter_mut().zip(&stress[k].0).for_each(|(l, n)| *l += z * n);
            }
        }
    }

    /// Each state of self-stress: its multipliers and the joint wrenches it makes (weighted).
    fn self_stresses(&mut self, prescribed: &[Prescribed], null: &[Vec<f64>]) -> Vec<(Vec<f64>, Vec<f64>)> {
        let own = self.wrench.clone();
        let saved = (self.friction.clone(), self.lambda.clone());
        let outputs = self.outputs.clone();
        self.friction.fill(0.0);
        self.outputs.iter_mut().for_each(|o| o.effort = 0.0);
        let stresses = null
            .iter()
            .map(|vector| {
                self.lambda.fill(0.0);
                self.lambda[..vector.len()].copy_from_slice(vector);
                self.gather_with_loops(prescribed, Demands::None);
                (self.lambda.clone(), self.weighted_wrenches())
            })
            .collect();
        (self.friction, self.lambda) = saved;
        self.outputs = outputs;
        self.wrench = own;
        stresses
    }

    /// All joint wrenches in one list of six a joint, moments divided by the machine's size.
    fn weighted_wrenches(&self) -> Vec<f64> {
        let size = self.mech.size;
        let six = |w: &(S::Vector, S::Angular)| {
            let (f, n) = (S::spread(w.0), S::spread_angular(w.1));
            [f[0], f[1], f[2], n[0] / size, n[1] / size, n[2] / size]
        };
        self.wrench.iter().flat_map(six).collect()
    }

    pub(crate) fn unique_components(&mut self) -> Vec<[bool; 6]> {
        let all = vec![[true; 6]; self.wrench.len()];
        let stresses = match (self.flight.take(), self.prepared.take()) {
            (Some(flight), prepared) => {
                let stresses = self.self_stresses(&flight.saddle.prescribed, &flight.saddle.self_stresses());
                (self.flight, self.prepared) = (Some(flight), prepared);
                stresses
            }
            (None, Some(mut prepared)) => {
                let Prepared { position, rate, effort, .. } = &mut *prepared;
                let system = effort.as_mut().or(rate.as_mut()).unwrap_or(position);
                self.rows.evaluate(&self.mech, &self.q, &self.x);
                system.factor(&self.mech, &self.rows, &self.x);
                let stresses = self.self_stresses(&system.prescribed, &system.null_vectors());
                self.prepared = Some(prepared);
                stresses
            }
            (None, None) => return all,
        };
        let mut unique = all;
        for (_, change) in &stresses {
            let top = change.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            for (j, joint) in unique.iter_mut().enumerate() {
                for (c, u) in joint.iter_mut().enumerate() {
                    *u &= change[6 * j + c].abs() <= CHANGES * top;
                }
            }
        }
        unique
    }
}
