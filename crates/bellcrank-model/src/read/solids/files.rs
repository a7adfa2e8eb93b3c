//! Meshes of other programs, and parts that an external program makes meshes of.

use std::path::Path;
use std::time::Duration;

use bellcrank_doc::Diagnostic;
use bellcrank_mesh::{FileError, Gmsh, Mesh, VolumeMesher, VolumeMesherError, VolumeWishes, read_inp, read_msh};

/// Faults of a file that are told; more help nobody.
const TOLD: usize = 8;
/// A mesher that has not answered by then will not.
const PATIENCE: Duration = Duration::from_secs(600);
/// Elements on a full turn: the volume of a bore of second-order elements is then exact to 1e-5.
const PER_TURN: f64 = 24.0;
/// The mesher's own choice for flat regions.
const ANY_SIZE: f64 = 1e22;

/// The mesh of an `inp` or `msh` file, in m.
pub(super) fn mesh(path: &Path, ending: &str, scale: f64) -> Result<Mesh, Vec<Diagnostic>> {
    let name = path.display();
    let bytes = std::fs::read(path)
        .map_err(|error| vec![Diagnostic::placeless("cannot-read", format!("cannot read `{name}`: {error}"))])?;
    let read = if ending == "inp" { read_inp(&bytes) } else { read_msh(&bytes) };
    let mut mesh = read.map_err(|errors| told(path, &errors))?.mesh;
    mesh.nodes.iter_mut().flatten().for_each(|x| *x *= scale);
    sound(path, mesh)
}

/// The mesh of a part, in m.
pub(super) fn part(path: &Path) -> Result<Mesh, Vec<Diagnostic>> {
    let wishes =
        VolumeWishes { size: ANY_SIZE, per_turn: PER_TURN, quadratic: true, timeout: PATIENCE, interrupted: &|| false };
    let mesher = Gmsh { program: "gmsh".into(), scratch: std::env::temp_dir() };
    match mesher.mesh(path, &wishes) {
        Ok(made) => sound(path, made.mesh),
        Err(error) => Err(vec![not_meshed(path, &error)]),
    }
}

fn not_meshed(path: &Path, error: &VolumeMesherError) -> Diagnostic {
    let report = Diagnostic::placeless("mesher", format!("no mesh of `{}`: {error}", path.display()));
    match error {
        VolumeMesherError::Absent { .. } => {
            report.hint("install Gmsh (gmsh.info), or mesh the part elsewhere and give the `.inp` or `.msh` file")
        }
        VolumeMesherError::Open { .. } => report.hint("mend it in the CAD program: a closed solid, not surfaces"),
        _ => report,
    }
}

fn told(path: &Path, errors: &[FileError]) -> Vec<Diagnostic> {
    let one = |error: &FileError| {
        let report = Diagnostic::placeless("mesh-file", format!("`{}`:{error}", path.display()));
        match error.fault.hint() {
            Some(hint) => report.hint(hint),
            None => report,
        }
    };
    errors.iter().take(TOLD).map(one).collect()
}

/// A mesh that encloses a volume, or what is wrong with it.
fn sound(path: &Path, mesh: Mesh) -> Result<Mesh, Vec<Diagnostic>> {
    let faults = mesh.check();
    if faults.is_empty() {
        return Ok(mesh);
    }
    let one =
        |fault| Diagnostic::placeless("mesh-file", format!("the mesh of `{}` is not sound: {fault}", path.display()));
    Err(faults.iter().take(TOLD).map(one).collect())
}
