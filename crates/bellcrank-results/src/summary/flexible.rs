//! Flexible bodies: their reduction and the stress in them over the rows.

use serde_json::{Map, Value, json};

use super::values::quantity;
use crate::{Deformation, Fatigue, FlexibleBodies, FlexibleBody, MeshRow, SpotHistory, Unit};

/// What stands under `flexible`.
pub(super) fn described(found: &FlexibleBodies) -> Value {
    let bodies = found.bodies.iter().map(|of| (of.body.clone(), body(found, of)));
    json!({ "bodies": bodies.collect::<Map<_, _>>(), "assumptions": found.assumptions })
}

fn text(words: &str) -> Value {
    if words.is_empty() { Value::Null } else { json!(words) }
}

fn body(found: &FlexibleBodies, of: &FlexibleBody) -> Value {
    let kilogram = Unit::new("kg", 1.0);
    let spots = |singular: bool| -> Vec<Value> {
        let wanted = of.spots.iter().filter(|spot| spot.singular.is_some() == singular);
        wanted.map(|one| spot(found, one)).collect()
    };
    json!({
        "solid": of.solid,
        "material": of.material,
        "yield": of.strength.map(|strength| quantity(strength, &found.unit)),
        "coupling": text(&of.coupling),
        "interfaces": of.interfaces,
        "coordinates": of.coordinates,
        "modes": modes(of),
        "stiffening": of.stiffening,
        "mesh": of.mesh.as_ref().map(mesh),
        "mass": { "reduced": quantity(of.mass[0], &kilogram), "solid": quantity(of.mass[1], &kilogram) },
        "checks": checks(of),
        "from_cache": of.cached,
        "peak": of.peak().map(|peak| spot(found, peak)),
        "hot_spots": spots(false),
        "singular": spots(true),
        "error": text(&of.error),
        "deformation": of.deformation.as_ref().map(|of| deformation(found, of)),
    })
}

fn modes(of: &FlexibleBody) -> Vec<Value> {
    let hertz = Unit::new("Hz", 1.0);
    of.modes.iter().map(|m| json!({ "frequency": quantity(m.frequency, &hertz), "damping": m.damping })).collect()
}

fn checks(of: &FlexibleBody) -> Value {
    let one = |check: &crate::ReductionCheck| {
        let value = json!({
            "meaning": check.meaning, "value": check.value, "limit": check.limit, "passed": check.passed(),
        });
        (check.key.clone(), value)
    };
    Value::Object(of.checks.iter().map(one).collect())
}

fn mesh(row: &MeshRow) -> Value {
    json!({
        "nodes": row.nodes,
        "elements": row.elements,
        "element": row.element,
        "worst_scaled_jacobian": row.worst_jacobian,
    })
}

fn spot(found: &FlexibleBodies, of: &SpotHistory) -> Value {
    let unit = &found.unit;
    json!({
        "region": of.region,
        "at": { "value": of.at.map(|x| super::rounded(x, &found.length)), "unit": found.length.symbol },
        "von_mises": quantity(of.value, unit),
        "error": of.error.map(|error| quantity(error, unit)),
        "relative_error": of.relative_error(),
        "largest_principal": quantity(of.principal[0], unit),
        "smallest_principal": quantity(of.principal[1], unit),
        "margin": of.margin,
        "singular": of.singular,
        "row": of.row,
        "position": text(&of.place),
        "signal": text(&of.signal),
        "fatigue": of.fatigue.as_ref().map(|of| fatigue(of, unit)),
    })
}

fn fatigue(of: &Fatigue, unit: &Unit) -> Value {
    json!({
        "damage": of.damage,
        "life": of.life,
        "amplitude": quantity(of.amplitude, unit),
        "mean": quantity(of.mean, unit),
        "cycles": of.cycles,
    })
}

fn deformation(found: &FlexibleBodies, of: &Deformation) -> Value {
    json!({
        "displacement": quantity(of.displacement, &found.length),
        "share": of.share,
        "turn": quantity(of.turn, &Unit::new("deg", std::f64::consts::PI / 180.0)),
        "position": text(&of.place),
        "limit": of.limit,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{KeptMode, ReductionCheck, StudyResult, study_summary};

    fn found() -> FlexibleBodies {
        let spot = SpotHistory {
            region: "bore B".to_owned(),
            at: [0.7, -0.02, 0.01],
            value: 142e6,
            row: 37,
            place: "time = 0.37 s".to_owned(),
            error: Some(7.1e6),
            principal: [150e6, -8e6],
            margin: Some(1.5),
            singular: None,
            signal: "body.link3.stress.bore.B".to_owned(),
            fatigue: Some(Fatigue { damage: 2e-7, life: Some(5e6), amplitude: 60e6, mean: 20e6, cycles: 3.5 }),
        };
        let body = FlexibleBody {
            body: "link3".to_owned(),
            solid: "link3".to_owned(),
            material: "S355".to_owned(),
            strength: Some(355e6),
            coupling: "distributing".to_owned(),
            interfaces: vec!["B".to_owned(), "N".to_owned()],
            coordinates: 5,
            modes: vec![KeptMode { frequency: 345.5, damping: 0.01 }],
            stiffening: false,
            mesh: None,
            mass: [20.79, 20.8],
            checks: vec![ReductionCheck {
                key: "rigid_inertia".to_owned(),
                meaning: "inertia".to_owned(),
                value: 3e-9,
                limit: Some(1e-10),
            }],
            cached: true,
            peak: Some(1),
            spots: vec![SpotHistory { singular: Some("re-entrant edge"), fatigue: None, ..spot.clone() }, spot],
            error: String::new(),
            deformation: None,
        };
        FlexibleBodies {
            bodies: vec![body],
            assumptions: vec!["one".to_owned()],
            unit: Unit::new("MPa", 1e6),
            length: Unit::new("mm", 1e-3),
        }
    }

    #[test]
    fn bodies_stand_beside_the_signals() {
        let study = StudyResult { flexible: Some(found()), ..StudyResult::default() };
        let summary = study_summary(&study);
        let body = &summary["flexible"]["bodies"]["link3"];
        assert_eq!(body["peak"]["von_mises"], json!({ "value": 142.0, "unit": "MPa" }));
        assert_eq!(body["peak"]["relative_error"], json!(0.05));
        assert_eq!(body["peak"]["fatigue"]["life"], json!(5e6));
        assert_eq!((body["hot_spots"].as_array().unwrap().len(), body["singular"].as_array().unwrap().len()), (1, 1));
        assert_eq!(body["checks"]["rigid_inertia"]["passed"], json!(false));
        assert_eq!(body["singular"][0]["fatigue"], Value::Null);
        assert!(summary.get("signals").is_some());
        assert!(study_summary(&StudyResult::default()).get("flexible").is_none());
    }
}
