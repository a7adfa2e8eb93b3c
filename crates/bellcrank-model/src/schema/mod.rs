//! The format as data: one table of keys for the reader, the JSON Schema and the hints.

mod joints_and_forces;
mod json;
mod keys;
mod studies;
mod tables;

pub(crate) use joints_and_forces::{FORCE, JOINT};
pub use json::schema;
pub(crate) use keys::{AXES, Along, Key, Schema, Shape};
pub(crate) use studies::{AVAILABLE, OPEN, STUDY};
pub(crate) use tables::{BODY, GROUND, MODEL, MOTION, PLACE, SEGMENT, SUBSYSTEM};
