//! Natural frequencies, damping and mode shapes.

use crate::Unit;

/// How a machine rings about a position.
#[derive(Clone, Debug)]
pub struct Modes {
    /// Degrees of freedom that nothing holds.
    pub freedom: usize,
    /// Modes there are.
    pub all: usize,
    /// The position is an equilibrium that was looked for.
    pub at_equilibrium: bool,
    /// Those that are told, slowest first.
    pub modes: Vec<ModeRow>,
}

/// One mode.
#[derive(Clone, Debug)]
pub struct ModeRow {
    /// Real and imaginary part, 1/s.
    pub eigenvalue: [f64; 2],
    /// Undamped natural frequency, Hz.
    pub frequency: f64,
    /// Damping ratio.
    pub damping: f64,
    /// In the order of the file.
    pub shape: Vec<ShapeRow>,
}

/// How much a coordinate takes part in a mode.
#[derive(Clone, Debug)]
pub struct ShapeRow {
    /// Joint, or `J.1`.
    pub coordinate: String,
    /// SI unit of the amplitude: m or rad.
    pub unit: Unit,
    /// Real and imaginary part; the largest of a mode is 1 m or 1 rad.
    pub amplitude: [f64; 2],
}

/// What a mode does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// Swings, and dies away or goes on for ever.
    Oscillation,
    /// Returns without swinging.
    Decay,
    /// Moves freely: nothing brings it back.
    Drift,
    /// Grows.
    Growth,
}

/// Below this share of the largest eigenvalue a part of one counts as zero: double roots at zero spread to the root of
/// the rounding.
const NOTHING: f64 = 1e-7;

impl Modes {
    /// What a mode does.
    pub fn kind(&self, mode: &ModeRow) -> ModeKind {
        let size = |mode: &ModeRow| mode.eigenvalue[0].hypot(mode.eigenvalue[1]);
        let nothing = NOTHING * self.modes.iter().map(size).fold(0.0, f64::max);
        let [re, im] = mode.eigenvalue;
        match (re > nothing, im.abs() > nothing, size(mode) > nothing) {
            (true, ..) => ModeKind::Growth,
            (_, true, _) => ModeKind::Oscillation,
            (_, _, true) => ModeKind::Decay,
            _ => ModeKind::Drift,
        }
    }
}

impl ModeKind {
    /// One or two words.
    pub fn words(self) -> &'static str {
        match self {
            ModeKind::Oscillation => "oscillates",
            ModeKind::Decay => "decays",
            ModeKind::Drift => "moves freely",
            ModeKind::Growth => "GROWS",
        }
    }
}

impl ShapeRow {
    /// Size of the amplitude.
    pub fn size(&self) -> f64 {
        self.amplitude[0].hypot(self.amplitude[1])
    }

    /// By how much it is ahead of the others' common clock, rad.
    pub fn phase(&self) -> f64 {
        self.amplitude[1].atan2(self.amplitude[0])
    }
}
