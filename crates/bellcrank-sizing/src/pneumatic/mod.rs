//! Pneumatic cylinders: what they can, what they need, which one to take.
//!
//! Forces, then the rod ([`buckling`]), the end of the stroke ([`cushion`]), the air ([`air`]), the
//! valve ([`flow`], ISO 6358), and [`select`] over a catalogue.

pub mod air;
pub mod buckling;
mod candidate;
mod checks;
mod conditions;
pub mod cushion;
mod cylinder;
pub mod flow;
pub mod force;

pub use buckling::{EndCondition, Mount, Mounting};
pub use candidate::{Air, CylinderCandidate, evaluate, select};
pub use conditions::{
    BUCKLING_SAFETY, BucklingLoad, Conditions, LOAD_FACTOR_FAST, LOAD_FACTOR_GENERAL, LOAD_FACTOR_SLOW, Supply,
};
pub use cylinder::Cylinder;
pub use flow::Conductance;
pub use force::{Side, WorkingPressure};
