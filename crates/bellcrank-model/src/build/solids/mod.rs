//! Solids on the points of their bodies, in numbers.
//!
//! What comes out is generic over the scalar, so that masses carry derivatives by any parameter of the geometry. A
//! geometry is kept from one evaluation to the next while the numbers that it is made of are the same.

mod attached;
mod faults;
mod link;

use std::sync::Arc;

use bellcrank_doc::Diagnostic;
use bellcrank_mesh::Mesh;
use bellcrank_multibody::{Body as BodyNumbers, Place};
use bellcrank_solid::{Fault, MassProperties, Revolved, Stack};

use super::frames::Matrix;
use super::{Built, Numbers, bodies};
use crate::design::{Body, Design, Plane, RevolvedForm, Solid, SolidForm, Values, Worn};
use crate::scalar::Scalar;
use attached::Attached;
use link::Laying;

/// The form of a solid on its body.
#[derive(Clone, Debug)]
pub(crate) enum Form<T = f64> {
    /// A link, in the axes of its plane.
    Stack { stack: Box<Stack<T>>, plane: Plane },
    /// A body of revolution, in body axes.
    Revolved(Revolved<T>),
    /// A mesh, in body axes.
    Mesh(Arc<Mesh>),
}

/// What a body's solid came to, and the numbers that it was made of.
#[derive(Clone, Debug)]
pub(crate) struct Kept<T> {
    numbers: Vec<T>,
    /// Room for the numbers of the next evaluation.
    next: Vec<T>,
    /// At a density of one, in body axes; `None` where nothing could be made.
    unit: Option<MassProperties<T>>,
}

impl<T: Copy> Kept<T> {
    /// m³.
    pub(super) fn volume(&self) -> Option<T> {
        self.unit.map(|unit| unit.volume)
    }
}

impl<T> Default for Kept<T> {
    fn default() -> Kept<T> {
        Kept { numbers: Vec::new(), next: Vec::new(), unit: None }
    }
}

/// Mass, centre and inertia of a body from its solid; massless where that cannot be made, which is reported.
pub(super) fn mass<T: Scalar>(
    numbers: &mut Numbers<'_, T>,
    worn: &Worn,
    places: &[Place<T>],
    kept: &mut Kept<T>,
) -> BodyNumbers<T> {
    let design = numbers.design;
    let solid = &design.solids[worn.solid];
    let unit = unit_mass(numbers, solid, worn, places, kept);
    let density = solid
        .material
        .and_then(|material| Some((&design.materials[material], design.materials[material].density.as_ref()?)));
    let density = density.map_or(T::zero(), |(material, density)| {
        numbers.above_zero(density, format_args!("`density` of material `{}`", material.name))
    });
    let zero = [[T::zero(); 3]; 3];
    unit.map_or(BodyNumbers { mass: T::zero(), center: [T::zero(); 3], inertia: zero }, |unit| BodyNumbers {
        mass: unit.mass * density,
        center: unit.center,
        inertia: unit.inertia.map(|row| row.map(|entry| entry * density)),
    })
}

fn unit_mass<T: Scalar>(
    numbers: &mut Numbers<'_, T>,
    solid: &Solid,
    worn: &Worn,
    places: &[Place<T>],
    kept: &mut Kept<T>,
) -> Option<MassProperties<T>> {
    kept.next.clear();
    let (values, next) = (numbers.values, &mut kept.next);
    solid.form.each_quantity(&mut |quantity| next.push(quantity.eval(values)));
    let points = worn.points.iter().filter_map(|&point| places.get(point));
    next.extend(points.flat_map(|place| place.position));
    if kept.unit.is_some() && kept.next == kept.numbers {
        return kept.unit;
    }
    std::mem::swap(&mut kept.numbers, &mut kept.next);
    kept.unit = form(numbers, solid, worn, places).and_then(|form| form.unit_mass());
    kept.unit
}

/// The form of a solid on the points of a body; what it cannot be is reported, and what may be a slip as well.
fn form<T: Scalar>(numbers: &mut Numbers<'_, T>, solid: &Solid, worn: &Worn, places: &[Place<T>]) -> Option<Form<T>> {
    let (made, faults) = made(numbers, solid, worn, places)?;
    for fault in faults.iter().filter(|fault| !fault.is_warning()) {
        tell(numbers.faults, faults::report(numbers.design, solid, worn, fault));
    }
    made
}

/// Adds a report; one that another body has got as well only gets this body's place.
fn tell(faults: &mut Vec<Diagnostic>, report: Diagnostic) {
    let same = |known: &&mut Diagnostic| (&known.message, &known.primary) == (&report.message, &report.primary);
    match faults.iter_mut().find(same) {
        Some(known) => known.secondary.extend(report.secondary),
        None => faults.push(report),
    }
}

/// The form, and what is wrong with it or may be; nothing where its numbers alone are wrong, which is reported.
fn made<T: Scalar>(
    numbers: &mut Numbers<'_, T>,
    solid: &Solid,
    worn: &Worn,
    places: &[Place<T>],
) -> Option<(Option<Form<T>>, Vec<Fault>)> {
    let before = numbers.faults.len();
    let mut laying = Laying { numbers, solid, worn, places };
    match &solid.form {
        SolidForm::Link(of) => {
            let link = laying.link(of);
            (numbers.faults.len() == before).then(|| match link.build() {
                Ok(stack) => {
                    let warnings = stack.warnings.clone();
                    (Some(Form::Stack { stack: Box::new(stack), plane: of.plane }), warnings)
                }
                Err(faults) => (None, faults),
            })
        }
        SolidForm::Revolved(of) => {
            let revolved = laying.revolved(of);
            (numbers.faults.len() == before).then(|| match revolved.moments() {
                Ok(_) => (Some(Form::Revolved(revolved)), Vec::new()),
                Err(faults) => (None, faults),
            })
        }
        SolidForm::File(file) => Some((Some(Form::Mesh(Arc::clone(&file.mesh))), Vec::new())),
        SolidForm::Faulty => None,
    }
}

impl<T: Scalar> Laying<'_, '_, T> {
    fn revolved(&mut self, form: &RevolvedForm) -> Revolved<T> {
        let name = &self.solid.name;
        let base = self.place(&form.at);
        let axis = self.numbers.direction(&form.axis, format_args!("the axis of solid `{name}`"));
        let length = crate::scalar::length(axis);
        let axis = if length.value() > 0.0 { axis.map(|component| component / length) } else { axis };
        let mut number =
            |quantity| self.numbers.number(quantity, format_args!("a corner of the profile of solid `{name}`"));
        let profile = form.profile.iter().map(|[r, h]| [number(r), number(h)]).collect();
        Revolved { base, axis, profile }
    }
}

impl<T: Scalar> Form<T> {
    /// Mass properties at a density of one, in body axes.
    fn unit_mass(&self) -> Option<MassProperties<T>> {
        match self {
            Form::Stack { stack, plane } => Some(in_body(&stack.mass_properties(T::one()), *plane)),
            Form::Revolved(revolved) => revolved.mass_properties(T::one()).ok(),
            Form::Mesh(mesh) => Some(of_mesh(mesh)),
        }
    }
}

/// A mesh depends on no parameter.
fn of_mesh<T: Scalar>(mesh: &Mesh) -> MassProperties<T> {
    let found = mesh.mass_properties(1.0);
    MassProperties {
        volume: T::from_f64(found.volume),
        mass: T::from_f64(found.mass),
        center: found.center.map(T::from_f64),
        inertia: found.inertia.map(|row| row.map(T::from_f64)),
    }
}

/// From the axes of a plane to those of the body.
fn in_body<T: Scalar>(plan: &MassProperties<T>, plane: Plane) -> MassProperties<T> {
    let axes = plane.axes();
    let (mut center, mut inertia): ([T; 3], Matrix<T>) = Default::default();
    for (i, &axis) in axes.iter().enumerate() {
        center[axis] = plan.center[i];
        for (j, &other) in axes.iter().enumerate() {
            inertia[axis][other] = plan.inertia[i][j];
        }
    }
    MassProperties { center, inertia, ..*plan }
}

/// The form of the solid of a body at some parameters: what is drawn, exported, meshed. `None` for a body without one,
/// and where it cannot be made, which is reported.
pub(crate) fn solid_of(design: &Design, values: &Values, body: usize, faults: &mut Vec<Diagnostic>) -> Option<Form> {
    let (worn, solid) = worn(design, body)?;
    let mut numbers = Numbers { design, values, faults };
    let mut points = Vec::new();
    bodies::points(&mut numbers, &mut points);
    form(&mut numbers, solid, worn, points.get(body)?)
}

/// What may be a slip in the solids of all bodies.
pub(super) fn warnings(design: &Design, values: &Values, built: &Built) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for (body, places) in built.geometry.points.iter().enumerate() {
        let Some((worn, solid)) = worn(design, body) else { continue };
        let mut numbers = Numbers { design, values, faults: &mut Vec::new() };
        let faults = made(&mut numbers, solid, worn, places).map_or_else(Vec::new, |(_, faults)| faults);
        for fault in faults.iter().filter(|fault| fault.is_warning()) {
            tell(&mut found, faults::report(design, solid, worn, fault));
        }
        if let SolidForm::Link(form) = &solid.form {
            let link = Laying { numbers: &mut numbers, solid, worn, places }.link(form);
            let joints = &built.blueprint.joints;
            found.extend(Attached { design, solid, worn, body, places, joints }.warnings(form, &link));
        }
    }
    found
}

fn worn(design: &Design, body: usize) -> Option<(&Worn, &Solid)> {
    let worn = design.bodies.get(body).and_then(|body: &Body| body.solid.as_ref())?;
    Some((worn, design.solids.get(worn.solid)?))
}
