//! Flexible bodies of a study: how they were reduced, and the stress in them over its rows.

use super::MeshRow;
use crate::Unit;

/// The flexible bodies of a study.
#[derive(Clone, Debug)]
pub struct FlexibleBodies {
    /// Each body.
    pub bodies: Vec<FlexibleBody>,
    /// What life under repeated load is based on, in sentences; empty where no life was worked out.
    pub assumptions: Vec<String>,
    /// Unit of stresses.
    pub unit: Unit,
    /// Unit of lengths.
    pub length: Unit,
}

/// One flexible body.
#[derive(Clone, Debug)]
pub struct FlexibleBody {
    /// Name.
    pub body: String,
    /// Its solid or beam, and its material.
    pub solid: String,
    /// See `solid`.
    pub material: String,
    /// Yield strength, Pa.
    pub strength: Option<f64>,
    /// How the interfaces take hold of it: `rigid` or `distributing`; empty where they are ends of a beam.
    pub coupling: String,
    /// Points where it is held, the one that carries its floating frame first.
    pub interfaces: Vec<String>,
    /// Elastic coordinates it has.
    pub coordinates: usize,
    /// Its modes with the interfaces held, slowest first.
    pub modes: Vec<KeptMode>,
    /// Whether tension stiffens it.
    pub stiffening: bool,
    /// The mesh; none of a beam.
    pub mesh: Option<MeshRow>,
    /// Mass as reduced and of the solid, kg.
    pub mass: [f64; 2],
    /// What was checked of the reduction.
    pub checks: Vec<ReductionCheck>,
    /// The reduction was taken from the cache.
    pub cached: bool,
    /// Largest stress that can be trusted: place in `spots`.
    pub peak: Option<usize>,
    /// Each bore, each fillet and hole, and the rest: where its stress is largest over the rows. Empty where stress
    /// was not recovered.
    pub spots: Vec<SpotHistory>,
    /// How far the numbers of `spots` can be trusted, in a sentence; empty without.
    pub error: String,
    /// How far it was deformed.
    pub deformation: Option<Deformation>,
}

/// A mode with all interfaces held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeptMode {
    /// Natural frequency, Hz.
    pub frequency: f64,
    /// Damping ratio.
    pub damping: f64,
}

/// A number that shows whether a reduction can be trusted.
#[derive(Clone, Debug, PartialEq)]
pub struct ReductionCheck {
    /// Key in the summary, e.g. `rigid_inertia`.
    pub key: String,
    /// What it is, e.g. `inertia as a rigid body against that of the solid`.
    pub meaning: String,
    /// Relative error or residual.
    pub value: f64,
    /// Up to where it counts as passed; none where it is only told.
    pub limit: Option<f64>,
}

/// The stress of a region over the rows.
#[derive(Clone, Debug)]
pub struct SpotHistory {
    /// `bore B`, `fillet at [732, -60] mm`, `elsewhere`.
    pub region: String,
    /// Place of the largest stress, body axes, m.
    pub at: [f64; 3],
    /// Largest von Mises stress of the region over the rows, Pa.
    pub value: f64,
    /// Row of the table where that is.
    pub row: usize,
    /// Where the machine was in that row, in words.
    pub place: String,
    /// Estimate of the error of `value`, Pa.
    pub error: Option<f64>,
    /// Largest and smallest principal stress there and then, Pa.
    pub principal: [f64; 2],
    /// Yield strength over the stress, less one.
    pub margin: Option<f64>,
    /// Why the number means nothing.
    pub singular: Option<&'static str>,
    /// Signal of the study's table with the largest stress of its region row by row; empty without.
    pub signal: String,
    /// Life under repeats of the study.
    pub fatigue: Option<Fatigue>,
}

/// Rainflow cycles of a history against a Woehler line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fatigue {
    /// Share of the life that one repeat of the study uses up.
    pub damage: f64,
    /// Repeats until it is used up; none where every cycle is below the endurance limit.
    pub life: Option<f64>,
    /// Largest amplitude, Pa.
    pub amplitude: f64,
    /// Mean of that cycle, Pa.
    pub mean: f64,
    /// Cycles of a repeat, halves counted as halves.
    pub cycles: f64,
}

/// How far a body left its undeformed shape, against its floating frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Deformation {
    /// Largest displacement of a node, m.
    pub displacement: f64,
    /// That over the largest extent of the body.
    pub share: f64,
    /// Largest turn of an interface, rad.
    pub turn: f64,
    /// Where the machine was, in words.
    pub place: String,
    /// Share above which linear theory is doubtful.
    pub limit: f64,
}

impl FlexibleBody {
    /// The largest stress that can be trusted.
    pub fn peak(&self) -> Option<&SpotHistory> {
        self.spots.get(self.peak?)
    }
}

impl SpotHistory {
    /// Its error, relative to the value.
    pub fn relative_error(&self) -> Option<f64> {
        self.error.filter(|_| self.value > 0.0).map(|error| error / self.value)
    }
}

impl ReductionCheck {
    /// Whether it is within its limit, where it has one.
    pub fn passed(&self) -> Option<bool> {
        self.limit.map(|limit| self.value <= limit)
    }
}
