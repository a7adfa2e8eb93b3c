//! A motion as binary glTF 2.0 (GLB): what Blender, web viewers and three.js open.
//!
//! One node a body under one root that turns the machine upright (glTF's y is up), the solid parts of the drawing
//! as meshes, one animation with the translation and rotation of every body that moves. An own writer: the
//! containers of the `gltf-json` crate are what `serde_json`, which is here anyway, writes in one page.
//! Format: <https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html>.

mod buffer;
mod materials;
mod mesh;
mod motion;
mod plate;
mod surface;

use std::io::{self, Write};

use serde_json::{Value, json};

use crate::solid::vector::cross;
use crate::{Drawing, RunResult, Solid, StudyResult, solids};
use buffer::Buffer;
use materials::Materials;
use mesh::Mesh;

const MAGIC: &[u8; 4] = b"glTF";
const VERSION: u32 = 2;

/// Right, up and towards the reader (rows, world axes) when a drawing with that `up` is seen from the front.
///
/// A plane is seen from +z, a machine that stands on the x-y plane from -y with x to the right.
pub fn upright([x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    let right = if z == 0.0 { [y, 0.0 - x, 0.0] } else { [1.0, 0.0, 0.0] };
    [right, [x, y, z], cross(right, [x, y, z])]
}

/// Writes the drawing and the motion of a study as GLB; without frames the file has no nodes.
///
/// Rows over time play in true time from 0, others spread over 4 s. Positions are in metres, numbers `f32`.
/// Frames that hold a number which is not finite are left out.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_glb(run: &RunResult, study: &StudyResult, mut out: impl Write) -> io::Result<()> {
    let (document, bytes) = document(run, study);
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let total = 12 + 8 + text.len() + if bytes.is_empty() { 0 } else { 8 + bytes.len() };
    out.write_all(MAGIC)?;
    out.write_all(&VERSION.to_le_bytes())?;
    out.write_all(&(total as u32).to_le_bytes())?;
    write_chunk(&mut out, *b"JSON", &text)?;
    if !bytes.is_empty() {
        write_chunk(&mut out, *b"BIN\0", &bytes)?;
    }
    out.flush()
}

fn write_chunk(out: &mut impl Write, kind: [u8; 4], bytes: &[u8]) -> io::Result<()> {
    out.write_all(&(bytes.len() as u32).to_le_bytes())?;
    out.write_all(&kind)?;
    out.write_all(bytes)
}

/// The JSON part, and the bytes that it points into.
fn document(run: &RunResult, study: &StudyResult) -> (Value, Vec<u8>) {
    let mut document = json!({
        "asset": {
            "version": "2.0",
            "generator": format!("bellcrank {}", run.provenance.version),
            "extras": { "model": run.model, "study": study.name, "kind": study.kind, "hash": run.provenance.hash },
        },
    });
    let Some(animation) = study.animation.as_ref().filter(|animation| !animation.frames.is_empty()) else {
        return (document, Vec::new());
    };
    let mut buffer = Buffer::default();
    let mut materials = Materials::default();
    let parts = solids(&run.drawing, animation);
    let (meshes, mesh_of) = meshes(&run.drawing, &parts, &mut buffer, &mut materials);
    document["scene"] = json!(0);
    document["scenes"] = json!([{ "name": run.model, "nodes": [0] }]);
    document["nodes"] = nodes(run, animation, &mesh_of);
    for (key, list) in [("meshes", meshes), ("materials", materials.list(&run.drawing))] {
        if !list.is_empty() {
            document[key] = Value::Array(list);
        }
    }
    if let Some(motion) = motion::animation(study, animation, &mut buffer) {
        document["animations"] = json!([motion]);
    }
    buffer.describe(&mut document);
    (document, buffer.into_bytes())
}

/// The root, then one node a body, each in its first pose.
fn nodes(run: &RunResult, animation: &crate::Animation, mesh_of: &[Option<usize>]) -> Value {
    let bodies = &run.drawing.bodies;
    let children: Vec<usize> = (1..=bodies.len()).collect();
    let root = json!({
        "name": if run.title.is_empty() { &run.model } else { &run.title },
        "rotation": motion::quaternion(upright(run.drawing.up)),
        "children": children,
    });
    let first = animation.frames.first();
    let node = |(index, body): (usize, &crate::DrawnBody)| {
        let mut node = json!({ "name": body.name });
        if let Some(pose) = first.and_then(|frame| frame.get(index)).filter(|pose| motion::is_finite(pose)) {
            node["translation"] = json!(pose.position.map(|x| x as f32));
            node["rotation"] = json!(motion::xyzw(pose.quaternion));
        }
        if let Some(mesh) = mesh_of[index] {
            node["mesh"] = json!(mesh);
        }
        node
    };
    [root].into_iter().chain(bodies.iter().enumerate().map(node)).collect()
}

/// One mesh a body that has parts, a primitive a material; and which body has which.
fn meshes(
    drawing: &Drawing,
    parts: &[Solid],
    buffer: &mut Buffer,
    materials: &mut Materials,
) -> (Vec<Value>, Vec<Option<usize>>) {
    let mut list = Vec::new();
    let mut mesh_of = vec![None; drawing.bodies.len()];
    for (index, body) in drawing.bodies.iter().enumerate() {
        let mut by_material: Vec<(usize, Mesh)> = Vec::new();
        for part in parts.iter().filter(|part| part.body == index) {
            let material = materials.of(part);
            let at = by_material.iter().position(|(other, _)| *other == material).unwrap_or(by_material.len());
            if at == by_material.len() {
                by_material.push((material, Mesh::default()));
            }
            by_material[at].1.push(&part.shape);
        }
        by_material.retain(|(_, mesh)| !mesh.is_empty());
        if by_material.is_empty() {
            continue;
        }
        let primitives: Vec<Value> =
            by_material.iter().map(|(material, mesh)| primitive(mesh, *material, buffer)).collect();
        mesh_of[index] = Some(list.len());
        list.push(json!({ "name": body.name, "primitives": primitives }));
    }
    (list, mesh_of)
}

fn primitive(mesh: &Mesh, material: usize, buffer: &mut Buffer) -> Value {
    json!({
        "attributes": {
            "POSITION": buffer.push_vertices(&mesh.positions, true),
            "NORMAL": buffer.push_vertices(&mesh.normals, false),
        },
        "indices": buffer.push_indices(&mesh.indices, mesh.positions.len()),
        "material": material,
    })
}

#[cfg(test)]
mod tests;
