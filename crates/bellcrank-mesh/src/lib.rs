//! Finite element meshes.
//!
//! Reading order: [`Shape`] (nodes, faces, shape functions, integration points of each element), [`Mesh`] (nodes,
//! blocks of elements, named sets), [`mesh_stack`] (from a solid to a mesh), [`Quality`] and [`MeshFault`] (how good
//! it is, and what is wrong with it). Lengths are in m, in the axes of the body.

mod boundary;
mod check;
mod element;
mod integrals;
mod mesh;
mod mesher;
mod quality;
mod shape;

pub use boundary::SharpEdge;
pub use check::MeshFault;
pub use integrals::MeshMass;
pub use mesh::{Block, Face, Mesh};
pub use mesher::{Division, MesherError, Sizes, mesh_stack};
pub use quality::Quality;
pub use shape::{FaceShape, MOST_NODES, Point, Shape};
