//! Buckling of the piston rod after Euler.
//!
//! F_cr = π² E I / (K L)² with I = π d⁴ / 64 (e.g. Roloff/Matek, Maschinenelemente; Hänchen,
//! calculation of hydraulic cylinders, gives the same with a safety of 3 to 5). The whole column is taken as thick as
//! the rod; the tube is stiffer, so this is on the safe side, most of all for [`Mount::Rear`].
//!
//! Euler's formula overestimates short columns (slenderness K L / (d/4) below π √(2 E / R_e), about 110 for
//! R_e = 350 MPa). That does no harm here: a rod at 10 bar carries at most p (D/d)², 26 MPa for every ISO 15552
//! and ISO 6432 size, and with a safety of 5 a column that Euler and Johnson judge differently takes more
//! than R_e / 2 / 5 = 35 MPa.

use std::f64::consts::PI;

/// Young's modulus of steel, Pa.
pub const YOUNGS_MODULUS_STEEL: f64 = 2.1e11;

/// How the ends of the column are held (Euler's four cases).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndCondition {
    /// Body clamped, rod end neither guided nor held: K = 2.
    FixedFree,
    /// Both ends turn: rear clevis or trunnion and rod eye: K = 1.
    PinnedPinned,
    /// Body clamped, rod end guided in a pin: K = 0.7 (exactly 0.6992).
    FixedPinned,
    /// Body clamped, rod end guided and clamped: K = 0.5.
    FixedFixed,
}

impl EndCondition {
    /// All of them, softest first.
    pub const ALL: [EndCondition; 4] =
        [EndCondition::FixedFree, EndCondition::PinnedPinned, EndCondition::FixedPinned, EndCondition::FixedFixed];

    /// Length of half a sine wave over the length of the column.
    pub fn factor(self) -> f64 {
        match self {
            EndCondition::FixedFree => 2.0,
            EndCondition::PinnedPinned => 1.0,
            EndCondition::FixedPinned => 0.7,
            EndCondition::FixedFixed => 0.5,
        }
    }
    /// Key for files, e.g. `pinned-pinned`.
    pub fn key(self) -> &'static str {
        match self {
            EndCondition::FixedFree => "fixed-free",
            EndCondition::PinnedPinned => "pinned-pinned",
            EndCondition::FixedPinned => "fixed-pinned",
            EndCondition::FixedFixed => "fixed-fixed",
        }
    }
}

/// Where the body is held: how much of it is part of the column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mount {
    /// At the rear end (clevis, rear trunnion, foot at the back): body and rod, 2 strokes and the base length.
    Rear,
    /// At half the body (centre trunnion): 1.5 strokes and half the base length.
    Centre,
    /// At the front end (flange, front trunnion, feet): the rod alone, 1 stroke.
    Front,
}

impl Mount {
    /// All of them, longest column first.
    pub const ALL: [Mount; 3] = [Mount::Rear, Mount::Centre, Mount::Front];

    /// Key for files: `rear`, `centre`, `front`.
    pub fn key(self) -> &'static str {
        match self {
            Mount::Rear => "rear",
            Mount::Centre => "centre",
            Mount::Front => "front",
        }
    }
    /// Strokes, and base lengths of the body, in the column.
    pub(crate) fn shares(self) -> (f64, f64) {
        match self {
            Mount::Rear => (2.0, 1.0),
            Mount::Centre => (1.5, 0.5),
            Mount::Front => (1.0, 0.0),
        }
    }
}

/// How the cylinder is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mounting {
    /// How the ends are held.
    pub end: EndCondition,
    /// Where the body is held.
    pub at: Mount,
    /// What is added to the length, m: rod eye, extended rod, clevis foot.
    pub offset: f64,
}

impl Mounting {
    /// Length of the column with the rod fully out, m. A base length that the catalogue does
    /// not give counts as 0, which is not on the safe side: put it into `offset`, or into the catalogue.
    pub fn column(&self, stroke: f64, base_length: Option<f64>) -> f64 {
        let (strokes, bases) = self.at.shares();
        strokes * stroke + bases * base_length.unwrap_or(0.0) + self.offset
    }
}

/// Second moment of area of a round rod, m⁴.
pub fn second_moment(diameter: f64) -> f64 {
    PI / 64.0 * diameter.powi(4)
}

/// Euler's load, N, of a round rod of a diameter and a length, m, and Young's modulus, Pa. Infinite at length 0.
pub fn critical_load(diameter: f64, length: f64, end: EndCondition, youngs_modulus: f64) -> f64 {
    PI.powi(2) * youngs_modulus * second_moment(diameter) / (end.factor() * length).powi(2)
}

/// The longest column, m, that carries a force, N, with a safety. Infinite at force 0.
pub fn longest_column(diameter: f64, force: f64, safety: f64, end: EndCondition, youngs_modulus: f64) -> f64 {
    (PI.powi(2) * youngs_modulus * second_moment(diameter) / (force * safety)).sqrt() / end.factor()
}
