//! Numbers as an engineer reads them: as many digits as mean something.

/// Digits of a number that stands alone.
const DIGITS: usize = 6;

/// `value` to six significant digits without trailing zeros; `–` where it is not finite.
pub(crate) fn alone(value: f64) -> String {
    significant(value, DIGITS)
}

/// `value` to `digits` significant digits; powers of ten only where zeros would hide it.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    match exponent.parse::<i32>() {
        Ok(power @ -4..=6) => {
            let decimals = (digits as i32 - 1 - power).max(0) as usize;
            trimmed(&format!("{value:.decimals$}")).to_owned()
        }
        _ => format!("{}e{exponent}", trimmed(mantissa)),
    }
}

/// Without zeros at the end of the decimals.
fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A place on an axis that spans `range`: what is only rounding noise on that scale reads `0`.
pub(crate) fn place(value: f64, range: f64) -> String {
    alone(if value.abs() < 1e-9 * range.abs() { 0.0 } else { value })
}

/// Decimals for a column of numbers whose largest magnitude is `scale`; `None` where powers of
/// ten read better.
pub(crate) fn decimals(scale: f64, digits: i32) -> Option<usize> {
    if scale == 0.0 {
        return Some(0);
    }
    let power = scale.abs().log10().floor();
    let plain = scale.is_finite() && (-4.0..=6.0).contains(&power);
    plain.then(|| (digits - 1 - power as i32).clamp(0, 9) as usize)
}

/// `value` with that many decimals (see [`decimals`]).
pub(crate) fn aligned(value: f64, decimals: Option<usize>) -> String {
    match decimals {
        Some(count) if value.is_finite() => unsigned_zero(format!("{value:.count$}")),
        _ => significant(value, 4),
    }
}

/// `-0.00` says nothing that `0.00` does not.
fn unsigned_zero(text: String) -> String {
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| b == b'0' || b == b'.') => rest.to_owned(),
        _ => text,
    }
}

/// Decimals that numbers of one row need so that each shows at least six digits of the largest.
pub(crate) fn shared_decimals(values: &[f64]) -> Option<usize> {
    let most = decimals(values.iter().fold(0.0, |most, v| v.abs().max(most)), DIGITS as i32)?;
    let after_point = |value: &f64| {
        let text = aligned(*value, Some(most));
        trimmed(&text).split_once('.').map_or(0, |(_, decimals)| decimals.len())
    };
    values.iter().map(after_point).max()
}

/// A number with its unit; no space is left where there is no unit.
pub(crate) fn with_unit(number: &str, symbol: &str) -> String {
    if symbol.is_empty() { number.to_owned() } else { format!("{number} {}", unit(symbol)) }
}

/// A unit as it is set in print: `mm/s²` for `mm/s^2`.
pub(crate) fn unit(symbol: &str) -> String {
    symbol.replace("^2", "²").replace("^3", "³").replace('*', "·")
}

/// A share in percent to three digits: `31.7 %`.
pub(crate) fn percent(share: f64) -> String {
    if share.is_finite() { format!("{} %", rounded_percent(share)) } else { "–".to_owned() }
}

/// A change in percent with its sign: `+3.2 %`, `-31.7 %`.
pub(crate) fn change(share: f64) -> String {
    let text = percent(share);
    if share > 0.0 && text != "0 %" { format!("+{text}") } else { text }
}

/// A part of a whole; what is next to nothing says so.
pub(crate) fn part(share: f64) -> String {
    if share != 0.0 && share.abs() < 5e-5 { "< 0.01 %".to_owned() } else { percent(share) }
}

/// An estimate with its error, both to the first digit of the error that counts.
pub(crate) fn estimate(value: f64, error: f64) -> String {
    if !(value.is_finite() && error.is_finite() && error > 0.0) {
        return significant(value, 3);
    }
    let decimals = (1.0 - error.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{} ± {error:.decimals$}", unsigned_zero(format!("{value:.decimals$}")))
}

/// A share near one keeps the digits that tell it from one: 99.865 %, not 99.9 %.
fn rounded_percent(share: f64) -> String {
    let missing = 1.0 - share;
    if share < 1.0 && missing > 1e-9 && missing < 5e-3 {
        let decimals = (2.0 - (100.0 * missing).log10().floor()) as usize;
        return trimmed(&format!("{:.decimals$}", 100.0 * share)).to_owned();
    }
    let text = significant(100.0 * share, 3);
    if text.contains('e') && share.abs() < 1e-3 { "0".to_owned() } else { text }
}

/// From where to where, relative; not finite where it began at zero.
pub(crate) fn relative_change(start: f64, value: f64) -> f64 {
    if start == 0.0 { f64::NAN } else { (value - start) / start.abs() }
}

/// Seconds as a reader takes them in: `0.6 ms`, `12.4 s`.
pub(crate) fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1e-3 => format!("{} µs", significant(s * 1e6, 3)),
        s if s < 1.0 => format!("{} ms", significant(s * 1e3, 3)),
        s => format!("{} s", significant(s, 3)),
    }
}

/// With a true minus sign, for print.
pub(crate) fn typeset(text: &str) -> String {
    text.replace('-', "\u{2212}")
}

/// As [`typeset`], but only a minus that begins a number: names keep their hyphens.
pub(crate) fn typeset_places(text: &str) -> String {
    let mut typeset = String::with_capacity(text.len());
    let mut before = ' ';
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let number = rest.peek().is_some_and(char::is_ascii_digit);
        typeset.push(if c == '-' && number && " (e".contains(before) { '\u{2212}' } else { c });
        before = c;
    }
    typeset
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_digits_are_enough() {
        for (value, text) in [
            (6_473.606_158, "6473.61"),
            (-30.000_000_000_000_004, "-30"),
            (0.0, "0"),
            (-0.0, "0"),
            (2.220_446e-16, "2.22045e-16"),
            (1_234_567.8, "1234568"),
            (12_345_678.0, "1.23457e7"),
            (0.000_123_456_7, "0.000123457"),
            (f64::NAN, "–"),
        ] {
            assert_eq!(alone(value), text);
        }
    }

    #[test]
    fn noise_on_an_axis_reads_zero() {
        assert_eq!(place(3e-15, 60.0), "0");
        assert_eq!(place(-30.0, 60.0), "-30");
    }

    #[test]
    fn names_keep_their_hyphens() {
        assert_eq!(typeset_places("at a-b = -3 m, c-1 = 2e-5"), "at a-b = −3 m, c-1 = 2e−5");
    }

    #[test]
    fn columns_share_their_decimals() {
        let shared = decimals(6473.6, 5);
        assert_eq!(aligned(6473.61, shared), "6473.6");
        assert_eq!(aligned(-0.01, shared), "0.0");
        assert_eq!(aligned(1e-12, decimals(1e-12, 5)), "1e-12");
        assert_eq!(aligned(f64::NAN, shared), "–");
    }

    #[test]
    fn shares_keep_what_they_miss() {
        for (share, text) in [
            (0.316_68, "31.7 %"),
            (0.999_937_4, "99.99374 %"),
            (0.998_65, "99.865 %"),
            (1.0, "100 %"),
            (-0.5, "-50 %"),
            (1e-9, "0 %"),
            (f64::NAN, "–"),
        ] {
            assert_eq!(percent(share), text);
        }
        assert_eq!([part(3.7e-6), part(0.25), part(0.0)], ["< 0.01 %", "25 %", "0 %"]);
        assert_eq!([estimate(3.7e-6, 0.0041), estimate(0.9432, 0.012)], ["0.0000 ± 0.0041", "0.943 ± 0.012"]);
        assert_eq!((change(0.0125), change(0.0)), ("+1.25 %".to_owned(), "0 %".to_owned()));
    }

    #[test]
    fn durations_pick_their_unit() {
        assert_eq!(duration(0.000_6), "600 µs");
        assert_eq!(duration(0.012_34), "12.3 ms");
        assert_eq!(duration(75.0), "75 s");
    }
}
