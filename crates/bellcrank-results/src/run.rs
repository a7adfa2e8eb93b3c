//! What one run of a model leaves.

use crate::{Drawing, StudyResult, Unit};

/// A parameter as it was used.
#[derive(Clone, Debug)]
pub struct ParameterRow {
    /// Name.
    pub name: String,
    /// As written in the file (or on the command line).
    pub written: String,
    /// SI value.
    pub value: f64,
    /// Display unit.
    pub unit: Unit,
    /// Bounds (SI), where given.
    pub bounds: (Option<f64>, Option<f64>),
    /// The author's note.
    pub note: String,
}

/// What made the result.
#[derive(Clone, Debug)]
pub struct Provenance {
    /// Version of bellcrank.
    pub version: String,
    /// Path of the model file as given.
    pub file: String,
    /// Hash of the model text (hex).
    pub hash: String,
    /// Date and time, ISO 8601.
    pub date: String,
}

/// What one run of a model leaves.
#[derive(Clone, Debug)]
pub struct RunResult {
    /// Model name (file stem).
    pub model: String,
    /// Title from the file.
    pub title: String,
    /// What made it.
    pub provenance: Provenance,
    /// Parameters as used.
    pub parameters: Vec<ParameterRow>,
    /// Facts about the mechanism: label and text (bodies, joints, degrees of freedom, loops, ...).
    pub facts: Vec<(String, String)>,
    /// The stick drawing.
    pub drawing: Drawing,
    /// Studies in the order they were run.
    pub studies: Vec<StudyResult>,
    /// Sentences about the model as a whole.
    pub warnings: Vec<String>,
}
