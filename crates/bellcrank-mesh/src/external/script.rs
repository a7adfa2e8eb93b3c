//! The script that Gmsh runs.

use std::fmt::Write;
use std::path::Path;

use super::{VolumeMesherError, VolumeWishes};

/// What the script says when there is nothing to fill.
pub(super) const OPEN: &str = "bellcrank: no volume";

pub(super) fn script(file: &Path, wishes: &VolumeWishes) -> Result<String, VolumeMesherError> {
    let mut text = String::new();
    let name = file.to_string_lossy().replace('\\', "\\\\").replace('"', "\\\"");
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("step" | "stp") => {
            let _ = writeln!(text, "SetFactory(\"OpenCASCADE\");\nGeometry.OCCTargetUnit = \"M\";");
            let _ = writeln!(text, "Geometry.OCCSewFaces = 0;\nMerge \"{name}\";\nv() = Volume{{:}};");
            let _ = writeln!(text, "If (#v() == 0)\n  Error(\"{OPEN}\");\n  Abort;\nEndIf");
        }
        Some("stl") => {
            let _ = writeln!(text, "Merge \"{name}\";\nClassifySurfaces{{40*Pi/180, 1, 1, Pi}};\nCreateGeometry;");
            let _ = writeln!(text, "Surface Loop(1) = Surface{{:}};\nVolume(1) = {{1}};");
        }
        _ => return Err(VolumeMesherError::FileKind { file: file.to_owned() }),
    }
    let order = if wishes.quadratic { 2 } else { 1 };
    let _ = writeln!(text, "Mesh.MeshSizeMax = {:e};\nMesh.MeshSizeFromCurvature = {};", wishes.size, wishes.per_turn);
    let _ =
        writeln!(text, "Mesh.ElementOrder = {order};\nMesh.SecondOrderIncomplete = 1;\nMesh.HighOrderOptimize = 2;");
    let _ = writeln!(text, "Mesh.Optimize = 1;\nMesh.MshFileVersion = 4.1;\nMesh.Binary = 0;\nMesh.SaveAll = 1;");
    Ok(text)
}
