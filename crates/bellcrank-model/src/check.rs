//! What `bellcrank check` shows.

mod facts;
mod notes;
mod show;

pub(crate) use facts::{check, counted, solid_fact};
pub use show::solid_table;

use bellcrank_results::{Failure, Programme, SpaceKind, Unit};

/// A body in a check.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyFact {
    /// Name.
    pub name: String,
    /// kg; 0 for a massless body.
    pub mass: f64,
    /// Joints at it.
    pub joints: Vec<String>,
    /// What its mass properties come from.
    pub solid: Option<SolidFact>,
}

/// The solid of a body, in body axes.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidFact {
    /// Name of the body.
    pub body: String,
    /// Name of the solid.
    pub solid: String,
    /// Name of its material.
    pub material: String,
    /// What the file says of the material: key, SI values, unit; one value, or one for each axis.
    pub properties: Vec<(&'static str, Vec<f64>, &'static str)>,
    /// m³
    pub volume: f64,
    /// kg
    pub mass: f64,
    /// Centre of mass, m.
    pub center: [f64; 3],
    /// Tensor about the centre of mass, kg·m².
    pub inertia: [[f64; 3]; 3],
    /// Unit that lengths are shown in.
    pub length: Unit,
}

/// A joint in a check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JointFact {
    /// Name.
    pub name: String,
    /// Kind, as in the file.
    pub kind: String,
    /// First and second body; empty for a coupler.
    pub bodies: Vec<String>,
    /// Closes a loop.
    pub closes: bool,
}

/// Facts about a mechanism.
#[derive(Clone, Debug)]
pub struct Check {
    /// Model name.
    pub model: String,
    /// Title.
    pub title: String,
    /// Plane or space.
    pub space: SpaceKind,
    /// Bodies without the ground.
    pub bodies: Vec<BodyFact>,
    /// Joints.
    pub joints: Vec<JointFact>,
    /// Names of forces.
    pub forces: Vec<String>,
    /// Names, kinds, and whether this version runs them.
    pub studies: Vec<crate::StudyInfo>,
    /// Coordinates of the spanning tree.
    pub coordinates: usize,
    /// Equations of loops and couplings.
    pub equations: usize,
    /// Independent ones at the assembled position; `None` when it could not be assembled.
    pub rank: Option<usize>,
    /// Degrees of freedom counted: coordinates less equations.
    pub counted: i64,
    /// Degrees of freedom: coordinates less rank.
    pub degrees: Option<usize>,
    /// Number of loops.
    pub loops: usize,
    /// Equations that take part in a dependency, in words: "`N` along x".
    pub redundant: Vec<String>,
    /// Coordinates able to move, most mobile first.
    pub mobile: Vec<String>,
    /// The assembled position is special: nearby, the rank is another.
    pub special: bool,
    /// What is missing or suspicious.
    pub notes: Vec<String>,
    /// What moves when in studies over time, and the names of those of which it holds.
    pub programmes: Vec<(Vec<String>, Programme)>,
    /// Why it could not be assembled.
    pub failure: Option<Failure>,
}
