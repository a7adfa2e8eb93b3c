//! From the checked model and its parameters to numbers: the blueprint of a mechanism.

mod bodies;
mod faults;
mod flexible;
mod forces;
mod forward;
mod frames;
mod joints;
mod materials;
mod plausible;
mod programme;
mod rods;
mod solids;
mod studies;

use std::fmt::Arguments;

use bellcrank_doc::{Diagnostic, Span};
use bellcrank_multibody::{Blueprint, Engine, Place, engine_for};

use crate::design::{Components, Design, Direction, Quantity, Values};
use crate::geometry::Geometry;
use crate::scalar::Scalar;

pub(crate) use faults::{check_connected, loose_bodies};
pub(crate) use flexible::{DAMPING, Deforming, MOST_MODES, Shapes as ShapesOf, deform, picked, shortened};
pub(crate) use forward::idle_velocities;
pub(crate) use materials::{ElasticNumbers, MaterialNumbers, material, material_faults};
pub(crate) use plausible::{implausible, implausible_study};
pub(crate) use programme::programme_faults;
use solids::Kept;
pub(crate) use solids::{Form, solid_of};

/// A model in numbers.
#[derive(Clone, Debug)]
pub(crate) struct Built<T = f64> {
    pub(crate) blueprint: Blueprint<T>,
    pub(crate) geometry: Geometry<T>,
    /// What the solids came to, by body.
    solids: Vec<Kept<T>>,
    /// Bodies that deform, in the order of the blueprint's; none in a machine that was built rigid.
    pub(crate) flexible: Vec<Deforming<T>>,
}

impl<T: Scalar> Built<T> {
    /// Volume of the solid of a body, m³.
    pub(crate) fn volume(&self, body: usize) -> Option<T> {
        self.solids.get(body)?.volume()
    }

    /// Nothing yet, for [`rebuild`].
    pub(crate) fn empty() -> Built<T> {
        let gravity = [T::zero(); 3];
        let blueprint = Blueprint {
            gravity,
            bodies: Vec::new(),
            joints: Vec::new(),
            forces: Vec::new(),
            flexible: Vec::new(),
            inputs: 0,
        };
        Built {
            blueprint,
            geometry: Geometry { points: Vec::new(), spans: Vec::new(), stresses: Vec::new() },
            solids: Vec::new(),
            flexible: Vec::new(),
        }
    }
}

/// Evaluates a model. What the numbers are not fit for is reported; then there is no result.
pub(crate) fn build<T: Scalar>(design: &Design, values: &Values<T>, faults: &mut Vec<Diagnostic>) -> Option<Built<T>> {
    let mut built = Built::empty();
    rebuild(design, values, &mut built, faults).then_some(built)
}

/// Evaluates a model in the memory of a former evaluation, and says whether its numbers are fit for a mechanism: what
/// they are not fit for is reported, and `built` is of no use then. Allocates for reports and for solids that change only.
pub(crate) fn rebuild<T: Scalar>(
    design: &Design,
    values: &Values<T>,
    built: &mut Built<T>,
    faults: &mut Vec<Diagnostic>,
) -> bool {
    let before = faults.len();
    let mut numbers = Numbers { design, values, faults };
    let Built { blueprint, geometry, solids, flexible } = built;
    blueprint.flexible.clear();
    flexible.clear();
    geometry.stresses.clear();
    blueprint.inputs = design.inputs.len();
    blueprint.gravity = numbers.vector(&design.gravity, format_args!("`gravity`"));
    bodies::points(&mut numbers, &mut geometry.points);
    bodies::bodies(&mut numbers, &geometry.points, solids, &mut blueprint.bodies);
    joints::joints(&mut numbers, &geometry.points, &mut blueprint.joints);
    forces::forces(&mut numbers, geometry, &mut blueprint.forces);
    flexible::faults(&mut numbers, &geometry.points);
    faults.len() == before
}

/// The frames of all points of all bodies, as far as their numbers are sound.
pub(crate) fn points(design: &Design, values: &Values) -> Vec<Vec<Place<f64>>> {
    let (mut points, mut faults) = (Vec::new(), Vec::new());
    bodies::points(&mut Numbers { design, values, faults: &mut faults }, &mut points);
    points
}

/// A mechanism of a blueprint, or what keeps it from being one.
pub(crate) fn engine(design: &Design, built: &Built) -> Result<Box<dyn Engine>, Box<Diagnostic>> {
    engine_for(design.planar, &built.blueprint).map_err(|error| Box::new(faults::report(design, &error)))
}

/// Values as numbers, and what is wrong with them. What a number is (`what`) becomes text in a report only.
struct Numbers<'a, T: Scalar = f64> {
    design: &'a Design,
    values: &'a Values<T>,
    faults: &'a mut Vec<Diagnostic>,
}

impl<T: Scalar> Numbers<'_, T> {
    fn report(&mut self, code: &'static str, span: Span, message: impl Into<String>) {
        self.faults.push(Diagnostic::error(code, span, message));
    }

    /// A finite number.
    fn number(&mut self, quantity: &Quantity, what: Arguments<'_>) -> T {
        let number = quantity.eval(self.values);
        let value = number.value();
        if !value.is_finite() {
            let message = format!("{what} is not a finite number: `{}` gives {value}", quantity.expression.written());
            self.report("not-finite", quantity.span(), message);
            return T::zero();
        }
        number
    }

    /// A finite number that is not negative.
    fn positive(&mut self, quantity: &Quantity, what: Arguments<'_>) -> T {
        let number = self.number(quantity, what);
        if number.value() < 0.0 {
            self.report("negative", quantity.span(), format!("{what} is negative"));
        }
        number
    }

    /// A finite number above zero.
    fn above_zero(&mut self, quantity: &Quantity, what: Arguments<'_>) -> T {
        let before = self.faults.len();
        let number = self.number(quantity, what);
        if self.faults.len() == before && number.value() <= 0.0 {
            self.report("out-of-range", quantity.span(), format!("{what} must be above zero"));
        }
        number
    }

    /// Three components; the third of a vector in the plane is 0.
    fn vector(&mut self, quantities: &[Quantity], what: Arguments<'_>) -> [T; 3] {
        let mut vector = [T::zero(); 3];
        for (place, quantity) in vector.iter_mut().zip(quantities) {
            *place = self.number(quantity, what);
        }
        vector
    }

    /// A direction that has one.
    fn direction(&mut self, direction: &Direction, what: Arguments<'_>) -> [T; 3] {
        let axis = match &direction.components {
            Components::Fixed(axis) => axis.map(T::from_f64),
            Components::Given(quantities) => self.vector(quantities, what),
        };
        if axis.iter().all(|component| component.value() == 0.0) {
            self.report("no-axis", direction.span, format!("{what} has no length, so it gives no direction"));
        }
        axis
    }
}
