//! From the axes of a plane to those of the body.

use bellcrank_solid::{Face, Form, Path, Shell, ShellEdge};

use crate::design::Plane;

/// The boundary of a link in the axes of its body.
pub(super) fn shell(of: Shell, plane: Plane) -> Shell {
    if plane == Plane::Xy {
        return of;
    }
    let turn = |plan: [f64; 3]| {
        let mut body = [0.0; 3];
        plane.axes().iter().zip(plan).for_each(|(&axis, x)| body[axis] = x);
        body
    };
    Shell {
        vertices: of.vertices.into_iter().map(turn).collect(),
        edges: of.edges.into_iter().map(|edge| ShellEdge { path: path(edge.path, turn), ..edge }).collect(),
        faces: of.faces.into_iter().map(|face| Face { form: form(face.form, turn), ..face }).collect(),
    }
}

fn path(of: Path, turn: impl Fn([f64; 3]) -> [f64; 3]) -> Path {
    match of {
        Path::Line => Path::Line,
        Path::Circle { center, axis, radius } => Path::Circle { center: turn(center), axis: turn(axis), radius },
    }
}

fn form(of: Form, turn: impl Fn([f64; 3]) -> [f64; 3]) -> Form {
    match of {
        Form::Plane { point, normal } => Form::Plane { point: turn(point), normal: turn(normal) },
        Form::Cylinder { point, axis, radius, convex } => {
            Form::Cylinder { point: turn(point), axis: turn(axis), radius, convex }
        }
        Form::Cone { apex, axis, slope, convex } => Form::Cone { apex: turn(apex), axis: turn(axis), slope, convex },
    }
}
