//! The quadratic subproblem of one step: all pieces linearized, every constraint elastic, the step in a box.
//!
//! With t above all pieces of the objective and vᵢ ≥ 0 the violation of constraint i that remains,
//!
//! min w t + ρ Σ vᵢ + ½ dᵀBd subject to fⱼ + gⱼ·d ≤ t, cᵢⱼ + aᵢⱼ·d ≤ vᵢ, ±(cᵢ + aᵢ·d) ≤ vᵢ for equalities, l ≤ d ≤ u.
//!
//! It is never infeasible, its multipliers are at most ρ, and d = 0 is a candidate, so the predicted merit never rises.

use super::dense::{add_scaled, dot, times};
use super::interior::{Minimum, Quadratic, minimize};
use super::point::violation;
use super::problem::{Piece, Relation};

/// Linear pieces around a point: value there and gradient.
#[derive(Clone, Debug)]
pub(crate) struct Linear {
    pub(crate) objective: Vec<Piece>,
    pub(crate) constraints: Vec<Vec<Piece>>,
}

/// What a subproblem is asked with.
pub(crate) struct Frame<'a> {
    pub(crate) relations: &'a [Relation],
    /// B, n × n.
    pub(crate) hessian: &'a [f64],
    /// w: one, or zero while only the violation is minimized.
    pub(crate) weight: f64,
    /// ρ.
    pub(crate) penalty: f64,
    /// Trust region.
    pub(crate) radius: f64,
    /// Distances to the bounds, ≤ 0 and ≥ 0.
    pub(crate) lower: &'a [f64],
    pub(crate) upper: &'a [f64],
}

/// Multipliers in the solver's scaling: of each piece, and of the bounds proper.
#[derive(Clone, Debug, Default)]
pub(crate) struct Weights {
    pub(crate) objective: Vec<f64>,
    pub(crate) constraints: Vec<Vec<f64>>,
    pub(crate) lower: Vec<f64>,
    pub(crate) upper: Vec<f64>,
}

/// The answer.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    pub(crate) d: Vec<f64>,
    pub(crate) weights: Weights,
    /// Sum of the violations of the linearized constraints.
    pub(crate) violation: f64,
    /// Predicted w f + ρ Σ v + ½ dᵀBd.
    pub(crate) merit: f64,
    /// Whether the trust region, not a bound, holds the step.
    pub(crate) held: bool,
}

/// Greatest of the linear pieces at d.
pub(crate) fn linear_maximum(pieces: &[Piece], d: &[f64]) -> f64 {
    pieces.iter().map(|p| p.value + dot(&p.gradient, d)).fold(f64::NEG_INFINITY, f64::max)
}

/// Where a constraint stands among the unknowns and rows.
struct Place {
    /// Unknown of vᵢ; `None` if no step in the box can violate it.
    elastic: Option<usize>,
    first_row: usize,
}

/// Solves the subproblem. All lengths are divided by the radius, so that the box has size one.
pub(crate) fn solve(linear: &Linear, frame: &Frame) -> Step {
    let n = frame.lower.len();
    let epigraph = has_epigraph(linear, frame);
    let size = n + usize::from(epigraph);
    let elastic = elastic_constraints(linear, frame, size);
    let unknowns = size + elastic.iter().flatten().count();
    let mut qp = empty(frame, n, unknowns);
    add_objective(&mut qp, linear, frame, epigraph.then_some(n));
    let places = add_constraints(&mut qp, linear, frame, &elastic);
    answer(linear, frame, &minimize(&qp), &places)
}

/// While only the violation is minimized, the objective has no rows.
fn has_epigraph(linear: &Linear, frame: &Frame) -> bool {
    linear.objective.len() > 1 && frame.weight > 0.0
}

fn elastic_constraints(linear: &Linear, frame: &Frame, first: usize) -> Vec<Option<usize>> {
    let reach = |p: &Piece| p.value + p.gradient.iter().map(|a| a.abs()).sum::<f64>() * frame.radius;
    let mut next = first;
    let mut place = |(relation, pieces): (&Relation, &Vec<Piece>)| {
        let matters = *relation == Relation::Zero || pieces.iter().any(|p| reach(p) > 0.0);
        next += usize::from(matters);
        matters.then_some(next - 1)
    };
    frame.relations.iter().zip(&linear.constraints).map(&mut place).collect()
}

fn empty(frame: &Frame, n: usize, unknowns: usize) -> Quadratic {
    let mut hessian = vec![0.0; unknowns * unknowns];
    for i in 0..n {
        for j in 0..n {
            hessian[i * unknowns + j] = frame.radius * frame.hessian[i * n + j];
        }
    }
    let mut lower: Vec<f64> = frame.lower.iter().map(|l| (l / frame.radius).max(-1.0)).collect();
    let mut upper: Vec<f64> = frame.upper.iter().map(|u| (u / frame.radius).min(1.0)).collect();
    lower.resize(unknowns, f64::NEG_INFINITY);
    upper.resize(unknowns, f64::INFINITY);
    Quadratic { hessian, linear: vec![0.0; unknowns], rows: Vec::new(), limits: Vec::new(), lower, upper }
}

fn add_objective(qp: &mut Quadratic, linear: &Linear, frame: &Frame, epigraph: Option<usize>) {
    match (epigraph, linear.objective.first()) {
        (Some(t), _) => {
            qp.linear[t] = frame.weight;
            let top = linear_maximum(&linear.objective, &[]);
            for piece in &linear.objective {
                push_row(qp, &piece.gradient, 1.0, t, (top - piece.value) / frame.radius);
            }
        }
        (None, Some(piece)) => add_scaled(&mut qp.linear, frame.weight, &piece.gradient),
        (None, None) => {}
    }
}

/// sign · gradient · d − z[slack] ≤ limit.
fn push_row(qp: &mut Quadratic, gradient: &[f64], sign: f64, slack: usize, limit: f64) {
    let start = qp.rows.len();
    qp.rows.resize(start + qp.linear.len(), 0.0);
    add_scaled(&mut qp.rows[start..], sign, gradient);
    qp.rows[start + slack] = -1.0;
    qp.limits.push(limit);
}

fn add_constraints(qp: &mut Quadratic, linear: &Linear, frame: &Frame, elastic: &[Option<usize>]) -> Vec<Place> {
    let mut places = Vec::with_capacity(elastic.len());
    for (i, &place) in elastic.iter().enumerate() {
        places.push(Place { elastic: place, first_row: qp.limits.len() });
        let Some(v) = place else { continue };
        qp.linear[v] = frame.penalty;
        let sides: &[f64] = if frame.relations[i] == Relation::Zero { &[1.0, -1.0] } else { &[1.0] };
        if sides.len() == 1 {
            qp.lower[v] = 0.0;
        }
        for piece in &linear.constraints[i] {
            sides.iter().for_each(|&s| push_row(qp, &piece.gradient, s, v, -s * piece.value / frame.radius));
        }
    }
    places
}

fn answer(linear: &Linear, frame: &Frame, minimum: &Minimum, places: &[Place]) -> Step {
    let n = frame.lower.len();
    let bounded = |j: usize| (minimum.z[j] * frame.radius).clamp(frame.lower[j], frame.upper[j]);
    let d: Vec<f64> = (0..n).map(bounded).collect();
    let violation = linear_violation(linear, frame.relations, &d);
    let curvature = 0.5 * dot(&d, &times(frame.hessian, &d));
    let merit = frame.weight * linear_maximum(&linear.objective, &d) + frame.penalty * violation + curvature;
    let is_bound = |bound: f64| bound.abs() <= frame.radius;
    let own = |y: &[f64], bounds: &[f64]| -> Vec<f64> {
        (0..n).map(|j| if is_bound(bounds[j]) { y[j] } else { 0.0 }).collect()
    };
    let held = |y: &[f64], bounds: &[f64]| (0..n).any(|j| !is_bound(bounds[j]) && y[j] > 1e-12);
    let held = held(&minimum.lower, frame.lower) || held(&minimum.upper, frame.upper);
    let weights = Weights {
        objective: objective_weights(linear, minimum, frame),
        constraints: places.iter().enumerate().map(|(i, p)| constraint_weights(linear, minimum, frame, i, p)).collect(),
        lower: own(&minimum.lower, frame.lower),
        upper: own(&minimum.upper, frame.upper),
    };
    Step { d, weights, violation, merit, held }
}

fn objective_weights(linear: &Linear, minimum: &Minimum, frame: &Frame) -> Vec<f64> {
    let pieces = linear.objective.len();
    if has_epigraph(linear, frame) { minimum.rows[..pieces].to_vec() } else { vec![frame.weight; pieces] }
}

fn constraint_weights(linear: &Linear, minimum: &Minimum, frame: &Frame, i: usize, place: &Place) -> Vec<f64> {
    let pieces = linear.constraints[i].len();
    let rows = &minimum.rows[place.first_row..];
    match (place.elastic, frame.relations[i]) {
        (None, _) => vec![0.0; pieces],
        (Some(_), Relation::AtMostZero) => rows[..pieces].to_vec(),
        (Some(_), Relation::Zero) => vec![rows[0] - rows[1]],
    }
}

/// Sum of the violations of the linearized constraints at d.
pub(crate) fn linear_violation(linear: &Linear, relations: &[Relation], d: &[f64]) -> f64 {
    let each = relations.iter().zip(&linear.constraints);
    each.map(|(&r, pieces)| violation(r, linear_maximum(pieces, d))).sum()
}
