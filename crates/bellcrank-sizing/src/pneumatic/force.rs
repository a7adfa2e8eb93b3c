//! Areas, forces, and the pressure that a force needs.

use std::f64::consts::PI;

use crate::{Duty, Row};

/// Area of a circle, m², from its diameter, m.
pub fn circle(diameter: f64) -> f64 {
    PI / 4.0 * diameter * diameter
}

/// Area the pressure pushes the rod out on, m²: the whole piston.
pub fn piston_area(bore: f64) -> f64 {
    circle(bore)
}

/// Area the pressure pulls the rod in on, m²: the piston less the rod.
pub fn annulus_area(bore: f64, rod: f64) -> f64 {
    circle(bore) - circle(rod)
}

/// Theoretical push, N, at a gauge pressure, Pa: F = p A.
pub fn push(bore: f64, pressure: f64) -> f64 {
    pressure * piston_area(bore)
}

/// Theoretical pull, N, at a gauge pressure, Pa: F = p (A − A_rod).
pub fn pull(bore: f64, rod: f64, pressure: f64) -> f64 {
    pressure * annulus_area(bore, rod)
}

/// The side of the piston that is under pressure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The full piston: pushes.
    Piston,
    /// The ring around the rod: pulls.
    Rod,
}

/// The pressure a row needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkingPressure {
    /// Drive coordinate, m.
    pub position: f64,
    /// The side it acts on.
    pub side: Side,
    /// Gauge pressure, Pa, the other side at atmosphere: |F| / (A η). Never negative.
    pub pressure: f64,
}

/// Gauge pressure, Pa, and side for an effort, N; `efficiency` is the share of p A that reaches the rod.
pub fn working_pressure(effort: f64, bore: f64, rod: f64, efficiency: f64) -> (Side, f64) {
    if effort >= 0.0 {
        (Side::Piston, effort / (piston_area(bore) * efficiency))
    } else {
        (Side::Rod, -effort / (annulus_area(bore, rod) * efficiency))
    }
}

/// The working pressure over the stroke, one value a row. The other side is taken as vented; a throttled exhaust
/// adds to it.
pub fn working_pressures(duty: &Duty, bore: f64, rod: f64, efficiency: f64) -> Vec<WorkingPressure> {
    let at = |row: &Row| {
        let (side, pressure) = working_pressure(row.effort, bore, rod, efficiency);
        WorkingPressure { position: row.position, side, pressure }
    };
    duty.rows().iter().map(at).collect()
}
