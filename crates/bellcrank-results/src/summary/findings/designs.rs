//! Responses over many designs: counts, statistics and the front; the rows are in the files.

use serde_json::{Map, Value, json};

use super::super::values::{object, shown};
use crate::{Column, ColumnStatistics, DesignFailure, Designs, ParetoFront};

pub(super) fn keys(found: &Designs) -> Map<String, Value> {
    object([
        ("of", json!(found.of)),
        ("method", json!(found.method)),
        ("seed", json!(found.seed)),
        ("total", json!(found.total)),
        ("done", json!(found.done)),
        ("resumed", json!(found.resumed)),
        ("failed", json!(found.failed)),
        ("failures", found.failures.iter().map(failure).collect()),
        ("statistics", Value::Object(found.statistics.iter().map(statistics).collect())),
        ("pareto", found.pareto.as_ref().map_or(Value::Null, pareto)),
        ("files", json!(found.files)),
        ("threads", json!(found.threads)),
    ])
}

fn failure(of: &DesignFailure) -> Value {
    json!({ "reason": of.reason, "count": of.count, "first": of.first })
}

fn statistics(of: &ColumnStatistics) -> (String, Value) {
    let extreme = |(si, design): (f64, u64)| json!({ "value": shown(si, &of.unit), "design": design });
    let value = json!({
        "unit": of.unit.symbol,
        "min": extreme(of.min),
        "max": extreme(of.max),
        "mean": shown(of.mean, &of.unit),
        "deviation": shown(of.deviation, &of.unit),
    });
    (of.name.clone(), value)
}

fn pareto(of: &ParetoFront) -> Value {
    let objective = |(name, minimize): &(String, bool)| {
        let goal = if *minimize { "minimize" } else { "maximize" };
        json!({ "response": name, "goal": goal })
    };
    let columns = &of.front.columns;
    let units: Map<_, _> = columns.iter().map(|c| (c.name.clone(), json!(c.unit.symbol))).collect();
    json!({
        "objectives": of.objectives.iter().map(objective).collect::<Vec<_>>(),
        "units": units,
        "rows": (0..of.front.rows()).map(|row| design(columns, row)).collect::<Vec<_>>(),
    })
}

fn design(columns: &[Column], row: usize) -> Map<String, Value> {
    let cell = |c: &Column| (c.name.clone(), shown(c.values.get(row).copied().unwrap_or(f64::NAN), &c.unit));
    columns.iter().map(cell).collect()
}
