//! One number with a sign for six components of stress.
//!
//! None of them is a critical plane. Where principal directions turn during a history (not proportional), every one can
//! err to either side.

use crate::{Six, principal, von_mises};

/// Below this share of von Mises' stress a mean pressure is rounding, and has no sign.
const NOISE: f64 = 1e-9;

/// How six components become one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Equivalent {
    /// Von Mises' stress, negative under pressure (negative hydrostatic part). In pure shear, which has no such part, it
    /// never turns negative, so that the range of an alternating shear comes out at half: unsafe there.
    VonMises,
    /// Von Mises' stress with the sign of the principal stress of largest size; the same holds of pure shear.
    VonMisesByPrincipal,
    /// The principal stress of largest size, with its sign: for brittle metals.
    Principal,
    /// Von Mises' stress, with the sign of its deviator's product with that of a reference: exact for every
    /// proportional history, pure shear too. See [`Equivalent::proportional`].
    Proportional {
        /// Stress whose direction counts as positive or negative by `sign`.
        reference: Six,
        /// Sign of the reference itself.
        sign: f64,
    },
}

impl Equivalent {
    /// With the stress of the history that has the largest von Mises' stress as reference, positive or negative as its
    /// hydrostatic part is.
    pub fn proportional<'a>(history: impl IntoIterator<Item = &'a Six>) -> Self {
        let larger = |a: &(f64, Six), b: &(f64, Six)| a.0.total_cmp(&b.0);
        let worst = history.into_iter().map(|stress| (von_mises(stress), *stress)).max_by(larger);
        let reference = worst.map_or([0.0; 6], |(_, stress)| stress);
        Equivalent::Proportional { reference, sign: pressure_sign(&reference) }
    }

    /// In the unit of the stress.
    pub fn of(&self, stress: &Six) -> f64 {
        match self {
            Equivalent::VonMises => pressure_sign(stress) * von_mises(stress),
            Equivalent::VonMisesByPrincipal => largest_principal(stress).signum() * von_mises(stress),
            Equivalent::Principal => largest_principal(stress),
            Equivalent::Proportional { reference, sign } => {
                let along = if deviator_product(stress, reference) < 0.0 { -sign } else { *sign };
                along * von_mises(stress)
            }
        }
    }
}

fn pressure_sign(stress: &Six) -> f64 {
    let trace = stress[0] + stress[1] + stress[2];
    if trace < -NOISE * von_mises(stress) { -1.0 } else { 1.0 }
}

/// Tension where tension and pressure are the same but for rounding.
fn largest_principal(stress: &Six) -> f64 {
    let [first, _, third] = principal(stress);
    if -third > first + NOISE * von_mises(stress) { third } else { first }
}

/// s : s' of the deviators.
fn deviator_product(a: &Six, b: &Six) -> f64 {
    let mean = |s: &Six| (s[0] + s[1] + s[2]) / 3.0;
    let normal: f64 = (0..3).map(|i| (a[i] - mean(a)) * (b[i] - mean(b))).sum();
    normal + 2.0 * (3..6).map(|i| a[i] * b[i]).sum::<f64>()
}
