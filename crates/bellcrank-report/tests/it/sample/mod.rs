//! Results to report on, made from closed forms: no solver is needed to test a report.

pub mod drive;
pub mod flexible;
pub mod forward;
pub mod kinds;
pub mod lift;
pub mod stewart;
pub mod stress;

use bellcrank_results::{Column, ParameterRow, Pose, Provenance, Unit};

/// 601 rows from −30 to 30 degrees, as in the model file.
pub fn unit(symbol: &str) -> Unit {
    let factor = match symbol {
        "mm" | "mm/s" | "mm/s^2" => 1e-3,
        "deg" | "deg/s" | "deg/s^2" => std::f64::consts::PI / 180.0,
        _ => 1.0,
    };
    Unit::new(symbol, factor)
}

pub fn column(name: impl Into<String>, symbol: &str, values: Vec<f64>) -> Column {
    Column { name: name.into(), unit: unit(symbol), values }
}

pub fn provenance(file: &str) -> Provenance {
    Provenance {
        version: "0.1.0".to_owned(),
        file: file.to_owned(),
        hash: "9f2c1e7a5b3d4f6880a1c2e3d4f5a6b7".to_owned(),
        date: "2026-03-14T09:26:53+01:00".to_owned(),
    }
}

pub fn parameter(
    name: &str,
    written: &str,
    value: f64,
    symbol: &str,
    bounds: Option<(f64, f64)>,
    note: &str,
) -> ParameterRow {
    ParameterRow {
        name: name.to_owned(),
        written: written.to_owned(),
        value,
        unit: unit(symbol),
        bounds: (bounds.map(|b| b.0), bounds.map(|b| b.1)),
        note: note.to_owned(),
    }
}

pub fn planar_pose(x: f64, y: f64, angle: f64) -> Pose {
    let (sin, cos) = (angle / 2.0).sin_cos();
    Pose { position: [x, y, 0.0], quaternion: [cos, 0.0, 0.0, sin] }
}

/// Rate of change along the rows: central differences over `dt` a row (s), one-sided at the ends.
pub fn rate(values: &[f64], dt: &[f64]) -> Vec<f64> {
    let last = values.len() - 1;
    let at = |i: usize| {
        let (a, b) = (i.saturating_sub(1), (i + 1).min(last));
        (values[b] - values[a]) / ((b - a) as f64 * dt[i])
    };
    (0..values.len()).map(at).collect()
}
