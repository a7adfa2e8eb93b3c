//! What studies found beside their rows: sentences, and a table of a kind's own.

use bellcrank_results::{
    BodyModes, Candidate, Column, ConstraintRow, Designs, Findings, Modes, Optimization, ParameterSensitivity,
    Sensitivity, Sizing, Stress, StudyResult, Tolerance, ToleranceInput, VariableRow,
};

use super::grid::{Cell, Grid};
use crate::number::{self, relative_change};
use crate::told::{self, by_weight, shown};

/// Rows of a table; the report has them all.
const MOST_ROWS: usize = 12;
/// Designs named for a response.
const BEST_DESIGNS: usize = 5;
/// Candidates that pass, and those that come nearest.
const PASSING: usize = 3;
const FAILING: usize = 2;
/// Coordinates of a mode.
const MOVERS: usize = 3;
/// The longest bar, characters.
const BAR: f64 = 20.0;

/// Sentences of the findings; nothing without.
pub(crate) fn sentences(study: &StudyResult) -> Vec<String> {
    study.findings.as_ref().map_or_else(Vec::new, told::sentences)
}

/// Tables of the findings, those without rows among them.
pub(crate) fn tables(study: &StudyResult) -> Vec<Grid> {
    match &study.findings {
        Some(Findings::Sensitivity(found)) => vec![sensitivities(found)],
        Some(Findings::Optimization(found)) if !found.objective.value.is_finite() => Vec::new(),
        Some(Findings::Optimization(found)) => vec![variables(found), compared(found), constraints(found)],
        Some(Findings::Designs(found)) => vec![failures(found), best(found)],
        Some(Findings::Tolerance(found)) => vec![tolerances(found)],
        Some(Findings::Sizing(found)) => vec![candidates(found)],
        Some(Findings::Modes(found)) => vec![modes(found)],
        Some(Findings::Stress(found)) => vec![hot_spots(found)],
        Some(Findings::BodyModes(found)) => vec![frequencies(found)],
        None => Vec::new(),
    }
}

fn more(grid: &mut Grid, all: usize, what: &str) {
    if let Some(rest) = all.checked_sub(MOST_ROWS).filter(|rest| *rest > 0) {
        grid.push(vec![Cell::left(&format!("and {rest} more {what} in the report"))]);
    }
}

/// Parameters without a defined effect come last, with the reason.
fn sensitivities(found: &Sensitivity) -> Grid {
    let mut grid = Grid::new(["parameter", "value", "relative", "", "derivative", ""]);
    let weighed = by_weight(found);
    let largest = weighed.first().map_or(1.0, |row| row.relative.abs());
    let others = found.parameters.iter().filter(|row| !weighed.iter().any(|other| std::ptr::eq(*other, *row)));
    let all: Vec<&ParameterSensitivity> = weighed.iter().copied().chain(others).collect();
    for row in all.iter().take(MOST_ROWS) {
        grid.push(vec![
            Cell::left(&row.name),
            Cell::right(&shown(row.value, &row.unit)),
            Cell::right(&number::aligned(row.relative, Some(4))),
            Cell::left(&bar(row.relative, largest)),
            Cell::right(&shown(row.derivative, &row.derivative_unit)),
            Cell::left(&row.note),
        ]);
    }
    more(&mut grid, all.len(), "parameters");
    grid
}

/// `+++` makes the response larger, `---` smaller.
fn bar(value: f64, largest: f64) -> String {
    let length = (BAR * value.abs() / largest).round();
    if !length.is_finite() {
        return String::new();
    }
    (if value < 0.0 { "-" } else { "+" }).repeat(length as usize)
}

fn variables(found: &Optimization) -> Grid {
    let mut grid = Grid::new(["variable", "before", "after", "change", "bound"]);
    let row = |row: &VariableRow| {
        vec![
            Cell::left(&row.name),
            Cell::right(&shown(row.start, &row.unit)),
            Cell::right(&shown(row.value, &row.unit)),
            Cell::right(&number::change(relative_change(row.start, row.value))),
            Cell::left(&row.bound.map_or_else(String::new, |end| format!("at {end}"))),
        ]
    };
    found.variables.iter().take(MOST_ROWS).for_each(|of| grid.push(row(of)));
    more(&mut grid, found.variables.len(), "variables");
    grid
}

fn compared(found: &Optimization) -> Grid {
    let mut grid = Grid::new(["response", "before", "after", "change"]);
    for row in found.compared.iter().take(MOST_ROWS) {
        grid.push(vec![
            Cell::left(&row.name),
            Cell::right(&shown(row.start, &row.unit)),
            Cell::right(&shown(row.value, &row.unit)),
            Cell::right(&number::change(relative_change(row.start, row.value))),
        ]);
    }
    more(&mut grid, found.compared.len(), "responses");
    grid
}

fn constraints(found: &Optimization) -> Grid {
    let mut grid = Grid::new(["constraint", "left", "right", ""]);
    let state = |row: &ConstraintRow| match (row.violation > 0.0, row.active) {
        (true, _) => format!("VIOLATED by {}", shown(row.violation, &row.unit)),
        (false, true) => "active".to_owned(),
        (false, false) => "holds".to_owned(),
    };
    for row in found.constraints.iter().take(MOST_ROWS) {
        let sides = [row.left.1, row.right].map(|si| Cell::right(&shown(si, &row.unit)));
        let [left, right] = sides;
        grid.push(vec![Cell::left(&row.written), left, right, Cell::left(&state(row))]);
    }
    more(&mut grid, found.constraints.len(), "constraints");
    grid
}

fn failures(found: &Designs) -> Grid {
    let mut grid = Grid::new(["failed because", "designs", "first"]);
    for failure in found.failures.iter().take(MOST_ROWS) {
        let [count, first] = [failure.count, failure.first].map(|number| Cell::right(&number.to_string()));
        grid.push(vec![Cell::left(&failure.reason), count, first]);
    }
    grid
}

/// The front where there is one, else the extremes of each response.
fn best(found: &Designs) -> Grid {
    let Some(front) = &found.pareto else { return extremes(found) };
    let mut grid = Grid::new(["best compromise", "design", "", ""]);
    let columns: Vec<&Column> = front.objectives.iter().filter_map(|(name, _)| front.front.column(name)).collect();
    let design = front.front.columns.first();
    let rows = front.front.rows();
    let shown_rows = rows.min(BEST_DESIGNS);
    for index in 0..shown_rows {
        let row = if shown_rows < 2 { 0 } else { index * (rows - 1) / (shown_rows - 1) };
        let cell = |column: &&Column| {
            format!(
                "{} {}",
                column.name,
                column.values.get(row).map_or_else(String::new, |si| shown(*si, &column.unit))
            )
        };
        let number = design.and_then(|column| column.values.get(row)).map_or_else(String::new, f64::to_string);
        let mut cells = vec![Cell::left(&format!("{} of {rows}", row + 1)), Cell::right(&number)];
        cells.extend(columns.iter().map(|column| Cell::left(&cell(column))));
        grid.push(cells);
    }
    grid
}

fn extremes(found: &Designs) -> Grid {
    let mut grid = Grid::new(["response", "min", "in design", "max", "in design", "mean"]);
    let computed = found.statistics.iter().skip(found.inputs).filter(|row| row.mean.is_finite());
    for row in computed.take(MOST_ROWS) {
        grid.push(vec![
            Cell::left(&row.name),
            Cell::right(&shown(row.min.0, &row.unit)),
            Cell::right(&row.min.1.to_string()),
            Cell::right(&shown(row.max.0, &row.unit)),
            Cell::right(&row.max.1.to_string()),
            Cell::right(&shown(row.mean, &row.unit)),
        ]);
    }
    grid
}

fn tolerances(found: &Tolerance) -> Grid {
    let mut grid = Grid::new(["tolerance", "nominal", "half width", "variance", "", "worst case"]);
    let largest = found.inputs.iter().map(|input| input.variance_share).fold(0.0, f64::max);
    let half = |input: &ToleranceInput| {
        if input.half_width.is_finite() { shown(input.half_width, &input.unit) } else { "–".to_owned() }
    };
    for input in found.inputs.iter().take(MOST_ROWS) {
        grid.push(vec![
            Cell::left(&input.name),
            Cell::right(&shown(input.nominal, &input.unit)),
            Cell::right(&half(input)),
            Cell::right(&number::part(input.variance_share)),
            Cell::left(&bar(input.variance_share, largest)),
            Cell::right(&number::part(input.worst_share)),
        ]);
    }
    more(&mut grid, found.inputs.len(), "tolerances");
    grid
}

fn modes(found: &Modes) -> Grid {
    let mut grid = Grid::new(["mode", "frequency", "damping", "", "moves most"]);
    for (index, mode) in found.modes.iter().take(MOST_ROWS).enumerate() {
        grid.push(vec![
            Cell::left(&(index + 1).to_string()),
            Cell::right(&number::with_unit(&number::alone(mode.frequency), "Hz")),
            Cell::right(&told::modes::ratio(mode)),
            Cell::left(found.kind(mode).words()),
            Cell::left(&told::modes::movers(mode, MOVERS)),
        ]);
    }
    more(&mut grid, found.modes.len(), "modes");
    grid
}

/// Those that mean nothing say so.
fn hot_spots(found: &Stress) -> Grid {
    let mut grid = Grid::new(["hot spot", "von Mises", "margin", "at", ""]);
    for body in &found.bodies {
        for spot in body.spots.iter().take(MOST_ROWS) {
            let stress = match spot.singular {
                Some(_) => told::about(spot.value, &found.unit, 4),
                None => told::stress::with_error(spot, found),
            };
            let at = told::stress::place(spot, found);
            let said = spot.singular.map_or_else(|| spot.place.clone(), |why| format!("NOT TO BE TRUSTED, {why}"));
            grid.push(vec![
                Cell::left(&format!("{} {}", body.body, spot.region)),
                Cell::right(&stress),
                Cell::right(&spot.margin.map_or_else(String::new, |margin| number::significant(margin, 3))),
                Cell::left(&format!("[{at}] {}", found.length.symbol)),
                Cell::left(&said),
            ]);
        }
        more(&mut grid, body.spots.len(), "regions");
    }
    grid
}

fn frequencies(found: &BodyModes) -> Grid {
    let mut grid = Grid::new(["mode", "frequency"]);
    for body in &found.bodies {
        for (index, frequency) in body.frequencies.iter().take(MOST_ROWS).enumerate() {
            let name = format!("{} {}", body.body, index + 1);
            grid.push(vec![Cell::left(&name), Cell::right(&number::with_unit(&number::alone(*frequency), "Hz"))]);
        }
        more(&mut grid, body.frequencies.len(), "modes");
    }
    grid
}

/// The first ones, and why those fail that do.
fn candidates(found: &Sizing) -> Grid {
    let mut grid = Grid::new(["candidate", "", ""]);
    let of = |passes: bool| found.candidates.iter().filter(move |candidate| candidate.passes == passes);
    let shown: Vec<&Candidate> = of(true).take(PASSING).chain(of(false).take(FAILING)).collect();
    for candidate in &shown {
        let word = if candidate.passes { "passes" } else { "FAILS" };
        grid.push(vec![Cell::left(&candidate.name), Cell::left(word), Cell::left(&why(candidate))]);
    }
    if let Some(rest) = found.candidates.len().checked_sub(shown.len()).filter(|rest| *rest > 0) {
        grid.push(vec![Cell::left(&format!("and {rest} more candidates in the report"))]);
    }
    grid
}

/// Which checks fail, and the reason of the first; for one that passes, the check that matters most.
fn why(candidate: &Candidate) -> String {
    let failed: Vec<_> = candidate.checks.iter().filter(|check| check.passes == Some(false)).collect();
    let keys: Vec<&str> = failed.iter().map(|check| check.key.as_str()).collect();
    match (failed.first(), candidate.checks.first()) {
        (Some(first), _) if failed.len() == 1 => first.reason.clone(),
        (Some(first), _) => format!("{}: {}", keys.join(", ").replace('_', " "), first.reason),
        (None, Some(first)) => first.reason.clone(),
        (None, None) => String::new(),
    }
}
