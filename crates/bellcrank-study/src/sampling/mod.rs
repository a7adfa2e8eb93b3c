//! Which points to look at, and how to look at many of them.
//!
//! Every point is computed from its number alone, so that a study can go on at any row and gives the same rows on any number
//! of threads. Points lie in the open unit cube; [`Distribution`] makes deviations of them.

mod distribution;
mod grid;
mod hypercube;
pub mod normal;
mod parallel;
mod random;
mod sobol;

pub use distribution::Distribution;
pub use grid::Grid;
pub use hypercube::LatinHypercube;
pub use parallel::{for_each_in_chunks, for_each_ordered};
pub use random::{mix, random_point, unit};
pub use sobol::{Sobol, SobolError};
