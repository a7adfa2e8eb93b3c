//! What colours mean: a range with round numbers, its bands and where it is cut.

use bellcrank_results::{ContourField, Unit};

use crate::number;
use crate::plot::ticks::Ticks;

/// Bands of colour aimed at.
const BANDS: f64 = 14.0;
/// A sign that makes up less than this share of the range is not worth two colours.
const SLIGHT: f64 = 0.05;

/// The scale of one field or of several alike, display units.
#[derive(Clone, Debug)]
pub(crate) struct Scale {
    pub(crate) name: String,
    pub(crate) unit: Unit,
    /// Where the colours begin and end.
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// Width of a band; round.
    pub(crate) step: f64,
    /// Least and largest value there is.
    pub(crate) least: f64,
    pub(crate) most: f64,
    /// Whether colours are about zero.
    pub(crate) signed: bool,
    /// Numbers beside the bar with their texts.
    pub(crate) marks: Vec<(f64, String)>,
}

impl Scale {
    /// The scale that shows all of `fields`, which are of one name and unit; nothing without a number.
    pub(crate) fn of(fields: &[&ContourField]) -> Option<Self> {
        let first = fields.first()?;
        let (least, most) = extent(fields, &first.unit)?;
        let ceiling = fields.iter().filter_map(|field| field.ceiling).reduce(f64_max_32);
        let ceiling = ceiling.map(|si| first.unit.show(f64::from(si))).filter(|top| top.is_finite() && *top > least);
        Some(Self::over(&first.name, &first.unit, (least, most), ceiling))
    }

    fn over(name: &str, unit: &Unit, (least, most): (f64, f64), ceiling: Option<f64>) -> Self {
        let (from, to) = opened(least, ceiling.unwrap_or(most));
        let step = Ticks::new((from, to), BANDS, "").step();
        let low = step * (from / step + 1e-6).floor();
        let high = ceiling.unwrap_or(step * (to / step - 1e-6).ceil());
        let ticks = Ticks::new((low, high), (high - low) / step, "");
        let marks = ticks.marks.iter().map(|mark| (*mark, ticks.text(*mark))).collect();
        let signed = least < 0.0 && most > 0.0 && (-least).min(most) > SLIGHT * (-least).max(most);
        Self { name: name.to_owned(), unit: unit.clone(), low, high, step, least, most, signed, marks }
    }

    /// Bands from low to high; the last may be narrower.
    pub(crate) fn bands(&self) -> usize {
        ((self.high - self.low) / self.step - 1e-6).ceil().max(1.0) as usize
    }

    /// From where to where a band reaches.
    pub(crate) fn band(&self, band: usize) -> (f64, f64) {
        let from = self.low + band as f64 * self.step;
        (from, (from + self.step).min(self.high))
    }

    /// Where the colour of a band lies among the colours.
    pub(crate) fn share(&self, band: usize) -> f64 {
        if !self.signed {
            return band as f64 / (self.bands().max(2) - 1) as f64;
        }
        let (from, to) = self.band(band);
        0.5 + 0.25 * (from + to) / self.high.abs().max(self.low.abs())
    }

    /// Whether values lie above the end of the colours.
    pub(crate) fn is_cut(&self) -> bool {
        self.most > self.high * (1.0 + 1e-6)
    }

    /// A value with its unit, four digits.
    pub(crate) fn text(&self, value: f64) -> String {
        number::with_unit(&number::typeset(&number::significant(value, 4)), &self.unit.symbol)
    }

    /// The end of the colours as a number.
    pub(crate) fn end(&self) -> String {
        number::typeset(&number::significant(self.high, 4))
    }

    /// `von Mises stress in MPa`.
    pub(crate) fn heading(&self) -> String {
        if self.unit.symbol.is_empty() {
            return self.name.clone();
        }
        format!("{} in {}", self.name, number::unit(&self.unit.symbol))
    }
}

fn f64_max_32(a: f32, b: f32) -> f32 {
    a.max(b)
}

/// Least and largest finite value, display units.
fn extent(fields: &[&ContourField], unit: &Unit) -> Option<(f64, f64)> {
    let values = fields.iter().flat_map(|field| &field.values).filter(|value| value.is_finite());
    let (low, high) = values.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)));
    (low <= high).then(|| (unit.show(f64::from(low)), unit.show(f64::from(high))))
}

/// A range that is not a point; what begins near zero begins at zero.
fn opened(least: f64, most: f64) -> (f64, f64) {
    let size = least.abs().max(most.abs());
    if size == 0.0 {
        return (0.0, 1.0);
    }
    if most - least < 1e-6 * size {
        return (least - 0.1 * size, most + 0.1 * size);
    }
    if least > 0.0 && least < 0.3 * most { (0.0, most) } else { (least, most) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(values: &[f32], ceiling: Option<f32>) -> Scale {
        let unit = Unit::new("MPa", 1e6);
        let values = values.iter().map(|v| 1e6 * v).collect();
        let field = ContourField { name: "stress".to_owned(), unit, values, ceiling: ceiling.map(|c| 1e6 * c) };
        Scale::of(&[&field]).unwrap()
    }

    #[test]
    fn bands_end_at_round_numbers() {
        let s = scale(&[0.7, 148.2, f32::NAN], None);
        assert_eq!((s.low, s.high, s.step, s.bands()), (0.0, 160.0, 20.0, 8));
        assert_eq!(s.marks.first().map(|m| m.1.as_str()), Some("0"));
        assert_eq!(s.marks.last().map(|m| m.1.as_str()), Some("160"));
        assert_eq!((s.text(s.most), s.signed, s.is_cut()), ("148.2 MPa".to_owned(), false, false));
    }

    #[test]
    fn colours_end_at_the_ceiling() {
        let s = scale(&[1.0, 1234.0], Some(250.0));
        assert_eq!((s.low, s.high, s.is_cut()), (0.0, 250.0, true));
        assert_eq!((s.bands(), s.band(s.bands() - 1)), (13, (240.0, 250.0)));
    }

    #[test]
    fn both_signs_meet_in_the_middle() {
        let s = scale(&[-40.0, 100.0], None);
        assert!(s.signed);
        let zero = (0..s.bands()).find(|band| s.band(*band).0 >= -1e-9).unwrap();
        assert!(s.share(zero) > 0.5 && s.share(zero - 1) < 0.5);
    }

    #[test]
    fn flat_and_empty_fields() {
        let s = scale(&[5.0, 5.0], None);
        assert!(s.low < 5.0 && s.high > 5.0 && s.bands() > 1);
        assert_eq!(scale(&[0.0], None).high, 1.0);
        let none =
            ContourField { name: String::new(), unit: Unit::new("", 1.0), values: vec![f32::NAN], ceiling: None };
        assert!(Scale::of(&[&none]).is_none());
    }
}
