//! The dimensions that scatter.

use bellcrank_doc::Distribution as Shape;
use bellcrank_study::sampling::Distribution;

use crate::ask::Asking;
use crate::design::Tolerance;

/// A normal dimension of which only the standard deviation is given deviates by so many of them in the worst case.
const WORST_SIGMAS: f64 = 3.0;
/// A tolerance alone is so many standard deviations of a normal distribution.
const SIGMAS_IN_A_TOLERANCE: f64 = 3.0;

/// A dimension that scatters; SI.
#[derive(Clone, Debug)]
pub(super) struct Input {
    pub(super) parameter: usize,
    pub(super) nominal: f64,
    pub(super) distribution: Distribution,
    pub(super) named: &'static str,
    /// Infinite where only a standard deviation is given.
    pub(super) half_width: f64,
    /// How far it deviates in the worst case.
    pub(super) width: f64,
}

impl Input {
    /// Whether it deviates at all.
    pub(super) fn moves(&self) -> bool {
        self.width > 0.0 || self.distribution.sigma() > 0.0
    }

    /// Whether no machine deviates by more than the half width.
    pub(super) fn is_bounded(&self) -> bool {
        !matches!(self.distribution, Distribution::Normal { .. })
    }
}

/// All inputs in the order of the file.
pub(super) fn of(asking: &Asking<'_>, question: &Tolerance) -> Vec<Input> {
    let (parameters, values) = (&asking.study.parameters, asking.study.parameters.values());
    let input = |scattered: &crate::design::Scattered| {
        let spread = scattered.spread(parameters, values);
        let shape = spread.distribution.unwrap_or(Shape::Normal);
        let half_width = spread.half_width.unwrap_or(f64::INFINITY);
        let sigma = spread.sigma.unwrap_or(half_width / SIGMAS_IN_A_TOLERANCE);
        let distribution = match shape {
            Shape::Uniform => Distribution::Uniform { half_width },
            Shape::Normal => Distribution::Normal { sigma },
            Shape::Truncated => Distribution::TruncatedNormal { sigma, half_width },
        };
        let width = if half_width.is_finite() { half_width } else { WORST_SIGMAS * sigma };
        let nominal = asking.value(scattered.parameter);
        Input { parameter: scattered.parameter, nominal, distribution, named: shape.name(), half_width, width }
    };
    question.scattered.iter().map(input).collect()
}
