//! Optimality residuals at a point, and multipliers from the gradients there alone.

use super::dense::{add_scaled, largest};
use super::hessian::Hessian;
use super::point::Point;
use super::problem::{Piece, Relation, maximum};
use super::solution::Kkt;
use super::subproblem::{self, Frame, Linear, Weights};

/// What stands still while a point is judged.
pub(crate) struct Judge<'a> {
    pub(crate) relations: &'a [Relation],
    /// Distances to the bounds, ≤ 0 and ≥ 0.
    pub(crate) lower: &'a [f64],
    pub(crate) upper: &'a [f64],
}

impl Judge<'_> {
    /// Residuals of the Karush–Kuhn–Tucker conditions (Nocedal and Wright, 2nd ed., equations 12.34).
    pub(crate) fn residuals(&self, point: &Point, weights: &Weights) -> Kkt {
        Kkt {
            stationarity: largest(&self.lagrangian_gradient(point, weights)),
            feasibility: point.worst_violation(self.relations),
            complementarity: self.complementarity(point, weights),
        }
    }

    fn lagrangian_gradient(&self, point: &Point, weights: &Weights) -> Vec<f64> {
        let mut r: Vec<f64> = weights.upper.iter().zip(&weights.lower).map(|(u, l)| u - l).collect();
        add_gradients(&mut r, &point.objective, &weights.objective);
        for (pieces, w) in point.constraints.iter().zip(&weights.constraints) {
            add_gradients(&mut r, pieces, w);
        }
        r
    }

    fn complementarity(&self, point: &Point, weights: &Weights) -> f64 {
        let mut worst = slack_product(&point.objective, &weights.objective, point.value());
        for (i, (pieces, w)) in point.constraints.iter().zip(&weights.constraints).enumerate() {
            if self.relations[i] == Relation::AtMostZero {
                // A violated piece has no slack: that is a matter of feasibility.
                worst = worst.max(slack_product(pieces, w, 0.0));
            }
        }
        let low = weights.lower.iter().zip(self.lower).map(|(w, l)| if *w > 0.0 { w * l.abs() } else { 0.0 });
        let high = weights.upper.iter().zip(self.upper).map(|(w, u)| if *w > 0.0 { w * u.abs() } else { 0.0 });
        low.chain(high).fold(worst, f64::max)
    }

    /// Multipliers that make the gradient of the Lagrangian shortest, given what is active: they are those of the shortest
    /// descent direction, min ½|d|² + max gⱼ·d subject to aᵢ·d ≤ 0.
    pub(crate) fn least_squares(&self, point: &Point, penalty: f64) -> Weights {
        let (linear, places) = self.active(point);
        let wall = |distance: &f64, sign: f64| if distance.abs() <= ACTIVE { 0.0 } else { sign * f64::INFINITY };
        let lower: Vec<f64> = self.lower.iter().map(|l| wall(l, -1.0)).collect();
        let upper: Vec<f64> = self.upper.iter().map(|u| wall(u, 1.0)).collect();
        let hessian = Hessian::new(lower.len());
        let frame = Frame {
            relations: self.relations,
            hessian: &hessian.b,
            weight: 1.0,
            penalty,
            radius: 10.0 * (1.0 + point.gradient_size()),
            lower: &lower,
            upper: &upper,
        };
        let weights = subproblem::solve(&linear, &frame).weights;
        places.spread(point, &weights)
    }

    /// The pieces that hold at the point, without their offsets.
    fn active(&self, point: &Point) -> (Linear, Places) {
        let top = point.value();
        let objective = near(&point.objective, top);
        let constraints = point.constraints.iter().zip(self.relations).map(|(p, r)| match r {
            Relation::Zero => (0..p.len()).collect(),
            Relation::AtMostZero => near(p, maximum(p).max(0.0)),
        });
        let constraints: Vec<Vec<usize>> = constraints.collect();
        let linear = Linear {
            objective: flat(&point.objective, &objective),
            constraints: point.constraints.iter().zip(&constraints).map(|(p, places)| flat(p, places)).collect(),
        };
        (linear, Places { objective, constraints })
    }
}

/// Slack, scaled, below which something counts as active.
const ACTIVE: f64 = 1e-7;

fn near(pieces: &[Piece], top: f64) -> Vec<usize> {
    (0..pieces.len()).filter(|&i| pieces[i].value >= top - ACTIVE * (1.0 + top.abs())).collect()
}

fn flat(pieces: &[Piece], places: &[usize]) -> Vec<Piece> {
    places.iter().map(|&i| Piece { value: 0.0, gradient: pieces[i].gradient.clone() }).collect()
}

/// Which pieces were kept.
struct Places {
    objective: Vec<usize>,
    constraints: Vec<Vec<usize>>,
}

impl Places {
    /// The weights of the kept pieces in their places, zero elsewhere.
    fn spread(&self, point: &Point, weights: &Weights) -> Weights {
        let constraints = self.constraints.iter().zip(&weights.constraints).zip(&point.constraints);
        Weights {
            objective: spread(&self.objective, &weights.objective, point.objective.len()),
            constraints: constraints.map(|((places, w), pieces)| spread(places, w, pieces.len())).collect(),
            lower: weights.lower.clone(),
            upper: weights.upper.clone(),
        }
    }
}

fn spread(places: &[usize], weights: &[f64], all: usize) -> Vec<f64> {
    let mut out = vec![0.0; all];
    places.iter().zip(weights).for_each(|(&i, w)| out[i] = *w);
    out
}

fn add_gradients(r: &mut [f64], pieces: &[Piece], weights: &[f64]) {
    for (piece, w) in pieces.iter().zip(weights) {
        add_scaled(r, *w, &piece.gradient);
    }
}

fn slack_product(pieces: &[Piece], weights: &[f64], top: f64) -> f64 {
    pieces.iter().zip(weights).map(|(p, w)| w * (top - p.value).max(0.0)).fold(0.0, f64::max)
}
