//! From the solver's scaling back to the caller's numbers.

use super::dense::largest;
use super::point::Point;
use super::problem::Problem;
use super::scaled::Scaled;
use super::solution::{Kkt, Multipliers, Solution, Status};
use super::subproblem::Weights;

/// The answer at a point.
pub(crate) fn assemble<P: Problem + ?Sized>(
    scaled: &Scaled<P>,
    point: &Point,
    weights: &Weights,
    kkt: Kkt,
    status: Status,
    iterations: usize,
) -> Solution {
    let multipliers = unscaled(scaled, weights);
    let on_bound = |bounds: &[f64], sign: f64| -> Vec<usize> {
        let places = (0..point.u.len()).filter(|&i| sign * (point.u[i] - bounds[i]) >= -1e-12);
        places.map(|i| scaled.free[i]).collect()
    };
    Solution {
        status,
        x: scaled.unscale(&point.u),
        objective: point.raw.objective,
        constraints: point.raw.constraints.clone(),
        violation: scaled.raw_violation(point),
        active_constraints: active_constraints(scaled, point, weights),
        active_lower: on_bound(&scaled.lower, -1.0),
        active_upper: on_bound(&scaled.upper, 1.0),
        multipliers,
        kkt,
        objective_gradient: point.objective.iter().map(|p| largest(&p.gradient)).fold(0.0, f64::max)
            * scaled.objective_scale,
        iterations,
        evaluations: scaled.counts.evaluations,
        gradient_evaluations: scaled.counts.gradients,
        undefined: scaled.counts.undefined,
    }
}

/// Constraints with value zero or a multiplier.
fn active_constraints<P: Problem + ?Sized>(scaled: &Scaled<P>, point: &Point, weights: &Weights) -> Vec<usize> {
    let holds = |i: &usize| {
        let value = point.raw.constraints[*i] / scaled.constraint_scale[*i];
        value >= -1e-8 || weights.constraints[*i].iter().any(|w| w.abs() > 1e-8)
    };
    (0..point.constraints.len()).filter(holds).collect()
}

fn unscaled<P: Problem + ?Sized>(scaled: &Scaled<P>, weights: &Weights) -> Multipliers {
    let f = scaled.objective_scale;
    let shares = weights.constraints.iter().zip(&scaled.constraint_scale);
    let constraint_pieces: Vec<Vec<f64>> = shares.map(|(w, c)| w.iter().map(|w| w * f / c).collect()).collect();
    let bounds = |w: &[f64]| {
        let mut all = vec![0.0; scaled.variables()];
        scaled.free.iter().zip(w).zip(&scaled.scale).for_each(|((&j, w), s)| all[j] = w * f / s);
        all
    };
    Multipliers {
        constraints: constraint_pieces.iter().map(|w| w.iter().sum()).collect(),
        lower: bounds(&weights.lower),
        upper: bounds(&weights.upper),
        objective_pieces: weights.objective.clone(),
        constraint_pieces,
    }
}

/// The answer where the problem has no values at the start.
pub(crate) fn undefined_start<P: Problem + ?Sized>(scaled: &Scaled<P>, origin: &[f64]) -> Solution {
    Solution {
        status: Status::UndefinedStart,
        x: scaled.unscale(origin),
        objective: f64::NAN,
        constraints: Vec::new(),
        violation: f64::NAN,
        multipliers: Multipliers::default(),
        active_constraints: Vec::new(),
        active_lower: Vec::new(),
        active_upper: Vec::new(),
        kkt: Kkt::UNKNOWN,
        objective_gradient: f64::NAN,
        iterations: 0,
        evaluations: scaled.counts.evaluations,
        gradient_evaluations: scaled.counts.gradients,
        undefined: scaled.counts.undefined,
    }
}
