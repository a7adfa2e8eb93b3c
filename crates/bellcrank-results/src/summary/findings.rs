//! What studies over other studies found: keys of their own, one file a kind.

mod designs;
mod modes;
mod optimization;
mod sensitivity;
mod sizing;
mod stress;
mod tolerance;

use serde_json::{Map, Value};

use crate::Findings;

/// The keys that stand beside `kind`, `rows`, `seconds`, ... of the study.
pub(super) fn keys(findings: &Findings) -> Map<String, Value> {
    match findings {
        Findings::Sensitivity(found) => sensitivity::keys(found),
        Findings::Optimization(found) => optimization::keys(found),
        Findings::Designs(found) => designs::keys(found),
        Findings::Tolerance(found) => tolerance::keys(found),
        Findings::Modes(found) => modes::keys(found),
        Findings::Sizing(found) => sizing::keys(found),
        Findings::Stress(found) => stress::keys(found),
        Findings::BodyModes(found) => stress::mode_keys(found),
    }
}

#[cfg(test)]
mod tests;
