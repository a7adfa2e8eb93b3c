//! What one study leaves.

use crate::{Animation, Contour, FlexibleMotion, ParameterRow, Table};

/// Why a study stopped before its end.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Which study, where, which joints.
    pub message: String,
    /// What to try.
    pub hints: Vec<String>,
}

/// How a joint's reaction stands to the redundancy of the mechanism.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Joint name.
    pub joint: String,
    /// Joint kind, as in the file.
    pub kind: String,
    /// For each component (`fx`, `fy`, ..., `mz`): whether equilibrium alone determines it.
    pub unique: Vec<(String, bool)>,
}

/// A file that a study leaves when asked for it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attachment {
    /// Name of the file.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

/// What one study leaves: its rows and everything said about them.
#[derive(Clone, Debug, Default)]
pub struct StudyResult {
    /// Study name.
    pub name: String,
    /// Study kind, e.g. `inverse-dynamics`.
    pub kind: String,
    /// Parameters that this study overrides (`set`), with the values it used; empty for most.
    pub changed: Vec<ParameterRow>,
    /// Names of the columns the rows are counted by: the swept coordinate, or `time`.
    pub axis: Vec<String>,
    /// All signals.
    pub table: Table,
    /// Reactions and their uniqueness.
    pub reactions: Vec<Reaction>,
    /// Body poses a row, for the moving drawing.
    pub animation: Option<Animation>,
    /// Single numbers beside the rows: name, SI value, unit (e.g. eigenvalues of an equilibrium).
    pub scalars: Vec<(String, f64, crate::Unit)>,
    /// What its motions move when, of studies over time.
    pub programme: Option<crate::Programme>,
    /// What happened, of studies in which something can.
    pub events: Option<crate::Events>,
    /// What it found beside its rows: of studies over another study, and modes.
    pub findings: Option<crate::Findings>,
    /// Pictures of parts with stress or mode shapes on them.
    pub contours: Vec<Contour>,
    /// Its flexible bodies: how they were reduced, and stress in them over the rows.
    pub flexible: Option<crate::FlexibleBodies>,
    /// Flexible bodies row by row, for the moving drawing.
    pub motions: Vec<FlexibleMotion>,
    /// Files that were asked for: meshes with their results.
    pub attachments: Vec<Attachment>,
    /// Sentences for the reader.
    pub warnings: Vec<String>,
    /// Solver effort by name (`newton_iterations`, `factorizations`, ...).
    pub effort: Vec<(String, f64)>,
    /// Wall time of the solution in seconds.
    pub seconds: f64,
    /// Set when the study stopped early; the rows before are kept.
    pub failure: Option<Failure>,
}
