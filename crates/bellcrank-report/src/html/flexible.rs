//! Flexible bodies: how they were reduced and the stress in them over the rows; and the numbers with which they move.

mod data;

pub(crate) use data::{any, push as push_data};
