//! Force values that are worked out at every position.

use bellcrank_multibody::Engine;

use crate::build::Built;
use crate::design::{Design, Values};
use crate::signals::{Level, MOST, Signal, Source, View};

/// The expressions of a model's forces, ready to be evaluated without allocation.
pub(super) struct Inputs<'d> {
    values: &'d Values,
    /// Sources in use, and which signals of each: part, and the signal's index.
    sources: Vec<(Source, Vec<(usize, usize)>)>,
    signals: Vec<f64>,
}

impl<'d> Inputs<'d> {
    pub(super) fn new(design: &Design, values: &'d Values) -> Inputs<'d> {
        let mut sources: Vec<(Source, Vec<(usize, usize)>)> = Vec::new();
        for (index, Signal { source, part }) in design.input_signals.iter().copied().enumerate() {
            match sources.iter_mut().find(|(known, _)| *known == source) {
                Some((_, parts)) => parts.push((part, index)),
                None => sources.push((source, vec![(part, index)])),
            }
        }
        Inputs { values, sources, signals: vec![f64::NAN; design.input_signals.len()] }
    }

    /// Values of all inputs at the present position and velocity.
    pub(super) fn evaluate(&mut self, engine: &dyn Engine, design: &Design, built: &Built, inputs: &mut [f64]) {
        let view = View {
            engine,
            catalogue: &design.catalogue,
            geometry: &built.geometry,
            efforts: &[],
            level: Level::Velocity,
        };
        let mut answers = [f64::NAN; MOST];
        for (source, parts) in &self.sources {
            view.read(*source, &mut answers);
            for (part, index) in parts {
                self.signals[*index] = answers[*part];
            }
        }
        for (value, input) in inputs.iter_mut().zip(&design.inputs) {
            *value = input.expression.eval(self.values.of(input.scope), &self.signals);
        }
    }
}
