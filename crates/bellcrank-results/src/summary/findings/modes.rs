//! Natural frequencies and mode shapes.

use serde_json::{Map, Value, json};

use super::super::values::{object, quantity};
use crate::{ModeRow, Modes, ShapeRow, Unit};

pub(super) fn keys(found: &Modes) -> Map<String, Value> {
    object([
        ("freedom", json!(found.freedom)),
        ("at_equilibrium", json!(found.at_equilibrium)),
        ("mode_count", json!(found.all)),
        ("modes", found.modes.iter().map(|row| mode(found, row)).collect()),
    ])
}

fn mode(found: &Modes, row: &ModeRow) -> Value {
    let [re, im] = row.eigenvalue;
    let shape: Map<String, Value> = row.shape.iter().map(|of| (of.coordinate.clone(), share(of))).collect();
    json!({
        "frequency": quantity(row.frequency, &Unit::new("Hz", 1.0)),
        "damping": row.damping,
        "eigenvalue": { "re": re, "im": im, "unit": "1/s" },
        "what": found.kind(row).words().to_lowercase(),
        "shape": shape,
    })
}

fn share(of: &ShapeRow) -> Value {
    let [re, im] = of.amplitude;
    json!({ "re": re, "im": im, "unit": of.unit.symbol })
}
