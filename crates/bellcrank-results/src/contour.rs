//! A part in space, coloured by a field and deformed: what stress and mode pictures are drawn from.

use crate::Unit;

/// The surface of a part with fields on it; body axes.
#[derive(Clone, Debug, Default)]
pub struct Contour {
    /// What it shows, e.g. `link3: stress at joint.B.position = -30 deg`.
    pub title: String,
    /// Places of the surface's nodes, m.
    pub nodes: Vec<[f32; 3]>,
    /// Numbers of those nodes in the mesh files that are exported, for the reader who goes on there; empty where
    /// there are none.
    pub numbers: Vec<u32>,
    /// Triangles between nodes, counter-clockwise seen from outside. Curved faces come already divided.
    pub triangles: Vec<[u32; 3]>,
    /// Edges of elements, to be drawn as lines: pairs of nodes.
    pub edges: Vec<[u32; 2]>,
    /// Ways it deforms: one for a static solution, one a mode.
    pub shapes: Vec<ContourShape>,
    /// Places worth pointing at.
    pub marks: Vec<ContourMark>,
}

/// One deformation of the part, with the fields that belong to it.
#[derive(Clone, Debug, Default)]
pub struct ContourShape {
    /// E.g. `mode 3, 345.7 Hz`; empty where there is one only.
    pub name: String,
    /// Displacement of each node, m; of arbitrary size for a mode.
    pub displacement: Vec<[f32; 3]>,
    /// Whether it swings about the undeformed part (a mode) or is the state under load.
    pub swings: bool,
    /// Fields by node.
    pub fields: Vec<ContourField>,
}

/// A number at each node.
#[derive(Clone, Debug)]
pub struct ContourField {
    /// E.g. `von Mises stress`.
    pub name: String,
    /// Unit of display; values are SI.
    pub unit: Unit,
    /// SI values, one a node; the first field is shown first.
    pub values: Vec<f32>,
    /// Value that colours end at, SI, where the largest is not to be trusted (a singular edge) or a limit is given.
    pub ceiling: Option<f32>,
}

/// A place with a label.
#[derive(Clone, Debug)]
pub struct ContourMark {
    /// E.g. `bore B: 148.2 MPa +- 1.9 %`.
    pub label: String,
    /// Place, m.
    pub at: [f32; 3],
    /// Whether the value there is not to be trusted.
    pub doubtful: bool,
}
