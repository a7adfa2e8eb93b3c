//! Stress and natural frequencies of bodies.

use serde_json::{Map, Value, json};

use super::super::values::{object, quantity};
use crate::{BodyModeRow, BodyModes, HotSpot, MeshRow, PartEffort, Stress, StressBody, Unit};

pub(super) fn keys(found: &Stress) -> Map<String, Value> {
    let named = |text: &str| if text.is_empty() { Value::Null } else { json!(text) };
    object([
        ("of", named(&found.of)),
        ("hinges", named(&found.hinges)),
        ("accuracy", json!(found.accuracy)),
        ("bodies", found.bodies.iter().map(|of| (of.body.clone(), body(found, of))).collect::<Map<_, _>>().into()),
    ])
}

fn body(found: &Stress, of: &StressBody) -> Value {
    let (unit, length) = (&found.unit, &found.length);
    let kilogram = Unit::new("kg", 1.0);
    let (displacement, at) = of.displacement;
    let spots = |singular: bool| -> Vec<Value> {
        let wanted = of.spots.iter().filter(|spot| spot.singular.is_some() == singular);
        wanted.map(|spot| hot_spot(found, spot)).collect()
    };
    json!({
        "solid": of.solid,
        "material": of.material,
        "yield": of.strength.map(|strength| quantity(strength, unit)),
        "position": if of.place.is_empty() { Value::Null } else { json!(of.place) },
        "peak": of.peak().map(|spot| hot_spot(found, spot)),
        "accuracy_reached": of.reached,
        "hot_spots": spots(false),
        "singular": spots(true),
        "displacement": { "largest": quantity(displacement, length), "at": place(at, length) },
        "meshes": of.meshes.iter().map(|row| mesh(row, unit)).collect::<Vec<_>>(),
        "mass": { "mesh": quantity(of.mass[0], &kilogram), "solid": quantity(of.mass[1], &kilogram) },
        "energy_error": of.energy_error,
        "check": { "unbalance": of.unbalance, "residual": of.residual },
        "solution": effort(&of.effort),
    })
}

fn hot_spot(found: &Stress, spot: &HotSpot) -> Value {
    json!({
        "region": spot.region,
        "at": place(spot.at, &found.length),
        "von_mises": quantity(spot.value, &found.unit),
        "error": quantity(spot.error, &found.unit),
        "relative_error": spot.relative_error(),
        "largest_principal": quantity(spot.principal[0], &found.unit),
        "smallest_principal": quantity(spot.principal[1], &found.unit),
        "margin": spot.margin,
        "singular": spot.singular,
        "position": if spot.place.is_empty() { Value::Null } else { json!(spot.place) },
    })
}

fn place(at: [f64; 3], unit: &Unit) -> Value {
    json!({ "value": at.map(|x| super::super::values::rounded(x, unit)), "unit": unit.symbol })
}

fn mesh(row: &MeshRow, unit: &Unit) -> Value {
    json!({
        "nodes": row.nodes,
        "elements": row.elements,
        "element": row.element,
        "worst_scaled_jacobian": row.worst_jacobian,
        "peak": row.peak.is_finite().then(|| quantity(row.peak, unit)),
        "relative_error": row.error.is_finite().then_some(row.error),
    })
}

fn effort(of: &PartEffort) -> Value {
    json!({
        "equations": of.equations,
        "factor_entries": of.factor_entries,
        "time": quantity(of.seconds, &Unit::new("s", 1.0)),
    })
}

pub(super) fn mode_keys(found: &BodyModes) -> Map<String, Value> {
    let bodies = found.bodies.iter().map(|of| (of.body.clone(), modes(of)));
    object([("bodies", bodies.collect::<Map<_, _>>().into())])
}

fn modes(of: &BodyModeRow) -> Value {
    let (hertz, kilogram) = (Unit::new("Hz", 1.0), Unit::new("kg", 1.0));
    json!({
        "solid": of.solid,
        "material": of.material,
        "fixed": of.fixed,
        "rigid_modes": of.rigid,
        "frequencies": of.frequencies.iter().map(|f| quantity(*f, &hertz)).collect::<Vec<_>>(),
        "residual": of.residual,
        "mesh": mesh(&of.mesh, &Unit::one()),
        "mass": { "mesh": quantity(of.mass[0], &kilogram), "solid": quantity(of.mass[1], &kilogram) },
        "solution": effort(&of.effort),
    })
}
