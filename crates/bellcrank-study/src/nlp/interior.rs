//! A dense convex quadratic program by a primal-dual interior-point method, then exactly on the active set it found.
//!
//! min ½ zᵀHz + qᵀz subject to Gz ≤ h and l ≤ z ≤ u. H is positive semidefinite, and the feasible set has an interior: the
//! subproblems of this crate are elastic, so both hold. Mehrotra's predictor and corrector as in Nocedal and Wright, 2nd
//! ed., algorithm 16.4, with one step length for both kinds of unknowns.

use super::dense::{add_scaled, cholesky, cholesky_solve, dot, largest, solve, times};

/// A quadratic program of n unknowns and m rows. Infinite bounds are no bounds.
#[derive(Clone, Debug, Default)]
pub(crate) struct Quadratic {
    /// H, n × n by rows.
    pub(crate) hessian: Vec<f64>,
    /// q, n.
    pub(crate) linear: Vec<f64>,
    /// G, m × n by rows.
    pub(crate) rows: Vec<f64>,
    /// h, m.
    pub(crate) limits: Vec<f64>,
    /// l, n.
    pub(crate) lower: Vec<f64>,
    /// u, n.
    pub(crate) upper: Vec<f64>,
}

/// Its minimum with multipliers ≥ 0: Hz + q + Gᵀy − lower + upper = 0.
#[derive(Clone, Debug)]
pub(crate) struct Minimum {
    pub(crate) z: Vec<f64>,
    pub(crate) rows: Vec<f64>,
    pub(crate) lower: Vec<f64>,
    pub(crate) upper: Vec<f64>,
}

/// One inequality a·z ≤ b.
#[derive(Clone, Copy, Debug)]
enum Side {
    Row(usize),
    Lower(usize),
    Upper(usize),
}

/// The state of the iteration: unknowns, slacks s > 0 and multipliers y > 0 of all sides.
struct Interior<'a> {
    qp: &'a Quadratic,
    n: usize,
    sides: Vec<Side>,
    z: Vec<f64>,
    s: Vec<f64>,
    y: Vec<f64>,
}

/// A direction in all three.
struct Direction {
    z: Vec<f64>,
    s: Vec<f64>,
    y: Vec<f64>,
}

/// Solves the program. What is not finite stays at its start: the answer is finite for finite data.
pub(crate) fn minimize(qp: &Quadratic) -> Minimum {
    let mut state = Interior::new(qp);
    state.iterate();
    state.polish();
    state.finish()
}

impl<'a> Interior<'a> {
    fn new(qp: &'a Quadratic) -> Self {
        let n = qp.linear.len();
        let finite = |values: &[f64], side: fn(usize) -> Side| -> Vec<Side> {
            (0..n).filter(|&j| values[j].is_finite()).map(side).collect()
        };
        let mut sides: Vec<Side> = (0..qp.limits.len()).map(Side::Row).collect();
        sides.extend(finite(&qp.lower, Side::Lower));
        sides.extend(finite(&qp.upper, Side::Upper));
        let z: Vec<f64> = (0..n).map(|j| inside(qp.lower[j], qp.upper[j])).collect();
        let mut state = Self { qp, n, sides, z, s: Vec::new(), y: Vec::new() };
        state.s =
            state.sides.iter().map(|&side| (state.limit(side) - state.apply(side, &state.z)).abs().max(1.0)).collect();
        state.y = vec![largest(&qp.linear).max(1.0); state.sides.len()];
        state
    }

    /// a·z of one side.
    fn apply(&self, side: Side, z: &[f64]) -> f64 {
        match side {
            Side::Row(i) => dot(self.row(i), z),
            Side::Lower(j) => -z[j],
            Side::Upper(j) => z[j],
        }
    }

    /// out += w a of one side.
    fn add(&self, side: Side, w: f64, out: &mut [f64]) {
        match side {
            Side::Row(i) => add_scaled(out, w, self.row(i)),
            Side::Lower(j) => out[j] -= w,
            Side::Upper(j) => out[j] += w,
        }
    }

    fn row(&self, i: usize) -> &[f64] {
        &self.qp.rows[i * self.n..(i + 1) * self.n]
    }

    fn limit(&self, side: Side) -> f64 {
        match side {
            Side::Row(i) => self.qp.limits[i],
            Side::Lower(j) => -self.qp.lower[j],
            Side::Upper(j) => self.qp.upper[j],
        }
    }

    /// Hz + q + Σ y a.
    fn dual_residual(&self) -> Vec<f64> {
        let mut r = times(&self.qp.hessian, &self.z);
        add_scaled(&mut r, 1.0, &self.qp.linear);
        for (&side, &y) in self.sides.iter().zip(&self.y) {
            self.add(side, y, &mut r);
        }
        r
    }

    /// a·z + s − b.
    fn primal_residual(&self) -> Vec<f64> {
        let residual = |(&side, &s): (&Side, &f64)| self.apply(side, &self.z) + s - self.limit(side);
        self.sides.iter().zip(&self.s).map(residual).collect()
    }

    fn gap(&self) -> f64 {
        dot(&self.s, &self.y) / self.sides.len().max(1) as f64
    }

    /// H + Σ (y/s) a aᵀ, factored.
    fn normal_matrix(&self) -> Vec<f64> {
        let n = self.n;
        let mut m = self.qp.hessian.clone();
        for (k, &side) in self.sides.iter().enumerate() {
            let w = self.y[k] / self.s[k];
            match side {
                Side::Row(i) => add_outer(&mut m, w, self.row(i)),
                Side::Lower(j) | Side::Upper(j) => m[j * n + j] += w,
            }
        }
        cholesky(&mut m, n);
        m
    }

    /// The Newton direction for given right-hand sides: dual, primal, and s∘y → `target`.
    fn direction(&self, factor: &[f64], dual: &[f64], primal: &[f64], target: &[f64]) -> Direction {
        let mut dz: Vec<f64> = dual.iter().map(|r| -r).collect();
        for (k, &side) in self.sides.iter().enumerate() {
            self.add(side, -(target[k] + self.y[k] * primal[k]) / self.s[k], &mut dz);
        }
        cholesky_solve(factor, &mut dz);
        let ds: Vec<f64> = self.sides.iter().zip(primal).map(|(&side, r)| -r - self.apply(side, &dz)).collect();
        let dy = (0..ds.len()).map(|k| (target[k] - self.y[k] * ds[k]) / self.s[k]).collect();
        Direction { z: dz, s: ds, y: dy }
    }

    fn iterate(&mut self) {
        let size = 1.0 + largest(&self.qp.linear);
        let reach = 1.0 + largest(&self.qp.limits);
        for _ in 0..60 {
            let (dual, primal, gap) = (self.dual_residual(), self.primal_residual(), self.gap());
            let solved = largest(&dual) <= 1e-12 * size && largest(&primal) <= 1e-13 * reach && gap <= 1e-14 * size;
            if solved || self.sides.is_empty() && self.newton(&dual) || !self.advance(&dual, &primal, gap) {
                break;
            }
        }
    }

    /// Without any side the minimum is one solve away.
    fn newton(&mut self, dual: &[f64]) -> bool {
        let mut dz: Vec<f64> = dual.iter().map(|r| -r).collect();
        cholesky_solve(&self.normal_matrix(), &mut dz);
        add_scaled(&mut self.z, 1.0, &dz);
        true
    }

    /// One predictor and corrector; false when no progress is possible any more.
    fn advance(&mut self, dual: &[f64], primal: &[f64], gap: f64) -> bool {
        let factor = self.normal_matrix();
        let products: Vec<f64> = self.s.iter().zip(&self.y).map(|(s, y)| -s * y).collect();
        let affine = self.direction(&factor, dual, primal, &products);
        let a = self.longest(&affine);
        let after: f64 = (0..self.s.len()).map(|k| (self.s[k] + a * affine.s[k]) * (self.y[k] + a * affine.y[k])).sum();
        let centre = (after / self.s.len() as f64 / gap).powi(3).clamp(0.0, 1.0) * gap;
        let target: Vec<f64> = (0..products.len()).map(|k| products[k] - affine.s[k] * affine.y[k] + centre).collect();
        let direction = self.direction(&factor, dual, primal, &target);
        let a = self.longest(&direction) * (1.0 - 0.01f64.min(gap.sqrt()).max(1e-4));
        if a.is_nan() || a <= 1e-10 || direction.z.iter().chain(&direction.y).any(|x| !x.is_finite()) {
            return false;
        }
        add_scaled(&mut self.z, a, &direction.z);
        add_scaled(&mut self.s, a, &direction.s);
        add_scaled(&mut self.y, a, &direction.y);
        true
    }

    /// The step, at most 1, at which the first slack or multiplier vanishes.
    fn longest(&self, d: &Direction) -> f64 {
        let ratio = |(x, dx): (&f64, &f64)| if *dx < 0.0 { -x / dx } else { f64::INFINITY };
        let slacks = self.s.iter().zip(&d.s).map(ratio);
        slacks.chain(self.y.iter().zip(&d.y).map(ratio)).fold(1.0, f64::min)
    }

    /// Takes the active set as known, solves for it exactly, mends it a few times; keeps the interior point if that fails.
    fn polish(&mut self) {
        let mut active: Vec<usize> = (0..self.s.len()).filter(|&k| self.y[k] > self.s[k]).collect();
        for _ in 0..4 {
            let Some((z, y)) = self.on_active(&active) else { return };
            let size = 1.0 + largest(&y);
            let slack: Vec<f64> = self.sides.iter().map(|&side| self.limit(side) - self.apply(side, &z)).collect();
            let wrong = |k: &usize| slack[*k] < -1e-11 * (1.0 + self.limit(self.sides[*k]).abs());
            let violated: Vec<usize> = (0..slack.len()).filter(|k| !active.contains(k)).filter(wrong).collect();
            let negative: Vec<usize> = (0..y.len()).filter(|&i| y[i] < -1e-11 * size).collect();
            if violated.is_empty() && negative.is_empty() {
                self.accept(&active, z, &y);
                return;
            }
            active = active.iter().enumerate().filter(|(i, _)| !negative.contains(i)).map(|(_, &k)| k).collect();
            active.extend(violated);
        }
    }

    fn accept(&mut self, active: &[usize], z: Vec<f64>, y: &[f64]) {
        self.z = z;
        self.y.iter_mut().for_each(|y| *y = 0.0);
        active.iter().zip(y).for_each(|(&k, y)| self.y[k] = y.max(0.0));
    }

    /// H z + Aᵀy = −q, A z = b.
    fn on_active(&self, active: &[usize]) -> Option<(Vec<f64>, Vec<f64>)> {
        let (n, all) = (self.n, self.n + active.len());
        let mut a = vec![0.0; all * all];
        let mut b: Vec<f64> = self.qp.linear.iter().map(|q| -q).collect();
        (0..n).for_each(|i| a[i * all..i * all + n].copy_from_slice(&self.qp.hessian[i * n..(i + 1) * n]));
        for (i, &k) in active.iter().enumerate() {
            let start = (n + i) * all;
            self.add(self.sides[k], 1.0, &mut a[start..start + n]);
            (0..n).for_each(|j| a[j * all + n + i] = a[start + j]);
            b.push(self.limit(self.sides[k]));
        }
        let mut z = solve(&a, &b)?;
        let y = z.split_off(n);
        Some((z, y))
    }

    fn finish(self) -> Minimum {
        let m = self.qp.limits.len();
        let (mut lower, mut upper) = (vec![0.0; self.n], vec![0.0; self.n]);
        for (&side, &y) in self.sides.iter().zip(&self.y).skip(m) {
            match side {
                Side::Lower(j) => lower[j] = y,
                Side::Upper(j) => upper[j] = y,
                Side::Row(_) => {}
            }
        }
        Minimum { z: self.z, rows: self.y[..m].to_vec(), lower, upper }
    }
}

/// A number inside an interval, zero if that is.
fn inside(lower: f64, upper: f64) -> f64 {
    match (lower.is_finite(), upper.is_finite()) {
        (true, true) => 0.0f64.clamp(lower + 0.1 * (upper - lower), upper - 0.1 * (upper - lower)),
        (true, false) => 0.0f64.max(lower + 1.0),
        (false, true) => 0.0f64.min(upper - 1.0),
        (false, false) => 0.0,
    }
}

/// The lower triangle of m += w a aᵀ.
fn add_outer(m: &mut [f64], w: f64, a: &[f64]) {
    let n = a.len();
    for i in 0..n {
        if a[i] != 0.0 {
            add_scaled(&mut m[i * n..i * n + i + 1], w * a[i], &a[..=i]);
        }
    }
}
