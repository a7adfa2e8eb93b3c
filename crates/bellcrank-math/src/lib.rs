//! Scalars, planar and spatial algebra, and small dense solves of bellcrank.
//!
//! Reading order: [`Real`] (what a number must do), [`Dual`] (numbers that carry derivatives),
//! [`Vector`], [`Space`] with its two members [`Planar`] and [`Spatial`], [`Frame`], and
//! [`linalg`] (factorizations in `f64`). No mechanics and no files.

mod dual;
mod frame;
pub mod linalg;
mod planar;
mod real;
mod space;
mod spatial;
mod vector;

pub use dual::Dual;
pub use frame::Frame;
pub use planar::Planar;
pub use real::Real;
pub use space::{Components, Space};
pub use spatial::{Matrix3, Spatial, matrix_from_quaternion, matrix_from_rpy, quaternion_from_matrix, rpy_from_matrix};
pub use vector::Vector;
