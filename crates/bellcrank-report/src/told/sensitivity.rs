//! What matters for a response.

use bellcrank_results::{ActivePlace, ParameterSensitivity, Sensitivity};

use super::{code, listed, shown};
use crate::number;

/// Parameters that share the first place.
const MOST_NAMED: usize = 3;
/// A parameter matters most while its effect is at least this share of the largest.
const COMPARABLE: f64 = 0.5;

/// Parameters with an effect, the largest relative one first.
pub(crate) fn by_weight(found: &Sensitivity) -> Vec<&ParameterSensitivity> {
    let mut rows: Vec<_> =
        found.parameters.iter().filter(|row| row.relative.is_finite() && row.relative != 0.0).collect();
    rows.sort_by(|a, b| b.relative.abs().total_cmp(&a.relative.abs()));
    rows
}

pub(super) fn sentences(found: &Sensitivity) -> Vec<String> {
    let value = format!(
        "{} of study {} is {}{}.",
        code(&found.response),
        code(&found.of),
        shown(found.value, &found.unit),
        places(&found.at)
    );
    [Some(value), most(found), without_effect(found)].into_iter().flatten().collect()
}

fn places(all: &[ActivePlace]) -> String {
    let place = |of: &ActivePlace| {
        let between = if of.between_rows { " (between two rows)" } else { "" };
        let at = format!("{} = {}{between}", code(&of.axis), shown(of.place, &of.unit));
        if all.len() == 1 { at } else { format!("{at} for {}", code(&of.reduction)) }
    };
    match all {
        [] => String::new(),
        all => format!(", at {}", listed(&all.iter().map(place).collect::<Vec<_>>())),
    }
}

fn most(found: &Sensitivity) -> Option<String> {
    let rows = by_weight(found);
    let largest = rows.first()?.relative.abs();
    let top: Vec<_> =
        rows.into_iter().take(MOST_NAMED).filter(|row| row.relative.abs() >= COMPARABLE * largest).collect();
    let names: Vec<String> = top.iter().map(|row| code(&row.name)).collect();
    let effect = |row: &&ParameterSensitivity| {
        let word = if row.relative * found.value.signum() < 0.0 { "less" } else { "more" };
        let size = number::significant(row.relative.abs(), 3);
        format!("1 % more {} makes it {size} % {word}", code(&row.name))
    };
    let effects: Vec<String> = top.iter().map(effect).collect();
    let verb = if names.len() == 1 { "matters" } else { "matter" };
    Some(format!("{} {verb} most: {}.", listed(&names), listed(&effects)))
}

fn without_effect(found: &Sensitivity) -> Option<String> {
    let idle: Vec<String> =
        found.parameters.iter().filter(|row| row.derivative == 0.0).map(|row| code(&row.name)).collect();
    let verb = if idle.len() == 1 { "has" } else { "have" };
    (!idle.is_empty()).then(|| format!("{} {verb} no effect.", listed(&idle)))
}
