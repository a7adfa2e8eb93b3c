//! The outside of a mesh: faces that one element has alone, and edges where it bends.

use std::collections::HashMap;

use crate::{Face, FaceShape, Mesh};

/// Corners of a face in ascending order; triangles end with `u32::MAX`.
type Corners = [u32; 4];

/// An edge where the surface bends.
#[derive(Clone, Debug, PartialEq)]
pub struct SharpEdge {
    /// Its nodes: two ends, then the mid-side node if there is one.
    pub nodes: Vec<u32>,
    /// Angle between the two faces outside of the material less a half turn, in degrees: positive where the edge is
    /// re-entrant.
    pub bend: f64,
}

impl Mesh {
    /// Faces that only one element has, ascending.
    pub fn boundary(&self) -> Vec<Face> {
        let mut alone: HashMap<Corners, Option<Face>, Hasher> = HashMap::default();
        alone.reserve(3 * self.element_count());
        for face in self.faces() {
            alone.entry(self.corners_of(face)).and_modify(|seen| *seen = None).or_insert(Some(face));
        }
        let mut faces: Vec<Face> = alone.into_values().flatten().collect();
        faces.sort_unstable();
        faces
    }

    /// Every face of every element.
    pub fn faces(&self) -> impl Iterator<Item = Face> + '_ {
        self.blocks.iter().enumerate().flat_map(|(block, contents)| {
            let count = contents.shape.faces().len() as u8;
            (0..contents.len() as u32)
                .flat_map(move |element| (0..count).map(move |face| Face { block: block as u32, element, face }))
        })
    }

    /// Nodes of faces, ascending, each once.
    pub fn nodes_of_faces(&self, faces: &[Face]) -> Vec<u32> {
        let mut nodes: Vec<u32> = faces.iter().flat_map(|&face| self.face_nodes(face)).collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    pub(crate) fn corners_of(&self, face: Face) -> Corners {
        let mut corners = [u32::MAX; 4];
        let count = self.face_shape(face).corners();
        for (corner, node) in corners.iter_mut().zip(self.face_nodes(face).take(count)) {
            *corner = node;
        }
        corners.sort_unstable();
        corners
    }

    /// Shape of a face.
    pub fn face_shape(&self, face: Face) -> FaceShape {
        let shape = self.blocks[face.block as usize].shape;
        FaceShape::with_nodes(shape.faces()[face.face as usize].len())
    }

    /// Edges of the surface that are re-entrant by more than `angle` degrees: where the angle outside of the material
    /// between two neighbouring faces, at the middle of their edge, is below 180° − `angle`.
    pub fn sharp_edges(&self, angle: f64) -> Vec<SharpEdge> {
        let mut edges: HashMap<[u32; 2], Vec<(Face, usize)>, Hasher> = HashMap::default();
        for face in self.boundary() {
            let nodes: Vec<u32> = self.face_nodes(face).collect();
            let corners = self.face_shape(face).corners();
            for side in 0..corners {
                let (a, b) = (nodes[side], nodes[(side + 1) % corners]);
                edges.entry([a.min(b), a.max(b)]).or_default().push((face, side));
            }
        }
        let mut sharp: Vec<SharpEdge> = edges.into_values().filter_map(|pair| self.bend(&pair, angle)).collect();
        sharp.sort_unstable_by(|a, b| a.nodes.cmp(&b.nodes));
        sharp
    }

    /// Nodes of [`Mesh::sharp_edges`], ascending, each once.
    pub fn sharp_nodes(&self, angle: f64) -> Vec<u32> {
        let mut nodes: Vec<u32> = self.sharp_edges(angle).into_iter().flat_map(|edge| edge.nodes).collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    fn bend(&self, pair: &[(Face, usize)], angle: f64) -> Option<SharpEdge> {
        // Four faces meet where two bodies touch in an edge: nothing can be said about its bend.
        let &[first, second] = pair else { return None };
        let [one, other] = [first, second].map(|(face, side)| self.frame(face, side));
        let sine = -dot(one.1, other.0);
        let cosine = dot(one.0, other.0);
        let bend = sine.atan2(cosine).to_degrees();
        (bend > angle).then(|| SharpEdge { nodes: self.edge_nodes(first.0, first.1), bend })
    }

    fn edge_nodes(&self, face: Face, side: usize) -> Vec<u32> {
        let shape = self.face_shape(face);
        let nodes: Vec<u32> = self.face_nodes(face).collect();
        let corners = shape.corners();
        let ends = [nodes[side], nodes[(side + 1) % corners]];
        ends.into_iter().chain(nodes.get(corners + side).copied()).collect()
    }

    /// At the middle of a side of a face: the normal out of the material and, in the face, the direction out of the
    /// face, square to the side.
    fn frame(&self, face: Face, side: usize) -> ([f64; 3], [f64; 3]) {
        let shape = self.face_shape(face);
        let (mut n, mut d) = ([0.0; 8], [[0.0; 2]; 8]);
        shape.evaluate(shape.middle_of_side(side), &mut n, &mut d);
        let places: Vec<[f64; 3]> = self.face_nodes(face).map(|node| self.nodes[node as usize]).collect();
        let along = |c: usize| sum(places.iter().zip(&d).map(|(place, d)| place.map(|x| x * d[c])));
        let normal = unit(cross(along(0), along(1)));
        let step = shape.side_direction(side);
        let tangent = sum([along(0).map(|x| x * step[0]), along(1).map(|x| x * step[1])].into_iter());
        (normal, unit(cross(tangent, normal)))
    }
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn sum(terms: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    terms.fold([0.0; 3], |a, b| std::array::from_fn(|i| a[i] + b[i]))
}

fn unit(a: [f64; 3]) -> [f64; 3] {
    let length = dot(a, a).sqrt();
    a.map(|c| c / length)
}

/// Node numbers need no protection against chosen keys: multiply and mix (after the `fxhash` of rustc).
pub(crate) type Hasher = std::hash::BuildHasherDefault<Mixer>;

#[derive(Default)]
pub(crate) struct Mixer(u64);

impl std::hash::Hasher for Mixer {
    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 29)
    }

    fn write(&mut self, bytes: &[u8]) {
        for part in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..part.len()].copy_from_slice(part);
            self.write_u64(u64::from_le_bytes(word));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }

    fn write_u64(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(0x517c_c1b7_2722_0a95);
    }
}
