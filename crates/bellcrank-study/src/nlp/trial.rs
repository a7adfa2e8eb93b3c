//! What a refused trial point teaches: a corrected step, and pieces that were not seen before.

use super::dense::{dot, largest};
use super::hessian::{matches, turn};
use super::point::Point;
use super::problem::{Piece, Relation};
use super::subproblem::Linear;

/// The linear pieces of a point as they are.
pub(crate) fn tangents(point: &Point) -> Linear {
    Linear { objective: point.objective.clone(), constraints: point.constraints.clone() }
}

/// The second-order correction (Nocedal and Wright, 2nd ed., section 18.3): the old slopes through the values that the trial
/// point at `d` really has. The old slopes, as the Hessian of the Lagrangian holds the curvature already.
pub(crate) fn corrected(old: &Point, trial: &Point, d: &[f64]) -> Linear {
    let constraints = old.constraints.iter().zip(&trial.constraints);
    Linear {
        objective: lifted(&old.objective, &trial.objective, d),
        constraints: constraints.map(|(old, trial)| lifted(old, trial, d)).collect(),
    }
}

/// Old pieces that the trial point does not show stay; new ones come with their own slope.
fn lifted(old: &[Piece], trial: &[Piece], d: &[f64]) -> Vec<Piece> {
    let pairs = matches(old, trial, d);
    let mut pieces = old.to_vec();
    for &(i, j) in &pairs {
        pieces[i].value = trial[j].value - dot(&old[i].gradient, d);
    }
    let unseen = (0..trial.len()).filter(|j| pairs.iter().all(|pair| pair.1 != *j));
    pieces.extend(unseen.map(|j| moved(&trial[j], d)));
    pieces
}

/// The tangent of a piece at the trial point, from the old point.
fn moved(piece: &Piece, d: &[f64]) -> Piece {
    Piece { value: piece.value - dot(&piece.gradient, d), gradient: piece.gradient.clone() }
}

/// Adds the pieces that the trial point has and the old point has not.
pub(crate) fn learn(extra: &mut Linear, relations: &[Relation], old: &Point, trial: &Point, d: &[f64]) {
    add_unseen(&mut extra.objective, &old.objective, &trial.objective, d);
    for (i, relation) in relations.iter().enumerate() {
        if *relation == Relation::AtMostZero {
            add_unseen(&mut extra.constraints[i], &old.constraints[i], &trial.constraints[i], d);
        }
    }
}

/// Only where there are pieces at all: a smooth function stays smooth. At the old point no unseen piece is above the top.
fn add_unseen(extra: &mut Vec<Piece>, old: &[Piece], trial: &[Piece], d: &[f64]) {
    if old.len() < 2 && trial.len() < 2 {
        return;
    }
    let top = super::problem::maximum(old);
    let pairs = matches(old, trial, d);
    for (j, piece) in trial.iter().enumerate() {
        let seen = pairs.iter().find(|pair| pair.1 == j).is_some_and(|&(i, _)| continues(&old[i], piece));
        if !seen {
            let mut piece = moved(piece, d);
            piece.value = piece.value.min(top);
            extra.push(piece);
        }
    }
}

fn continues(old: &Piece, new: &Piece) -> bool {
    turn(old, new) <= 0.5 * largest(&old.gradient).max(largest(&new.gradient))
}
