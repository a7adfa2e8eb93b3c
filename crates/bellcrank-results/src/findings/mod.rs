//! What studies over other studies find: plain data, one file a kind.

mod designs;
mod flexible;
mod modes;
mod optimization;
mod sensitivity;
mod sizing;
mod stress;
mod tolerance;

pub use designs::{ColumnStatistics, DesignFailure, Designs, ParetoFront};
pub use flexible::{Deformation, Fatigue, FlexibleBodies, FlexibleBody, KeptMode, ReductionCheck, SpotHistory};
pub use modes::{ModeKind, ModeRow, Modes, ShapeRow};
pub use optimization::{
    Compared, ConstraintRow, FirstOrder, IterationRow, Objective, Optimization, StartRow, VariableRow,
};
pub use sensitivity::{ActivePlace, Curve, ParameterSensitivity, Sensitivity};
pub use sizing::{Candidate, Check, Property, Sizing};
pub use stress::{BodyModeRow, BodyModes, HotSpot, MeshRow, PartEffort, Stress, StressBody};
pub use tolerance::{HistogramBin, MonteCarlo, SobolIndices, Tolerance, ToleranceInput, Yield};

/// What a study found beside its rows: one over another study, or one of modes.
#[derive(Clone, Debug)]
pub enum Findings {
    /// Derivatives of a response.
    Sensitivity(Sensitivity),
    /// A better design.
    Optimization(Optimization),
    /// Responses over many designs.
    Designs(Designs),
    /// Scatter of a response.
    Tolerance(Tolerance),
    /// Natural frequencies and mode shapes.
    Modes(Modes),
    /// Standard drives that carry the loads.
    Sizing(Sizing),
    /// Stress in bodies.
    Stress(Stress),
    /// Natural frequencies of bodies.
    BodyModes(BodyModes),
}
