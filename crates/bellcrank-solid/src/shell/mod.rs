//! Boundaries of solids: faces, edges and vertices in space.

mod revolved;
mod space;
mod stack;
mod surface;

pub mod step;
pub mod stl;

pub use surface::Surface;

use space::{Place, across, add, cross, dot, scale, sub, unit};

/// The closed boundary of a solid; lengths in m.
///
/// Every edge is used by exactly two faces, once in each direction.
#[derive(Clone, Debug, Default)]
pub struct Shell {
    /// Places of the vertices.
    pub vertices: Vec<[f64; 3]>,
    /// Lines and arcs between them.
    pub edges: Vec<ShellEdge>,
    /// Pieces of planes, cylinders and cones.
    pub faces: Vec<Face>,
}

/// An edge of a shell, at most half a turn.
#[derive(Clone, Debug)]
pub struct ShellEdge {
    /// Vertices at its beginning and end.
    pub ends: [usize; 2],
    /// How it gets from one to the other.
    pub path: Path,
}

/// Form of an edge in space.
#[derive(Clone, Debug)]
pub enum Path {
    /// Straight.
    Line,
    /// Part of a circle, counter-clockwise about its axis.
    Circle {
        /// Centre.
        center: [f64; 3],
        /// Direction of its axis, of length one.
        axis: [f64; 3],
        /// Radius.
        radius: f64,
    },
}

/// A piece of a surface.
#[derive(Clone, Debug)]
pub struct Face {
    /// What it is a piece of.
    pub form: Form,
    /// Loops of (edge, run forward), with the face on the left seen from outside; the outer one first.
    pub loops: Vec<Vec<(usize, bool)>>,
}

/// Surface that a face is a piece of.
#[derive(Clone, Debug)]
pub enum Form {
    /// A plane.
    Plane {
        /// A place in it.
        point: [f64; 3],
        /// Direction out of the solid, of length one.
        normal: [f64; 3],
    },
    /// A circular cylinder.
    Cylinder {
        /// A place on its axis.
        point: [f64; 3],
        /// Direction of its axis, of length one.
        axis: [f64; 3],
        /// Radius.
        radius: f64,
        /// Whether the solid is on the side of the axis: a boss, not a hole.
        convex: bool,
    },
    /// A circular cone that opens along its axis.
    Cone {
        /// Its tip.
        apex: [f64; 3],
        /// Direction in which it opens, of length one.
        axis: [f64; 3],
        /// Tangent of half its opening angle.
        slope: f64,
        /// Whether the solid is on the side of the axis.
        convex: bool,
    },
}

/// An edge with more than half a turn of material round it: the stress of linear elasticity is singular there.
#[derive(Clone, Debug)]
pub struct SharpEdge {
    /// Places of its beginning and end.
    pub ends: [[f64; 3]; 2],
    /// How it gets from one to the other.
    pub path: Path,
    /// Angle of the material round it, rad: more than pi.
    pub angle: f64,
}

impl Form {
    /// Direction out of the solid at a place on the surface.
    pub fn normal(&self, at: [f64; 3]) -> [f64; 3] {
        let (outward, convex) = match self {
            Form::Plane { normal, .. } => return *normal,
            Form::Cylinder { point, axis, convex, .. } => (unit(across(sub(at, *point), *axis)), *convex),
            Form::Cone { apex, axis, slope, convex } => {
                let radial = unit(across(sub(at, *apex), *axis));
                (unit(sub(radial, scale(*axis, *slope))), *convex)
            }
        };
        if convex { outward } else { scale(outward, -1.0) }
    }
}

impl ShellEdge {
    /// Angle run through, in (0, 2 pi); zero for a line.
    pub(crate) fn sweep(&self, vertices: &[Place]) -> f64 {
        match &self.path {
            Path::Line => 0.0,
            Path::Circle { center, axis, .. } => {
                let [a, b] = self.ends.map(|v| sub(vertices[v], *center));
                dot(*axis, cross(a, b)).atan2(dot(a, b)).rem_euclid(std::f64::consts::TAU)
            }
        }
    }

    /// The place at a fraction of its length.
    pub(crate) fn at(&self, vertices: &[Place], fraction: f64) -> Place {
        let [a, b] = self.ends.map(|v| vertices[v]);
        match &self.path {
            Path::Line => add(a, scale(sub(b, a), fraction)),
            Path::Circle { center, axis, .. } => {
                let from = sub(a, *center);
                let (s, c) = (fraction * self.sweep(vertices)).sin_cos();
                let rise = scale(*axis, dot(*axis, from));
                let out = sub(from, rise);
                add(add(*center, rise), add(scale(out, c), scale(cross(*axis, out), s)))
            }
        }
    }

    /// Direction at the middle of its length, of length one.
    fn middle_direction(&self, vertices: &[Place]) -> Place {
        let [a, b] = self.ends.map(|v| vertices[v]);
        match &self.path {
            Path::Line => unit(sub(b, a)),
            Path::Circle { center, axis, .. } => unit(cross(*axis, sub(self.at(vertices, 0.5), *center))),
        }
    }
}

impl Shell {
    /// Angles between outward directions of the two faces at each edge, at its middle, rad: positive where the solid
    /// is convex, negative where it is re-entrant, zero where the faces are tangent.
    pub(crate) fn folds(&self) -> Vec<f64> {
        let mut beside: Vec<[Option<Place>; 2]> = vec![[None; 2]; self.edges.len()];
        for face in &self.faces {
            for (edge, forward) in face.loops.iter().flatten() {
                let normal = face.form.normal(self.edges[*edge].at(&self.vertices, 0.5));
                beside[*edge][usize::from(!forward)] = Some(normal);
            }
        }
        let fold = |(edge, beside): (&ShellEdge, &[Option<Place>; 2])| {
            let [Some(left), Some(right)] = beside else { return 0.0 };
            let along = edge.middle_direction(&self.vertices);
            dot(cross(*left, *right), along).atan2(dot(*left, *right))
        };
        self.edges.iter().zip(&beside).map(fold).collect()
    }

    /// Re-entrant edges with more than half a turn and 5 degrees of material.
    pub fn sharp_edges(&self) -> Vec<SharpEdge> {
        let folds = self.folds();
        let sharp = self.edges.iter().zip(folds).filter(|(_, fold)| *fold < -5_f64.to_radians());
        sharp
            .map(|(edge, fold)| SharpEdge {
                ends: edge.ends.map(|v| self.vertices[v]),
                path: edge.path.clone(),
                angle: std::f64::consts::PI - fold,
            })
            .collect()
    }
}
