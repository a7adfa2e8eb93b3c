//! Which points to look at: every sample can be computed from its index alone.

mod random;

pub use random::{mix, unit};
