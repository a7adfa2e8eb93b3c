//! Integrals over faces of elements.

use bellcrank_mesh::{Face, FaceShape, Mesh};

use crate::vector::{self, V3};
use crate::{Coupling, Region};

/// An integration point on a face.
pub(crate) struct SurfacePoint {
    /// Place, m.
    pub(crate) at: V3,
    /// Normal out of the part, of length one.
    pub(crate) normal: V3,
    /// Its share of the area, m².
    pub(crate) area: f64,
}

/// Calls back for every integration point of every face, with its shape functions and nodes.
pub(crate) fn each(mesh: &Mesh, faces: &[Face], mut call: impl FnMut(&SurfacePoint, &[f64], &[u32])) {
    let (mut n, mut d) = ([0.0; 8], [[0.0; 2]; 8]);
    for &face in faces {
        let mut nodes = [0_u32; 8];
        let mut count = 0;
        for node in mesh.face_nodes(face) {
            nodes[count] = node;
            count += 1;
        }
        let (nodes, shape) = (&nodes[..count], FaceShape::with_nodes(count));
        for point in shape.points() {
            shape.evaluate([point.at[0], point.at[1]], &mut n, &mut d);
            let sum = |weight: &dyn Fn(usize) -> f64| -> V3 {
                std::array::from_fn(|i| {
                    nodes.iter().enumerate().map(|(k, &node)| mesh.nodes[node as usize][i] * weight(k)).sum()
                })
            };
            let normal = vector::cross(sum(&|k| d[k][0]), sum(&|k| d[k][1]));
            let size = vector::norm(normal);
            let normal = vector::scale(normal, 1.0 / size.max(f64::MIN_POSITIVE));
            call(&SurfacePoint { at: sum(&|k| n[k]), normal, area: size * point.weight }, &n[..count], nodes);
        }
    }
}

/// Adds the nodal forces of a traction.
pub(crate) fn integrate(mesh: &Mesh, faces: &[Face], nodal: &mut [V3], traction: impl Fn(&SurfacePoint) -> V3) {
    each(mesh, faces, |point, n, nodes| {
        let force = vector::scale(traction(point), point.area);
        for (n, &node) in n.iter().zip(nodes) {
            vector::accumulate(&mut nodal[node as usize], vector::scale(force, *n));
        }
    });
}

/// The force of a traction.
pub(crate) fn resultant(mesh: &Mesh, faces: &[Face], traction: impl Fn(&SurfacePoint) -> V3) -> V3 {
    let mut sum = [0.0; 3];
    each(mesh, faces, |point, _, _| vector::accumulate(&mut sum, vector::scale(traction(point), point.area)));
    sum
}

/// m².
pub(crate) fn area(mesh: &Mesh, faces: &[Face]) -> f64 {
    let mut sum = 0.0;
    each(mesh, faces, |point, _, _| sum += point.area);
    sum
}

/// Weight, centre and second moments of what a distributing coupling takes hold of.
pub(crate) struct Spread {
    weight: f64,
    center: V3,
    /// ∫ (|r|² 1 − r rᵀ), r from the centre.
    moments: [V3; 3],
}

impl Spread {
    pub(crate) fn new(mesh: &Mesh, coupling: &Coupling) -> Self {
        let (mut weight, mut first) = (0.0, [0.0; 3]);
        points(mesh, &coupling.region, |at, share| {
            weight += share;
            vector::accumulate(&mut first, vector::scale(at, share));
        });
        let center = vector::scale(first, 1.0 / weight);
        let mut moments = [[0.0; 3]; 3];
        points(mesh, &coupling.region, |at, share| {
            let r = vector::sub(at, center);
            for i in 0..3 {
                moments[i][i] += share * vector::dot(r, r);
                (0..3).for_each(|j| moments[i][j] -= share * r[i] * r[j]);
            }
        });
        Self { weight, center, moments }
    }

    /// Whether it can carry a moment about every axis: not all on one line.
    pub(crate) fn carries_moments(&self) -> bool {
        vector::solve(&self.moments, [1.0, 1.0, 1.0]).is_some()
    }

    /// Adds the nodal forces of a force and a moment at the reference.
    pub(crate) fn add(&self, mesh: &Mesh, coupling: &Coupling, force: V3, moment: V3, nodal: &mut [V3]) {
        let arm = vector::sub(coupling.reference, self.center);
        let about = vector::add(moment, vector::cross(arm, force));
        let turn = vector::solve(&self.moments, about).unwrap_or([0.0; 3]);
        let even = vector::scale(force, 1.0 / self.weight);
        let traction = |at: V3| vector::add(even, vector::cross(turn, vector::sub(at, self.center)));
        match &coupling.region {
            Region::Faces(faces) => integrate(mesh, faces, nodal, |point| traction(point.at)),
            Region::Nodes(nodes) => {
                for &node in nodes {
                    vector::accumulate(&mut nodal[node as usize], traction(mesh.nodes[node as usize]));
                }
            }
        }
    }
}

fn points(mesh: &Mesh, region: &Region, mut call: impl FnMut(V3, f64)) {
    match region {
        Region::Faces(faces) => each(mesh, faces, |point, _, _| call(point.at, point.area)),
        Region::Nodes(nodes) => nodes.iter().for_each(|&node| call(mesh.nodes[node as usize], 1.0)),
    }
}
