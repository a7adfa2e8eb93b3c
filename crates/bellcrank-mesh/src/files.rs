//! Mesh files of other programs: Abaqus and CalculiX `.inp`, Gmsh `.msh`, VTK `.vtu`.
//!
//! Everything takes and gives bytes or text; files are opened elsewhere. A reader keeps going after an error, so that
//! all errors of a file come at once.

mod error;
mod inp;
mod inp_writer;
mod labels;
mod msh;
mod msh_writer;
mod vtu;

use std::collections::BTreeMap;

use crate::Mesh;

pub use error::{FileError, FileFault, Note};
pub use inp::read_inp;
pub use inp_writer::write_inp;
pub use msh::{read_msh, read_msh_entities};
pub use msh_writer::write_msh;
pub use vtu::{VtuField, write_vtu};

/// What a mesh file gave.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// The mesh, in the unit of the file; nodes that no element has are gone.
    pub mesh: Mesh,
    /// Named sets of elements, as (block, element), ascending. Sets that an element card names are blocks, too.
    pub element_sets: BTreeMap<String, Vec<(u32, u32)>>,
    /// Labels that the file gives the nodes.
    pub node_labels: Vec<u64>,
    /// What was left out, or read as something else.
    pub notes: Vec<Note>,
}
