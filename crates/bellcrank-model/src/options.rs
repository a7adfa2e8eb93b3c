//! How studies are run, beside what the file says.

use std::path::PathBuf;

/// How studies are run. Results are the same for any number of threads.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RunOptions {
    /// Threads of studies over many designs; 0 is one a core.
    pub threads: usize,
    /// Where studies over many designs write their rows while they run (a folder a study); `None` keeps all in memory.
    pub folder: Option<PathBuf>,
    /// Files that studies of parts leave of their meshes.
    pub meshes: MeshFormats,
    /// Where reductions of flexible bodies are kept from run to run; `None` keeps them in memory alone.
    pub cache: Option<PathBuf>,
    /// Begin anew even where an interrupted study could go on.
    pub fresh: bool,
}

/// Formats of meshes with their results.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MeshFormats {
    /// For ParaView, with displacement, stress and its error.
    pub vtu: bool,
    /// A whole input file of CalculiX.
    pub inp: bool,
    /// For Gmsh.
    pub msh: bool,
}
