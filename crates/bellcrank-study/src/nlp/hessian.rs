//! The Hessian of the Lagrangian by the damped BFGS formula.

use super::dense::{add_scaled, dot, largest, times};
use super::point::Point;
use super::problem::Piece;
use super::subproblem::Weights;

/// A positive definite approximation B, n × n by rows.
#[derive(Clone, Debug)]
pub(crate) struct Hessian {
    pub(crate) b: Vec<f64>,
    n: usize,
    /// No step has been learnt from yet.
    fresh: bool,
}

impl Hessian {
    /// The identity.
    pub(crate) fn new(n: usize) -> Self {
        let b = (0..n * n).map(|k| if k % (n + 1) == 0 { 1.0 } else { 0.0 }).collect();
        Self { b, n, fresh: true }
    }

    pub(crate) fn is_fresh(&self) -> bool {
        self.fresh
    }

    /// Greatest diagonal element.
    pub(crate) fn size(&self) -> f64 {
        (0..self.n).map(|i| self.b[i * (self.n + 1)]).fold(0.0, f64::max)
    }

    /// Learns that the gradient changed by `y` over the step `s`. Damping after Powell (1978): Nocedal and Wright, 2nd ed.,
    /// procedure 18.2; the first scaling after their equation 6.20.
    pub(crate) fn update(&mut self, s: &[f64], y: &[f64]) {
        let (ss, sy, yy) = (dot(s, s), dot(s, y), dot(y, y));
        if largest(s) < 3e-9 || yy + ss + sy == 0.0 || !(yy + ss).is_finite() {
            return;
        }
        if self.fresh && sy > 1e-8 * (ss * yy).sqrt() {
            let gamma = (sy / ss).clamp(1e-6, 1e6);
            self.b.iter_mut().for_each(|b| *b *= gamma);
        }
        self.fresh = false;
        let bs = times(&self.b, s);
        let sbs = dot(s, &bs);
        let theta = if sy >= 0.2 * sbs { 1.0 } else { 0.8 * sbs / (sbs - sy) };
        let r: Vec<f64> = y.iter().zip(&bs).map(|(y, bs)| theta * y + (1.0 - theta) * bs).collect();
        let sr = dot(s, &r);
        if sbs > 0.0 && sr > 0.0 {
            self.replace(&bs, sbs, &r, sr);
        }
    }

    /// B − (Bs)(Bs)ᵀ / sᵀBs + r rᵀ / sᵀr.
    fn replace(&mut self, bs: &[f64], sbs: f64, r: &[f64], sr: f64) {
        for (i, row) in self.b.chunks_exact_mut(self.n).enumerate() {
            add_scaled(row, -bs[i] / sbs, bs);
            add_scaled(row, r[i] / sr, r);
        }
    }
}

/// Change of the gradient of the Lagrangian with fixed multipliers from one point to another.
pub(crate) fn gradient_change(old: &Point, new: &Point, weights: &Weights, s: &[f64]) -> Vec<f64> {
    let mut y = vec![0.0; s.len()];
    add_change(&mut y, &old.objective, &new.objective, &weights.objective, s);
    for (i, w) in weights.constraints.iter().enumerate() {
        add_change(&mut y, &old.constraints[i], &new.constraints[i], w, s);
    }
    y
}

fn add_change(y: &mut [f64], old: &[Piece], new: &[Piece], weights: &[f64], s: &[f64]) {
    for (i, j) in matches(old, new, s) {
        if weights[i] != 0.0 {
            add_scaled(y, weights[i], &new[j].gradient);
            add_scaled(y, -weights[i], &old[i].gradient);
        }
    }
}

/// Which new piece continues which old one: pairs of least disagreement, each piece at most once.
///
/// Pieces carry no names, and their number may change. A smooth function agrees with the trapezoidal rule along the step to
/// third order and its gradient to first order, so the disagreement of a true pair vanishes with the step.
pub(crate) fn matches(old: &[Piece], new: &[Piece], s: &[f64]) -> Vec<(usize, usize)> {
    let mut pairs: Vec<(f64, usize, usize)> = (0..old.len())
        .flat_map(|i| (0..new.len()).map(move |j| (i, j)))
        .map(|(i, j)| (disagreement(&old[i], &new[j], s), i, j))
        .collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut taken = Vec::new();
    for (_, i, j) in pairs {
        if taken.iter().all(|&(a, b)| a != i && b != j) {
            taken.push((i, j));
        }
    }
    taken
}

fn disagreement(old: &Piece, new: &Piece, s: &[f64]) -> f64 {
    let change = new.value - old.value - 0.5 * (dot(&old.gradient, s) + dot(&new.gradient, s));
    turn(old, new) + change.abs() / largest(s).max(f64::MIN_POSITIVE)
}

/// Greatest difference of the gradients.
pub(crate) fn turn(old: &Piece, new: &Piece) -> f64 {
    old.gradient.iter().zip(&new.gradient).fold(0.0, |m, (a, b)| f64::max(m, (a - b).abs()))
}
