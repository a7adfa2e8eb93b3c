//! Finite element meshes.
//!
//! Reading order: [`Shape`] (nodes, faces, shape functions, integration points of each element), [`Mesh`] (nodes,
//! blocks of elements, named sets). Lengths are in m, in the axes of the body.

mod mesh;
mod shape;

pub use mesh::{Block, Face, Mesh};
pub use shape::{FaceShape, MOST_NODES, Point, Shape};
