//! The lowest eigenpairs of K x = λ M x by block Lanczos on (K − σM)⁻¹ M, with full reorthogonalization in the product of M.
//!
//! Grimes, Lewis & Simon (1994), "A shifted block Lanczos algorithm for solving sparse symmetric generalized eigenproblems";
//! restarts as Wu & Simon (2000), "Thick-restart Lanczos method for large symmetric eigenvalue problems". A block finds as
//! many copies of a multiple eigenvalue as it is wide.

mod basis;
mod projected;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use self::basis::{Basis, Inverse};
use self::projected::Projected;
use super::factor::Progress;
use super::{Cholesky, Failure, Held, Plan, SymmetricMatrix};

/// Eigenvalues and eigenvectors of K x = λ M x.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Eigenpairs {
    /// λ, ascending.
    pub values: Vec<f64>,
    /// Eigenvectors, one after another, xᵢᵀ M xⱼ = δᵢⱼ.
    pub vectors: Vec<f64>,
    /// |K x − λ M x| over |(λ − σ) M x|, Euclidean, one an eigenpair.
    pub residuals: Vec<f64>,
    /// Solves with the factored matrix, one a right-hand side.
    pub solves: usize,
}

/// Why there are no eigenpairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EigenFailure {
    /// K − σM could not be factored, or the caller asked to stop.
    Factor(Failure),
    /// So many of the eigenpairs were found after the last restart.
    NotConverged {
        /// Eigenpairs with a residual within the tolerance.
        found: usize,
    },
}

/// A symmetric generalized eigenproblem.
#[derive(Clone, Copy, Debug)]
pub struct Eigenproblem<'a> {
    /// K, positive semidefinite.
    pub stiffness: &'a SymmetricMatrix,
    /// M, positive definite, with entries only where K has some.
    pub mass: &'a SymmetricMatrix,
}

/// |σ| as a share of tr K / tr M, which is near the largest eigenvalue: below what an elastic part's lowest mode has unless
/// it is very slender, and far above rounding, so that a body free to move is as well as one that is held.
const SHIFT: f64 = 1e-9;
/// Width of the block: more than the six rigid-body modes.
const BLOCK: usize = 8;
/// Largest residual of an eigenpair of the inverse, as a share of its eigenvalue. That of an eigenvalue is about its square.
const TOLERANCE: f64 = 1e-9;
/// Restarts before giving up.
const RESTARTS: usize = 40;

impl Eigenproblem<'_> {
    /// The `count` lowest eigenpairs (as many as there are rows, if fewer). `plan` is that of the stiffness. The stiffness may
    /// be singular: the shift is a small negative one. `progress` is told the share of the work done.
    ///
    /// # Errors
    /// When K − σM is not positive definite, when the iteration does not converge, or when `progress` returns false.
    pub fn lowest(
        &self,
        plan: &Arc<Plan>,
        count: usize,
        threads: usize,
        progress: Progress,
    ) -> Result<Eigenpairs, EigenFailure> {
        let shift = -SHIFT * self.stiffness.trace() / self.mass.trace();
        let shifted = self.stiffness.plus(-shift, self.mass);
        let factor = Cholesky::factor(Arc::clone(plan), &shifted, threads, &|share| progress(0.5 * share))
            .map_err(EigenFailure::Factor)?;
        drop(shifted);
        self.lowest_with(&factor, shift, count, &|share| progress(0.5 + 0.5 * share))
    }

    /// The `count` lowest eigenpairs with the factored K − σM at hand; σ = `shift` below all eigenvalues.
    ///
    /// # Errors
    /// When the iteration does not converge or `progress` returns false.
    pub fn lowest_with(
        &self,
        factor: &Cholesky,
        shift: f64,
        count: usize,
        progress: Progress,
    ) -> Result<Eigenpairs, EigenFailure> {
        self.search(Inverse::Free(factor), shift, count, progress)
    }

    /// The `count` lowest eigenpairs of K x + Cᵀ μ = λ M x with C x = 0, for the constraints of `held` (as many as they leave, if
    /// fewer). K may be singular where the constraints hold what it leaves free. The residuals are without what constraints
    /// can hold.
    ///
    /// # Errors
    /// When the iteration does not converge or `progress` returns false.
    pub fn lowest_held(&self, held: &Held, count: usize, progress: Progress) -> Result<Eigenpairs, EigenFailure> {
        self.search(Inverse::Held(held), 0.0, count, progress)
    }

    fn search(
        &self,
        inverse: Inverse,
        shift: f64,
        count: usize,
        progress: Progress,
    ) -> Result<Eigenpairs, EigenFailure> {
        let size = inverse.dimension(self.stiffness.size);
        let count = count.min(size);
        if count == 0 {
            return Ok(Eigenpairs::default());
        }
        let most = (2 * count + 12 * BLOCK).min(size);
        let mut basis = Basis::start(self.mass, inverse, BLOCK.min(size), most);
        let mut projected = Projected::default();
        for _ in 0..RESTARTS {
            loop {
                basis.extend(&mut projected);
                let found = projected.converged(count, TOLERANCE);
                if found == count || basis.complete() {
                    return Ok(self.collect(&basis, &projected, inverse, shift, count));
                }
                if !progress(found as f64 / count as f64) {
                    return Err(EigenFailure::Factor(Failure::Interrupted));
                }
                if basis.full() {
                    break;
                }
            }
            basis.restart(&mut projected, count + BLOCK);
        }
        Err(EigenFailure::NotConverged { found: projected.converged(count, TOLERANCE) })
    }

    fn collect(&self, basis: &Basis, projected: &Projected, inverse: Inverse, shift: f64, count: usize) -> Eigenpairs {
        let vectors = basis.combine(&projected.leading(count), count);
        let size = self.stiffness.size;
        let (mut stiff, mut heavy) = (vec![0.0; vectors.len()], vec![0.0; vectors.len()]);
        self.stiffness.multiply(&vectors, &mut stiff);
        self.mass.multiply(&vectors, &mut heavy);
        let mut pairs = Eigenpairs { vectors, solves: basis.solves, ..Eigenpairs::default() };
        let columns = pairs.vectors.chunks_exact(size).zip(stiff.chunks_exact(size).zip(heavy.chunks_exact(size)));
        for (x, (kx, mx)) in columns {
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let value = dot(x, kx) / dot(x, mx);
            let mut left: Vec<f64> = kx.iter().zip(mx).map(|(k, m)| k - value * m).collect();
            if let Inverse::Held(held) = inverse {
                held.without_held(&mut left);
            }
            pairs.values.push(value);
            pairs.residuals.push(dot(&left, &left).sqrt() / ((value - shift).abs() * dot(mx, mx).sqrt()));
        }
        pairs
    }
}
