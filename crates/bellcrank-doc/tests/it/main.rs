//! The crate through its public face.

mod fuzz;
mod lift;
