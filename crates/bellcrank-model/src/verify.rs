//! Reference numbers beside computed ones: `verify/cases/<id>/` and `models/*/`.
//!
//! A folder holds a model and a `reference.toml` (model `model.toml`) or `expected.toml` (which names its model); the
//! numbers of a second model there stand in `NAME.expected.toml`. Each has
//! `kind`, `source` and a list `[[check]]`. A check takes one number: a `signal` of a `study` at a row (`at`, the
//! first one unless given), a `reduce` expression over the rows, a `scalar` of the study or of the mechanism
//! (`bodies`, `joints`, `loops`, `degrees_of_freedom`, `redundant`), or whether a reaction component is determined by
//! equilibrium alone (`unique = "joint.fx"`). It has a `value` and may differ by `rtol·|value| + atol`.
//!
//! `summary` is a path into the study's `summary.json`, such as `sensitivity.l32.relative`, `variables.l5.value` or
//! `starts.0.point.l5`. Value and tolerances are then plain numbers in the unit shown there; `unit` says which that is,
//! and is held against it. True and false are 1 and 0, `null` agrees with nothing. A text is compared by `text`.

mod compare;
mod reference;
mod summary;

use std::path::Path;

/// One number compared.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Study it belongs to; empty for facts of the mechanism.
    pub study: String,
    /// What was compared: a signal or scalar, how it is reduced, where.
    pub what: String,
    /// Computed, in the unit.
    pub value: f64,
    /// Reference, in the unit.
    pub reference: f64,
    /// Unit of all numbers; empty for a pure number.
    pub unit: String,
    /// Absolute difference.
    pub error: f64,
    /// Allowed difference.
    pub allowed: f64,
    /// Within what is allowed.
    pub passed: bool,
}

/// What one case came to.
#[derive(Clone, Debug, Default)]
pub struct CaseReport {
    /// Name of the folder.
    pub name: String,
    /// `analytic`, `literature`, `other-code` or `regression`.
    pub kind: String,
    /// Where the reference comes from.
    pub source: String,
    /// Every comparison.
    pub comparisons: Vec<Comparison>,
    /// What kept the case, or one of its checks, from being run or compared; empty when all was.
    pub faults: Vec<String>,
}

impl CaseReport {
    /// Every comparison passed and nothing was in the way.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.faults.is_empty() && !self.comparisons.is_empty() && self.comparisons.iter().all(|c| c.passed)
    }
}

/// Runs a model and compares it with reference numbers: those of a file, or of `reference.toml` or `expected.toml` in a
/// folder.
#[must_use]
pub fn run_case(case: &Path) -> CaseReport {
    let mut report = CaseReport { name: case_name(case), ..CaseReport::default() };
    if let Err(faults) = reference::read(case).and_then(|reference| compare::run(&reference, &mut report)) {
        report.faults.extend(faults);
    }
    report
}

/// The folder's name, with that of the model where the folder has more than one.
#[must_use]
pub fn case_name(case: &Path) -> String {
    let last = |path: &Path| path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    if case.extension().is_none_or(|extension| extension != "toml") {
        return last(case);
    }
    let folder = last(case.parent().unwrap_or(Path::new("")));
    last(case).strip_suffix(".expected.toml").map_or_else(|| folder.clone(), |model| format!("{folder}/{model}"))
}
