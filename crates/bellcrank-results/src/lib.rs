//! Result columns with names and units, and their CSV and JSON writers.
//!
//! Everything in here is plain data in SI units; a [`Unit`] says how a number is shown.
//! No mechanics: what is stored was computed elsewhere.

mod drawing;
mod run;
mod study;
mod table;
mod unit;

pub use drawing::{Animation, Arrow, DrawnBody, DrawnJoint, Drawing, Pose, SpaceKind};
pub use run::{ParameterRow, Provenance, RunResult};
pub use study::{Failure, Reaction, StudyResult};
pub use table::{Column, Table};
pub use unit::Unit;
