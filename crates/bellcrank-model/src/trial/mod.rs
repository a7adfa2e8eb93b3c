//! One study run for a few numbers: designs are tried here, with exact derivatives when asked (differences
//! by what makes another mesh).
//!
//! A [`Trial`] holds a machine and a study. [`Trial::run`] gives it other parameters and works out the responses;
//! [`Trial::gradients`] follows with their derivatives at the same design. Maxima and minima are those of the curve
//! between the rows, too: the rows only say where to look.

mod asked;
mod differences;
mod extremes;
mod gradient;
mod machine;
mod plain;
mod turning;

pub(crate) use asked::Asked;
pub(crate) use gradient::{Derived, Piece};
pub(crate) use machine::{Trial, Undefined};
pub(crate) use plain::Plain;
pub(crate) use turning::running_on;

#[cfg(test)]
mod tests;
