//! SI values as text, in the unit an author uses.

use crate::expression::plain;
use crate::{Parameter, unit};

impl Parameter {
    /// The unit of its definition where that is a number with at most a unit: `mm` for `732 mm`
    /// and for `732 ± 0.1 mm`, an empty text for a number alone. `None` for an expression.
    #[must_use]
    pub fn unit_as_written(&self) -> Option<String> {
        let unit = plain(&self.written)?.unit;
        Some(unit.and_then(|(bytes, _)| self.written.get(bytes)).unwrap_or("").to_owned())
    }

    /// [`written_value`] in the unit of its definition; in the unit `otherwise` where the
    /// definition is an expression, has no unit (`0`), or `otherwise` is no unit in the SI unit.
    /// `None` for a value that is not finite.
    #[must_use]
    pub fn value_as_written(&self, si: f64, otherwise: &str) -> Option<String> {
        written_value(si, &self.symbol(otherwise))
    }

    /// [`Parameter::value_as_written`] with the fewest digits that stay within `tolerance` (SI) of the value.
    #[must_use]
    pub fn value_as_written_within(&self, si: f64, tolerance: f64, otherwise: &str) -> Option<String> {
        let symbol = self.symbol(otherwise);
        let exact = written_value(si, &symbol)?;
        Some(rounded_value(si, &symbol, tolerance).unwrap_or(exact))
    }

    /// The unit of [`Parameter::value_as_written`].
    fn symbol(&self, otherwise: &str) -> String {
        let fits = |symbol: &str| match unit(symbol) {
            Ok(unit) => unit.dimension.agrees(self.dimension),
            Err(_) => symbol.is_empty() && self.dimension.is_none(),
        };
        let own = self.unit_as_written().filter(|symbol| fits(symbol));
        let symbol = own.or_else(|| Some(otherwise.to_owned()).filter(|symbol| fits(symbol)));
        symbol.unwrap_or_else(|| if self.dimension.is_none() { String::new() } else { self.dimension.unit() })
    }
}

/// A value that reads well and lies within `tolerance` of another, both SI.
fn rounded_value(si: f64, symbol: &str, tolerance: f64) -> Option<String> {
    let unit = if symbol.is_empty() { None } else { Some(unit(symbol).ok()?) };
    let scaled = unit.map_or(si, |unit| unit.from_si(si));
    let near = |value: &f64| (unit.map_or(*value, |unit| unit.to_si(*value)) - si).abs() <= tolerance;
    let zero = std::iter::once(0.0);
    let value = zero.chain((0..17).map(|decimals| rounded(scaled, decimals))).find(near)?;
    Some(if symbol.is_empty() { digits(value) } else { format!("{} {symbol}", digits(value)) })
}

/// An SI value as a model file writes it: `600 mm` for 0.6 and `mm`, a number alone for an empty
/// unit. The fewest digits that read back as the same number, or, where none does, as a neighbour
/// of it. `None` for what is no unit or no finite number.
#[must_use]
pub fn written_value(si: f64, symbol: &str) -> Option<String> {
    if symbol.is_empty() {
        return si.is_finite().then(|| digits(si));
    }
    let unit = unit(symbol).ok()?;
    let scaled = unit.from_si(si);
    if !si.is_finite() || !scaled.is_finite() {
        return None;
    }
    let reads_back = |text: &str, ulps: u64| {
        let value: f64 = text.parse().unwrap_or(f64::NAN);
        distance(unit.to_si(value), si) <= ulps
    };
    // The division may be off by some last bits, so its neighbours are tried as well.
    let neighbours = [scaled, scaled.next_up(), scaled.next_down(), scaled.next_up().next_up()];
    let shortest = |ulps: u64| {
        let candidates = (0..17).flat_map(|decimals| neighbours.map(|value| rounded(value, decimals)));
        candidates.map(digits).find(|text| reads_back(text, ulps))
    };
    let number = shortest(0).or_else(|| shortest(1)).unwrap_or_else(|| digits(scaled));
    Some(format!("{number} {symbol}"))
}

/// A number rounded to one digit and `decimals` more.
fn rounded(value: f64, decimals: usize) -> f64 {
    format!("{value:.decimals$e}").parse().unwrap_or(value)
}

/// The shortest text of a number; both expressions and TOML read it.
fn digits(value: f64) -> String {
    // A minus before a zero says nothing.
    let value = value + 0.0;
    let size = value.abs();
    if value == 0.0 || (1e-5..1e16).contains(&size) { value.to_string() } else { format!("{value:e}") }
}

/// How many numbers lie between two, and one.
fn distance(a: f64, b: f64) -> u64 {
    if a == b {
        return 0;
    }
    if a.is_sign_negative() != b.is_sign_negative() || !a.is_finite() || !b.is_finite() {
        return u64::MAX;
    }
    a.to_bits().abs_diff(b.to_bits())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{rounded_value, written_value};
    use crate::{unit, unit_names};

    #[test]
    fn short_where_it_can_be() {
        let cases = [
            (0.6, "mm", "600 mm"),
            (0.1 + 0.2, "mm", "300.00000000000006 mm"),
            (std::f64::consts::PI / 12.0, "deg", "15 deg"),
            (293.15, "degC", "20 degC"),
            (268.15, "degC", "-5 degC"),
            (-9.81, "m/s^2", "-9.81 m/s^2"),
            (1e-9, "m", "1e-9 m"),
            (2.0e17, "Pa", "2e17 Pa"),
            (2.0e17, "GPa", "200000000 GPa"),
            (-0.0, "mm", "0 mm"),
            (0.7, "", "0.7"),
            (10.0, "1/s", "10 1/s"),
        ];
        for (si, symbol, expected) in cases {
            assert_eq!(written_value(si, symbol).as_deref(), Some(expected));
        }
        assert_eq!((written_value(1.0, "mmm"), written_value(f64::NAN, "mm")), (None, None));
        assert_eq!((written_value(f64::INFINITY, ""), written_value(f64::MAX, "um")), (None, None));
    }

    #[test]
    fn rounded_where_that_is_near_enough() {
        let cases = [
            (0.1 + 0.2, "mm", 1e-12, "300 mm"),
            (0.123_456_789_012_345_67, "m", 1e-13, "0.1234567890123 m"),
            (1e-17, "mm", 1e-12, "0 mm"),
            (293.150_000_000_000_1, "degC", 1e-9, "20 degC"),
            (2.0 / 3.0, "", 1e-6, "0.666667"),
            (-0.6, "mm", 0.0, "-600 mm"),
        ];
        for (si, symbol, tolerance, expected) in cases {
            assert_eq!(rounded_value(si, symbol, tolerance).as_deref(), Some(expected));
        }
        assert_eq!(rounded_value(1.0, "mmm", 1.0), None);
    }

    proptest! {
        #[test]
        fn reads_back(mantissa in -1e4..1e4_f64, exponent in -9..9_i32, pick in 0..100_usize) {
            let symbol = unit_names().nth(pick % unit_names().count()).unwrap();
            let offset = unit(symbol).unwrap().offset;
            let si = mantissa * 10_f64.powi(exponent);
            let text = written_value(si, symbol).unwrap();
            let number: f64 = text.split(' ').next().unwrap().parse().unwrap();
            let back = unit(symbol).unwrap().to_si(number);
            let ulp = (si.abs().next_up() - si.abs()).max(offset * f64::EPSILON);
            prop_assert!((back - si).abs() <= ulp, "{text}: {back:e} for {si:e}");
        }
    }
}
