//! A point in the solver's scaling with everything that is known there.

use super::dense::largest;
use super::problem::{Piece, Relation, Values, maximum};

/// Scaled variables u, functions and gradients there.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    /// Scaled free variables.
    pub(crate) u: Vec<f64>,
    /// Pieces of the objective, at least one.
    pub(crate) objective: Vec<Piece>,
    /// Pieces of each constraint, at least one each.
    pub(crate) constraints: Vec<Vec<Piece>>,
    /// The same values as the caller computed them.
    pub(crate) raw: Values,
}

/// How much a value of c violates its relation.
pub(crate) fn violation(relation: Relation, c: f64) -> f64 {
    match relation {
        Relation::AtMostZero => c.max(0.0),
        Relation::Zero => c.abs(),
    }
}

impl Point {
    /// Objective, scaled.
    pub(crate) fn value(&self) -> f64 {
        maximum(&self.objective)
    }

    /// Sum of the scaled violations.
    pub(crate) fn violations(&self, relations: &[Relation]) -> f64 {
        self.each_violation(relations).sum()
    }

    /// Greatest scaled violation.
    pub(crate) fn worst_violation(&self, relations: &[Relation]) -> f64 {
        self.each_violation(relations).fold(0.0, f64::max)
    }

    fn each_violation(&self, relations: &[Relation]) -> impl Iterator<Item = f64> {
        relations.iter().zip(&self.constraints).map(|(&r, pieces)| violation(r, maximum(pieces)))
    }

    /// Greatest component of a gradient of the pieces at the top of the objective.
    pub(crate) fn gradient_size(&self) -> f64 {
        self.objective.iter().map(|piece| largest(&piece.gradient)).fold(0.0, f64::max)
    }
}

/// Greatest violation in the caller's own numbers.
pub(crate) fn raw_violation(relations: &[Relation], values: &Values) -> f64 {
    let each = relations.iter().zip(&values.constraints).map(|(&r, &c)| violation(r, c));
    each.fold(0.0, f64::max)
}
