//! Prescribed motions as functions of time, with exact first and second derivatives.

mod csv;
mod jet;
mod profile;
mod programme;
mod running;
mod schedule;
mod spline;

pub(crate) use csv::{Columns, read_table};
pub(crate) use jet::Jet;
pub(crate) use profile::Profile;
pub(crate) use programme::{EPS, Programme, Track, Turn};
pub(crate) use running::{Running, Stretch};
pub(crate) use schedule::Schedule;
pub(crate) use spline::Spline;

#[cfg(test)]
mod tests;
