//! Finite element meshes.
//!
//! Reading order: [`Shape`] (nodes, faces, shape functions, integration points of each element), [`Mesh`] (nodes,
//! blocks of elements, named sets), [`mesh_stack`] (from a solid to a mesh), [`Quality`] and [`MeshFault`] (how good
//! it is, and what is wrong with it), [`read_inp`], [`read_msh`], [`write_vtu`] (files of other programs), [`Gmsh`] (parts
//! from other CAD programs). Lengths are in m, in the axes of the body.

mod boundary;
mod check;
mod cylinders;
mod element;
mod external;
mod files;
mod integrals;
mod mesh;
mod mesher;
mod quality;
mod shape;
mod surface;

pub use boundary::SharpEdge;
pub use check::MeshFault;
pub use cylinders::Cylinder;
pub use external::{Gmsh, VolumeMesh, VolumeMesher, VolumeMesherError, VolumeWishes};
pub use files::{
    FileError, FileFault, Imported, Note, VtuField, read_inp, read_msh, read_msh_entities, write_inp, write_msh,
    write_vtu,
};
pub use integrals::MeshMass;
pub use mesh::{Block, Face, Mesh};
pub use mesher::{Division, MesherError, SizeMap, Sizes, mesh_revolved, mesh_stack};
pub use quality::Quality;
pub use shape::{FaceShape, MOST_NODES, Point, Shape};
pub use surface::Surface;
