//! Exact derivatives of one response, and the response over the range of each parameter.

use bellcrank_results::{Curve, Findings, ParameterSensitivity, Sensitivity as Found, StudyResult};

use super::active::active_places;
use super::{Asking, cancelled};
use crate::design::Sensitivity;
use crate::progress::Progress;
use crate::trial::{Asked, Derived, Trial, Undefined};

/// A change of the parameter by its own size that changes the response by less than this part of it does nothing.
const ROUNDING: f64 = 1e-13;
const NONE: &str = "no effect";

pub(super) fn run(
    asking: &Asking<'_>,
    question: &Sensitivity,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<(), Undefined> {
    progress.at(0.0, "differentiating");
    let mut asked = Asked::default();
    asked.response(&question.response);
    let mut trial = asking.trial(asked);
    let value = trial.run(&[])?[0];
    let derived = trial.gradients(&question.parameters)?.swap_remove(0);
    let dimension = question.response.value.dimension();
    let mut found = Found {
        of: asking.of.name.clone(),
        response: question.response.written().to_owned(),
        value,
        unit: asking.unit(dimension),
        at: active_places(asking, &trial, 0),
        parameters: Vec::with_capacity(question.parameters.len()),
    };
    for (place, &index) in question.parameters.iter().enumerate() {
        let parameter = asking.parameter(index);
        let derivative = derived.active.gradient[place];
        let by = Asking::derivative_unit(dimension, parameter.dimension);
        found.parameters.push(ParameterSensitivity {
            name: parameter.name.clone(),
            value: asking.value(index),
            unit: asking.parameter_unit(index),
            derivative,
            derivative_unit: by,
            relative: if value == 0.0 { f64::NAN } else { derivative * asking.value(index) / value },
            note: note(asking, &trial, &derived, place, index),
            curve: None,
        });
    }
    result.warnings.extend(warnings(&found));
    result.warnings.extend(asking.unplaced().into_iter().map(|name| {
        format!(
            "`{name}` rests where assembly put it; the derivatives take that place as fixed (give it one in `hold`)"
        )
    }));
    let curves = curves(asking, question, &mut trial, progress);
    result.effort = vec![("positions".to_owned(), trial.positions as f64)];
    let stopped = curves.len() < question.parameters.len();
    for (parameter, curve) in found.parameters.iter_mut().zip(curves) {
        parameter.curve = curve;
    }
    result.findings = Some(Findings::Sensitivity(found));
    if stopped { Err(cancelled("before all curves were drawn; the derivatives are complete")) } else { Ok(()) }
}

/// What a reader should know about one derivative.
fn note(asking: &Asking<'_>, trial: &Trial<'_>, derived: &Derived, place: usize, index: usize) -> String {
    let derivative = derived.active.gradient[place];
    let reach = derivative * asking.value(index);
    if derivative == 0.0 {
        return NONE.to_owned();
    }
    if reach.abs() <= ROUNDING * derived.active.value.abs() {
        return format!("{NONE}: the derivative is rounding");
    }
    if derivative.is_nan() && trial.is_ambiguous(0) {
        return "not defined: equilibrium alone does not determine this reaction".to_owned();
    }
    if derivative.is_nan() {
        return "not defined: with this parameter alone changed, the redundant loops no longer close".to_owned();
    }
    let here = derived.active.value;
    let tied = |piece: &&crate::trial::Piece| (piece.value - here).abs() <= 1e-9 * here.abs();
    let other = derived.others.iter().filter(tied).find(|piece| {
        (piece.gradient[place] - derivative).abs() > 1e-6 * derivative.abs().max(piece.gradient[place].abs())
    });
    if other.is_some() {
        return "one of two: another position has the same extreme and another derivative".to_owned();
    }
    if asking.parameter(index).expression.parameters().is_empty() { String::new() } else { follows(asking, index) }
}

fn follows(asking: &Asking<'_>, index: usize) -> String {
    format!("varied on its own: the file has it follow (`{}`)", asking.parameter(index).written)
}

fn warnings(found: &Found) -> Vec<String> {
    let flat = found.parameters.iter().all(|p| p.note.starts_with(NONE)) && !found.parameters.is_empty();
    let mut warnings = Vec::new();
    if flat {
        warnings.push(format!("`{}` does not depend on any of these parameters", found.response));
    }
    if found.value == 0.0 {
        warnings.push(format!("`{}` is zero here, so no relative sensitivity is defined", found.response));
    }
    warnings
}

/// The response over the range of each parameter that has one; shorter when stopped.
fn curves(
    asking: &Asking<'_>,
    question: &Sensitivity,
    trial: &mut Trial<'_>,
    progress: &mut dyn Progress,
) -> Vec<Option<Curve>> {
    let mut curves = Vec::with_capacity(question.parameters.len());
    for (place, &index) in question.parameters.iter().enumerate() {
        if progress.cancelled() {
            break;
        }
        progress.at(place as f64 / question.parameters.len() as f64, "drawing the response over its parameters");
        curves.push(curve(asking, index, question.points, trial));
    }
    curves
}

/// Samples over the range with the present value among them.
fn curve(asking: &Asking<'_>, index: usize, points: usize, trial: &mut Trial<'_>) -> Option<Curve> {
    let parameter = asking.parameter(index);
    let (min, max) = (parameter.min?, parameter.max?);
    if points < 2 || min >= max {
        return None;
    }
    let share = |i: usize| i as f64 / (points - 1) as f64;
    let mut values: Vec<f64> = (0..points).map(|i| min * (1.0 - share(i)) + max * share(i)).collect();
    let here = asking.value(index);
    if let Err(place) = values.binary_search_by(|x| x.total_cmp(&here)) {
        values.insert(place, here);
    }
    let response = values.iter().map(|&x| trial.run(&[(index, x)]).map_or(f64::NAN, |found| found[0])).collect();
    Some(Curve { parameter: values, response })
}
