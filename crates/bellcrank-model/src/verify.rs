//! Reference numbers beside computed ones: `verify/cases/<id>/` and `models/*/expected.toml`.

use std::path::Path;

/// One number compared.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Study it belongs to.
    pub study: String,
    /// What was compared: a signal or scalar, how it is reduced, where.
    pub what: String,
    /// Computed, in the unit of the reference.
    pub value: f64,
    /// Reference.
    pub reference: f64,
    /// Unit of both; empty for SI or a pure number.
    pub unit: String,
    /// Absolute difference.
    pub error: f64,
    /// Allowed difference.
    pub allowed: f64,
    /// Within what is allowed.
    pub passed: bool,
}

/// What one case came to.
#[derive(Clone, Debug)]
pub struct CaseReport {
    /// Name of the folder.
    pub name: String,
    /// `analytic`, `literature`, `other-code` or `regression`.
    pub kind: String,
    /// Where the reference comes from.
    pub source: String,
    /// Every comparison.
    pub comparisons: Vec<Comparison>,
    /// What kept the case from being run or compared; empty when all was.
    pub faults: Vec<String>,
}

impl CaseReport {
    /// Every comparison passed and nothing was in the way.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.faults.is_empty() && self.comparisons.iter().all(|c| c.passed)
    }
}

/// Runs the model of a folder and compares it with `reference.toml` or `expected.toml` in it.
#[must_use]
pub fn run_case(_folder: &Path) -> CaseReport {
    todo!()
}
