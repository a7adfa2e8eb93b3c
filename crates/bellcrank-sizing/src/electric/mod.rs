//! Electric drives, linear and rotary: what they can, what they need, which one to take.
//!
//! The duty is brought to the motor shaft first ([`Drive::shaft_duty`]: gear, efficiency, own inertia), then compared
//! with the ratings there.

mod candidate;
mod checks;
mod conditions;
mod drive;

pub use candidate::{DriveCandidate, evaluate, select};
pub use conditions::Conditions;
pub use drive::{Drive, Gear, Kind};
