//! Large sparse symmetric systems: a positive definite matrix, its factorization, its lowest eigenpairs.

mod matrix;

pub use matrix::SymmetricMatrix;
