//! What is wrong with a mesh file, and what was left out of it.

use std::fmt;

/// A fault of a mesh file, with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct FileError {
    /// Line from 1.
    pub line: usize,
    /// Column from 1, in bytes.
    pub column: usize,
    /// What is wrong there.
    pub fault: FileFault,
}

/// What is wrong at a place of a mesh file.
#[derive(Clone, Debug, PartialEq)]
pub enum FileFault {
    /// Something else stands there.
    Expected {
        /// What belongs there.
        expected: &'static str,
        /// What was found.
        found: String,
    },
    /// The file ends too early.
    EndsEarly {
        /// What it ends in.
        within: &'static str,
    },
    /// A parameter of a card is missing.
    Parameter {
        /// The card.
        card: String,
        /// The parameter.
        parameter: &'static str,
    },
    /// A node, element or set that is not in the file.
    Unknown {
        /// `node`, `element` or `set`.
        what: &'static str,
        /// Its label or name.
        name: String,
    },
    /// A label that was used before.
    Twice {
        /// `node` or `element`.
        what: &'static str,
        /// The label.
        label: u64,
    },
    /// A set that contains itself.
    Circular {
        /// Its name.
        set: String,
    },
    /// An element does not have this face.
    NoFace {
        /// What was given.
        face: String,
        /// Shape of the element.
        shape: &'static str,
    },
    /// A solid element of a kind that is not read.
    Shape {
        /// Its name, or Gmsh's number for it.
        name: String,
    },
    /// Something that would change the mesh and is not read.
    Unsupported {
        /// The card.
        card: String,
    },
    /// The file is binary.
    Binary,
    /// A version of the format that is not read.
    Version {
        /// What the file says.
        found: String,
    },
}

impl fmt::Display for FileFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FileFault::Expected { expected, found } => write!(f, "expected {expected}, found `{found}`"),
            FileFault::EndsEarly { within } => write!(f, "the file ends too early, within {within}"),
            FileFault::Parameter { card, parameter } => write!(f, "`*{card}` needs `{parameter}=`"),
            FileFault::Unknown { what, name } => write!(f, "there is no {what} `{name}`"),
            FileFault::Twice { what, label } => write!(f, "{what} {label} is defined twice"),
            FileFault::Circular { set } => write!(f, "set `{set}` contains itself"),
            FileFault::NoFace { face, shape } => write!(f, "an element of type {shape} has no face `{face}`"),
            FileFault::Shape { name } => write!(
                f,
                "solid elements of type {name} are not read; expected 4 or 10 node tetrahedra, 6 or 15 node wedges, 8 \
                 or 20 node hexahedra"
            ),
            FileFault::Unsupported { card } => write!(f, "`*{card}` is not read, and the mesh is not whole without it"),
            FileFault::Binary => write!(f, "the file is binary; expected text"),
            FileFault::Version { found } => write!(f, "expected version 4.1 or 2.2 of the format, found `{found}`"),
        }
    }
}

impl FileFault {
    /// What to do about it, where that is not plain.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            FileFault::Binary => Some("write it as text: `Mesh.Binary = 0` in Gmsh"),
            FileFault::Version { .. } => Some("write it with `Mesh.MshFileVersion = 4.1` in Gmsh"),
            FileFault::Unsupported { card } if card == "INCLUDE" => Some("put the contents of that file in its place"),
            FileFault::Unsupported { .. } => {
                Some("write the mesh out flat: all nodes and elements of one part, in place")
            }
            FileFault::EndsEarly { .. } => Some("the file may have been cut while it was written or copied"),
            FileFault::Shape { .. } => Some("mesh with `Mesh.SecondOrderIncomplete = 1` in Gmsh, and without pyramids"),
            _ => None,
        }
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.line, self.column, self.fault)
    }
}

impl std::error::Error for FileError {}

/// What a reader left out of a file, or read as something else.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// A kind of card or section that says nothing about the mesh, or nothing that is read.
    Skipped {
        /// Its name.
        card: String,
        /// How often it is there.
        count: usize,
        /// Line of the first one.
        line: usize,
    },
    /// Elements that are no solids.
    ElementsLeftOut {
        /// Their type.
        name: String,
        /// How many.
        count: usize,
        /// Line of the first one.
        line: usize,
    },
    /// Elements that are integrated fully, without incompatible modes or extra pressures.
    ReadAs {
        /// The type in the file.
        name: String,
        /// The type that it is read as.
        shape: &'static str,
        /// Line of the first one.
        line: usize,
    },
    /// Nodes that no solid element has.
    NodesLeftOut {
        /// How many.
        count: usize,
    },
    /// Surface elements that are no face of a solid element on the outside.
    FacesLeftOut {
        /// Their set.
        set: String,
        /// How many.
        count: usize,
    },
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Note::Skipped { card, count: 1, line } => write!(f, "`{card}` in line {line} is not read"),
            Note::Skipped { card, count, line } => {
                write!(f, "{count} times `{card}` are not read, first in line {line}")
            }
            Note::ElementsLeftOut { name, count, line } => {
                write!(f, "{count} elements of type {name} are no solids and left out, first in line {line}")
            }
            Note::ReadAs { name, shape, line } => {
                write!(f, "elements of type {name} are integrated fully, as {shape}, first in line {line}")
            }
            Note::NodesLeftOut { count } => write!(f, "{count} nodes belong to no solid element and are left out"),
            Note::FacesLeftOut { set, count } => {
                write!(f, "{count} surface elements of `{set}` lie on no outer face of a solid and are left out")
            }
        }
    }
}

/// Errors of a file so far; more than that are not collected.
pub(super) const MOST_ERRORS: usize = 50;

#[derive(Default)]
pub(super) struct Errors(pub(super) Vec<FileError>);

impl Errors {
    pub(super) fn push(&mut self, (line, column): (usize, usize), fault: FileFault) {
        if self.0.len() < MOST_ERRORS {
            self.0.push(FileError { line, column, fault });
        }
    }

    pub(super) fn full(&self) -> bool {
        self.0.len() >= MOST_ERRORS
    }
}
