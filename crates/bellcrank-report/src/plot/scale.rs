//! Display numbers to pixels.

use super::Axis;
use super::ticks::{Ticks, span};
use crate::number;

/// Pixels between two marks of an axis, about.
const MARK_EVERY: f64 = 70.0;
/// The same on axes so low that there would be one mark or two.
const MARK_EVERY_LOW: f64 = 38.0;
const LOW: f64 = 270.0;

/// A stretch of numbers on a stretch of pixels.
pub(crate) struct Scale {
    pub(crate) ticks: Ticks,
    pub(crate) pixels: (f64, f64),
    /// The marks are powers of ten.
    logarithmic: bool,
}

impl Scale {
    /// The span of `values`, widened by a share of itself at both ends.
    pub(crate) fn new(values: impl Iterator<Item = f64>, axis: &Axis, pixels: (f64, f64), margin: f64) -> Self {
        Self::over(span(values, margin), &axis.unit, pixels)
    }

    /// A given span.
    pub(crate) fn over(span: (f64, f64), unit: &str, pixels: (f64, f64)) -> Self {
        let low = pixels.0 > pixels.1 && pixels.0 - pixels.1 < LOW;
        let every = if low { MARK_EVERY_LOW } else { MARK_EVERY };
        let count = ((pixels.1 - pixels.0).abs() / every).max(2.0);
        Self { ticks: Ticks::new(span, count, unit), pixels, logarithmic: false }
    }

    /// Whole powers of ten around the positive `values`; what is not positive lies on the lower edge.
    pub(crate) fn logarithmic(values: impl Iterator<Item = f64>, pixels: (f64, f64)) -> Self {
        let (low, high) = values
            .filter(|value| *value > 0.0 && value.is_finite())
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v.log10()), high.max(v.log10())));
        let (low, high) = if low > high { (-1.0, 0.0) } else { (low.floor(), high.ceil().max(low.floor() + 1.0)) };
        let count = ((pixels.1 - pixels.0).abs() / MARK_EVERY_LOW * 2.0).max(2.0).min(high - low);
        Self { ticks: Ticks::new((low, high), count, ""), pixels, logarithmic: true }
    }

    pub(crate) fn at(&self, value: f64) -> f64 {
        let value = if self.logarithmic { self.power(value) } else { value };
        self.at_mark(value)
    }

    /// Where a mark stands.
    pub(crate) fn at_mark(&self, mark: f64) -> f64 {
        let part = (mark - self.ticks.from) / (self.ticks.to - self.ticks.from);
        self.pixels.0 + part * (self.pixels.1 - self.pixels.0)
    }

    pub(crate) fn text(&self, mark: f64) -> String {
        if self.logarithmic { number::typeset(&format!("1e{mark:.0}")) } else { self.ticks.text(mark) }
    }

    /// Whether a mark stands for zero.
    pub(crate) fn is_zero(&self, mark: f64) -> bool {
        !self.logarithmic && mark.abs() < 1e-9 * (self.ticks.to - self.ticks.from)
    }

    fn power(&self, value: f64) -> f64 {
        if value > 0.0 {
            value.log10().max(self.ticks.from)
        } else if value.is_nan() {
            f64::NAN
        } else {
            self.ticks.from
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_marked() {
        let scale = Scale::logarithmic([0.04, 0.0, 3e-9].into_iter(), (290.0, 0.0));
        assert_eq!((scale.ticks.from, scale.ticks.to), (-9.0, -1.0));
        assert_eq!(scale.text(-9.0), "1e−9");
        assert_eq!(scale.at(0.0), 290.0);
        assert_eq!(scale.at(0.1), 0.0);
        assert!(scale.at(f64::NAN).is_nan());
    }

    #[test]
    fn nothing_positive_still_has_an_axis() {
        let scale = Scale::logarithmic([0.0].into_iter(), (100.0, 0.0));
        assert_eq!(scale.at(0.0), 100.0);
    }
}
