//! From a history of one number to damage: Miner's sum.

use super::mean::MeanStress;
use super::rainflow::{Cycle, Rainflow, Residue};
use super::woehler::Woehler;

/// Rules of a check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fatigue {
    /// For amplitudes at R = −1.
    pub line: Woehler,
    /// How the mean of a cycle counts.
    pub mean: MeanStress,
    /// What becomes of open ranges.
    pub residue: Residue,
}

/// What one pass of a history does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Damage {
    /// Σ n/N: failure is expected at 1 (experience puts it between 0.3 and 3). Not a number if the history is not one.
    pub sum: f64,
    /// Cycles counted, halves as halves.
    pub cycles: f64,
    /// Largest amplitude at R = −1, Pa.
    pub largest: f64,
}

impl Damage {
    /// Repeats of the history to failure; infinite without damage.
    pub fn repeats(&self) -> f64 {
        1.0 / self.sum
    }

    /// Amplitude at R = −1 that, `cycles` times at constant height, does the same damage on this line; Pa. 0 without damage.
    pub fn equivalent(&self, line: &Woehler, cycles: f64) -> f64 {
        if self.sum == 0.0 { 0.0 } else { line.amplitude_at(cycles / self.sum) }
    }

    fn add(&mut self, rules: &Fatigue, cycle: &Cycle) {
        let amplitude = rules.mean.equivalent(cycle.amplitude(), cycle.mean);
        self.sum += cycle.count * rules.line.damage(amplitude);
        self.cycles += cycle.count;
        self.largest = self.largest.max(amplitude);
    }
}

impl Fatigue {
    /// Damage of a history of stress, Pa.
    pub fn assess(&self, history: impl IntoIterator<Item = f64>) -> Damage {
        self.assess_with(&mut Rainflow::new(), history)
    }

    /// The same with a counter that keeps its memory from history to history.
    pub fn assess_with(&self, counter: &mut Rainflow, history: impl IntoIterator<Item = f64>) -> Damage {
        let (mut damage, mut finite) = (Damage::default(), true);
        for value in history {
            finite &= value.is_finite();
            counter.push(value, |cycle| damage.add(self, &cycle));
        }
        counter.finish(self.residue, |cycle| damage.add(self, &cycle));
        if finite { damage } else { Damage { sum: f64::NAN, ..Damage::default() } }
    }
}
