//! What arrives at the end of the stroke.

/// Kinetic energy, J, of a mass, kg, at a speed, m/s: m v² / 2.
pub fn kinetic_energy(mass: f64, speed: f64) -> f64 {
    mass * speed * speed / 2.0
}

/// Kinetic energy and the work of a force, N, that goes on driving over the length of a shock absorber, m (weight,
/// pressure): what an external absorber must take. Makers rate built-in cushions by kinetic energy alone.
pub fn absorber_energy(mass: f64, speed: f64, force: f64, length: f64) -> f64 {
    kinetic_energy(mass, speed) + force * length
}

/// The fastest arrival, m/s, of a mass, kg, that a cushion of an energy, J, takes. Infinite at mass 0.
pub fn fastest_arrival(energy: f64, mass: f64) -> f64 {
    (2.0 * energy / mass).sqrt()
}
