//! Exact derivatives of one response.

use crate::Unit;

/// Derivatives of a response with respect to parameters.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// Name of the study that gives the response.
    pub of: String,
    /// The response as written.
    pub response: String,
    /// Its value, SI.
    pub value: f64,
    /// Its display unit.
    pub unit: Unit,
    /// Where each maximum or minimum in the response lies.
    pub at: Vec<ActivePlace>,
    /// In the order of the file.
    pub parameters: Vec<ParameterSensitivity>,
}

/// The position at which a reduction takes its value.
#[derive(Clone, Debug)]
pub struct ActivePlace {
    /// The reduction as written, e.g. `max(abs(drive.slide.force))`.
    pub reduction: String,
    /// Name of the axis, e.g. `joint.B.position`.
    pub axis: String,
    /// Place on it, SI.
    pub place: f64,
    /// Unit of the place.
    pub unit: Unit,
    /// It lies between two rows: the extreme was found between them.
    pub between_rows: bool,
}

/// One derivative.
#[derive(Clone, Debug)]
pub struct ParameterSensitivity {
    /// Parameter.
    pub name: String,
    /// Its value, SI.
    pub value: f64,
    /// Its display unit.
    pub unit: Unit,
    /// ∂R/∂p, SI; NaN where it is not defined (`note` says why).
    pub derivative: f64,
    /// SI unit of the derivative, e.g. `N/m`.
    pub derivative_unit: Unit,
    /// p/R · ∂R/∂p; NaN where the response is zero.
    pub relative: f64,
    /// What a reader should know: no effect, not defined and why; empty for most.
    pub note: String,
    /// The response against the parameter over its range, all others held; `None` without a range.
    pub curve: Option<Curve>,
}

/// A response against one parameter.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Parameter values, SI, ascending.
    pub parameter: Vec<f64>,
    /// Response values, SI; NaN where the machine cannot be assembled.
    pub response: Vec<f64>,
}
