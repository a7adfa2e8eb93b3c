//! From a path to a checked model, with everything that is wrong in one go.

use std::path::Path;

use bellcrank_doc::{Diagnostics, Sources};

use crate::Model;

/// What reading a file gave.
pub struct Loaded {
    /// All texts that were read: what diagnostics point into.
    pub sources: Sources,
    /// Everything found, in the order of places.
    pub diagnostics: Diagnostics,
    /// The model, when there is no error.
    pub model: Option<Model>,
}

/// Reads a model file with other values for some of its parameters (name and value as written on
/// the command line), and checks all of it.
#[must_use]
pub fn load(_path: &Path, _overrides: &[(String, String)]) -> Loaded {
    todo!()
}
