//! Standard drives that carry the loads.

use serde_json::{Map, Value, json};

use super::super::values::{object, quantity, shown};
use crate::{Candidate, Check, Property, Sizing};

pub(super) fn keys(found: &Sizing) -> Map<String, Value> {
    let name = |index: Option<usize>| index.and_then(|index| found.candidates.get(index)).map(|one| &one.name);
    object([
        ("of", json!(found.of)),
        ("drive", json!(found.drive)),
        ("drive_kind", json!(found.kind)),
        ("requirements", properties(&found.requirements)),
        ("conditions", properties(&found.conditions)),
        ("chosen", json!(name(found.chosen))),
        ("nearest", json!(name(found.nearest))),
        ("candidates", found.candidates.iter().map(candidate).collect()),
    ])
}

fn properties(of: &[Property]) -> Value {
    Value::Object(of.iter().map(|one| (one.key.clone(), quantity(one.value, &one.unit))).collect())
}

fn candidate(of: &Candidate) -> Value {
    json!({
        "name": of.name,
        "passes": of.passes,
        "properties": properties(&of.properties),
        "checks": of.checks.iter().map(check).collect::<Vec<_>>(),
    })
}

fn check(of: &Check) -> Value {
    json!({
        "check": of.key,
        "passes": of.passes,
        "needed": shown(of.needed, &of.unit),
        "available": shown(of.available, &of.unit),
        "unit": of.unit.symbol,
        "reason": of.reason,
    })
}
