//! Shapes of elements: nodes, faces, shape functions, integration points.
//!
//! Nodes, faces and natural coordinates follow Abaqus and CalculiX (C3D4, C3D10, C3D6, C3D15, C3D8, C3D20), except
//! that the nodes of a face run so that its normal points out of the element.

mod faces;
mod functions;
mod points;

pub use faces::FaceShape;
pub use points::Point;

/// Shape of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shape {
    /// Linear tetrahedron (C3D4).
    Tet4,
    /// Quadratic tetrahedron (C3D10).
    Tet10,
    /// Linear wedge (C3D6).
    Wedge6,
    /// Quadratic wedge of the serendipity family (C3D15).
    Wedge15,
    /// Linear hexahedron (C3D8, fully integrated, without incompatible modes).
    Hex8,
    /// Quadratic hexahedron of the serendipity family (C3D20).
    Hex20,
}

/// Most nodes that an element has.
pub const MOST_NODES: usize = 20;

impl Shape {
    /// All shapes.
    pub const ALL: [Shape; 6] = [Shape::Tet4, Shape::Tet10, Shape::Wedge6, Shape::Wedge15, Shape::Hex8, Shape::Hex20];

    /// Number of nodes.
    pub const fn nodes(self) -> usize {
        match self {
            Shape::Tet4 => 4,
            Shape::Tet10 => 10,
            Shape::Wedge6 => 6,
            Shape::Wedge15 => 15,
            Shape::Hex8 => 8,
            Shape::Hex20 => 20,
        }
    }

    /// Number of corner nodes; they come first.
    pub const fn corners(self) -> usize {
        match self {
            Shape::Tet4 | Shape::Tet10 => 4,
            Shape::Wedge6 | Shape::Wedge15 => 6,
            Shape::Hex8 | Shape::Hex20 => 8,
        }
    }

    /// Whether it has mid-side nodes.
    pub const fn quadratic(self) -> bool {
        self.nodes() > self.corners()
    }

    /// The same form with mid-side nodes.
    pub const fn with_mid_sides(self) -> Shape {
        match self {
            Shape::Tet4 | Shape::Tet10 => Shape::Tet10,
            Shape::Wedge6 | Shape::Wedge15 => Shape::Wedge15,
            Shape::Hex8 | Shape::Hex20 => Shape::Hex20,
        }
    }

    /// Its name in Abaqus and CalculiX.
    pub const fn abaqus(self) -> &'static str {
        match self {
            Shape::Tet4 => "C3D4",
            Shape::Tet10 => "C3D10",
            Shape::Wedge6 => "C3D6",
            Shape::Wedge15 => "C3D15",
            Shape::Hex8 => "C3D8",
            Shape::Hex20 => "C3D20",
        }
    }

    /// Corners at the two ends of each edge. The mid-side node of edge k is node `corners() + k` of quadratic shapes.
    pub const fn edges(self) -> &'static [[u8; 2]] {
        match self {
            Shape::Tet4 | Shape::Tet10 => &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
            Shape::Wedge6 | Shape::Wedge15 => &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]],
            Shape::Hex8 | Shape::Hex20 => {
                &[[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]]
            }
        }
    }

    /// Nodes of each face: corners, then mid-sides (between corner k and k + 1), the normal out of the element by the
    /// right-hand rule.
    pub const fn faces(self) -> &'static [&'static [u8]] {
        faces::of(self)
    }

    /// Natural coordinates of the corners: [0, 1] for tetrahedra and the triangle of wedges, [-1, 1] otherwise.
    pub const fn corner_coordinates(self) -> &'static [[f64; 3]] {
        match self {
            Shape::Tet4 | Shape::Tet10 => &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            Shape::Wedge6 | Shape::Wedge15 => &[
                [0.0, 0.0, -1.0],
                [1.0, 0.0, -1.0],
                [0.0, 1.0, -1.0],
                [0.0, 0.0, 1.0],
                [1.0, 0.0, 1.0],
                [0.0, 1.0, 1.0],
            ],
            Shape::Hex8 | Shape::Hex20 => &functions::HEX,
        }
    }

    /// Natural coordinates of a node.
    pub fn node_coordinates(self, node: usize) -> [f64; 3] {
        let corners = self.corner_coordinates();
        match node.checked_sub(self.corners()) {
            None => corners[node],
            Some(edge) => {
                let [a, b] = self.edges()[edge].map(|corner| corners[corner as usize]);
                std::array::from_fn(|i| (a[i] + b[i]) / 2.0)
            }
        }
    }

    /// Shape functions and their derivatives by the natural coordinates at a place; the first [`Shape::nodes`] entries
    /// of each are written.
    pub fn evaluate(self, at: [f64; 3], values: &mut [f64], gradients: &mut [[f64; 3]]) {
        functions::evaluate(self, at, values, gradients);
    }

    /// Integration points of the stiffness, as many as CalculiX takes (1, 4, 2, 9, 8, 27).
    pub fn stiffness_points(self) -> &'static [Point] {
        points::stiffness(self)
    }

    /// Integration points that integrate the mass matrix of an undistorted element exactly.
    pub fn mass_points(self) -> &'static [Point] {
        points::mass(self)
    }
}

#[cfg(test)]
mod tests;
