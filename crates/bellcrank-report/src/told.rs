//! What studies over other studies found, in sentences: the page and the terminal say the same.
//!
//! Names stand between backticks; numbers have plain minus signs, which the page sets itself.

mod designs;
pub(crate) mod events;
pub(crate) mod flexible;
pub(crate) mod modes;
mod optimization;
mod sensitivity;
mod sizing;
pub(crate) mod stress;
mod tolerance;

pub(crate) use optimization::{constraint_effect, optima, variable_effect};
pub(crate) use sensitivity::by_weight;
pub(crate) use sizing::word;

use bellcrank_results::{Findings, StudyResult, Unit};

use crate::number;

/// The findings in a few sentences, the most important first.
pub(crate) fn sentences(findings: &Findings) -> Vec<String> {
    match findings {
        Findings::Sensitivity(found) => sensitivity::sentences(found),
        Findings::Optimization(found) => optimization::sentences(found),
        Findings::Designs(found) => designs::sentences(found),
        Findings::Tolerance(found) => tolerance::sentences(found),
        Findings::Modes(found) => modes::sentences(found),
        Findings::Sizing(found) => sizing::sentences(found),
        Findings::Stress(found) => stress::sentences(found),
        Findings::BodyModes(found) => stress::mode_sentences(found),
    }
}

/// Why the study did not reach what it was for, though it ran to its end. A failure says it by itself.
pub(crate) fn unmet(study: &StudyResult) -> Option<String> {
    if study.failure.is_some() {
        return None;
    }
    match study.findings.as_ref()? {
        Findings::Optimization(found) => optimization::unmet(found),
        Findings::Designs(found) => designs::unmet(found),
        Findings::Sizing(found) => sizing::unmet(found),
        Findings::Stress(found) => stress::unmet(found),
        Findings::Sensitivity(_) | Findings::Tolerance(_) | Findings::Modes(_) | Findings::BodyModes(_) => None,
    }
}

/// An SI value with its unit, six digits.
pub(crate) fn shown(si: f64, unit: &Unit) -> String {
    number::with_unit(&number::alone(unit.show(si)), &unit.symbol)
}

/// An SI value with its unit, fewer digits: estimates do not have six.
pub(crate) fn about(si: f64, unit: &Unit, digits: usize) -> String {
    number::with_unit(&number::significant(unit.show(si), digits), &unit.symbol)
}

/// `a`, `a and b`, `a, b and c`.
pub(crate) fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [front @ .., last] => format!("{} and {last}", front.join(", ")),
    }
}

pub(crate) fn code(name: &str) -> String {
    format!("`{name}`")
}
