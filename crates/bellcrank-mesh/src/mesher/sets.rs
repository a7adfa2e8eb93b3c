//! Names of the surfaces that the mesher knows: bores, top, bottom, everything.

use std::collections::HashMap;

use super::extrude::Origin;
use super::heights::Levels;
use super::plan::Plan;
use super::plane::Plane;
use crate::{Face, Mesh};

/// Edges that are re-entrant by more than this are sharp: 185° between the faces, measured through the material.
const SHARP: f64 = 5.0;

pub(super) fn name(mesh: &mut Mesh, origin: &[Origin], plan: &Plan, plane: &Plane, levels: &Levels, names: &[&str]) {
    let segments: HashMap<[u32; 2], usize> = plane
        .segments
        .iter()
        .map(|segment| ([segment.ends[0].min(segment.ends[1]), segment.ends[0].max(segment.ends[1])], segment.edge))
        .collect();
    let surface = mesh.boundary();
    let mut sets: HashMap<String, Vec<Face>> = HashMap::new();
    for bore in &plan.stack.bores {
        sets.entry(bore_name(bore.eye, names)).or_default();
    }
    for &face in &surface {
        let origins: Vec<Origin> = mesh.face_nodes(face).map(|node| origin[node as usize]).collect();
        let [low, high] = span(&origins);
        if low == high {
            let ends = [(0, "bottom"), (2 * levels.layers(), "top")];
            let named = ends.into_iter().filter(|&(half, _)| half == low);
            named.for_each(|(_, name)| sets.entry(name.to_owned()).or_default().push(face));
            continue;
        }
        let Some(edge) = segments.get(&side_of(&origins)) else { continue };
        let z = (levels.half(low) + levels.half(high)) / 2.0;
        if let Some(bore) = plan.bores[*edge].and_then(|bore| layer_of(plan, bore, z)) {
            sets.entry(bore_name(plan.stack.bores[bore].eye, names)).or_default().push(face);
        }
    }
    for bore in &plan.stack.bores {
        let name = bore_name(bore.eye, names);
        let faces = sets.get(&name).map_or(&[][..], Vec::as_slice);
        mesh.node_sets.insert(name, mesh.nodes_of_faces(faces));
    }
    mesh.face_sets = sets.into_iter().collect();
    mesh.face_sets.insert("surface".to_owned(), surface);
    let sharp = mesh.sharp_nodes(SHARP);
    if !sharp.is_empty() {
        mesh.node_sets.insert("sharp".to_owned(), sharp);
    }
}

fn bore_name(eye: usize, names: &[&str]) -> String {
    names.get(eye).map_or_else(|| format!("bore.{}", eye + 1), |name| format!("bore.{name}"))
}

fn span(origins: &[Origin]) -> [usize; 2] {
    origins.iter().fold([usize::MAX, 0], |[low, high], &(_, half)| [low.min(half), high.max(half)])
}

/// The side of the plane that a vertical face stands on.
fn side_of(origins: &[Origin]) -> [u32; 2] {
    let points = origins.iter().flat_map(|&(side, _)| side);
    points.fold([u32::MAX, 0], |[low, high], point| [low.min(point), high.max(point)])
}

/// The bore on the same circle whose eye is at that height.
fn layer_of(plan: &Plan, bore: usize, z: f64) -> Option<usize> {
    let bores = &plan.stack.bores;
    let same = |other: &usize| {
        let apart =
            (bores[*other].center[0] - bores[bore].center[0]).hypot(bores[*other].center[1] - bores[bore].center[1]);
        apart.max((bores[*other].diameter - bores[bore].diameter).abs()) < 1e-8 * plan.extent
    };
    let here = |other: &usize| bores[*other].layers.iter().any(|layer| layer[0] < z && z < layer[1]);
    (0..bores.len()).filter(same).find(here)
}
