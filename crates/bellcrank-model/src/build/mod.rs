//! From the checked model and its parameters to numbers: the blueprint of a mechanism.

mod bodies;
mod faults;
mod forces;
mod frames;
mod joints;
mod plausible;
mod studies;

use bellcrank_doc::{Diagnostic, Span};
use bellcrank_multibody::{Blueprint, Engine, engine_for};

use crate::design::{Components, Design, Direction, Quantity, Values};
use crate::geometry::Geometry;

pub(crate) use faults::{check_connected, loose_bodies};
pub(crate) use plausible::{implausible, implausible_study};

/// A model in numbers.
#[derive(Clone, Debug)]
pub(crate) struct Built {
    pub(crate) blueprint: Blueprint<f64>,
    pub(crate) geometry: Geometry,
}

/// Evaluates a model. What the numbers are not fit for is reported; then there is no result.
pub(crate) fn build(design: &Design, values: &Values, faults: &mut Vec<Diagnostic>) -> Option<Built> {
    let before = faults.len();
    let mut numbers = Numbers { design, values, faults };
    let gravity = numbers.vector(&design.gravity, "`gravity`");
    let bodies = bodies::bodies(&mut numbers);
    let points = bodies::points(&mut numbers);
    let joints = joints::joints(&mut numbers, &points);
    let (forces, spans) = forces::forces(&mut numbers, &points);
    if numbers.faults.len() > before {
        return None;
    }
    let blueprint = Blueprint { gravity, bodies, joints, forces, inputs: design.inputs.len() };
    Some(Built { blueprint, geometry: Geometry { points, spans } })
}

/// A mechanism of a blueprint, or what keeps it from being one.
pub(crate) fn engine(design: &Design, built: &Built) -> Result<Box<dyn Engine>, Box<Diagnostic>> {
    engine_for(design.planar, &built.blueprint).map_err(|error| Box::new(faults::report(design, &error)))
}

/// Values as numbers, and what is wrong with them.
struct Numbers<'a> {
    design: &'a Design,
    values: &'a Values,
    faults: &'a mut Vec<Diagnostic>,
}

impl Numbers<'_> {
    fn report(&mut self, code: &'static str, span: Span, message: impl Into<String>) {
        self.faults.push(Diagnostic::error(code, span, message));
    }

    /// A finite number.
    fn number(&mut self, quantity: &Quantity, what: &str) -> f64 {
        let value = quantity.eval(self.values);
        if !value.is_finite() {
            let message = format!("{what} is not a finite number: `{}` gives {value}", quantity.expression.written());
            self.report("not-finite", quantity.span(), message);
            return 0.0;
        }
        value
    }

    /// Three components; the third of a vector in the plane is 0.
    fn vector(&mut self, quantities: &[Quantity], what: &str) -> [f64; 3] {
        let mut vector = [0.0; 3];
        for (place, quantity) in vector.iter_mut().zip(quantities) {
            *place = self.number(quantity, what);
        }
        vector
    }

    /// A direction that has one.
    fn direction(&mut self, direction: &Direction, what: &str) -> [f64; 3] {
        let axis = match &direction.components {
            Components::Fixed(axis) => *axis,
            Components::Given(quantities) => self.vector(quantities, what),
        };
        if axis == [0.0; 3] {
            self.report("no-axis", direction.span, format!("{what} has no length, so it gives no direction"));
        }
        axis
    }
}
