//! What the motions of a study move when.

use crate::Unit;

/// The moves of a study, in the order of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Programme {
    /// Unit of all times.
    pub time: Unit,
    /// The moves, by their beginnings.
    pub moves: Vec<Move>,
}

/// A motion of one coordinate, or one segment of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// Name of the motion.
    pub motion: String,
    /// The coordinate: a joint, or `joint.1`.
    pub joint: String,
    /// Name of the segment, or its number from 1; `None` where the motion is one piece.
    pub segment: Option<String>,
    /// How it goes: a profile, `hold`, `table`, `expression` or `velocity`.
    pub profile: &'static str,
    /// s.
    pub start: f64,
    /// s; `None` when it never ends.
    pub end: Option<f64>,
    /// Position at the start, SI.
    pub from: f64,
    /// Position at the end, SI; `None` when it never ends.
    pub to: Option<f64>,
    /// Unit of the positions.
    pub unit: Unit,
}

impl Move {
    /// It keeps its position.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.profile == "hold"
    }
}
