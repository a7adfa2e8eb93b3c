//! A scatter in words.

use bellcrank_results::{MonteCarlo, Tolerance, Unit};

use super::{about, code, listed, shown};
use crate::number;

pub(super) fn sentences(found: &Tolerance) -> Vec<String> {
    let worst = worst_case(found);
    let run = found.monte_carlo.as_ref().map(|run| monte_carlo(run, &found.unit));
    [Some(nominal(found)), Some(worst), run, within(found), capability(found), blame(found)]
        .into_iter()
        .flatten()
        .collect()
}

fn nominal(found: &Tolerance) -> String {
    format!(
        "{} of study {} is {} with nominal dimensions; by the derivatives its standard deviation is {}.",
        code(&found.response),
        code(&found.of),
        shown(found.nominal, &found.unit),
        about(found.linear_deviation, &found.unit, 3)
    )
}

fn worst_case(found: &Tolerance) -> String {
    let ends = |(low, high): (f64, f64)| format!("{} to {}", about(low, &found.unit, 5), about(high, &found.unit, 5));
    let exact = found.worst_case_exact.map_or(String::new(), |worst| format!(" (evaluated there: {})", ends(worst)));
    let open = found.inputs.iter().filter(|input| input.half_width.is_infinite()).map(|input| code(&input.name));
    let open: Vec<String> = open.collect();
    let held = if open.is_empty() { String::new() } else { format!(", {} at ± 3 standard deviations", listed(&open)) };
    format!("With every dimension at the worse end of its tolerance it is {}{exact}{held}.", ends(found.worst_case))
}

fn monte_carlo(run: &MonteCarlo, unit: &Unit) -> String {
    let failed = if run.failed == 0 { String::new() } else { format!(", {} of which gave no result", run.failed) };
    format!(
        "{} samples (seed {}{failed}) have a mean of {} ± {} and a standard deviation of {} ± {}; ± is one standard error.",
        run.samples,
        run.seed,
        about(run.mean.0, unit, 6),
        about(run.mean.1, unit, 2),
        about(run.deviation.0, unit, 4),
        about(run.deviation.1, unit, 2)
    )
}

fn limits(found: &Tolerance) -> Option<String> {
    match found.limits {
        (None, None) => None,
        (Some(low), None) => Some(format!("above {}", shown(low, &found.unit))),
        (None, Some(high)) => Some(format!("below {}", shown(high, &found.unit))),
        (Some(low), Some(high)) => {
            Some(format!("between {} and {}", shown(low, &found.unit), shown(high, &found.unit)))
        }
    }
}

/// The yield as found, with its sampling error, beside that of the linear estimate.
fn within(found: &Tolerance) -> Option<String> {
    let limits = limits(found)?;
    let linear = number::percent(found.linear_yield);
    let Some(run) = found.monte_carlo.as_ref().and_then(|run| run.within) else {
        return Some(format!("By the derivatives {linear} lie {limits}."));
    };
    // As many decimals as the sample can tell.
    let width = 100.0 * (run.interval.1 - run.interval.0);
    let decimals = if width > 0.0 { (1.0 - width.log10().floor()).clamp(0.0, 9.0) as usize } else { 3 };
    let shares = [run.share, run.interval.0, run.interval.1].map(|share| format!("{:.decimals$}", 100.0 * share));
    Some(format!(
        "{} % of the samples lie {limits} (95 % confidence: {} % to {} %); the linear estimate is {linear}.",
        shares[0], shares[1], shares[2]
    ))
}

fn capability(found: &Tolerance) -> Option<String> {
    let (cp, cpk) = found.capability;
    let named = [("Cp", cp), ("Cpk", cpk)]
        .map(|(name, value)| value.is_finite().then(|| format!("{name} is {}", number::significant(value, 3))));
    let named: Vec<String> = named.into_iter().flatten().collect();
    let judged = match cpk {
        value if !value.is_finite() => "",
        value if value >= 4.0 / 3.0 => " (capable: at least 1.33)",
        value if value >= 1.0 => " (just capable: between 1 and 1.33)",
        _ => " (not capable: below 1)",
    };
    (!named.is_empty()).then(|| format!("{}{judged}.", listed(&named)))
}

/// The tolerances that make up half of the variance.
fn blame(found: &Tolerance) -> Option<String> {
    let mut sum = 0.0;
    let mut parts = Vec::new();
    for input in found.inputs.iter().filter(|input| input.variance_share > 0.0) {
        if sum >= 0.5 || parts.len() == 3 {
            break;
        }
        sum += input.variance_share;
        parts.push(format!("{} ({})", code(&input.name), number::part(input.variance_share)));
    }
    (!parts.is_empty()).then(|| format!("Most of the variance comes from {}: tighten that first.", listed(&parts)))
}
