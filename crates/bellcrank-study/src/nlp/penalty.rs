//! The price of violation: high enough that steps become feasible where they can.

use super::subproblem::{Frame, Linear, Step, solve};

/// Above this a constraint that is still violated counts as one that cannot be met from here.
pub(crate) const GREATEST: f64 = 1e6;

/// A step, the penalty it was made with, and what is known about feasibility.
pub(crate) struct Choice {
    pub(crate) step: Step,
    pub(crate) penalty: f64,
    /// No step in the trust region lessens the violation of the linearized constraints.
    pub(crate) stuck: bool,
}

/// Solves the subproblem, and with a higher penalty again until the step brings nine tenths of the gain in feasibility that
/// is to be had (the steering rule of Byrd, Nocedal and Waltz, Optim. Methods Softw. 23 (2008) 197).
pub(crate) fn choose(linear: &Linear, frame: &Frame, now: f64, tolerance: f64) -> Choice {
    let mut penalty = frame.penalty;
    let mut step = solve(linear, frame);
    if frame.weight == 0.0 || step.violation <= tolerance {
        return Choice { step, penalty, stuck: false };
    }
    let least = least_violation(linear, frame);
    let wanted = least + (0.1 * (now - least)).max(tolerance);
    while step.violation > wanted && penalty < GREATEST {
        penalty *= 10.0;
        step = solve(linear, &Frame { penalty, ..*frame });
    }
    Choice { step, penalty, stuck: least >= now * (1.0 - 1e-6) }
}

/// The least sum of linearized violations in the trust region.
fn least_violation(linear: &Linear, frame: &Frame) -> f64 {
    let n = frame.lower.len();
    let small: Vec<f64> = (0..n * n).map(|k| if k % (n + 1) == 0 { 1e-8 } else { 0.0 }).collect();
    solve(linear, &Frame { hessian: &small, weight: 0.0, penalty: 1.0, ..*frame }).violation
}
