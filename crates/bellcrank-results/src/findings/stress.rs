//! Stress in bodies, with its error.

use crate::Unit;

/// What a study of stress found.
#[derive(Clone, Debug)]
pub struct Stress {
    /// Name of the study that gives the loads; empty without one.
    pub of: String,
    /// How the pins bear: `bearing`, `distributing` or `rigid`; empty without joints.
    pub hinges: String,
    /// Error that was asked for, relative.
    pub accuracy: Option<f64>,
    /// Each body.
    pub bodies: Vec<StressBody>,
    /// Unit of stresses.
    pub unit: Unit,
    /// Unit of lengths.
    pub length: Unit,
}

/// Stress in one body.
#[derive(Clone, Debug)]
pub struct StressBody {
    /// Name.
    pub body: String,
    /// Its solid and its material.
    pub solid: String,
    /// See `solid`.
    pub material: String,
    /// Yield strength, Pa.
    pub strength: Option<f64>,
    /// Where the machine was, in words; empty without a study that loads it.
    pub place: String,
    /// Largest stress that can be trusted: place in `spots`.
    pub peak: Option<usize>,
    /// Each bore, each fillet and hole, and the rest.
    pub spots: Vec<HotSpot>,
    /// The estimated errors of all that can be trusted are within what was asked; `None` without that.
    pub reached: Option<bool>,
    /// Each mesh in turn.
    pub meshes: Vec<MeshRow>,
    /// Mass of the mesh and of the solid, kg.
    pub mass: [f64; 2],
    /// Estimated error of the last solution in the energy norm, relative.
    pub energy_error: f64,
    /// Resultant that inertia had to balance beside that of the motion, relative to the largest load.
    pub unbalance: Option<f64>,
    /// Largest force that no equation accounts for, relative.
    pub residual: f64,
    /// Largest displacement, m, and its place, body axes, m.
    pub displacement: (f64, [f64; 3]),
    /// Size of the last solution.
    pub effort: PartEffort,
}

/// The largest von Mises stress of a region.
#[derive(Clone, Debug)]
pub struct HotSpot {
    /// `bore B`, `fillet at [732, -60] mm`, `elsewhere`.
    pub region: String,
    /// Place, body axes, m.
    pub at: [f64; 3],
    /// Von Mises stress, Pa.
    pub value: f64,
    /// Estimate of its error, Pa.
    pub error: f64,
    /// Largest and smallest principal stress there, Pa.
    pub principal: [f64; 2],
    /// Yield strength over the stress, less one.
    pub margin: Option<f64>,
    /// Why the number means nothing: it grows without bound as the mesh gets finer.
    pub singular: Option<&'static str>,
    /// Where the machine was; empty where that is the same for the whole body.
    pub place: String,
}

/// A mesh that was solved on.
#[derive(Clone, Debug)]
pub struct MeshRow {
    /// Nodes.
    pub nodes: usize,
    /// Elements.
    pub elements: usize,
    /// Kind of elements, as Abaqus calls it.
    pub element: String,
    /// Smallest scaled Jacobian.
    pub worst_jacobian: f64,
    /// Largest stress that can be trusted, Pa; NaN where there is none, and for modes.
    pub peak: f64,
    /// Largest relative error of the hot spots that can be trusted; NaN where there is none, and for modes.
    pub error: f64,
}

/// Size of a solution.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PartEffort {
    /// Unknowns.
    pub equations: usize,
    /// Entries of the factor.
    pub factor_entries: usize,
    /// Wall time, s.
    pub seconds: f64,
}

/// Natural frequencies of bodies.
#[derive(Clone, Debug)]
pub struct BodyModes {
    /// Each body.
    pub bodies: Vec<BodyModeRow>,
}

/// Natural frequencies of one body.
#[derive(Clone, Debug)]
pub struct BodyModeRow {
    /// Name.
    pub body: String,
    /// Its solid and its material.
    pub solid: String,
    /// See `solid`.
    pub material: String,
    /// What is clamped.
    pub fixed: Vec<String>,
    /// Motions as a rigid body.
    pub rigid: usize,
    /// The others, slowest first, Hz.
    pub frequencies: Vec<f64>,
    /// Largest relative residual of an eigenpair.
    pub residual: f64,
    /// The mesh.
    pub mesh: MeshRow,
    /// Mass of the mesh and of the solid, kg.
    pub mass: [f64; 2],
    /// Size of the solution.
    pub effort: PartEffort,
}

impl HotSpot {
    /// Its error, relative to the value.
    pub fn relative_error(&self) -> f64 {
        if self.value > 0.0 { self.error / self.value } else { 0.0 }
    }
}

impl StressBody {
    /// The largest stress that can be trusted.
    pub fn peak(&self) -> Option<&HotSpot> {
        self.spots.get(self.peak?)
    }
}
