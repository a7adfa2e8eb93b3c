//! Mean stress: which amplitude about zero (R = −1) does the same damage.

/// How a mean stress is counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeanStress {
    /// Not at all.
    None,
    /// a / (1 − m/R_m) for a tensile mean, with the tensile strength in Pa; compression is no help. Goodman 1899.
    Goodman {
        /// R_m, Pa.
        tensile: f64,
    },
    /// Haigh diagram of four straight pieces with the mean stress sensitivity M (FKM guideline "Rechnerischer
    /// Festigkeitsnachweis für Maschinenbauteile", 6th edition 2012): slope M for R ≤ 0, M/3 for 0 < R < ½, none beyond
    /// and in compression throughout.
    Fkm {
        /// M, between 0 and 1.
        sensitivity: f64,
    },
}

/// Groups of metals that the FKM guideline gives a mean stress sensitivity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MetalGroup {
    /// Rolled and forged steel.
    Steel,
    /// Cast steel.
    CastSteel,
    /// Nodular cast iron.
    NodularIron,
    /// Malleable cast iron.
    MalleableIron,
    /// Grey cast iron.
    GreyIron,
    /// Wrought aluminium alloys.
    WroughtAluminium,
    /// Cast aluminium alloys.
    CastAluminium,
}

impl MetalGroup {
    /// M = a R_m / 1000 MPa + b for normal stress; tensile strength in Pa. Not below 0.
    pub fn sensitivity(self, tensile: f64) -> f64 {
        let (a, b) = match self {
            MetalGroup::Steel => (0.35, -0.1),
            MetalGroup::CastSteel => (0.35, 0.05),
            MetalGroup::NodularIron => (0.35, 0.08),
            MetalGroup::MalleableIron => (0.35, 0.13),
            MetalGroup::GreyIron => (0.0, 0.5),
            MetalGroup::WroughtAluminium => (1.0, -0.04),
            MetalGroup::CastAluminium => (1.0, 0.2),
        };
        (a * tensile / 1e9 + b).max(0.0)
    }
}

impl MeanStress {
    /// Amplitude at R = −1 that does the damage of `amplitude` about `mean`; infinite where the mean alone breaks it.
    pub fn equivalent(&self, amplitude: f64, mean: f64) -> f64 {
        match *self {
            MeanStress::None => amplitude,
            // Also a compressive mean: cracks that it keeps shut are not relied on.
            MeanStress::Goodman { .. } if mean <= 0.0 => amplitude,
            MeanStress::Goodman { tensile } if mean >= tensile => f64::INFINITY,
            MeanStress::Goodman { tensile } => amplitude / (1.0 - mean / tensile),
            MeanStress::Fkm { sensitivity } => fkm(sensitivity, amplitude, mean),
        }
    }
}

/// The borders are R = ±∞, 0 and ½: mean = −a, a and 3a; beyond the outer ones the ratio of mean to amplitude counts as there.
fn fkm(m: f64, amplitude: f64, mean: f64) -> f64 {
    let mean = mean.clamp(-amplitude, 3.0 * amplitude);
    if mean <= amplitude { amplitude + m * mean } else { (1.0 + m) * (amplitude + m / 3.0 * mean) / (1.0 + m / 3.0) }
}
