//! Large sparse symmetric systems: a positive definite matrix, its factorization, its lowest eigenpairs.
//!
//! ```text
//! SymmetricMatrix ┬► Plan (order, supernodes, sizes) ─► Cholesky (numbers) ─► solve
//!                 │                                        ├► Held: solve under linear constraints
//!                 │                                        └► Eigenproblem: lowest eigenpairs
//!                 └► Incomplete ─► conjugate_gradients: where the factor does not fit into memory
//! ```

mod dissection;
mod factor;
mod front;
mod gradients;
mod held;
mod incomplete;
mod lanczos;
mod matrix;
mod plan;
mod quotient;
mod solve;
mod supernodes;
#[cfg(test)]
mod tests;
mod tree;
mod worker;

pub use factor::{Cholesky, Failure, NotPositive, Progress, SMALLEST_PIVOT};
pub use gradients::{Accuracy, Iterated, IterationFailure, conjugate_gradients};
pub use held::Held;
pub use incomplete::Incomplete;
pub use lanczos::{EigenFailure, Eigenpairs, Eigenproblem};
pub use matrix::SymmetricMatrix;
pub use plan::Plan;
