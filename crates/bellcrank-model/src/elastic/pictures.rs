//! Coloured and deformed surfaces of a solved mesh.

use bellcrank_fem::{principal, von_mises};
use bellcrank_mesh::{Face, Mesh};
use bellcrank_results::{Contour, ContourField, ContourMark, ContourShape, HotSpot, Unit};

use super::vector::V3;

/// The surface of a mesh, divided into triangles: what is the same for every picture of it.
pub(super) struct Picture<'m> {
    mesh: &'m Mesh,
    /// Numbers of its nodes.
    nodes: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
}

/// Corners and mid-sides of a face divided so that every node is used.
fn parts(nodes: usize) -> &'static [[usize; 3]] {
    match nodes {
        3 => &[[0, 1, 2]],
        6 => &[[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]],
        4 => &[[0, 1, 2], [0, 2, 3]],
        _ => &[[0, 4, 7], [4, 1, 5], [5, 2, 6], [6, 3, 7], [4, 5, 7], [5, 6, 7]],
    }
}

impl<'m> Picture<'m> {
    pub(super) fn new(mesh: &'m Mesh) -> Picture<'m> {
        let faces = mesh.boundary();
        let nodes = mesh.nodes_of_faces(&faces);
        let mut place = vec![0; mesh.nodes.len()];
        nodes.iter().zip(0_u32..).for_each(|(&node, k)| place[node as usize] = k);
        let (mut triangles, mut edges) = (Vec::new(), Vec::new());
        for &face in &faces {
            let of_face: Vec<u32> = mesh.face_nodes(face).map(|node| place[node as usize]).collect();
            triangles.extend(parts(of_face.len()).iter().map(|part| part.map(|corner| of_face[corner])));
            edges.extend(sides(mesh, face, &of_face));
        }
        edges.sort_unstable();
        edges.dedup();
        Picture { mesh, nodes, triangles, edges }
    }

    /// A picture without shapes.
    pub(super) fn contour(&self, title: String) -> Contour {
        Contour {
            title,
            nodes: self.nodes.iter().map(|&node| narrow(self.mesh.nodes[node as usize])).collect(),
            numbers: self.nodes.iter().map(|node| node + 1).collect(),
            triangles: self.triangles.clone(),
            edges: self.edges.clone(),
            shapes: Vec::new(),
            marks: Vec::new(),
        }
    }

    /// How it deforms, still without fields.
    pub(super) fn shape(&self, name: String, displacement: &[V3], swings: bool) -> ContourShape {
        let displacement = self.nodes.iter().map(|&node| narrow(displacement[node as usize])).collect();
        ContourShape { name, displacement, swings, fields: Vec::new() }
    }

    /// A number at each node, of one a node of the mesh.
    pub(super) fn field(&self, name: &str, unit: &Unit, value: impl Fn(usize) -> f64) -> ContourField {
        let values = self.nodes.iter().map(|&node| value(node as usize) as f32).collect();
        ContourField { name: name.to_owned(), unit: unit.clone(), values, ceiling: None }
    }
}

/// Sides of a face by way of their middle nodes.
fn sides(mesh: &Mesh, face: Face, nodes: &[u32]) -> Vec<[u32; 2]> {
    let corners = mesh.face_shape(face).corners();
    let mut all = Vec::with_capacity(2 * corners);
    for side in 0..corners {
        let (a, b) = (nodes[side], nodes[(side + 1) % corners]);
        let stops = nodes.get(corners + side).map_or_else(|| vec![a, b], |&middle| vec![a, middle, b]);
        all.extend(stops.windows(2).map(|pair| [pair[0].min(pair[1]), pair[0].max(pair[1])]));
    }
    all
}

fn narrow(at: V3) -> [f32; 3] {
    at.map(|x| x as f32)
}

/// The fields of a solution, von Mises first. Colours end at what can be trusted.
pub(super) fn fields(
    picture: &Picture<'_>,
    displacement: &[V3],
    stress: &bellcrank_fem::Stress,
    units: [&Unit; 2],
    ceiling: Option<f64>,
) -> Vec<ContourField> {
    let [pressure, length] = units;
    let mises = picture.field("von Mises stress", pressure, |node| von_mises(&stress.nodal[node]));
    let largest = picture.field("largest principal stress", pressure, |node| principal(&stress.nodal[node])[0]);
    let smallest = picture.field("smallest principal stress", pressure, |node| principal(&stress.nodal[node])[2]);
    let moved = picture.field("displacement", length, |node| super::vector::norm(displacement[node]));
    let error = picture.field("estimated error of the stress", pressure, |node| stress.spread[node]);
    let ceiling = ceiling.map(|ceiling| ceiling as f32);
    vec![ContourField { ceiling, ..mises }, largest, smallest, moved, error]
}

/// A hot spot to point at.
pub(super) fn mark(spot: &HotSpot, unit: &Unit) -> ContourMark {
    let stress = crate::run::shown((spot.value / unit.factor * 100.0).round() / 100.0 * unit.factor, unit);
    let label = match spot.singular {
        Some(why) => format!("{}: {why}", spot.region),
        None => format!("{}: {stress} +- {:.1} %", spot.region, 100.0 * spot.relative_error()),
    };
    ContourMark { label, at: narrow(spot.at), doubtful: spot.singular.is_some() }
}
