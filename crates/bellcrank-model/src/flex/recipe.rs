//! All that a reduction depends on.

use bellcrank_doc::ParameterSet;
use bellcrank_fem::{CouplingKind, Keep, Material};
use bellcrank_math::Dual;
use sha2::{Digest, Sha256};

use crate::build;
use crate::design::{Body, Design, Flexible, Quantity, Values};
use crate::elastic::{End, Solid, material_of};

/// What is written beside the numbers: a change of how reductions are made makes other keys.
const MADE_BY: &str = concat!("bellcrank ", env!("CARGO_PKG_VERSION"), ", reductions 1");

/// Name of a reduction by its content.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Key(pub(super) [u8; 32]);

impl Key {
    /// As digits.
    pub(super) fn hex(self) -> String {
        self.0.iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

/// What goes into a reduction.
#[derive(Debug)]
pub(super) struct Recipe {
    pub(super) solid: Solid,
    pub(super) material: Material,
    /// Names and places of the interfaces, body axes, m.
    pub(super) interfaces: Vec<(String, [f64; 3])>,
    pub(super) kind: CouplingKind,
    pub(super) keep: Keep,
    /// The interface that the frame goes with, where tension stiffens the part.
    pub(super) stiffening: Option<usize>,
    /// The machine cannot feel what leaves the x-y plane.
    pub(super) planar: bool,
}

impl Recipe {
    pub(super) fn new(design: &Design, values: &Values, body: usize, form: &Flexible) -> Result<Recipe, End> {
        let solid = Solid::of(design, values, &form.mesh, body)?;
        let (material, _) = material_of(design, values, body, &solid)?;
        let points = build::points(design, values);
        let of = &design.bodies[body];
        let interface = |point: usize| (of.points[point].name.clone(), points[body][point].position);
        Ok(Recipe {
            solid,
            material,
            interfaces: form.interfaces.iter().map(|point| interface(point.value)).collect(),
            kind: if form.rigid { CouplingKind::Rigid } else { CouplingKind::Distributing },
            keep: Keep {
                count: Some(form.modes.count),
                frequency: form.modes.frequency.as_ref().map(|limit| limit.eval::<f64>(values)),
            },
            stiffening: form.stiffening.then_some(form.reference),
            planar: design.planar,
        })
    }

    /// Everything in it as text, numbers to the last digit, hashed.
    pub(super) fn key(&self) -> Key {
        let mut hash = Sha256::new();
        hash.update(MADE_BY);
        hash.update(format!("{self:?}"));
        Key(hash.finalize().into())
    }
}

/// Whether a parameter of the main file changes a reduction: derivatives by it need differences, as no exact one goes
/// through a mesh. A body's points count where they are interfaces or the solid is laid on them.
///
/// A derivative that is not a number taints all that depends on the parameter.
pub(crate) fn changes(design: &Design, main: &ParameterSet, index: usize) -> bool {
    let Some(value) = main.values().get(index) else { return false };
    let tainted = Dual::<1> { re: *value, eps: [f64::NAN] };
    let values = Values::with(&design.scopes, main, &[(index, tainted)]);
    let mut found = false;
    for body in 0..design.bodies.len() {
        each_quantity(design, body, &mut |quantity| found |= quantity.eval::<Dual<1>>(&values).eps[0].is_nan());
    }
    found
}

fn each_quantity(design: &Design, body: usize, visit: &mut dyn FnMut(&Quantity)) {
    let body = &design.bodies[body];
    let (Some(form), Some(worn)) = (&body.flexible, &body.solid) else { return };
    form.mesh.each_quantity(visit);
    form.modes.frequency.iter().for_each(&mut *visit);
    let points = worn.points.iter().copied().chain(form.interfaces.iter().map(|interface| interface.value));
    points.for_each(|point| each_of_point(body, point, visit));
    let solid = &design.solids[worn.solid];
    solid.form.each_quantity(visit);
    if let Some(material) = solid.material {
        design.materials[material].each_quantity(visit);
    }
}

/// The point, and those that it is given in.
fn each_of_point(body: &Body, point: usize, visit: &mut dyn FnMut(&Quantity)) {
    let mut next = Some(point);
    while let Some(point) = next.and_then(|index| body.points.get(index)) {
        point.at.iter().for_each(&mut *visit);
        point.rotation.each_quantity(visit);
        next = point.base;
    }
}
