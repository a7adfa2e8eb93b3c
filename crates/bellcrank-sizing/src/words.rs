//! Numbers in sentences: four digits that count, in the units engineers buy in.

use crate::Quantity;

/// Symbol, and its size in SI.
fn unit(quantity: Quantity) -> (&'static str, f64) {
    match quantity {
        Quantity::Force => ("N", 1.0),
        Quantity::Torque => ("N·m", 1.0),
        Quantity::Length => ("mm", 1e-3),
        Quantity::Angle => ("°", std::f64::consts::PI / 180.0),
        Quantity::Speed => ("mm/s", 1e-3),
        Quantity::AngularSpeed => ("rpm", std::f64::consts::PI / 30.0),
        Quantity::Pressure => ("bar", 1e5),
        Quantity::Energy => ("J", 1.0),
        Quantity::Power => ("W", 1.0),
        Quantity::Flow => ("l/min ANR", 1e-3 / 60.0),
    }
}

/// An SI value with its unit: `2111 N`.
pub(crate) fn shown(value: f64, quantity: Quantity) -> String {
    digits(value, quantity, DIGITS)
}

/// Two SI values with as many digits as it takes to tell them apart.
pub(crate) fn both(a: f64, b: f64, quantity: Quantity) -> (String, String) {
    let pair = |count| (digits(a, quantity, count), digits(b, quantity, count));
    let apart = (DIGITS..=9).map(pair).find(|(x, y)| x != y);
    apart.unwrap_or_else(|| pair(DIGITS))
}

const DIGITS: i32 = 4;

fn digits(value: f64, quantity: Quantity, count: i32) -> String {
    let (symbol, size) = unit(quantity);
    let space = if symbol == "°" { "" } else { " " };
    format!("{}{space}{symbol}", rounded(value / size, count))
}

/// A pure number: `0.7`.
pub(crate) fn number(value: f64) -> String {
    rounded(value, DIGITS)
}

/// So many digits that count, whole numbers whole, no zeros at the end.
fn rounded(value: f64, count: i32) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".to_owned() } else { format!("{value}") };
    }
    let exponent = value.abs().log10().floor() as i32;
    if !(-4..=8).contains(&exponent) {
        return format!("{value:.*e}", (count - 1).max(0) as usize);
    }
    let text = format!("{value:.*}", (count - 1 - exponent).max(0) as usize);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_count() {
        let shown = [3015.93, 12063.7157, 0.7, 16.0841, 0.04712345, -2.5, 999.96, 0.0, 1.0e-12, f64::NAN].map(number);
        assert_eq!(shown, ["3016", "12064", "0.7", "16.08", "0.04712", "-2.5", "1000", "0", "1.000e-12", "NaN"]);
    }

    #[test]
    fn close_numbers_are_told_apart() {
        let texts = |a, b| both(a, b, Quantity::Force);
        assert_eq!(texts(2111.14, 2111.24), ("2111.1 N".to_owned(), "2111.2 N".to_owned()));
        assert_eq!(texts(5.0, 5.0), ("5 N".to_owned(), "5 N".to_owned()));
    }
}
