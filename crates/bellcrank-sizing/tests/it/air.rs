//! Air consumption: examples of a maker and of a dealer, identities.

use bellcrank_sizing::pneumatic::air::{FREE_AIR_PRESSURE, filling_flow, free_air, per_double_stroke};

use crate::near;

/// Pneumax, general catalogue, appendix "Cylinder air consumption": ISO 15552, 63 x 20, stroke 50 mm, 6 bar
/// (7 bar absolute): 2.072 normal litres a double stroke (the catalogue's areas have π = 3.14).
#[test]
fn the_catalogues_cylinder_takes_2_072_litres() {
    near(per_double_stroke(0.063, 0.020, 0.05, 6e5, 1e5, 0.0) * 1e3, 2.072, 5e-4);
}

/// Mead Fluid Dynamics, "How do I calculate the air consumption of a cylinder": 2 in bore, 4 in stroke, the rod left
/// out, 30 cycles a minute at 80 psi: 2.81 cubic feet a minute of air at 14.7 psi.
#[test]
fn the_dealers_cylinder_takes_2_81_cubic_feet_a_minute() {
    let (inch, psi) = (0.0254, 6894.757);
    let free = per_double_stroke(2.0 * inch, 0.0, 4.0 * inch, 80.0 * psi, 14.7 * psi, 0.0);
    let at_sea_level = free * FREE_AIR_PRESSURE / (14.7 * psi);
    near(at_sea_level * 30.0 / (12.0 * inch).powi(3), 2.81, 2e-3);
}

/// Dead volume is filled from atmosphere, not from nothing.
#[test]
fn dead_volume_counts_with_the_gauge_pressure() {
    let with = per_double_stroke(0.063, 0.020, 0.05, 6e5, 1.013e5, 1e-4);
    near(with - per_double_stroke(0.063, 0.020, 0.05, 6e5, 1.013e5, 0.0), free_air(1e-4, 6e5), 1e-12);
}

/// Filling both sides at a speed for as long as the stroke takes is one double stroke.
#[test]
fn flow_over_time_is_the_double_stroke() {
    let (bore, rod, stroke, speed): (f64, f64, f64, f64) = (0.08, 0.025, 0.16, 0.3);
    let area = std::f64::consts::PI / 4.0;
    let flow = filling_flow(area * bore * bore, speed, 7.013e5)
        + filling_flow(area * (bore * bore - rod * rod), speed, 7.013e5);
    near(flow * stroke / speed, per_double_stroke(bore, rod, stroke, 6e5, 1.013e5, 0.0), 1e-13);
}
