//! Derivatives of a response by parameter.

use serde_json::{Map, Value, json};

use super::super::values::{object, shown};
use crate::{ActivePlace, Curve, ParameterSensitivity, Sensitivity, Unit};

pub(super) fn keys(found: &Sensitivity) -> Map<String, Value> {
    let parameter = |row: &ParameterSensitivity| (row.name.clone(), parameter(row, &found.unit));
    object([
        ("of", json!(found.of)),
        ("response", response(found)),
        ("sensitivity", Value::Object(found.parameters.iter().map(parameter).collect())),
    ])
}

fn response(found: &Sensitivity) -> Value {
    json!({
        "value": shown(found.value, &found.unit),
        "unit": found.unit.symbol,
        "expression": found.response,
        "at": found.at.iter().map(place).collect::<Vec<_>>(),
    })
}

/// `at` is the place by axis, as in the extremes of signals.
fn place(of: &ActivePlace) -> Value {
    let at = Map::from_iter([(of.axis.clone(), shown(of.place, &of.unit))]);
    json!({ "reduction": of.reduction, "at": at, "unit": of.unit.symbol, "between_rows": of.between_rows })
}

/// The derivative in its SI unit, value and curve in the unit of the parameter.
fn parameter(row: &ParameterSensitivity, response: &Unit) -> Value {
    json!({
        "derivative": shown(row.derivative, &row.derivative_unit),
        "unit": row.derivative_unit.symbol,
        "relative": row.relative,
        "value": shown(row.value, &row.unit),
        "parameter_unit": row.unit.symbol,
        "note": row.note,
        "curve": row.curve.as_ref().map(|curve| of_curve(curve, &row.unit, response)),
    })
}

fn of_curve(curve: &Curve, parameter: &Unit, response: &Unit) -> Value {
    let all = |values: &[f64], unit: &Unit| values.iter().map(|si| shown(*si, unit)).collect::<Value>();
    json!({
        "parameter": all(&curve.parameter, parameter),
        "response": all(&curve.response, response),
        "parameter_unit": parameter.symbol,
        "response_unit": response.symbol,
    })
}
