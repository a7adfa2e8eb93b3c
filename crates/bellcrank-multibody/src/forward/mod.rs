//! Forward dynamics: what forces make of a machine in time.
//!
//! `door` is what others see, `machine` the way from output to output. `saddle` solves masses and constraints together
//! (`articulated` does for a long tree without loops), `acceleration` and `project` use them; `start` makes the beginning
//! consistent. Time is stepped by `explicit` (over stretched `poses` with care) or `implicit` (by the tangents of
//! `stiffness`); `watch` looks for events in a step, `locks` does what they ask for. `modes` linearizes.

mod acceleration;
mod articulated;
mod door;
mod dop853;
mod explicit;
mod flight;
mod implicit;
mod locks;
mod machine;
mod mixing;
mod modes;
mod poses;
mod project;
mod saddle;
mod start;
mod state;
mod step;
mod stiffness;
mod watch;

pub use door::{
    Advance, Begun, Dynamics, Event, EventKind, Forward, Linearized, Method, Mode, SolverEffort, Surroundings,
};
pub(crate) use flight::Flight;
