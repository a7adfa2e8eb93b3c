//! The sparse solver, with its failures in terms of the part.

use std::sync::Arc;

use bellcrank_math::linalg::sparse::{Cholesky, Failure, Plan, SymmetricMatrix};

use crate::numbering::Numbering;
use crate::{Fault, Settings};

/// A failure by equation.
pub(crate) enum Failed {
    Loose { equation: usize },
    Interrupted,
    NotConverged { found: usize },
}

impl Failed {
    /// The failure with the node that its equation belongs to.
    pub(crate) fn named(self, numbering: &Numbering) -> Fault {
        match self {
            Failed::Interrupted => Fault::Interrupted,
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

pub(crate) fn factor(plan: &Arc<Plan>, matrix: &SymmetricMatrix, settings: &Settings<'_>) -> Result<Cholesky, Failed> {
    Ok(Cholesky::factor(Arc::clone(plan), matrix, settings.threads, settings.progress)?)
}
