//! Force values that are worked out at every position.

use bellcrank_multibody::Readings;

use crate::design::{Design, Values};
use crate::geometry::Geometry;
use crate::scalar::Scalar;
use crate::signals::{Level, MOST, Signal, Source, View};

/// A model and its numbers.
#[derive(Clone, Copy)]
pub(crate) struct Evaluated<'a, T: Scalar = f64> {
    pub(crate) design: &'a Design,
    pub(crate) values: &'a Values<T>,
    pub(crate) geometry: &'a Geometry<T>,
}

/// The expressions of a model's forces, ready to be evaluated without allocation.
pub(crate) struct Inputs<T: Scalar = f64> {
    /// Sources in use, and which signals of each: part, and the signal's index.
    sources: Vec<(Source, Vec<(usize, usize)>)>,
    signals: Vec<T::Number>,
}

impl<T: Scalar> Inputs<T> {
    pub(crate) fn new(design: &Design) -> Inputs<T> {
        let mut sources: Vec<(Source, Vec<(usize, usize)>)> = Vec::new();
        for (index, Signal { source, part }) in design.input_signals.iter().copied().enumerate() {
            match sources.iter_mut().find(|(known, _)| *known == source) {
                Some((_, parts)) => parts.push((part, index)),
                None => sources.push((source, vec![(part, index)])),
            }
        }
        Inputs { sources, signals: vec![T::Number::from(f64::NAN); design.input_signals.len()] }
    }

    /// Values of all inputs at the present position and velocity.
    pub(crate) fn evaluate(&mut self, readings: &dyn Readings<T>, of: Evaluated<'_, T>, inputs: &mut [T]) {
        let Evaluated { design, values, geometry } = of;
        let catalogue = &design.catalogue;
        let view = View { readings, catalogue, geometry, efforts: &[], level: Level::Velocity };
        let mut answers = [T::zero(); MOST];
        for (source, parts) in &self.sources {
            view.read(*source, &mut answers);
            for (part, index) in parts {
                self.signals[*index] = answers[*part].number();
            }
        }
        for (value, input) in inputs.iter_mut().zip(&design.inputs) {
            *value = T::of(input.expression.eval(values.of(input.scope), &self.signals));
        }
    }
}
