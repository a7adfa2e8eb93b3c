//! From the solid of a body to a mesh in body axes.

use bellcrank_fem::SizeField;
use bellcrank_mesh::{Division, Face, Mesh, Shape, Sizes, mesh_revolved, mesh_stack};
use bellcrank_results::MeshRow;

use super::vector::V3;
use super::{Asked, End, faults};
use crate::build::{Form, solid_of};
use crate::design::{Design, MeshForm, Plane, Quantity, SolidForm, Values};

/// The solid of a body and what is said of its mesh.
#[derive(Debug)]
pub(crate) struct Solid {
    pub(crate) form: Form,
    /// Names of its eyes.
    pub(crate) eyes: Vec<String>,
    pub(crate) shape: Shape,
    size: Option<f64>,
    bores: Option<f64>,
    fillets: Option<f64>,
    layers: Option<usize>,
    /// Multiplies all sizes.
    scale: f64,
}

impl Solid {
    pub(super) fn new(asked: &Asked<'_>, body: usize) -> Result<Solid, End> {
        Solid::of(asked.design, &asked.study.values, &asked.parts.mesh, body)
    }

    pub(crate) fn of(design: &Design, values: &Values, wish: &MeshForm, body: usize) -> Result<Solid, End> {
        let mut reports = Vec::new();
        let form = solid_of(design, values, body, &mut reports);
        let form = form.ok_or_else(|| faults::no_form(design, body, reports.first()))?;
        let of = |quantity: &Option<Quantity>| quantity.as_ref().map(|one| one.eval::<f64>(values));
        Ok(Solid {
            form,
            eyes: eyes(design, body),
            shape: if wish.tetrahedra { Shape::Tet10 } else { Shape::Wedge15 },
            size: of(&wish.size),
            bores: of(&wish.bores),
            fillets: of(&wish.fillets),
            layers: wish.layers,
            scale: wish.scale.unwrap_or(1.0),
        })
    }

    /// Meshes it, with sizes (body axes) that a former solution asks for.
    pub(crate) fn mesh(&self, wanted: Option<&SizeField>, most_nodes: usize) -> Result<Mesh, End> {
        let plane = match &self.form {
            Form::Stack { plane, .. } => *plane,
            Form::Revolved(_) | Form::Mesh(_) => Plane::Xy,
        };
        let background = |at: V3| wanted.map_or(f64::INFINITY, |field| field.at(in_body(at, plane)));
        let usual = Sizes::default();
        let length = |given: Option<f64>, usual| given.map_or(usual, Division::Length);
        let sizes = Sizes {
            size: self.size,
            at_bores: length(self.bores, usual.at_bores),
            at_fillets: length(self.fillets, usual.at_fillets),
            layers_across: self.layers.unwrap_or(usual.layers_across),
            background: wanted.is_some().then_some(&background),
            most_nodes,
            ..usual
        }
        .scaled(self.scale);
        let names: Vec<&str> = self.eyes.iter().map(String::as_str).collect();
        let made = match &self.form {
            Form::Stack { stack, .. } => mesh_stack(stack, &names, self.shape, &sizes),
            Form::Revolved(revolved) => mesh_revolved(revolved, self.shape, &sizes),
            Form::Mesh(_) if wanted.is_some() => return Err(faults::mesh_from_file()),
            Form::Mesh(mesh) => Ok((**mesh).clone()),
        };
        let mut mesh = made.map_err(|error| faults::no_mesh(&error))?;
        mesh.nodes.iter_mut().for_each(|node| *node = in_body(*node, plane));
        add_ends(&mut mesh);
        if !mesh.node_sets.contains_key("sharp") {
            let sharp = mesh.sharp_nodes(SHARP);
            mesh.node_sets.extend((!sharp.is_empty()).then(|| ("sharp".to_owned(), sharp)));
        }
        Ok(mesh)
    }

    /// The normal of its plane, or the axis that it is turned about.
    pub(super) fn axis(&self) -> V3 {
        match &self.form {
            Form::Stack { plane, .. } => in_body([0.0, 0.0, 1.0], *plane),
            Form::Revolved(revolved) => revolved.axis,
            Form::Mesh(_) => [0.0, 0.0, 1.0],
        }
    }

    /// Exact, at a density in kg/m³.
    pub(super) fn mass(&self, density: f64) -> f64 {
        match &self.form {
            Form::Stack { stack, .. } => stack.mass_properties(density).mass,
            Form::Revolved(revolved) => revolved.mass_properties(density).map_or(f64::NAN, |of| of.mass),
            Form::Mesh(mesh) => mesh.mass_properties(density).mass,
        }
    }

    /// Axes of the solid in those of the body, as columns.
    pub(super) fn axes(&self) -> [V3; 3] {
        match &self.form {
            Form::Stack { plane, .. } => {
                let axes = plane.axes();
                std::array::from_fn(|i| std::array::from_fn(|k| f64::from(axes[k] == i)))
            }
            Form::Revolved(_) | Form::Mesh(_) => std::array::from_fn(|i| std::array::from_fn(|k| f64::from(i == k))),
        }
    }
}

fn eyes(design: &Design, body: usize) -> Vec<String> {
    let worn = design.bodies.get(body).and_then(|body| body.solid.as_ref());
    match worn.and_then(|worn| design.solids.get(worn.solid)).map(|solid| &solid.form) {
        Some(SolidForm::Link(link)) => link.eyes.iter().map(|eye| eye.name.clone()).collect(),
        _ => Vec::new(),
    }
}

/// Where surfaces bend inwards by more than this many degrees, stress has no bound.
const SHARP: f64 = 15.0;

/// Names of the faces that lie in the ends of the part along the axes of the body.
pub(crate) const ENDS: [[&str; 2]; 3] = [["xmin", "xmax"], ["ymin", "ymax"], ["zmin", "zmax"]];

/// Adds them as sets of faces, where they are plane.
fn add_ends(mesh: &mut Mesh) {
    let boundary = mesh.boundary();
    for (axis, names) in ENDS.iter().enumerate() {
        let along = mesh.nodes.iter().map(|node| node[axis]);
        let [low, high] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
        let slack = 1e-9 * (high - low);
        for (name, end) in names.iter().zip([low, high]) {
            let inside = |face: &&Face| {
                mesh.face_nodes(**face).all(|node| (mesh.nodes[node as usize][axis] - end).abs() <= slack)
            };
            let faces: Vec<Face> = boundary.iter().filter(inside).copied().collect();
            if !faces.is_empty() {
                mesh.face_sets.insert((*name).to_owned(), faces);
            }
        }
    }
}

/// What there is to say of a mesh before it is solved on.
pub(super) fn row(mesh: &Mesh) -> MeshRow {
    let quality = mesh.quality();
    let element = mesh.blocks.first().map_or("", |block| block.shape.abaqus());
    MeshRow {
        nodes: quality.nodes,
        elements: quality.elements,
        element: element.to_owned(),
        worst_jacobian: quality.worst,
        peak: f64::NAN,
        error: f64::NAN,
    }
}

/// From the axes of a plane to those of the body.
pub(super) fn in_body(at: V3, plane: Plane) -> V3 {
    let mut place = [0.0; 3];
    plane.axes().into_iter().zip(at).for_each(|(axis, x)| place[axis] = x);
    place
}
