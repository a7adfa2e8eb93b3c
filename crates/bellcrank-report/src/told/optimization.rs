//! A better design in words.

use bellcrank_results::{ConstraintRow, Optimization, StartRow, VariableRow};

use super::{code, listed, shown};
use crate::number::{self, relative_change};

pub(super) fn sentences(found: &Optimization) -> Vec<String> {
    if !found.objective.value.is_finite() {
        return vec![course(found)];
    }
    if is_infeasible(found) {
        return vec![course(found), outcome(found), first_order(found)];
    }
    [Some(outcome(found)), Some(course(found)), bounds(found), Some(first_order(found)), written(found)]
        .into_iter()
        .flatten()
        .collect()
}

/// Bounds and constraints then hold back the violation, not the objective.
fn is_infeasible(found: &Optimization) -> bool {
    found.status == "infeasible"
}

fn outcome(found: &Optimization) -> String {
    let objective = &found.objective;
    let what = format!("{} of study {}", code(&objective.written), code(&found.of));
    let goal = if objective.maximize { "large" } else { "small" };
    let value = shown(objective.value, &objective.unit);
    if !objective.start.is_finite() {
        return format!("{what}, to be made {goal}, is {value}; the model as it is gives no value.");
    }
    let change = number::change(relative_change(objective.start, objective.value));
    format!("{what}, to be made {goal}, goes from {} to {value} ({change}).", shown(objective.start, &objective.unit))
}

fn course(found: &Optimization) -> String {
    let failed = match found.failed_designs {
        0 => String::new(),
        _ if found.evaluations == 1 => ", which could not be assembled or solved".to_owned(),
        count => format!(", {count} of which could not be assembled or solved"),
    };
    let starts = match found.starts.len() {
        0 | 1 => String::new(),
        count => format!("; the {count} starts lead to {}", optima_counted(found)),
    };
    let (iterations, evaluations) = (found.iteration_count, found.evaluations);
    let (s, designs) =
        (if iterations == 1 { "" } else { "s" }, if evaluations == 1 { "design was" } else { "designs were" });
    format!(
        "{} after {iterations} iteration{s}; {evaluations} {designs} evaluated{failed}{starts}.",
        status(&found.status)
    )
}

/// The status in words; one that is not known here is told as it is.
fn status(word: &str) -> String {
    match word {
        "converged" => "The search converged",
        "infeasible" => "No design was found that meets all constraints: the search ended",
        "iteration-limit" => "The search stopped at its limit, not converged,",
        "small-step" => "The search stopped, not converged, because its steps became too small,",
        "interrupted" => "The search was interrupted",
        "no-start" => "No starting point could be assembled: the search ended",
        other => return format!("The search ended as {}", code(other)),
    }
    .to_owned()
}

fn bounds(found: &Optimization) -> Option<String> {
    let at = |row: &VariableRow| Some(format!("{} at its {} bound", code(&row.name), row.bound?));
    let variables = found.variables.iter().filter_map(at);
    let active = |row: &ConstraintRow| {
        let met = row.active && row.violation == 0.0;
        met.then(|| format!("{} with equality", code(&row.written)))
    };
    let all: Vec<String> = variables.chain(found.constraints.iter().filter_map(active)).collect();
    (!all.is_empty()).then(|| format!("What holds it back: {}.", listed(&all)))
}

fn first_order(found: &Optimization) -> String {
    let [gradient, violation, slack] =
        [found.first_order.stationarity, found.first_order.feasibility, found.first_order.complementarity]
            .map(|value| number::significant(value, 2));
    let numbers = format!(
        "gradient of the Lagrangian {gradient}, violation {violation}, multipliers times slacks {slack}, all scaled"
    );
    if found.first_order.holds {
        format!(
            "It is a first-order (Karush–Kuhn–Tucker) point: to first order no small change that is allowed improves it; {numbers}."
        )
    } else {
        format!("It is NOT shown to be a first-order (Karush–Kuhn–Tucker) point: {numbers}.")
    }
}

fn written(found: &Optimization) -> Option<String> {
    found.written.as_ref().map(|file| format!("The improved model is in {}.", code(file)))
}

pub(super) fn unmet(found: &Optimization) -> Option<String> {
    match found.status.as_str() {
        "converged" if found.first_order.holds => None,
        "converged" => Some("the search ended where the first-order conditions do not hold".to_owned()),
        "infeasible" => Some("no design was found that meets all constraints".to_owned()),
        "no-start" => Some("no starting point could be assembled".to_owned()),
        other => Some(format!("the search did not converge ({})", code(other))),
    }
}

/// What moving an active bound by one display unit does to the objective.
pub(crate) fn variable_effect(row: &VariableRow, found: &Optimization) -> Option<String> {
    row.bound.filter(|_| !is_infeasible(found))?;
    Some(effect(row.multiplier * row.unit.factor, &row.unit.symbol, "on this bound", found))
}

/// What moving the right side of an active constraint by one display unit does to the objective.
pub(crate) fn constraint_effect(row: &ConstraintRow, found: &Optimization) -> Option<String> {
    let met = row.active && row.violation == 0.0 && !is_infeasible(found);
    met.then(|| effect(row.multiplier * row.unit.factor, &row.unit.symbol, "on the right side", found))
}

fn effect(si: f64, symbol: &str, what: &str, found: &Optimization) -> String {
    let unit = &found.objective.unit;
    let change = number::significant(unit.show(si), 3);
    let signed = if si > 0.0 { format!("+{change}") } else { change };
    format!("{} more {what}: {}", number::with_unit("1", symbol), number::with_unit(&signed, &unit.symbol))
}

/// Which starts led to the same optimum: a letter for each start, `A` for the best.
///
/// Points are the same when no variable differs by more than a thousandth of the span all points have.
pub(crate) fn optima(found: &Optimization) -> Vec<char> {
    let mut distinct: Vec<&StartRow> = Vec::new();
    let letter = |row: &'_ StartRow, distinct: &[&StartRow]| distinct.iter().position(|other| same(found, row, other));
    let mut letters = Vec::new();
    for row in &found.starts {
        let index = letter(row, &distinct).unwrap_or(distinct.len());
        if index == distinct.len() {
            distinct.push(row);
        }
        letters.push(char::from(b'A' + (index % 26) as u8));
    }
    letters
}

fn same(found: &Optimization, a: &StartRow, b: &StartRow) -> bool {
    const SHARE: f64 = 1e-3;
    let close = |index: usize| {
        let of = |row: &StartRow| row.point.get(index).copied().unwrap_or(f64::NAN);
        let ends = found.starts.iter().flat_map(|row| [row.point.get(index), row.from.get(index)]).flatten();
        let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
        (of(a) - of(b)).abs() <= SHARE * (high - low)
    };
    a.status == b.status && (0..found.variables.len()).all(close)
}

fn optima_counted(found: &Optimization) -> String {
    let mut letters = optima(found);
    letters.sort_unstable();
    letters.dedup();
    match letters.len() {
        1 => "the same point".to_owned(),
        count => format!("{count} different points"),
    }
}
