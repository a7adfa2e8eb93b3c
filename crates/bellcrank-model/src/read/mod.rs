//! From the tree of a file to the checked model: names resolved, every fault told.
//!
//! Files are read together, sort by sort: all bodies, then joints, then forces, motions and studies, so that a
//! file may refer to what its subsystems hold.

mod asks;
mod beams;
mod bodies;
mod context;
mod files;
mod flexible;
mod forces;
mod forward_keys;
mod grounds;
mod joints;
mod machine;
mod materials;
mod motions;
mod parts;
mod planes;
mod points;
mod solids;
mod starts;
mod studies;
mod study_keys;
mod tasks;
mod units;

pub(crate) use context::PartReader;
pub(crate) use files::{Files, Part, Tables, read_files};
pub(crate) use machine::{Machine, ReadModel, read_model};
