//! Conjugate gradients, for systems whose factor does not fit into memory.
//!
//! Hestenes & Stiefel (1952), "Methods of conjugate gradients for solving linear systems"; Golub & Van Loan (2013), "Matrix
//! Computations", algorithm 11.5.1.

use super::factor::Progress;
use super::{Incomplete, SymmetricMatrix};

/// How far to go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// |b − A x| over |b| that will do.
    pub tolerance: f64,
    /// Iterations at most.
    pub iterations: usize,
}

/// What it took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iterated {
    /// Products with the matrix.
    pub iterations: usize,
    /// |b − A x| over |b|, computed afresh from x.
    pub residual: f64,
}

/// Why there is no solution; `x` holds the last iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IterationFailure {
    /// The residual has stopped to fall, or there were too many iterations.
    Stagnated(Iterated),
    /// A direction along which the matrix is not positive.
    NotPositive(Iterated),
    /// The caller's progress function asked to stop.
    Interrupted(Iterated),
}

/// Iterations in which the residual must come down to nine tenths of its least.
const PATIENCE: usize = 1000;

/// Solves A x = b from the `x` that is given. `progress` is told the share of the way in orders of magnitude.
///
/// # Errors
/// When the residual stagnates, the matrix is not positive definite, or `progress` returns false.
pub fn conjugate_gradients(
    matrix: &SymmetricMatrix,
    preconditioner: &Incomplete<'_>,
    b: &[f64],
    x: &mut [f64],
    accuracy: Accuracy,
    progress: Progress,
) -> Result<Iterated, IterationFailure> {
    let scale = length(b);
    if scale == 0.0 {
        x.fill(0.0);
        return Ok(Iterated { iterations: 0, residual: 0.0 });
    }
    let mut iteration = Iteration::start(matrix, preconditioner, b, x);
    let mut least = (f64::INFINITY, 0);
    for iterations in 0..accuracy.iterations {
        let mut now = Iterated { iterations, residual: length(&iteration.left) / scale };
        if now.residual <= accuracy.tolerance {
            // The recurrence drifts away from the residual by rounding: look at the residual itself, and go on from it.
            iteration.restart(b, x);
            now.residual = length(&iteration.left) / scale;
            if now.residual <= accuracy.tolerance {
                return Ok(now);
            }
        }
        if now.residual < 0.9 * least.0 {
            least = (now.residual, iterations);
        }
        if iterations - least.1 > PATIENCE {
            return Err(IterationFailure::Stagnated(now));
        }
        if iterations % 16 == 0 && !progress((now.residual.ln() / accuracy.tolerance.ln()).clamp(0.0, 1.0)) {
            return Err(IterationFailure::Interrupted(now));
        }
        if !iteration.step(x) {
            return Err(IterationFailure::NotPositive(now));
        }
    }
    iteration.restart(b, x);
    Err(IterationFailure::Stagnated(Iterated {
        iterations: accuracy.iterations,
        residual: length(&iteration.left) / scale,
    }))
}

/// The vectors of the recurrence.
struct Iteration<'a> {
    matrix: &'a SymmetricMatrix,
    preconditioner: &'a Incomplete<'a>,
    /// r = b − A x.
    left: Vec<f64>,
    /// z = preconditioned r.
    better: Vec<f64>,
    direction: Vec<f64>,
    /// A times the direction.
    image: Vec<f64>,
    /// rᵀ z.
    product: f64,
}

impl<'a> Iteration<'a> {
    fn start(matrix: &'a SymmetricMatrix, preconditioner: &'a Incomplete<'a>, b: &[f64], x: &[f64]) -> Self {
        let zeros = vec![0.0; b.len()];
        let (left, better, direction, image) = (zeros.clone(), zeros.clone(), zeros.clone(), zeros);
        let mut iteration = Self { matrix, preconditioner, left, better, direction, image, product: 0.0 };
        iteration.restart(b, x);
        iteration
    }

    /// Begins again at x, with the residual computed afresh.
    fn restart(&mut self, b: &[f64], x: &[f64]) {
        self.matrix.multiply(x, &mut self.image);
        self.left.iter_mut().zip(b).zip(&self.image).for_each(|((left, b), image)| *left = b - image);
        self.precondition();
        self.direction.copy_from_slice(&self.better);
    }

    fn precondition(&mut self) {
        self.better.copy_from_slice(&self.left);
        self.preconditioner.apply(&mut self.better);
        self.product = dot(&self.left, &self.better);
    }

    /// One step; false when the matrix is not positive along it.
    fn step(&mut self, x: &mut [f64]) -> bool {
        self.matrix.multiply(&self.direction, &mut self.image);
        let curvature = dot(&self.direction, &self.image);
        if curvature <= 0.0 || curvature.is_nan() {
            return false;
        }
        let along = self.product / curvature;
        x.iter_mut().zip(&self.direction).for_each(|(x, d)| *x += along * d);
        self.left.iter_mut().zip(&self.image).for_each(|(left, image)| *left -= along * image);
        let before = self.product;
        self.precondition();
        let keep = self.product / before;
        self.direction.iter_mut().zip(&self.better).for_each(|(d, z)| *d = z + keep * *d);
        true
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
