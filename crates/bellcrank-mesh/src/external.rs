//! Meshing of parts from other CAD programs: an external program turns a STEP or STL file into a mesh.
//!
//! The one place of this crate that opens files and starts a process.

mod gmsh;
mod run;
mod script;

use std::fmt;
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::{Cylinder, FileError, Mesh, Note};

pub use gmsh::Gmsh;

/// Something that meshes a file of geometry.
pub trait VolumeMesher {
    /// Meshes a STEP file (lengths in its own unit, read into m) or an STL file (lengths as they are).
    ///
    /// # Errors
    ///
    /// When the mesher is absent, finds fault with the geometry, takes too long, or is interrupted.
    fn mesh(&self, file: &Path, wishes: &VolumeWishes) -> Result<VolumeMesh, VolumeMesherError>;
}

/// What is wanted of a mesh of a part.
#[derive(Clone, Copy)]
pub struct VolumeWishes<'a> {
    /// Largest length of an element's edge, in m (STL: in the unit of the file).
    pub size: f64,
    /// Elements on a full turn of curved faces.
    pub per_turn: f64,
    /// Whether elements have mid-side nodes.
    pub quadratic: bool,
    /// The program is stopped after that time.
    pub timeout: Duration,
    /// Asked several times a second; the program is stopped when it says true.
    pub interrupted: &'a dyn Fn() -> bool,
}

/// A mesh of a part.
#[derive(Clone, Debug)]
pub struct VolumeMesh {
    /// Its surfaces are the face sets and node sets `face.1`, `face.2`, …
    pub mesh: Mesh,
    /// Faces that are cylinders: bores to hang joints on.
    pub cylinders: Vec<Cylinder>,
    /// Warnings of the program.
    pub warnings: Vec<String>,
    /// What was left out of its answer.
    pub notes: Vec<Note>,
}

/// Why a part was not meshed.
#[derive(Clone, Debug, PartialEq)]
pub enum VolumeMesherError {
    /// The program is not there.
    Absent {
        /// What was looked for.
        program: PathBuf,
    },
    /// The file ends neither in `.step`, `.stp` nor in `.stl`.
    FileKind {
        /// The file.
        file: PathBuf,
    },
    /// A file or the program could not be opened.
    Io {
        /// The file or the program.
        what: PathBuf,
        /// What the system says.
        reason: String,
    },
    /// The geometry encloses no volume: its surface is open.
    Open {
        /// Errors and warnings of the program.
        messages: Vec<String>,
    },
    /// The program failed.
    Failed {
        /// Errors and warnings of the program, the last ones.
        messages: Vec<String>,
    },
    /// The program took too long.
    TimedOut {
        /// After that time.
        after: Duration,
    },
    /// The user interrupted it.
    Interrupted,
    /// Its answer was not understood.
    Answer {
        /// Faults of the mesh file.
        errors: Vec<FileError>,
    },
}

impl fmt::Display for VolumeMesherError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            VolumeMesherError::Absent { program } => write!(
                f,
                "the mesher `{}` was not found; STEP and STL parts need Gmsh, while solids of eyes, webs and plates and \
                 meshes in `.inp` or `.msh` files work without it",
                program.display()
            ),
            VolumeMesherError::FileKind { file } => {
                write!(f, "expected a file that ends in .step, .stp or .stl, found `{}`", file.display())
            }
            VolumeMesherError::Io { what, reason } => write!(f, "`{}`: {reason}", what.display()),
            VolumeMesherError::Open { messages } => {
                write!(f, "the surface of the part is open, so it encloses no volume{}", Said(messages))
            }
            VolumeMesherError::Failed { messages } => write!(f, "the mesher failed{}", Said(messages)),
            VolumeMesherError::TimedOut { after } => {
                write!(f, "the mesher was stopped after {} s without an answer", after.as_secs_f64())
            }
            VolumeMesherError::Interrupted => write!(f, "the mesher was interrupted"),
            VolumeMesherError::Answer { errors } => match errors.first() {
                Some(first) => write!(f, "the mesher's answer is not understood: {first}"),
                None => write!(f, "the mesher's answer is not understood"),
            },
        }
    }
}

impl std::error::Error for VolumeMesherError {}

/// Messages of the program after a sentence of ours.
struct Said<'a>(&'a [String]);

impl fmt::Display for Said<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().enumerate().try_for_each(|(k, line)| write!(f, "{}{line}", if k == 0 { ": " } else { "; " }))
    }
}
