//! The sparse solver, with its failures in terms of the part.

use std::sync::Arc;

use bellcrank_math::linalg::sparse::{
    Accuracy, Cholesky, Failure, Incomplete, IterationFailure, Plan, SymmetricMatrix, conjugate_gradients,
};

use crate::numbering::Numbering;
use crate::{Fault, Settings};

/// A failure by equation.
pub(crate) enum Failed {
    Loose { equation: usize },
    Interrupted,
    NotConverged { found: usize },
    Stagnated { residual: f64 },
    Memory { needed: usize, allowed: usize },
}

impl Failed {
    /// The failure with the node that its equation belongs to.
    pub(crate) fn named(self, numbering: &Numbering) -> Fault {
        match self {
            Failed::Interrupted => Fault::Interrupted,
            Failed::Stagnated { residual } => Fault::Stagnated { residual },
            Failed::Memory { needed, allowed } => Fault::Memory { needed, allowed },
            Failed::NotConverged { found } => Fault::NotConverged { found },
            Failed::Loose { equation } => {
                let (node, component) = numbering.owner(equation);
                Fault::Loose { node: node.unwrap_or(0) as u32, component }
            }
        }
    }
}

impl From<Failure> for Failed {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::NotPositive(found) => Failed::Loose { equation: found.row },
            Failure::Interrupted => Failed::Interrupted,
        }
    }
}

/// Residual of conjugate gradients, relative to the loads.
const ACCURACY: Accuracy = Accuracy { tolerance: 1e-10, iterations: 100_000 };

/// A stiffness matrix that systems can be solved with.
pub(crate) enum System {
    /// Factored.
    Direct(Cholesky),
    /// As it is, for conjugate gradients: its factor would not fit into memory.
    Iterated(SymmetricMatrix),
}

impl System {
    /// Factors where the factor fits into memory, and keeps the matrix where only that does.
    pub(crate) fn new(stiffness: SymmetricMatrix, settings: &Settings<'_>) -> Result<(Self, usize), Failed> {
        let plan = Arc::new(Plan::new(&stiffness));
        let own = 12 * stiffness.values.len();
        if settings.fits(plan.memory() + own).is_ok() {
            let entries = plan.factor_entries();
            let cholesky = Cholesky::factor(plan, &stiffness, settings.threads, settings.progress)?;
            return Ok((System::Direct(cholesky), entries));
        }
        // The incomplete factor has as many entries as the matrix.
        settings.fits(2 * own).map_err(|(needed, allowed)| Failed::Memory { needed, allowed })?;
        Ok((System::Iterated(stiffness), 0))
    }

    /// x ← K⁻¹ x.
    pub(crate) fn solve(&self, x: &mut [f64]) -> Result<(), Failed> {
        match self {
            System::Direct(cholesky) => {
                cholesky.solve(x);
                Ok(())
            }
            System::Iterated(stiffness) => iterate(stiffness, x),
        }
    }
}

fn iterate(stiffness: &SymmetricMatrix, x: &mut [f64]) -> Result<(), Failed> {
    let incomplete = Incomplete::new(stiffness).map_err(|found| Failed::Loose { equation: found.row })?;
    let rhs = x.to_vec();
    x.fill(0.0);
    match conjugate_gradients(stiffness, &incomplete, &rhs, x, ACCURACY, &|_| true) {
        Ok(_) => Ok(()),
        Err(IterationFailure::Interrupted(_)) => Err(Failed::Interrupted),
        Err(IterationFailure::Stagnated(at) | IterationFailure::NotPositive(at)) => {
            Err(Failed::Stagnated { residual: at.residual })
        }
    }
}
