//! Sizing against standards, catalogues, textbooks and identities.

mod air;
mod any_input;
mod buckling;
mod catalogue;
mod cylinders;
mod drives;
mod duty;
mod flow;
mod forces;

/// Relative difference within a tolerance.
#[track_caller]
pub(crate) fn near(found: f64, expected: f64, tolerance: f64) {
    let scale = expected.abs().max(f64::MIN_POSITIVE);
    assert!((found - expected).abs() <= tolerance * scale, "found {found}, expected {expected}");
}
