//! A better design and how it was found.

use serde_json::{Map, Value, json};

use super::super::values::{change, object, shown};
use crate::{Compared, ConstraintRow, FirstOrder, IterationRow, Objective, Optimization, StartRow, Unit, VariableRow};

pub(super) fn keys(found: &Optimization) -> Map<String, Value> {
    let unit = &found.objective.unit;
    let list = |rows: Vec<Value>| Value::Array(rows);
    object([
        ("of", json!(found.of)),
        ("objective", objective(&found.objective)),
        ("variables", Value::Object(found.variables.iter().map(variable).collect())),
        ("constraints", list(found.constraints.iter().map(constraint).collect())),
        ("compared", list(found.compared.iter().map(compared).collect())),
        ("iterations", json!(found.iteration_count)),
        ("evaluations", json!(found.evaluations)),
        ("failed_designs", json!(found.failed_designs)),
        ("status", json!(found.status)),
        ("first_order", first_order(found.first_order)),
        ("starts", list(found.starts.iter().map(|row| start(row, found)).collect())),
        ("history", list(found.iterations.iter().map(|row| iteration(row, unit)).collect())),
        ("written", json!(found.written)),
    ])
}

fn objective(of: &Objective) -> Value {
    json!({
        "start": shown(of.start, &of.unit),
        "value": shown(of.value, &of.unit),
        "unit": of.unit.symbol,
        "change": change(of.start, of.value),
        "expression": of.written,
        "maximize": of.maximize,
    })
}

fn variable(row: &VariableRow) -> (String, Value) {
    let value = json!({
        "start": shown(row.start, &row.unit),
        "value": shown(row.value, &row.unit),
        "unit": row.unit.symbol,
        "bound": row.bound,
        "min": shown(row.bounds.0, &row.unit),
        "max": shown(row.bounds.1, &row.unit),
        "multiplier": shown(row.multiplier, &row.multiplier_unit),
        "multiplier_unit": row.multiplier_unit.symbol,
    });
    (row.name.clone(), value)
}

/// A list, not an object: the same text may be written twice.
fn constraint(row: &ConstraintRow) -> Value {
    json!({
        "expression": row.written,
        "start": shown(row.left.0, &row.unit),
        "left": shown(row.left.1, &row.unit),
        "right": shown(row.right, &row.unit),
        "unit": row.unit.symbol,
        "active": row.active,
        "violation": shown(row.violation, &row.unit),
        "multiplier": shown(row.multiplier, &row.multiplier_unit),
        "multiplier_unit": row.multiplier_unit.symbol,
    })
}

fn compared(row: &Compared) -> Value {
    json!({
        "expression": row.name,
        "start": shown(row.start, &row.unit),
        "value": shown(row.value, &row.unit),
        "unit": row.unit.symbol,
        "change": change(row.start, row.value),
    })
}

fn first_order(of: FirstOrder) -> Value {
    json!({
        "holds": of.holds,
        "stationarity": of.stationarity,
        "feasibility": of.feasibility,
        "complementarity": of.complementarity,
    })
}

/// Points by variable, in the units of `variables`.
fn start(row: &StartRow, found: &Optimization) -> Value {
    let point = |values: &[f64]| {
        let of = |(variable, si): (&VariableRow, &f64)| (variable.name.clone(), shown(*si, &variable.unit));
        found.variables.iter().zip(values).map(of).collect::<Map<_, _>>()
    };
    json!({
        "start": row.start,
        "from": point(&row.from),
        "point": point(&row.point),
        "objective": shown(row.objective, &found.objective.unit),
        "unit": found.objective.unit.symbol,
        "violation": row.violation,
        "status": row.status,
    })
}

fn iteration(row: &IterationRow, unit: &Unit) -> Value {
    json!({
        "start": row.start,
        "iteration": row.iteration,
        "evaluations": row.evaluations,
        "objective": shown(row.objective, unit),
        "unit": unit.symbol,
        "violation": row.violation,
        "optimality": row.optimality,
        "step": row.step,
    })
}
