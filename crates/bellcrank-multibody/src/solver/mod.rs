//! The machine in motion: `f64` solves over the generic passes.

mod assembly;
mod balance;
mod checks;
mod efforts;
mod freedom;
mod jacobian;
mod machine;
mod position;
mod rates;
mod readings;
mod redundancy;
mod settling;
mod statics;
mod system;
mod tangent;
mod unknowns;

pub(crate) use assembly::SparseRows;
pub(crate) use balance::{Demands, turn_attitude_drives};
pub(crate) use freedom::{LARGE, RANK};
pub(crate) use jacobian::{Entry, Rows, source_entries};
pub(crate) use machine::Stage;
pub use machine::{Machine, engine_for};
pub(crate) use tangent::{Along, Slip, Tangent};
pub(crate) use unknowns::{OUT, Prescribed, Unknowns};
