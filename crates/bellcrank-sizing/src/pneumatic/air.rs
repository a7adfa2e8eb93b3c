//! Free air that a cylinder takes.
//!
//! Free air is air at the reference of ISO 8778 (ANR): 100 kPa absolute, 20 °C, 65 % relative humidity. Air in the
//! cylinder is taken as back at 20 °C when it is vented.

use crate::pneumatic::force::{annulus_area, piston_area};

/// Absolute pressure of free air, Pa (ISO 8778).
pub const FREE_AIR_PRESSURE: f64 = 1e5;
/// Temperature of free air, K (ISO 8778).
pub const FREE_AIR_TEMPERATURE: f64 = 293.15;
/// Density of free air, kg/m³ (ISO 8778).
pub const FREE_AIR_DENSITY: f64 = 1.185;

/// Free air in a volume, m³, at an absolute pressure, Pa: V p / p_ANR.
pub fn free_air(volume: f64, absolute_pressure: f64) -> f64 {
    volume * absolute_pressure / FREE_AIR_PRESSURE
}

/// Free air of one double stroke, m³ (m, m, m, gauge Pa, Pa, m³).
///
/// Each side is swept from nothing to full and counts with the absolute pressure, (A + A_annulus) s (p + p_atm) /
/// p_ANR. The dead volume (tubes, ports; both sides together) still holds air of atmosphere when it is filled and
/// counts with the gauge pressure, V p / p_ANR, as in makers' formulas for tubes.
pub fn per_double_stroke(bore: f64, rod: f64, stroke: f64, gauge: f64, atmosphere: f64, dead_volume: f64) -> f64 {
    let swept = (piston_area(bore) + annulus_area(bore, rod)) * stroke;
    free_air(swept, gauge + atmosphere) + free_air(dead_volume, gauge)
}

/// Flow of free air into a chamber, m³/s, that grows at a speed, m/s, under an absolute pressure, Pa.
pub fn filling_flow(area: f64, speed: f64, absolute_pressure: f64) -> f64 {
    free_air(area * speed, absolute_pressure)
}
