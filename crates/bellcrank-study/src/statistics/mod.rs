//! What a sample of numbers says: moments, quantiles, yield, sensitivities, trade-offs.
//!
//! Nothing in here panics; where a question has no answer (the variance of one number) the answer is NaN.

mod capability;
mod histogram;
mod moments;
mod pareto;
mod quantiles;
mod sensitivity;
mod tolerance;

pub use capability::{Capability, Limits, Proportion, capability, wilson};
pub use histogram::{Histogram, freedman_diaconis};
pub use moments::Moments;
pub use pareto::{Aim, Candidate, ParetoFront, pareto_front};
pub use quantiles::Sorted;
pub use sensitivity::{Saltelli, SensitivityIndex};
pub use tolerance::{
    Extreme, TooManyVertices, WorstCase, linear_sigma, linear_worst_case, variance_shares, vertex_worst_case,
};
