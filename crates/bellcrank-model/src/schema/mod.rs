//! The format as data: one table of keys for the reader, the JSON Schema and the hints.

mod asks;
mod flexible;
mod joints_and_forces;
mod json;
mod keys;
mod parts;
mod sizing;
mod solids;
mod studies;
mod tables;

pub(crate) use asks::{ASKING, LIMITS, LOADING, OBJECTIVE, RANGE, SCATTER, VARIABLE, WITH_ROWS};
pub(crate) use flexible::BEAM;
pub(crate) use joints_and_forces::{FORCE, JOINT};
pub use json::schema;
pub(crate) use keys::{AXES, Along, DIRECTIONS, Key, Schema, Shape};
pub(crate) use parts::{LOAD, SUPPORT};
pub(crate) use sizing::{ELECTRIC_KEYS, PNEUMATIC_KEYS};
pub(crate) use solids::{CORNER, CUT, EYE, MATERIAL, PLATE, SOLID, WEB};
pub(crate) use studies::{AVAILABLE, OPEN, STUDY};
pub(crate) use tables::{BODY, GROUND, MODEL, MOTION, PLACE, SEGMENT, SUBSYSTEM};
