//! The caller's problem in variables and functions of size one, with everything it returns checked.
//!
//! x = origin + scale ∘ u. Variables whose bounds are equal do not appear in u.

use super::dense::largest;
use super::point::{Point, raw_violation};
use super::problem::{Evaluation, Function, Malformed, Piece, Problem, Relation, Undefined, maximum};

/// How often the problem was asked.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Counts {
    pub(crate) evaluations: usize,
    pub(crate) gradients: usize,
    pub(crate) undefined: usize,
}

/// The problem as the solver sees it.
pub(crate) struct Scaled<'p, P: Problem + ?Sized> {
    problem: &'p mut P,
    /// Places of the free variables in x.
    pub(crate) free: Vec<usize>,
    origin: Vec<f64>,
    bounds: Vec<(f64, f64)>,
    /// Scale of each free variable.
    pub(crate) scale: Vec<f64>,
    /// Bounds of u.
    pub(crate) lower: Vec<f64>,
    pub(crate) upper: Vec<f64>,
    pub(crate) relations: Vec<Relation>,
    /// The caller's objective over the scaled one.
    pub(crate) objective_scale: f64,
    /// The same for each constraint.
    pub(crate) constraint_scale: Vec<f64>,
    pub(crate) counts: Counts,
}

impl<'p, P: Problem + ?Sized> Scaled<'p, P> {
    /// Checks shapes and bounds and puts the start inside the bounds.
    pub(crate) fn new(problem: &'p mut P, start: &[f64]) -> Result<Self, Malformed> {
        check(problem, start)?;
        let bounds = problem.bounds().to_vec();
        let relations = problem.relations().to_vec();
        let origin: Vec<f64> = start.iter().zip(&bounds).map(|(x, &(l, u))| x.clamp(l, u)).collect();
        let free: Vec<usize> = (0..origin.len()).filter(|&j| bounds[j].0 < bounds[j].1).collect();
        let scale: Vec<f64> = free.iter().map(|&j| variable_scale(origin[j], bounds[j])).collect();
        let to_scaled = |x: f64, i: usize| (x - origin[free[i]]) / scale[i];
        let lower = (0..free.len()).map(|i| to_scaled(bounds[free[i]].0, i)).collect();
        let upper = (0..free.len()).map(|i| to_scaled(bounds[free[i]].1, i)).collect();
        let constraint_scale = vec![1.0; relations.len()];
        let counts = Counts::default();
        let objective_scale = 1.0;
        Ok(Self {
            problem,
            free,
            origin,
            bounds,
            scale,
            lower,
            upper,
            relations,
            objective_scale,
            constraint_scale,
            counts,
        })
    }

    /// Number of the caller's variables.
    pub(crate) fn variables(&self) -> usize {
        self.origin.len()
    }

    /// The caller's x; a u on its bound gives the bound itself.
    pub(crate) fn unscale(&self, u: &[f64]) -> Vec<f64> {
        let mut x = self.origin.clone();
        for (i, &j) in self.free.iter().enumerate() {
            let (l, h) = self.bounds[j];
            let inner = (self.origin[j] + self.scale[i] * u[i]).clamp(l, h);
            let above = if u[i] >= self.upper[i] { h } else { inner };
            x[j] = if u[i] <= self.lower[i] { l } else { above };
        }
        x
    }

    /// Everything at u.
    pub(crate) fn evaluate(&mut self, u: &[f64]) -> Result<Point, Undefined> {
        let x = self.unscale(u);
        self.counts.evaluations += 1;
        self.counts.gradients += 1;
        let answer = self.problem.evaluate(&x).and_then(|e| self.checked(e));
        self.counts.undefined += usize::from(answer.is_err());
        answer.map(|evaluation| self.scaled(u, evaluation))
    }

    fn checked(&self, e: Evaluation) -> Result<Evaluation, Undefined> {
        let n = self.origin.len();
        let is_good = |f: &Function| {
            !f.pieces.is_empty() && f.pieces.iter().all(|p| p.value.is_finite() && is_gradient(&p.gradient, n))
        };
        let single = |(r, f): (&Relation, &Function)| *r == Relation::AtMostZero || f.pieces.len() == 1;
        let fits = e.constraints.len() == self.relations.len() && self.relations.iter().zip(&e.constraints).all(single);
        if fits && is_good(&e.objective) && e.constraints.iter().all(is_good) { Ok(e) } else { Err(Undefined) }
    }

    fn scaled(&self, u: &[f64], e: Evaluation) -> Point {
        let raw = e.values();
        let objective = self.pieces(e.objective, self.objective_scale);
        let scales = self.constraint_scale.iter();
        let constraints = e.constraints.into_iter().zip(scales).map(|(f, &s)| self.pieces(f, s)).collect();
        Point { u: u.to_vec(), objective, constraints, raw }
    }

    fn pieces(&self, function: Function, by: f64) -> Vec<Piece> {
        function.pieces.into_iter().map(|p| self.piece(&p, by)).collect()
    }

    fn piece(&self, piece: &Piece, by: f64) -> Piece {
        let gradient = self.free.iter().zip(&self.scale).map(|(&j, s)| piece.gradient[j] * s / by).collect();
        Piece { value: piece.value / by, gradient }
    }

    /// Takes function scales from a point that was evaluated with scales of one, and applies them to it.
    pub(crate) fn scale_functions(&mut self, point: &mut Point) {
        self.objective_scale = function_scale(&point.objective);
        self.constraint_scale = point.constraints.iter().map(|pieces| function_scale(pieces)).collect();
        rescale(&mut point.objective, self.objective_scale);
        for (pieces, &s) in point.constraints.iter_mut().zip(&self.constraint_scale) {
            rescale(pieces, s);
        }
    }

    /// Scales again the constraints whose gradients have become ten times larger or smaller than at the start, and are near
    /// their limit. Returns whether there were any.
    pub(crate) fn follow_constraints(&mut self, point: &mut Point) -> bool {
        let mut any = false;
        for ((pieces, scale), relation) in
            point.constraints.iter_mut().zip(&mut self.constraint_scale).zip(&self.relations)
        {
            let by = function_scale(pieces).max(maximum(pieces).abs());
            let near = *relation == Relation::Zero || maximum(pieces) >= -by;
            if near && !(0.1..=10.0).contains(&by) {
                rescale(pieces, by);
                *scale *= by;
                any = true;
            }
        }
        any
    }

    /// Brings a point that was scaled earlier to the present scales of the constraints.
    pub(crate) fn apply_constraint_scales(&self, point: &mut Point) {
        for (i, pieces) in point.constraints.iter_mut().enumerate() {
            let now = point.raw.constraints[i] / self.constraint_scale[i];
            let was = maximum(pieces);
            if was != 0.0 && now != 0.0 {
                rescale(pieces, was / now);
            }
        }
    }

    /// Greatest violation at a point in the caller's numbers.
    pub(crate) fn raw_violation(&self, point: &Point) -> f64 {
        raw_violation(&self.relations, &point.raw)
    }
}

fn is_gradient(g: &[f64], n: usize) -> bool {
    g.len() == n && g.iter().all(|x| x.is_finite())
}

fn check<P: Problem + ?Sized>(problem: &P, start: &[f64]) -> Result<(), Malformed> {
    let (variables, bounds) = (problem.variables(), problem.bounds());
    if bounds.len() != variables {
        return Err(Malformed::Bounds { found: bounds.len(), variables });
    }
    if start.len() != variables {
        return Err(Malformed::Start { found: start.len(), variables });
    }
    let empty =
        |&(l, u): &(f64, f64)| l.is_nan() || u.is_nan() || l > u || l == f64::INFINITY || u == f64::NEG_INFINITY;
    if let Some(variable) = bounds.iter().position(empty) {
        return Err(Malformed::EmptyBound { variable });
    }
    match start.iter().position(|x| !x.is_finite()) {
        Some(variable) => Err(Malformed::StartNotFinite { variable }),
        None => Ok(()),
    }
}

/// The width of the bounds; where they are absent or say little, the magnitude of the start.
fn variable_scale(x: f64, (l, u): (f64, f64)) -> f64 {
    let width = u - l;
    let magnitude = if x.abs() > 1e-6 { x.abs() } else { 1.0 };
    if width.is_finite() { width.min((100.0 * x.abs()).max(1.0)) } else { magnitude }
}

/// The size of the gradients; where they vanish against the value (a start that is stationary), of the value.
fn function_scale(pieces: &[Piece]) -> f64 {
    let gradient = pieces.iter().map(|p| largest(&p.gradient)).fold(0.0, f64::max);
    let value = maximum(pieces).abs();
    if gradient > 1e-8 * value.max(1e-8) { gradient.max(1e-4 * value) } else { value.max(1.0) }
}

fn rescale(pieces: &mut [Piece], by: f64) {
    for piece in pieces {
        piece.value /= by;
        piece.gradient.iter_mut().for_each(|g| *g /= by);
    }
}
