//! A shell as a manifold solid.

use super::super::space::{any_across, sub, unit};
use super::super::{Face, Form, Path, Shell, ShellEdge};
use super::text::{File, Id, list, real, text};

/// Writes the solid within a shell.
pub(super) fn solid(file: &mut File, name: &str, shell: &Shell) -> Id {
    let places: Vec<Id> = shell.vertices.iter().map(|p| file.point(*p)).collect();
    let vertices: Vec<Id> = places.iter().map(|p| file.add(&format!("VERTEX_POINT('',{p})"))).collect();
    let edges: Vec<Id> = shell.edges.iter().map(|e| edge(file, shell, e, &places, &vertices)).collect();
    let faces: Vec<Id> = shell.faces.iter().map(|f| face(file, f, &edges)).collect();
    let closed = file.add(&format!("CLOSED_SHELL('',{})", list(&faces)));
    file.add(&format!("MANIFOLD_SOLID_BREP({},{closed})", text(name)))
}

fn edge(file: &mut File, shell: &Shell, edge: &ShellEdge, places: &[Id], vertices: &[Id]) -> Id {
    let [a, b] = edge.ends;
    let curve = match &edge.path {
        Path::Line => {
            let along = file.direction(unit(sub(shell.vertices[b], shell.vertices[a])));
            let vector = file.add(&format!("VECTOR('',{along},1.)"));
            file.add(&format!("LINE('',{},{vector})", places[a]))
        }
        Path::Circle { center, axis, radius } => {
            let axes = file.axes(*center, *axis, unit(sub(shell.vertices[a], *center)));
            file.add(&format!("CIRCLE('',{axes},{})", real(radius * 1000.0)))
        }
    };
    file.add(&format!("EDGE_CURVE('',{},{},{curve},.T.)", vertices[a], vertices[b]))
}

fn face(file: &mut File, face: &Face, edges: &[Id]) -> Id {
    let mut bounds = Vec::new();
    for (i, walk) in face.loops.iter().enumerate() {
        let oriented: Vec<Id> = walk
            .iter()
            .map(|(edge, forward)| file.add(&format!("ORIENTED_EDGE('',*,*,{},{})", edges[*edge], truth(*forward))))
            .collect();
        let walk = file.add(&format!("EDGE_LOOP('',{})", list(&oriented)));
        let kind = if i == 0 { "FACE_OUTER_BOUND" } else { "FACE_BOUND" };
        bounds.push(file.add(&format!("{kind}('',{walk},.T.)")));
    }
    let (surface, outward) = surface(file, &face.form);
    file.add(&format!("ADVANCED_FACE('',{},{surface},{})", list(&bounds), truth(outward)))
}

/// The surface of a face, and whether its normal points out of the solid.
fn surface(file: &mut File, form: &Form) -> (Id, bool) {
    match form {
        Form::Plane { point, normal } => {
            let axes = file.axes(*point, *normal, any_across(*normal));
            (file.add(&format!("PLANE('',{axes})")), true)
        }
        Form::Cylinder { point, axis, radius, convex } => {
            let axes = file.axes(*point, *axis, any_across(*axis));
            (file.add(&format!("CYLINDRICAL_SURFACE('',{axes},{})", real(radius * 1000.0))), *convex)
        }
        Form::Cone { apex, axis, slope, convex } => {
            let axes = file.axes(*apex, *axis, any_across(*axis));
            (file.add(&format!("CONICAL_SURFACE('',{axes},0.,{})", real(slope.atan()))), *convex)
        }
    }
}

fn truth(value: bool) -> &'static str {
    if value { ".T." } else { ".F." }
}
