//! What a material stands when loaded again and again, in numbers.

use bellcrank_fem::fatigue::{Fatigue, MeanStress, Residue, Woehler};

use super::Check;
use crate::design::{FatigueForm, MeanForm, Quantity};

impl Check<'_> {
    /// The rules by which a history of stress is checked; `None` where a number is wrong, which is reported.
    pub(super) fn fatigue(&mut self, form: &FatigueForm, tensile: Option<f64>) -> Option<Fatigue> {
        let before = self.numbers.faults.len();
        let amplitude = self.above_zero(&form.amplitude, "fatigue.amplitude");
        let cycles = self.above_zero(&form.cycles, "fatigue.cycles");
        let slope = self.above_one(&form.slope, "fatigue.slope");
        let mean = self.mean(&form.mean, tensile)?;
        if self.numbers.faults.len() == before
            && let Some(tensile) = tensile.filter(|tensile| amplitude >= *tensile)
        {
            let name = &self.material.name;
            let message = format!(
                "`fatigue.amplitude` of material `{name}` is not below its tensile strength of {} MPa",
                tensile / 1e6
            );
            self.report(&form.amplitude, message, "the amplitude that it stands many times, half of the stress range");
        }
        let line = Woehler::new(amplitude, cycles, slope, form.beyond).ok()?;
        (self.numbers.faults.len() == before).then_some(Fatigue { line, mean, residue: Residue::Repeated })
    }

    fn above_one(&mut self, quantity: &Quantity, key: &str) -> f64 {
        let before = self.numbers.faults.len();
        let value = self.number(quantity, key);
        if self.numbers.faults.len() == before && value <= 1.0 {
            let message = format!("`{key}` of material `{}` must be above 1, found {value}", self.material.name);
            self.report(quantity, message, "parts of steel have about 5, welds 3, polished specimens 10 to 15");
        }
        value
    }

    fn mean(&mut self, form: &MeanForm, tensile: Option<f64>) -> Option<MeanStress> {
        match form {
            MeanForm::None => Some(MeanStress::None),
            MeanForm::Goodman => tensile.map(|tensile| MeanStress::Goodman { tensile }),
            MeanForm::Group(group) => {
                tensile.map(|tensile| MeanStress::Fkm { sensitivity: group.sensitivity(tensile).min(1.0) })
            }
            MeanForm::Sensitivity(quantity) => {
                let before = self.numbers.faults.len();
                let sensitivity = self.number(quantity, "fatigue.sensitivity");
                if self.numbers.faults.len() == before && !(0.0..=1.0).contains(&sensitivity) {
                    let message = format!(
                        "`fatigue.sensitivity` of material `{}` must lie between 0 and 1, found {sensitivity}",
                        self.material.name
                    );
                    self.report(quantity, message, "0 where the mean does not matter; steel has 0.1, cast iron 0.5");
                }
                Some(MeanStress::Fkm { sensitivity })
            }
        }
    }
}
