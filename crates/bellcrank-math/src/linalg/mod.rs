//! Factorizations in `f64`.
//!
//! [`BandLu`] and [`Qr`] are filled and refilled without allocation: they serve the inner step.
//! [`dense`] is for the few questions asked once a study (singular values, eigenvalues).

#![expect(clippy::needless_range_loop, reason = "row and column indices are how the algorithms are written down")]

pub mod dense;
mod lu;
mod ordering;
mod qr;
pub mod sparse;

pub use lu::BandLu;
pub use ordering::{Ordering, band_ordering};
pub use qr::Qr;
