//! Counts, statistics, the designs side by side, and the best compromises.

use bellcrank_results::{Column, Designs};

use super::super::Escaped;
use super::super::rows::{Rows, code, number, symbol, words};
use super::pictures;
use crate::{FigureFile, number};

/// Designs of the front in the page, evenly spread; `summary.json` has all.
const MOST_OF_FRONT: usize = 15;

pub(super) fn section(found: &Designs, index: usize, figures: &[FigureFile]) -> String {
    [failures(found), explorer(found, index), pictures(figures, "designs", "figures"), front(found), statistics(found)]
        .concat()
}

/// Where the browser part puts its axes and its scatter plot.
fn explorer(found: &Designs, index: usize) -> String {
    if found.sample.rows() < 2 {
        return String::new();
    }
    let kept = found.sample.rows() as u64;
    let share =
        if kept < found.total { format!(" Shown are {kept} of {} designs.", found.total) } else { String::new() };
    format!(
        "<h3>Designs</h3>\n<p class=\"hint needs-script no-print\">Each line is a design. Drag along an axis to keep the \
         designs that pass there, click the axis to let go.{share}</p>\n\
         <div class=\"designs needs-script no-print\" data-designs=\"{index}\"></div>\n"
    )
}

fn failures(found: &Designs) -> String {
    let mut rows = Rows::new(&["Failed because", " Designs", " First"]);
    for failure in &found.failures {
        rows.push(&[words(&failure.reason), failure.count.to_string(), failure.first.to_string()]);
    }
    rows.html()
}

fn front(found: &Designs) -> String {
    let Some(front) = &found.pareto else { return String::new() };
    let columns = &front.front.columns;
    let head = |column: &Column| {
        let unit = number::unit(&column.unit.symbol);
        if unit.is_empty() { format!(" {}", column.name) } else { format!(" {} / {unit}", column.name) }
    };
    let mut rows = Rows::new(&columns.iter().map(head).collect::<Vec<_>>());
    let kept = spread(front.front.rows());
    let aligned: Vec<Vec<String>> = columns.iter().map(|column| aligned(column, &kept)).collect();
    for row in 0..kept.len() {
        rows.push(&aligned.iter().map(|cells| cells[row].clone()).collect::<Vec<_>>());
    }
    let table = rows.html();
    let all = front.front.rows();
    let hint = if kept.len() < all {
        format!(
            "<p class=\"hint\">{} of {all}, evenly spread; <code>summary.json</code> has them all.</p>\n",
            kept.len()
        )
    } else {
        String::new()
    };
    if table.is_empty() { table } else { format!("<h3>Best compromises</h3>\n{hint}{table}") }
}

/// The first, the last and some between.
fn spread(count: usize) -> Vec<usize> {
    let shown = count.min(MOST_OF_FRONT);
    (0..shown).map(|index| if shown < 2 { 0 } else { index * (count - 1) / (shown - 1) }).collect()
}

/// Numbers of a column with the same decimals; designs are counted.
fn aligned(column: &Column, rows: &[usize]) -> Vec<String> {
    let values: Vec<f64> =
        rows.iter().map(|row| column.unit.show(column.values.get(*row).copied().unwrap_or(f64::NAN))).collect();
    let decimals = number::shared_decimals(&values);
    values.iter().map(|value| number::typeset(&number::aligned(*value, decimals))).collect()
}

fn statistics(found: &Designs) -> String {
    let heads = ["Column", "", " Min", " in design", " Max", " in design", " Mean", " Deviation", "Unit"];
    let mut rows = Rows::new(&heads);
    for (index, row) in found.statistics.iter().enumerate() {
        let kind = if index < found.inputs { "varied" } else { "found" };
        rows.push(&[
            code(&row.name),
            Escaped(kind).to_string(),
            number(row.min.0, &row.unit),
            row.min.1.to_string(),
            number(row.max.0, &row.unit),
            row.max.1.to_string(),
            number(row.mean, &row.unit),
            number(row.deviation, &row.unit),
            symbol(&row.unit),
        ]);
    }
    let table = rows.html();
    if table.is_empty() { table } else { format!("<h3>Statistics of all designs</h3>\n{table}") }
}
