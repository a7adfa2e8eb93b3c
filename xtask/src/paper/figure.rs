//! A printed number beside the computed one.

/// What stands in the last column where a figure is not reproduced to its printed digits.
pub(crate) const DEVIATES: &str = "**no**";

/// A number as it is printed somewhere, and what the program computes for it.
pub(crate) struct Figure {
    /// What it is, with its unit.
    pub(crate) quantity: &'static str,
    /// As the paper prints it; empty where it does not.
    pub(crate) paper: &'static str,
    /// As recomputed from the paper's own equations by an independent script.
    pub(crate) target: &'static str,
    /// Computed by the program, in the same unit.
    pub(crate) value: f64,
}

impl Figure {
    /// Heading of the tables that [`Figure::row`] fills.
    pub(crate) const HEADING: &str = "| quantity | paper | recomputed | bellcrank | deviation from recomputed | deviation from paper | to every recomputed digit |\n|---|---|---|---|---|---|---|\n";

    /// One line of a table.
    pub(crate) fn row(&self) -> String {
        let Self { quantity, paper, target, value } = self;
        let shown = unsigned_zero(format!("{value:.*}", decimals(target)));
        let word = if agrees(target, *value) { "yes" } else { DEVIATES };
        let (from_target, from_paper) = (deviation(target, *value), deviation(paper, *value));
        format!("| {quantity} | {paper} | {target} | {shown} | {from_target} | {from_paper} | {word} |\n")
    }
}

/// The computed number with the digits of the printed one, and their difference with one digit more.
pub(crate) fn cell(target: &str, value: f64) -> String {
    let word = if agrees(target, value) { "" } else { DEVIATES };
    let shown = unsigned_zero(format!("{value:.*}", decimals(target)));
    format!("{shown} ({}){word}", deviation(target, value))
}

fn decimals(printed: &str) -> usize {
    printed.split_once('.').map_or(0, |(_, decimals)| decimals.len())
}

/// Within half of the last printed digit, and the rounding of the last bit.
fn agrees(printed: &str, value: f64) -> bool {
    let half = 0.5 * 0.1_f64.powi(decimals(printed) as i32);
    printed.parse::<f64>().is_ok_and(|number| (value - number).abs() <= half * (1.0 + 1e-6))
}

fn deviation(printed: &str, value: f64) -> String {
    let digits = decimals(printed) + 1;
    match printed.parse::<f64>() {
        Ok(number) => signed(value - number, digits),
        Err(_) => String::new(),
    }
}

/// With its sign, and without one where the digits shown are all zero.
pub(crate) fn signed(value: f64, digits: usize) -> String {
    unsigned_zero(format!("{value:+.digits$}"))
}

fn unsigned_zero(text: String) -> String {
    let is_zero = text.chars().all(|c| !c.is_ascii_digit() || c == '0');
    if is_zero { text.trim_start_matches(['+', '-']).to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agreement_is_to_the_printed_digits() {
        assert!(agrees("-31.883", -31.88304));
        assert!(!agrees("-31.883", -31.8836));
        assert_eq!(cell("4844.52", 4844.5236), "4844.52 (+0.004)");
        assert_eq!(cell("4844.52", 4844.6), "4844.60 (+0.080)**no**");
        assert_eq!(signed(-0.000_01, 3), "0.000");
        assert_eq!(signed(-0.01, 2), "-0.01");
    }
}
