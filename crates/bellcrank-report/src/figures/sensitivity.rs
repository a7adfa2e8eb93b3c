//! What moves a response, and how it runs over each parameter.

use bellcrank_results::{Curve, ParameterSensitivity, Sensitivity};

use super::FigureFile;
use crate::number;
use crate::plot::{Axis, Bar, Bars, Response, shared_span};
use crate::told::by_weight;

/// Bars in one plot: the others are in the table.
const MOST_BARS: usize = 24;

pub(super) fn figures(found: &Sensitivity) -> Vec<FigureFile> {
    tornado(found).into_iter().chain(curves(found)).collect()
}

/// Nothing where no parameter has a relative effect.
fn tornado(found: &Sensitivity) -> Option<FigureFile> {
    let rows = by_weight(found);
    let bars: Vec<_> = rows.iter().take(MOST_BARS).map(|row| bar(row)).collect();
    if bars.is_empty() {
        return None;
    }
    let title = match rows.len() - bars.len() {
        0 => "Relative sensitivity".to_owned(),
        _ => format!("Relative sensitivity ({} of {} parameters)", bars.len(), rows.len()),
    };
    let label = "change of the response in % for 1 % more of the parameter".to_owned();
    let svg = Bars { title: title.clone(), label, kinds: None, bars }.svg();
    Some(FigureFile::of_finding("tornado", "tornado".to_owned(), title, svg))
}

fn bar(row: &ParameterSensitivity) -> Bar<'_> {
    let text = number::typeset(&number::significant(row.relative, 3));
    Bar { name: &row.name, value: row.relative, text, second: None }
}

fn curves(found: &Sensitivity) -> Vec<FigureFile> {
    let with_curve: Vec<(&ParameterSensitivity, &Curve)> =
        found.parameters.iter().filter_map(|row| Some((row, row.curve.as_ref()?))).collect();
    let responses: Vec<f64> = with_curve
        .iter()
        .flat_map(|(_, curve)| &curve.response)
        .chain([&found.value])
        .map(|si| found.unit.show(*si))
        .collect();
    let span = shared_span(responses.iter());
    with_curve.into_iter().map(|(row, curve)| response(found, row, curve, span)).collect()
}

fn response(found: &Sensitivity, row: &ParameterSensitivity, curve: &Curve, span: (f64, f64)) -> FigureFile {
    let across: Vec<f64> = curve.parameter.iter().map(|si| row.unit.show(*si)).collect();
    let up: Vec<f64> = curve.response.iter().map(|si| found.unit.show(*si)).collect();
    let title = row.name.clone();
    let svg = Response {
        title: title.clone(),
        x: Axis { name: row.name.clone(), unit: row.unit.symbol.clone() },
        y: Axis { name: found.response.clone(), unit: found.unit.symbol.clone() },
        across: &across,
        up: &up,
        here: (row.unit.show(row.value), found.unit.show(found.value)),
        slope: row.derivative * row.unit.factor / found.unit.factor,
        span,
    }
    .svg();
    FigureFile::of_finding("curve", format!("curve-{}", row.name), title, svg)
}
