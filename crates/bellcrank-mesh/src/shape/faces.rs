//! Faces of elements, and the triangles and quadrilaterals that they are.

use super::{Point, Shape, points};

/// Shape of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceShape {
    /// Linear triangle.
    Tri3,
    /// Quadratic triangle.
    Tri6,
    /// Linear quadrilateral.
    Quad4,
    /// Quadratic quadrilateral of the serendipity family.
    Quad8,
}

pub(super) const fn of(shape: Shape) -> &'static [&'static [u8]] {
    match shape {
        Shape::Tet4 => &[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
        Shape::Tet10 => &[&[0, 2, 1, 6, 5, 4], &[0, 1, 3, 4, 8, 7], &[1, 2, 3, 5, 9, 8], &[2, 0, 3, 6, 7, 9]],
        Shape::Wedge6 => &[&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
        Shape::Wedge15 => &[
            &[0, 2, 1, 8, 7, 6],
            &[3, 4, 5, 9, 10, 11],
            &[0, 1, 4, 3, 6, 13, 9, 12],
            &[1, 2, 5, 4, 7, 14, 10, 13],
            &[2, 0, 3, 5, 8, 12, 11, 14],
        ],
        Shape::Hex8 => &[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]],
        Shape::Hex20 => &[
            &[0, 3, 2, 1, 11, 10, 9, 8],
            &[4, 5, 6, 7, 12, 13, 14, 15],
            &[0, 1, 5, 4, 8, 17, 12, 16],
            &[1, 2, 6, 5, 9, 18, 13, 17],
            &[2, 3, 7, 6, 10, 19, 14, 18],
            &[3, 0, 4, 7, 11, 16, 15, 19],
        ],
    }
}

impl FaceShape {
    /// The shape of a face with that many nodes (3, 6, 4 or 8).
    pub fn with_nodes(nodes: usize) -> FaceShape {
        match nodes {
            3 => FaceShape::Tri3,
            6 => FaceShape::Tri6,
            4 => FaceShape::Quad4,
            _ => FaceShape::Quad8,
        }
    }

    /// Number of corners.
    pub const fn corners(self) -> usize {
        match self {
            FaceShape::Tri3 | FaceShape::Tri6 => 3,
            FaceShape::Quad4 | FaceShape::Quad8 => 4,
        }
    }

    /// Natural coordinates of the corners, in the order of the nodes.
    pub const fn corner_coordinates(self) -> &'static [[f64; 2]] {
        match self {
            FaceShape::Tri3 | FaceShape::Tri6 => &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            FaceShape::Quad4 | FaceShape::Quad8 => &SQUARE,
        }
    }

    /// Natural coordinates of the middle of the side between corner k and k + 1.
    pub fn middle_of_side(self, side: usize) -> [f64; 2] {
        let corners = self.corner_coordinates();
        let (a, b) = (corners[side], corners[(side + 1) % corners.len()]);
        [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]
    }

    /// Way from corner k to k + 1 in natural coordinates.
    pub fn side_direction(self, side: usize) -> [f64; 2] {
        let corners = self.corner_coordinates();
        let (a, b) = (corners[side], corners[(side + 1) % corners.len()]);
        [b[0] - a[0], b[1] - a[1]]
    }

    /// Shape functions and their derivatives by the two natural coordinates.
    pub fn evaluate(self, at: [f64; 2], n: &mut [f64; 8], d: &mut [[f64; 2]; 8]) {
        let [r, s] = at;
        match self {
            FaceShape::Tri3 => {
                n[..3].copy_from_slice(&[1.0 - r - s, r, s]);
                d[..3].copy_from_slice(&[[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]]);
            }
            FaceShape::Tri6 => tri6(r, s, n, d),
            FaceShape::Quad4 => {
                for (k, [a, b]) in SQUARE.into_iter().enumerate() {
                    n[k] = (1.0 + r * a) * (1.0 + s * b) / 4.0;
                    d[k] = [a * (1.0 + s * b) / 4.0, b * (1.0 + r * a) / 4.0];
                }
            }
            FaceShape::Quad8 => quad8(r, s, n, d),
        }
    }

    /// Integration points, exact to degree 5; the third coordinate is zero.
    pub fn points(self) -> &'static [Point] {
        match self {
            FaceShape::Tri3 | FaceShape::Tri6 => points::triangle(),
            FaceShape::Quad4 | FaceShape::Quad8 => points::square(),
        }
    }
}

const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

fn tri6(r: f64, s: f64, n: &mut [f64; 8], d: &mut [[f64; 2]; 8]) {
    let l = [1.0 - r - s, r, s];
    let g = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];
    for k in 0..3 {
        let next = (k + 1) % 3;
        n[k] = l[k] * (2.0 * l[k] - 1.0);
        n[3 + k] = 4.0 * l[k] * l[next];
        for i in 0..2 {
            d[k][i] = g[k][i] * (4.0 * l[k] - 1.0);
            d[3 + k][i] = 4.0 * (g[k][i] * l[next] + l[k] * g[next][i]);
        }
    }
}

fn quad8(r: f64, s: f64, n: &mut [f64; 8], d: &mut [[f64; 2]; 8]) {
    for (k, [a, b]) in SQUARE.into_iter().enumerate() {
        let (p, q, sum) = (1.0 + r * a, 1.0 + s * b, r * a + s * b - 1.0);
        n[k] = p * q * sum / 4.0;
        d[k] = [a * q * (sum + p) / 4.0, b * p * (sum + q) / 4.0];
    }
    for (k, b) in [(4, -1.0), (6, 1.0)] {
        n[k] = (1.0 - r * r) * (1.0 + s * b) / 2.0;
        d[k] = [-r * (1.0 + s * b), (1.0 - r * r) * b / 2.0];
    }
    for (k, a) in [(5, 1.0), (7, -1.0)] {
        n[k] = (1.0 + r * a) * (1.0 - s * s) / 2.0;
        d[k] = [a * (1.0 - s * s) / 2.0, -s * (1.0 + r * a)];
    }
}
