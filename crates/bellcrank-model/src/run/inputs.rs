//! Force values that are worked out at every position.

use bellcrank_multibody::Readings;

use crate::design::{Design, Values};
use crate::geometry::Geometry;
use crate::scalar::Scalar;
use crate::signals::{Level, Probe, View};

/// A model and its numbers.
#[derive(Clone, Copy)]
pub(crate) struct Evaluated<'a, T: Scalar = f64> {
    pub(crate) design: &'a Design,
    pub(crate) values: &'a Values<T>,
    pub(crate) geometry: &'a Geometry<T>,
}

/// The expressions of a model's forces, ready to be evaluated without allocation.
pub(crate) struct Inputs<T: Scalar = f64> {
    probe: Probe<T>,
}

impl<T: Scalar> Inputs<T> {
    pub(crate) fn new(design: &Design) -> Inputs<T> {
        let all: Vec<usize> = (0..design.input_signals.len()).collect();
        Inputs { probe: Probe::new(&design.input_signals, &all) }
    }

    /// Values of all inputs at the present position and velocity.
    pub(crate) fn evaluate(&mut self, readings: &dyn Readings<T>, of: Evaluated<'_, T>, inputs: &mut [T]) {
        let Evaluated { design, values, geometry } = of;
        let catalogue = &design.catalogue;
        self.probe.read(&View { readings, catalogue, geometry, efforts: &[], level: Level::Velocity });
        for (value, input) in inputs.iter_mut().zip(&design.inputs) {
            *value = T::of(input.expression.eval(values.of(input.scope), &self.probe.values));
        }
    }
}
