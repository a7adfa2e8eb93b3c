//! Scatter of a response from tolerances.

use crate::Unit;

/// What tolerances do to a response.
#[derive(Clone, Debug)]
pub struct Tolerance {
    /// Name of the study that gives the response.
    pub of: String,
    /// The response as written.
    pub response: String,
    /// At nominal dimensions, SI.
    pub nominal: f64,
    /// Display unit.
    pub unit: Unit,
    /// Limits asked for, SI.
    pub limits: (Option<f64>, Option<f64>),
    /// Dimensions with tolerances, the largest contribution to the variance first.
    pub inputs: Vec<ToleranceInput>,
    /// Lowest and highest value with every dimension at an end of its tolerance, by the derivatives, SI; one of which only
    /// a deviation is given at ± 3 of them.
    pub worst_case: (f64, f64),
    /// The same by evaluating those corners, SI; `None` where it could not be done.
    pub worst_case_exact: Option<(f64, f64)>,
    /// Standard deviation by the derivatives, SI.
    pub linear_deviation: f64,
    /// Share within the limits of a normal response with that deviation; NaN without limits.
    pub linear_yield: f64,
    /// Process capability from the Monte Carlo run (linear without one): Cp, Cpk; NaN without limits.
    pub capability: (f64, f64),
    /// The Monte Carlo run.
    pub monte_carlo: Option<MonteCarlo>,
}

/// A dimension with a tolerance.
#[derive(Clone, Debug)]
pub struct ToleranceInput {
    /// Parameter.
    pub name: String,
    /// Nominal value, SI.
    pub nominal: f64,
    /// Display unit.
    pub unit: Unit,
    /// Half width, SI; infinite where only a deviation is given.
    pub half_width: f64,
    /// `uniform`, `normal` or `truncated`.
    pub distribution: &'static str,
    /// Standard deviation, SI.
    pub deviation: f64,
    /// ∂R/∂p, SI.
    pub derivative: f64,
    /// Its SI unit.
    pub derivative_unit: Unit,
    /// Share of the linear variance, 0..1.
    pub variance_share: f64,
    /// Share of the linear worst case, 0..1.
    pub worst_share: f64,
    /// Sobol' indices, where asked for.
    pub sobol: Option<SobolIndices>,
}

/// Shares of the variance, each with its standard error.
#[derive(Clone, Copy, Debug)]
pub struct SobolIndices {
    /// First order.
    pub first: (f64, f64),
    /// Total.
    pub total: (f64, f64),
}

/// A Monte Carlo run.
#[derive(Clone, Debug)]
pub struct MonteCarlo {
    /// Samples drawn: those asked for, fewer when the run was stopped.
    pub samples: u64,
    /// Start of the random numbers.
    pub seed: u64,
    /// Samples without a result.
    pub failed: u64,
    /// Mean and its standard error, SI.
    pub mean: (f64, f64),
    /// Standard deviation and its standard error, SI.
    pub deviation: (f64, f64),
    /// Smallest and largest, SI.
    pub range: (f64, f64),
    /// Probability and value, SI.
    pub quantiles: Vec<(f64, f64)>,
    /// Equal bins from smallest to largest.
    pub histogram: Vec<HistogramBin>,
    /// Share within the limits.
    pub within: Option<Yield>,
}

/// How many samples lie in a stretch.
#[derive(Clone, Copy, Debug)]
pub struct HistogramBin {
    /// From, SI.
    pub from: f64,
    /// To, SI.
    pub to: f64,
    /// Samples.
    pub count: u64,
}

/// A share with its 95 % confidence interval.
#[derive(Clone, Copy, Debug)]
pub struct Yield {
    /// Share.
    pub share: f64,
    /// Interval (Wilson).
    pub interval: (f64, f64),
}
