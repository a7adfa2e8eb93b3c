//! Before and after, what holds it back, and how the search went.

use bellcrank_results::{ConstraintRow, IterationRow, Optimization, VariableRow};

use super::super::rows::{Rows, code, digits, number, symbol, words};
use super::super::{Escaped, page::counted};
use super::pictures;
use crate::FigureFile;
use crate::number::{change, relative_change, typeset};
use crate::told::{constraint_effect, optima, variable_effect};

/// Iterations in the page; the file has all of all starts.
const MOST_ITERATIONS: usize = 60;

pub(super) fn section(found: &Optimization, figures: &[FigureFile]) -> String {
    // A search without a start found nothing.
    if !found.objective.value.is_finite() {
        return String::new();
    }
    [
        titled("Variables", &variables(found)),
        titled("Before and after", &compared(found)),
        titled("Constraints", &constraints(found)),
        pictures(figures, "progress", "wide"),
        titled("Starting points", &starts(found)),
        titled("Iterations", &iterations(found)),
    ]
    .concat()
}

fn titled(title: &str, body: &str) -> String {
    if body.is_empty() { String::new() } else { format!("<h3>{title}</h3>\n{body}") }
}

fn variables(found: &Optimization) -> String {
    let heads = ["Variable", " Before", " After", " Change", "Unit", " Min", " Max", "Bound", "What the bound costs"];
    let mut rows = Rows::new(&heads);
    for row in &found.variables {
        rows.push(&variable(row, found));
    }
    rows.html()
}

fn variable(row: &VariableRow, found: &Optimization) -> [String; 9] {
    let bound = |si: f64| if si.is_finite() { number(si, &row.unit) } else { "none".to_owned() };
    [
        code(&row.name),
        number(row.start, &row.unit),
        format!("<b>{}</b>", number(row.value, &row.unit)),
        typeset(&change(relative_change(row.start, row.value))),
        symbol(&row.unit),
        bound(row.bounds.0),
        bound(row.bounds.1),
        row.bound.map_or_else(|| "free".to_owned(), |end| format!("<span class=\"loose\">at {end}</span>")),
        variable_effect(row, found).map_or_else(String::new, |text| words(&text)),
    ]
}

fn compared(found: &Optimization) -> String {
    let mut rows = Rows::new(&["Response", " Before", " After", " Change", "Unit"]);
    for row in &found.compared {
        rows.push(&[
            code(&row.name),
            number(row.start, &row.unit),
            format!("<b>{}</b>", number(row.value, &row.unit)),
            typeset(&change(relative_change(row.start, row.value))),
            symbol(&row.unit),
        ]);
    }
    rows.html()
}

fn constraints(found: &Optimization) -> String {
    let heads = ["Constraint", " Before", " After", " Limit", " Margin", "Unit", "State", "What it costs"];
    let mut rows = Rows::new(&heads);
    for row in &found.constraints {
        rows.push(&constraint(row, found));
    }
    rows.html()
}

fn constraint(row: &ConstraintRow, found: &Optimization) -> [String; 8] {
    let violated = row.violation > 0.0;
    let margin = if violated { -row.violation } else { (row.right - row.left.1).abs() };
    let state = match (violated, row.active) {
        (true, _) => "<span class=\"fail\">VIOLATED</span>",
        (false, true) => "<span class=\"loose\">active</span>",
        (false, false) => "<span class=\"pass\">holds</span>",
    };
    [
        code(&row.written),
        number(row.left.0, &row.unit),
        number(row.left.1, &row.unit),
        number(row.right, &row.unit),
        if row.active && !violated { "0".to_owned() } else { number(margin, &row.unit) },
        symbol(&row.unit),
        state.to_owned(),
        constraint_effect(row, found).map_or_else(String::new, |text| words(&text)),
    ]
}

/// One start only is told by the variables.
fn starts(found: &Optimization) -> String {
    if found.starts.len() < 2 {
        return String::new();
    }
    let unit = &found.objective.unit;
    let mut heads = vec!["Start".to_owned()];
    let names = |word: &'static str| {
        found.variables.iter().map(move |row| format!(" {word} {} / {}", row.name, row.unit.symbol))
    };
    heads.extend(names("from"));
    heads.extend(names("to"));
    heads.extend([
        format!(" Objective / {}", unit.symbol),
        " Violation".to_owned(),
        "Status".to_owned(),
        "Optimum".to_owned(),
    ]);
    let mut rows = Rows::new(&heads);
    for (row, letter) in found.starts.iter().zip(optima(found)) {
        let start = if row.start == 0 { "0, the model".to_owned() } else { row.start.to_string() };
        let point =
            |values: &[f64]| found.variables.iter().zip(values).map(|(v, si)| number(*si, &v.unit)).collect::<Vec<_>>();
        let mut cells = vec![start];
        cells.extend(point(&row.from));
        cells.extend(point(&row.point));
        cells.extend([
            number(row.objective, unit),
            digits(row.violation, 2),
            Escaped(&row.status).to_string(),
            letter.to_string(),
        ]);
        rows.push(&cells);
    }
    format!("<p class=\"hint\">The best first. Starts with the same letter led to the same point.</p>\n{}", rows.html())
}

fn iterations(found: &Optimization) -> String {
    let unit = &found.objective.unit;
    let best = found.starts.first().map_or(0, |row| row.start);
    let of_best: Vec<&IterationRow> = found.iterations.iter().filter(|row| row.start == best).collect();
    let objective = format!(" Objective / {}", unit.symbol);
    let mut rows = Rows::new(&[" Iteration", " Designs", &objective, " Violation", " Optimality", " Step"]);
    for row in of_best.iter().take(MOST_ITERATIONS) {
        let rest = [row.violation, row.optimality, row.step].map(|value| digits(value, 2));
        let [violation, optimality, step] = rest;
        rows.push(&[
            row.iteration.to_string(),
            row.evaluations.to_string(),
            number(row.objective, unit),
            violation,
            optimality,
            step,
        ]);
    }
    let table = rows.html();
    if table.is_empty() {
        return table;
    }
    let shown = counted(of_best.len().min(MOST_ITERATIONS), "row", "rows");
    let all = counted(found.iterations.len(), "row", "rows");
    format!(
        "<p class=\"hint\">Violation, optimality and step are scaled. {shown} of the best start; <code>iterations.csv</code> holds {all}.</p>\n{table}"
    )
}
