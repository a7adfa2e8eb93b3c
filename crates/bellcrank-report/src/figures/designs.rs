//! Designs side by side, and two of their columns against each other.

use bellcrank_results::{Column, Designs, Table};

use super::FigureFile;
use crate::plot::{Axis, Parallel, Ruler, Scatter};

/// Lines in a picture that is not moved: more become a grey area, and the file large.
const MOST_LINES: usize = 250;
const MOST_DOTS: usize = 900;
/// Axes side by side.
const MOST_RULERS: usize = 9;

pub(super) fn figures(found: &Designs) -> Vec<FigureFile> {
    if found.sample.rows() < 2 || found.sample.columns.len() < 3 {
        return Vec::new();
    }
    parallel(found).into_iter().chain(scatter(found)).collect()
}

/// Inputs first, responses last; of very many, as many of both as there is room for.
fn shown(found: &Designs) -> Vec<(&Column, bool)> {
    let all: Vec<_> = found.sample.columns.iter().skip(1).enumerate().map(|(i, c)| (c, i < found.inputs)).collect();
    let (inputs, responses): (Vec<_>, Vec<_>) = all.into_iter().partition(|(_, input)| *input);
    let of_responses = responses.len().min(MOST_RULERS.saturating_sub(inputs.len()).max(MOST_RULERS / 2));
    let of_inputs = inputs.len().min(MOST_RULERS - of_responses);
    inputs.into_iter().take(of_inputs).chain(responses.into_iter().take(of_responses)).collect()
}

fn parallel(found: &Designs) -> Option<FigureFile> {
    let step = found.sample.rows().div_ceil(MOST_LINES).max(1);
    let columns = shown(found);
    let ruler = |(column, input): &(&'_ Column, bool)| (column_numbers(column, step), *input);
    let numbers: Vec<_> = columns.iter().map(ruler).collect();
    let rulers: Vec<Ruler<'_>> = columns
        .iter()
        .zip(numbers)
        .map(|((column, _), (values, input))| Ruler { name: &column.name, unit: &column.unit.symbol, values, input })
        .collect();
    let drawn = rulers.first()?.values.len();
    let title = counted_title("Designs side by side", drawn, found.total);
    let svg = Parallel { title: title.clone(), rulers }.svg();
    Some(FigureFile::of_finding("designs", "parallel".to_owned(), title, svg))
}

fn column_numbers(column: &Column, step: usize) -> Vec<f64> {
    column.values.iter().step_by(step).map(|si| column.unit.show(*si)).collect()
}

fn counted_title(what: &str, drawn: usize, total: u64) -> String {
    if drawn as u64 == total { what.to_owned() } else { format!("{what} ({drawn} of {total})") }
}

/// The responses of the front; else the first response over the first parameter.
fn scatter(found: &Designs) -> Option<FigureFile> {
    let (x, y) = axes(found)?;
    let step = found.sample.rows().div_ceil(MOST_DOTS).max(1);
    let points: Vec<_> = pairs(&found.sample, x, y)?.into_iter().step_by(step).collect();
    let front = found.pareto.as_ref().and_then(|front| pairs(&front.front, x, y)).unwrap_or_default();
    let title = counted_title("Designs", points.len(), found.total);
    let axis = |name: &str| {
        let unit = found.sample.column(name).map_or(String::new(), |column| column.unit.symbol.clone());
        Axis { name: name.to_owned(), unit }
    };
    let note = if found.failed > 0 { "failed designs are left out" } else { "" };
    let svg = Scatter { title: title.clone(), x: axis(x), y: axis(y), points, front, note }.svg();
    Some(FigureFile::of_finding("designs", "scatter".to_owned(), title, svg))
}

fn axes(found: &Designs) -> Option<(&str, &str)> {
    if let Some(front) = &found.pareto {
        return Some((&front.objectives[0].0, &front.objectives[1].0));
    }
    let columns = &found.sample.columns;
    Some((&columns.get(1)?.name, &columns.get(1 + found.inputs)?.name))
}

fn pairs(table: &Table, x: &str, y: &str) -> Option<Vec<(f64, f64)>> {
    let (x, y) = (table.column(x)?, table.column(y)?);
    Some(x.values.iter().zip(&y.values).map(|(a, b)| (x.unit.show(*a), y.unit.show(*b))).collect())
}
