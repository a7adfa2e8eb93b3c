//! Standard drives that carry the loads.

use crate::Unit;

/// What a sizing study found. The working pressure over the stroke is in the study's table.
#[derive(Clone, Debug)]
pub struct Sizing {
    /// Name of the study that gives the loads.
    pub of: String,
    /// The driven joint.
    pub drive: String,
    /// `pneumatic`, `electric-linear` or `electric-rotary`.
    pub kind: String,
    /// What the drive must do: stroke, peak efforts, speed, power.
    pub requirements: Vec<Property>,
    /// Assumptions: supply pressure, load factor, end conditions, safety.
    pub conditions: Vec<Property>,
    /// All candidates: those that pass first, smallest first; then the others, the nearest first.
    pub candidates: Vec<Candidate>,
    /// The one proposed.
    pub chosen: Option<usize>,
    /// Where none passes: the one whose worst check is missed by least.
    pub nearest: Option<usize>,
}

/// A labelled number.
#[derive(Clone, Debug)]
pub struct Property {
    /// Key for JSON, e.g. `peak_push`.
    pub key: String,
    /// Label for readers, e.g. `peak push`.
    pub label: String,
    /// SI value.
    pub value: f64,
    /// Display unit.
    pub unit: Unit,
}

/// A drive from the catalogue.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Name, e.g. `ISO 15552 63 x 20, stroke 160`.
    pub name: String,
    /// It passes every check.
    pub passes: bool,
    /// What it is: bore, rod, stroke, forces, air consumption.
    pub properties: Vec<Property>,
    /// Every check, in the order of importance.
    pub checks: Vec<Check>,
}

/// One check.
#[derive(Clone, Debug)]
pub struct Check {
    /// Key for JSON, e.g. `push`.
    pub key: String,
    /// What is needed, SI.
    pub needed: f64,
    /// What there is, SI; NaN where the catalogue does not say.
    pub available: f64,
    /// Unit of both.
    pub unit: Unit,
    /// `Some(false)` fails, `None` was not checked.
    pub passes: Option<bool>,
    /// In words with numbers.
    pub reason: String,
}
