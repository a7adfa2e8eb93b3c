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
mod statics;
mod system;
mod tangent;

pub use machine::{Machine, engine_for};
