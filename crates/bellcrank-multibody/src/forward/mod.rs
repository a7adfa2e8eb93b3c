//! Forward dynamics: what forces make of a machine in time.

mod door;
mod machine;

pub use door::{
    Advance, Begun, Dynamics, Event, EventKind, Forward, Linearized, Method, Mode, SolverEffort, Surroundings,
};
