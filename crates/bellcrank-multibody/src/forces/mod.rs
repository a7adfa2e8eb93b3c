//! Force elements: where they act, and what they put there.
//!
//! An element with two ends puts its wrench on the second and the opposite on the first.

mod apply;
mod element;

pub(crate) use apply::{Output, Present, apply_all, friction_direction, friction_effort, holding_effort, push, read};
pub(crate) use element::{Element, Friction, elements_of};
