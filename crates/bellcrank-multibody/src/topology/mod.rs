//! From joints to a spanning tree of elementary motions, and the links that close loops.

mod path;
mod steps;
mod tree;

pub(crate) use path::{PathEntry, path_between};
pub(crate) use steps::{Motion, Step, coordinate_count, joint_alignment, steps_of};
pub(crate) use tree::{Branch, Edge, spanning_tree};
