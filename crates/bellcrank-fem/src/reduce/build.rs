//! From a part and its interfaces to the reduction.

use super::columns::{self, FixedModes};
use super::matrices::decouple;
use super::problem::{Factored, Problem};
use super::products::table;
use super::{Interface, Keep, Reduction, ReductionChecks, free};
use crate::numbering::rigid_motions;
use crate::vector::{self, V3};
use crate::{Effort, Fault, Part, Settings};

impl Reduction {
    /// Reduces a part, which has no supports and couplings of its own.
    ///
    /// # Errors
    /// Everything that is wrong with the part; no interface, one without faces or nodes, one whose nodes lie on a line,
    /// two that share a node; more modes than there are; no convergence; no memory.
    pub fn craig_bampton(
        part: &Part<'_>,
        interfaces: &[Interface],
        keep: &Keep,
        settings: &Settings<'_>,
    ) -> Result<Self, Vec<Fault>> {
        let problem = Problem::new(part, interfaces, settings)?;
        let (factor, effort) = problem.factor(settings)?;
        let factored = problem.with(&factor)?;
        let modes = FixedModes::new(&factored, keep, settings)?;
        Ok(collect(&factored, modes, effort, settings.threads))
    }
}

fn collect(factored: &Factored<'_, '_>, modes: FixedModes, effort: Effort, threads: usize) -> Reduction {
    let problem = factored.problem;
    let mut shapes = columns::of_interfaces(factored);
    shapes.extend(modes.shapes);
    let forces = problem.times_stiffness(&shapes);
    let n = shapes.len();
    let mut reduction = Reduction {
        points: problem.interfaces.iter().map(|interface| interface.point).collect(),
        modes: modes.eigenvalues.len(),
        frequencies: modes.eigenvalues.iter().map(|l| l.max(0.0).sqrt() / (2.0 * std::f64::consts::PI)).collect(),
        stiffness: table(&shapes, &forces),
        inertia: problem.integrals(&shapes, threads),
        shapes,
        checks: ReductionChecks { mode_residual: modes.residual, ..ReductionChecks::default() },
        effort,
    };
    reduction.checks.static_residual = static_residual(factored, &forces[..n - reduction.modes]);
    reduction.tidy(&modes.eigenvalues);
    reduction.checks.rigid = reduction.rigid_deviation(&problem.part.mesh.nodes, &problem.used());
    reduction.checks.unstrained = reduction.unstrained();
    reduction.checks.free_frequencies = free::natural_frequencies(&reduction.stiffness, &reduction.mass());
    reduction
}

/// Largest force on a free unknown, without what distributing interfaces hold, relative to the largest force there is.
fn static_residual(factored: &Factored<'_, '_>, forces: &[Vec<V3>]) -> f64 {
    let largest = |forces: &[f64]| forces.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    let mut worst = 0.0_f64;
    for forces in forces {
        let mut left = factored.problem.gather(forces);
        if let Some(held) = &factored.held {
            held.without_held(&mut left);
        }
        worst = worst.max(largest(&left) / largest(forces.as_flattened()).max(f64::MIN_POSITIVE));
    }
    worst
}

impl Reduction {
    /// Makes the stiffness what it is but for rounding, and notes how much that was.
    fn tidy(&mut self, eigenvalues: &[f64]) {
        let (n, boundary) = (self.coordinates(), 6 * self.points.len());
        let k = self.stiffness.clone();
        let scale = |i: usize, j: usize| (k[i * (n + 1)] * k[j * (n + 1)]).abs().sqrt().max(f64::MIN_POSITIVE);
        for i in 0..n {
            for j in 0..i {
                let (a, b) = (k[i * n + j], k[j * n + i]);
                self.checks.symmetry = self.checks.symmetry.max((a - b).abs() / scale(i, j));
                if i >= boundary && j < boundary {
                    self.checks.coupling = self.checks.coupling.max(a.abs().max(b.abs()) / scale(i, j));
                }
                let mean = f64::midpoint(a, b);
                (self.stiffness[i * n + j], self.stiffness[j * n + i]) = (mean, mean);
            }
        }
        decouple(&mut self.stiffness, eigenvalues, n);
    }

    /// How far the columns are from rigid motion when all interfaces move as one rigid body.
    fn rigid_deviation(&self, nodes: &[V3], used: &[bool]) -> f64 {
        let mut worst = 0.0_f64;
        for (k, motion) in self.rigid_motions().iter().enumerate() {
            let (mut apart, mut size) = (0.0_f64, 0.0_f64);
            for (node, at) in nodes.iter().enumerate().filter(|(node, _)| used[*node]) {
                let wanted = rigid_motions(*at)[k];
                let mut found = [0.0; 3];
                for (shape, share) in self.shapes.iter().zip(motion) {
                    vector::accumulate(&mut found, vector::scale(shape[node], *share));
                }
                apart = apart.max(vector::norm(vector::sub(found, wanted)));
                size = size.max(vector::norm(wanted));
            }
            worst = worst.max(apart / size.max(f64::MIN_POSITIVE));
        }
        worst
    }

    /// Force that rigid motion leaves in the stiffness, relative to the sum of the sizes of what cancels.
    fn unstrained(&self) -> f64 {
        let mut worst = 0.0_f64;
        for motion in self.rigid_motions() {
            for row in self.stiffness.chunks_exact(self.coordinates()) {
                let terms = || row.iter().zip(&motion).map(|(k, z)| k * z);
                let size: f64 = terms().map(f64::abs).sum();
                worst = worst.max(terms().sum::<f64>().abs() / size.max(f64::MIN_POSITIVE));
            }
        }
        worst
    }
}
