//! Reads the signals that expressions use, without allocation.

use super::{MOST, Signal, Source, View};
use crate::scalar::Scalar;

/// Signals of some expressions and their values.
#[derive(Clone, Debug)]
pub(crate) struct Probe<T: Scalar = f64> {
    /// Sources in use, and which signals of each: part, and the signal's index.
    sources: Vec<(Source, Vec<(usize, usize)>)>,
    pub(crate) values: Vec<T::Number>,
}

impl<T: Scalar> Probe<T> {
    /// For the signals with an index in `used`.
    pub(crate) fn new(signals: &[Signal], used: &[usize]) -> Probe<T> {
        let mut sources: Vec<(Source, Vec<(usize, usize)>)> = Vec::new();
        for (index, Signal { source, part }) in signals.iter().copied().enumerate() {
            if !used.contains(&index) {
                continue;
            }
            match sources.iter_mut().find(|(known, _)| *known == source) {
                Some((_, parts)) => parts.push((part, index)),
                None => sources.push((source, vec![(part, index)])),
            }
        }
        Probe { sources, values: vec![T::Number::from(f64::NAN); signals.len()] }
    }

    /// Values at the present position.
    pub(crate) fn read(&mut self, view: &View<'_, T>) {
        let mut answers = [T::zero(); MOST];
        for (source, parts) in &self.sources {
            view.read(*source, &mut answers);
            for (part, index) in parts {
                self.values[*index] = answers[*part].number();
            }
        }
    }
}
