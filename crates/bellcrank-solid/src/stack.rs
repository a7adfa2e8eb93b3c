//! A solid as layers of one plane arrangement.
//!
//! All outlines of all layers are laid into one plane and cut at each other: vertices, edges (lines and arcs) and
//! cells between them. A level splits the height where anything begins or ends. What is filled is then a table of
//! cells by intervals. Volumes, boundary faces and conforming meshes need no further intersection.

use bellcrank_math::Real;

use crate::{Fault, MassProperties, Moments};

/// Cells of one plane times intervals of height; lengths in m, in the axes of the link's plane.
#[derive(Clone, Debug)]
pub struct Stack<T> {
    /// Ends of edges, in plan.
    pub vertices: Vec<[T; 2]>,
    /// Lines and arcs that meet only in vertices.
    pub edges: Vec<Edge<T>>,
    /// The bounded cells between the edges that are filled somewhere.
    pub cells: Vec<Cell>,
    /// Heights in ascending order, one more than there are intervals.
    pub levels: Vec<T>,
    /// Holes of the eyes that have one.
    pub bores: Vec<Bore<T>>,
    /// Integrals over the solid. Their first derivatives hold also where outlines or layers of different derivatives
    /// coincide, which vertices and levels cannot show.
    pub moments: Moments<T>,
    /// What is suspicious but no fault.
    pub warnings: Vec<Fault>,
}

impl<T: Real> Stack<T> {
    /// Mass properties at a density in kg/m³, in the axes of the link's plane; exact.
    pub fn mass_properties(&self, density: T) -> MassProperties<T> {
        self.moments.mass_properties(density)
    }
}

/// A line or an arc of the arrangement, shorter than half a turn.
#[derive(Clone, Debug)]
pub struct Edge<T> {
    /// Vertices at its beginning and end.
    pub ends: [usize; 2],
    /// How it gets from one to the other.
    pub curve: Curve<T>,
    /// Cells on its left and right, seen along it; `None` outside of all of them.
    pub cells: [Option<usize>; 2],
}

/// Form of an edge.
#[derive(Clone, Debug)]
pub enum Curve<T> {
    /// Straight.
    Line,
    /// Part of a circle.
    Arc {
        /// Centre in plan.
        center: [T; 2],
        /// Radius.
        radius: T,
        /// Whether it runs counter-clockwise from its first vertex to its second.
        counter_clockwise: bool,
    },
}

/// A cell of the plane: one outer loop and the loops of what lies inside it.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Loops of (edge, run forward), with the cell on the left: the outer one counter-clockwise, then holes clockwise.
    pub loops: Vec<Vec<(usize, bool)>>,
    /// For each interval of height, whether it is filled.
    pub filled: Vec<bool>,
}

/// The hole of an eye.
#[derive(Clone, Debug)]
pub struct Bore<T> {
    /// Place of the eye in [`crate::Link::eyes`].
    pub eye: usize,
    /// Axis in plan.
    pub center: [T; 2],
    /// Diameter.
    pub diameter: T,
    /// Where the eye is along z.
    pub layers: Vec<[T; 2]>,
}
