//! Position by continuation: predict, correct by Newton, halve the step when it does not contract.

use super::machine::{Machine, Prepared};
use super::system::{LinearSystem, SINGULAR};
use super::unknowns::Prescribed;
use crate::attitude::{normalize, rotation_vector, wrap};
use crate::constraint::Measure;
use crate::mechanism::Source;
use crate::topology::Motion;
use crate::{Coordinate, MechanismError, Moved};
use bellcrank_math::{Space, matrix_from_rpy};

/// Newton iterations before a step is given up.
const MOST_ITERATIONS: usize = 12;
/// Corrections below this (m, rad) leave an error at rounding level: Newton converges quadratically.
const LAST_CORRECTION: f64 = 3e-8;
/// The smallest part of a step that is tried.
const SMALLEST_PART: f64 = 1e-7;
/// The largest turn of one step, rad: beyond it neither branch nor whole turns could be told.
const LARGEST_TURN: f64 = 1.6;
/// A correction may be this much of the step; beyond it another branch may be near.
const LARGEST_CORRECTION: f64 = 0.25;

/// Positions that extrapolation looks back on: a polynomial of one degree less.
const DEPTH: usize = 6;

/// The last positions of a uniform sweep, newest first, for extrapolation.
#[derive(Clone, Debug)]
pub(crate) struct History {
    q: [Vec<f64>; DEPTH],
    count: usize,
    increment: Vec<f64>,
}

impl History {
    pub(crate) fn new(nq: usize) -> Self {
        Self { q: std::array::from_fn(|_| vec![0.0; nq]), count: 0, increment: Vec::new() }
    }
    pub(crate) fn clear(&mut self) {
        self.count = 0;
    }
    /// Records an accepted position reached by this increment of the targets.
    fn push(&mut self, q: &[f64], from: &[f64], to: &[f64]) {
        let uniform = self.count > 0
            && self.increment.len() == to.len()
            && self.increment.iter().zip(from.iter().zip(to)).all(|(i, (a, b))| {
                let d = b - a;
                (d - i).abs() <= 1e-9 * d.abs().max(i.abs())
            });
        if !uniform && self.count > 1 {
            self.count = 1;
        }
        self.increment.clear();
        self.increment.extend(from.iter().zip(to).map(|(a, b)| b - a));
        self.q.rotate_right(1);
        self.q[0].copy_from_slice(q);
        self.count = (self.count + 1).min(DEPTH);
    }
    /// The next position by a polynomial through three to six equal steps.
    fn extrapolate(&self, from: &[f64], to: &[f64], out: &mut [f64]) -> bool {
        let same = self.increment.iter().zip(from.iter().zip(to)).all(|(i, (a, b))| {
            let d = b - a;
            (d - i).abs() <= 1e-6 * d.abs().max(i.abs())
        });
        if self.count < 3 || !same {
            return false;
        }
        // Binomial coefficients with alternating signs: the polynomial through the last equal steps.
        let weights: &[f64] = match self.count {
            3 => &[3.0, -3.0, 1.0],
            4 => &[4.0, -6.0, 4.0, -1.0],
            5 => &[5.0, -10.0, 10.0, -5.0, 1.0],
            _ => &[6.0, -15.0, 20.0, -15.0, 6.0, -1.0],
        };
        for (i, out) in out.iter_mut().enumerate() {
            *out = weights.iter().zip(&self.q).map(|(w, q)| w * q[i]).sum();
        }
        true
    }
}

/// How a Newton correction ended.
struct Corrected {
    converged: bool,
    iterations: usize,
}

impl<S: Space<T = f64>> Machine<S> {
    /// Moves the position coordinates to `targets`.
    pub(crate) fn continue_to(&mut self, time: f64, targets: &[f64]) -> Result<Moved, MechanismError> {
        let Some(mut prepared) = self.prepared.take() else {
            return Err(MechanismError::NotFinite("no actuation prepared"));
        };
        let result = if targets.iter().any(|t| !t.is_finite()) {
            Err(MechanismError::NotFinite("a prescribed position"))
        } else {
            let Prepared { position, actuation, targets: at, .. } = &mut *prepared;
            self.walk(position, &actuation.position, at, targets)
        };
        if let Ok(moved) = &result {
            self.time = time;
            self.note_unwrapped();
            let _ = moved;
        }
        let result = result.map(|mut moved| {
            let sign = prepared.position.determinant_sign();
            moved.passed_change_point = prepared.position_sign * sign < 0.0;
            if sign != 0.0 {
                prepared.position_sign = sign;
            }
            moved
        });
        self.prepared = Some(prepared);
        result
    }

    fn walk(
        &mut self,
        system: &mut LinearSystem,
        coordinates: &[Coordinate],
        at: &mut [f64],
        targets: &[f64],
    ) -> Result<Moved, MechanismError> {
        let mut moved = Moved::default();
        self.scratch.saved.copy_from_slice(&self.q);
        if self.whole_step(system, at, targets, &mut moved) {
            at.copy_from_slice(targets);
            return Ok(moved);
        }
        self.substeps(system, coordinates, at, targets, moved)
    }

    /// One step from a good prediction; leaves `q` anywhere when it fails.
    fn whole_step(&mut self, system: &mut LinearSystem, at: &[f64], targets: &[f64], moved: &mut Moved) -> bool {
        if !self.history.extrapolate(at, targets, &mut self.scratch.predicted) {
            return false;
        }
        self.q.copy_from_slice(&self.scratch.predicted);
        self.renormalize();
        let done = self.correct(system, targets);
        moved.iterations += done.iterations;
        moved.steps = 1;
        let good = done.converged && self.correction_is_small();
        if good {
            let Self { history, q, .. } = self;
            history.push(q, at, targets);
        }
        good
    }

    /// Distance of the solution from the prediction against the length of the step.
    fn correction_is_small(&self) -> bool {
        let turned = |n: &crate::mechanism::Node<S>| {
            matches!(n.motion, Motion::Turn | Motion::Screw(_))
                && (self.q[n.q] - self.scratch.saved[n.q]).abs() > LARGEST_TURN
        };
        if self.mech.nodes.iter().any(turned) {
            return false;
        }
        let largest = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
        let step = largest(&self.q, &self.scratch.saved);
        largest(&self.q, &self.scratch.predicted) <= LARGEST_CORRECTION * step + 1e-9
    }

    /// From the last good position along the tangent, in as many parts as it takes.
    fn substeps(
        &mut self,
        system: &mut LinearSystem,
        coordinates: &[Coordinate],
        at: &mut [f64],
        targets: &[f64],
        mut moved: Moved,
    ) -> Result<Moved, MechanismError> {
        let from = at.to_vec();
        let (mut done, mut part) = (0.0, 1.0_f64);
        let mut goal = from.clone();
        self.restore();
        while done < 1.0 {
            let next = if done + part >= 1.0 - 1e-12 { 1.0 } else { done + part };
            for (g, (a, b)) in goal.iter_mut().zip(from.iter().zip(targets)) {
                *g = if next == 1.0 { *b } else { a + (b - a) * next };
            }
            let tangent = self.predict_by_tangent(system, at, &goal);
            let result =
                if tangent { self.correct(system, &goal) } else { Corrected { converged: false, iterations: 0 } };
            moved.iterations += result.iterations;
            moved.steps += 1;
            if result.converged && self.correction_is_small() {
                self.scratch.saved.copy_from_slice(&self.q);
                let Self { history, q, .. } = self;
                history.push(q, at, &goal);
                at.copy_from_slice(&goal);
                self.note_unwrapped();
                done = next;
                part = (part * 2.0).min(1.0);
            } else {
                self.restore();
                part *= 0.5;
                if part < SMALLEST_PART {
                    return Err(self.stopped(system, coordinates, at, targets));
                }
            }
        }
        Ok(moved)
    }

    fn restore(&mut self) {
        self.q.copy_from_slice(&self.scratch.saved);
        self.update_positions();
    }

    /// `q` moved along the tangent of the solution curve; false where there is none.
    fn predict_by_tangent(&mut self, system: &mut LinearSystem, at: &[f64], goal: &[f64]) -> bool {
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        let ratio = system.factor(&self.mech, &self.rows, &self.x);
        if ratio < SINGULAR {
            // No tangent here: start from where we are and let Newton find the way.
            self.scratch.predicted.copy_from_slice(&self.q);
            return true;
        }
        self.scratch.delta.fill(0.0);
        self.scratch.rhs.fill(0.0);
        for (k, p) in system.prescribed.iter().enumerate() {
            match p {
                Prescribed::Node(n) => self.scratch.delta[self.mech.nodes[*n].v] = goal[k] - at[k],
                Prescribed::Row(row, source) => self.scratch.rhs[*row] = self.row_step(*source, k, at, goal),
            }
        }
        system.multiply_known(&self.rows, &self.scratch.delta, &mut self.scratch.product);
        for r in 0..system.rows {
            self.scratch.rhs[r] -= self.scratch.product[r];
        }
        system.solve(&self.scratch.rhs, &mut self.scratch.delta);
        self.step(1.0);
        self.scratch.predicted.copy_from_slice(&self.q);
        self.scratch.predicted.iter().all(|x| x.is_finite())
    }

    /// How far a prescribed row has to go from `at` to `goal`.
    fn row_step(&self, source: Source, k: usize, at: &[f64], goal: &[f64]) -> f64 {
        match source {
            Source::Measured { measure: Measure::Attitude(i), .. } => {
                let (a, g) = (attitude_of(k, i, at), attitude_of(k, i, goal));
                turn_between(&matrix_from_rpy(&g), &matrix_from_rpy(&a))[i]
            }
            _ => goal[k] - at[k],
        }
    }

    fn renormalize(&mut self) {
        for node in &self.mech.nodes {
            if node.motion == Motion::Ball {
                normalize(&mut self.q[node.q..node.q + 4]);
            }
        }
    }

    /// From nearby onto `targets`; `q` stays as it was where that fails.
    pub(crate) fn correct_to(&mut self, system: &mut LinearSystem, targets: &[f64]) -> bool {
        self.scratch.saved.copy_from_slice(&self.q);
        let converged = self.correct(system, targets).converged;
        if converged {
            self.note_unwrapped();
        } else {
            self.restore();
        }
        converged
    }

    /// Newton on the free coordinates with the prescribed ones at `targets`.
    fn correct(&mut self, system: &mut LinearSystem, targets: &[f64]) -> Corrected {
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                self.q[self.mech.nodes[*n].q] = targets[k];
            }
        }
        let tight = 1e-15 * self.mech.size.max(1e-3);
        let mut before = f64::INFINITY;
        for iteration in 0..MOST_ITERATIONS {
            self.update_positions();
            self.rows.evaluate(&self.mech, &self.q, &self.x);
            let error = self.fill_residual(system, targets);
            if !error.is_finite() || error > 1e3 * before {
                return Corrected { converged: false, iterations: iteration };
            }
            if error <= tight && iteration > 0 {
                return Corrected { converged: true, iterations: iteration };
            }
            before = error.min(before);
            let ratio = system.factor(&self.mech, &self.rows, &self.x);
            let size = if ratio < SINGULAR { self.damped_step(system) } else { self.newton_step(system) };
            self.step(1.0);
            if size <= LAST_CORRECTION {
                return self.settle(system, targets, iteration + 1);
            }
        }
        Corrected { converged: false, iterations: MOST_ITERATIONS }
    }

    /// After the last correction: poses and residuals at the final position.
    fn settle(&mut self, system: &mut LinearSystem, targets: &[f64], iterations: usize) -> Corrected {
        self.update_positions();
        self.rows.residuals(&self.mech, &self.q, &self.x);
        let error = self.fill_residual(system, targets);
        // Redundant equations from rounded dimensions may disagree a little; `check.closure` shows it.
        let limit = if system.is_redundant() { 1e-7 } else { 1e-11 };
        Corrected { converged: error <= limit * self.mech.size.max(1e-3), iterations }
    }

    fn newton_step(&mut self, system: &mut LinearSystem) -> f64 {
        self.scratch.delta.fill(0.0);
        system.solve(&self.scratch.rhs, &mut self.scratch.delta);
        self.scratch.delta.iter().fold(0.0, |m: f64, d| m.max(d.abs()))
    }

    /// A step where the matrix is singular: least squares with a little damping.
    fn damped_step(&mut self, system: &mut LinearSystem) -> f64 {
        let a = system.dense(&self.mech, &self.rows);
        let rhs = &self.scratch.rhs[..system.rows];
        self.scratch.delta.fill(0.0);
        let Some(svd) = bellcrank_math::linalg::dense::svd(&a, system.columns.len()) else { return f64::INFINITY };
        let top = svd.values.first().copied().unwrap_or(0.0);
        for (k, s) in svd.values.iter().enumerate().filter(|(_, s)| **s > 1e-9 * top) {
            let along: f64 = svd.left[k].iter().zip(rhs).map(|(u, b)| u * b).sum();
            for (c, v) in system.columns.iter().enumerate() {
                self.scratch.delta[*v] += svd.right[k][c] * along / s;
            }
        }
        self.scratch.delta.iter().fold(0.0, |m: f64, d| m.max(d.abs()))
    }

    /// `rhs = −residual`; its largest entry is returned.
    fn fill_residual(&mut self, system: &LinearSystem, targets: &[f64]) -> f64 {
        let mut largest: f64 = 0.0;
        for (r, value) in self.rows.value.iter().enumerate() {
            self.scratch.rhs[r] = -value;
            largest = if value.is_nan() { f64::INFINITY } else { largest.max(value.abs()) };
        }
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, source) = p {
                let error = self.row_error(*source, k, targets);
                self.scratch.rhs[*row] = -error;
                largest = if error.is_nan() { f64::INFINITY } else { largest.max(error.abs()) };
            }
        }
        largest
    }

    /// Measured less asked, angles by the shorter way.
    pub(crate) fn row_error(&self, source: Source, k: usize, targets: &[f64]) -> f64 {
        let Source::Measured { link, measure } = source else { return 0.0 };
        let pose = self.mech.links[link].pose(&self.x);
        if let Measure::Attitude(i) = measure {
            let target = attitude_of(k, i, targets);
            return turn_between(&pose.relative(), &matrix_from_rpy(&target))[i];
        }
        let error = self.mech.links[link].measure(measure, &pose).value - targets[k];
        if measure.is_angle() { wrap(error) } else { error }
    }

    pub(crate) fn stopped(
        &mut self,
        system: &mut LinearSystem,
        coordinates: &[Coordinate],
        at: &[f64],
        targets: &[f64],
    ) -> MechanismError {
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        system.factor(&self.mech, &self.rows, &self.x);
        let (singular_value, mobile) = self.weakest(system);
        let moved = (0..targets.len()).find(|&k| targets[k] != at[k]).unwrap_or(0);
        MechanismError::Stopped {
            coordinate: coordinates[moved],
            reached: at[moved],
            asked: targets[moved],
            singular_value,
            mobile,
        }
    }

    /// Smallest singular value (relative) of a filled system and the coordinates in its direction.
    pub(crate) fn weakest(&self, system: &LinearSystem) -> (f64, Vec<Coordinate>) {
        let a = system.dense(&self.mech, &self.rows);
        if a.len() > 600 {
            return (system.ratio, Vec::new());
        }
        let Some(svd) = bellcrank_math::linalg::dense::svd(&a, system.columns.len()) else { return (0.0, Vec::new()) };
        let (Some(top), Some(last)) = (svd.values.first(), svd.values.last()) else { return (0.0, Vec::new()) };
        let mut motion = vec![0.0; self.mech.nv];
        if let Some(right) = svd.right.last() {
            system.columns.iter().zip(right).for_each(|(v, x)| motion[*v] = *x);
        }
        (if *top > 0.0 { last / top } else { 0.0 }, self.coordinates_by_motion(&motion))
    }

    /// Coordinates of tree joints that take part in a motion (nv), most mobile first.
    pub(crate) fn coordinates_by_motion(&self, motion: &[f64]) -> Vec<Coordinate> {
        let mut found: Vec<(f64, Coordinate)> = Vec::new();
        for (j, sources) in self.mech.sources.iter().enumerate() {
            for (index, s) in sources.iter().enumerate() {
                if let Some(size) = self.part_of(j, *s, motion) {
                    found.push((size, Coordinate { joint: crate::JointId(j), index }));
                }
            }
        }
        let top = found.iter().fold(0.0, |m: f64, f| m.max(f.0));
        found.retain(|f| f.0 > 0.05 * top && f.0 > 0.0);
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.into_iter().map(|f| f.1).collect()
    }

    /// How much a coordinate of a tree joint takes part in a motion; the angles of a ball share its turning.
    fn part_of(&self, j: usize, source: Source, motion: &[f64]) -> Option<f64> {
        match source {
            Source::Node(n) => Some(motion[self.mech.nodes[n].v].abs()),
            Source::Measured { measure: Measure::Attitude(0), .. } => {
                let of_joint = |n: &&crate::mechanism::Node<S>| n.joint == Some(crate::JointId(j));
                let ball = self.mech.nodes.iter().filter(of_joint).find(|n| n.motion == Motion::Ball)?;
                Some(motion[ball.v..ball.v + 3].iter().map(|x| x * x).sum::<f64>().sqrt())
            }
            Source::Measured { .. } => None,
        }
    }

    /// Follows measured angles across ±180°.
    pub(crate) fn note_unwrapped(&mut self) {
        for (j, i, link, measure) in &self.measured_angles {
            let raw = self.mech.links[*link].measure(*measure, &self.mech.links[*link].pose(&self.x)).value;
            let last = &mut self.unwrapped[*j][*i];
            *last += wrap(raw - *last);
        }
        self.rows.note_coupled(&self.mech, &self.q, &self.x);
    }
    /// Measured angles start afresh within ±180°.
    pub(crate) fn reset_unwrapped(&mut self) {
        self.unwrapped.iter_mut().flatten().for_each(|u| *u = 0.0);
        self.rows.coupled.fill([0.0; 2]);
        self.note_unwrapped();
    }
}

/// Roll, pitch, yaw among targets, given that entry `k` is component `i`.
fn attitude_of(k: usize, i: usize, targets: &[f64]) -> [f64; 3] {
    std::array::from_fn(|c| targets.get(k + c - i).copied().unwrap_or(0.0))
}

/// Rotation vector of `A Bᵀ`.
fn turn_between(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [f64; 3] {
    rotation_vector(&std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[j][k]).sum())))
}
