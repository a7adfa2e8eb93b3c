//! Steps of the generalized-α method on the Lie group of the joint coordinates, stabilized to index 2.
//!
//! With the acceleration-like a of Chung & Hulbert (1993), `(1 − α_m) a₁ + α_m a₀ = (1 − α_f) v̇₁ + α_f v̇₀`,
//!
//! `q₁ = q₀ ∘ exp(h v₀ + h² (½ − β) a₀ + h² β a₁ + D)`,  `v₁ = v₀ + h (1 − γ) a₀ + h γ a₁`,
//!
//! where λ holds the velocities on their constraints and the correction D = −h M⁻¹Jᵀη the positions on theirs (Arnold &
//! Brüls 2007 for the group, Arnold, Cardona & Brüls 2015 for the stabilized index 2). Second order in q, v and λ.

use super::door::{Method, Surroundings};
use super::dop853::STAGES;
use super::explicit::{SHARE, after, before};
use super::flight::Flight;
use super::state::error_norm;
use super::step::Between;
use crate::solver::{LARGE, Machine, Prescribed};
use crate::{MechanismError, dynamics, kinematics};
use bellcrank_math::Space;
use bellcrank_math::linalg::BandLu;

/// Newton iterations of one step.
const MOST_ITERATIONS: usize = 10;
/// Corrections below this part of the tolerance end the iteration.
const CONVERGED: f64 = 1e-3;
/// Spectral radius where none is asked for.
const RADIUS: f64 = 0.8;
/// Steps below this part of the time passed (or of a second) have collapsed.
const SMALLEST: f64 = 1e-13;

/// The method's numbers from its spectral radius at infinity (Chung & Hulbert 1993).
#[derive(Clone, Copy, Debug)]
struct Weights {
    alpha_m: f64,
    alpha_f: f64,
    beta: f64,
    gamma: f64,
    /// How far a looks ahead of v̇, in steps.
    ahead: f64,
}

impl Weights {
    fn of(method: Method) -> Self {
        let rho = if let Method::GeneralizedAlpha { spectral_radius } = method { spectral_radius } else { RADIUS };
        let (alpha_m, alpha_f) = ((2.0 * rho - 1.0) / (rho + 1.0), rho / (rho + 1.0));
        let ahead = alpha_m - alpha_f;
        Self { alpha_m, alpha_f, beta: 0.25 * (1.0 - ahead).powi(2), gamma: 0.5 - ahead, ahead }
    }
    /// Change of a₁ a unit of v̇₁.
    fn slope(self) -> f64 {
        (1.0 - self.alpha_f) / (1.0 - self.alpha_m)
    }
    /// Factors of h³ v̈ in the local error of positions, and of h³ v⃛ in that of velocities.
    fn errors(self) -> [f64; 2] {
        let (t, g) = (self.ahead, self.gamma);
        [(0.5 * t + self.beta - 1.0 / 6.0).abs(), (0.5 * t * t + g * t + 0.5 * g - 1.0 / 6.0).abs()]
    }
}

/// What the method carries from step to step, over velocity components.
#[derive(Debug, Default)]
pub(crate) struct Alpha {
    /// v̇ and a at the beginning.
    vd0: Vec<f64>,
    a0: Vec<f64>,
    /// The same at the end.
    vd1: Vec<f64>,
    a1: Vec<f64>,
    /// Correction of the positions.
    correction: Vec<f64>,
    move_by: Vec<f64>,
    change: Vec<f64>,
    /// Slope of v̇ over the last step, and its length, s.
    jerk: Vec<f64>,
    length: f64,
    /// The iteration matrix, and the step length that it belongs to.
    matrix: Option<BandLu>,
    matrix_length: f64,
    right: Vec<f64>,
    /// Carried on from the step before.
    running: bool,
}

impl Alpha {
    /// The next step begins afresh.
    pub(crate) fn forget(&mut self) {
        self.running = false;
        self.matrix_length = 0.0;
    }
    fn size(&mut self, nv: usize) {
        let Self { vd0, a0, vd1, a1, correction, move_by, change, jerk, .. } = self;
        for list in [vd0, a0, vd1, a1, correction, move_by, change, jerk] {
            list.resize(nv, 0.0);
        }
    }
}

/// How the iteration ended.
enum Iterated {
    Converged,
    Failed,
}

impl<S: Space<T = f64>> Machine<S> {
    /// One step from the end of the last one, not beyond `limit`.
    pub(crate) fn step_implicitly(
        &mut self,
        f: &mut Flight<S>,
        limit: f64,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        let weights = Weights::of(f.dynamics.method);
        self.use_masses(f);
        let anew = f.step.stale;
        f.step.go_on();
        self.freshen(f, around)?;
        if f.step.wished <= 0.0 {
            f.step.wished = self.first_length(f, limit, around)?;
        }
        if anew || !f.alpha.running {
            self.begin_alpha(f, weights, around)?;
        }
        loop {
            let h = self.choose_length(f, limit);
            match self.try_implicit(f, h, weights, around)? {
                Ok(error) => {
                    self.accept_implicit(f, h, error);
                    return Ok(());
                }
                Err(part) => {
                    f.effort.rejected += 1;
                    f.step.wished = h * part;
                    if f.step.wished < SMALLEST * f.step.t0.abs().max(1e-3) || f.dynamics.fixed_step.is_some() {
                        return Err(self.collapsed(f, h * part));
                    }
                }
            }
        }
    }

    fn choose_length(&self, f: &mut Flight<S>, limit: f64) -> f64 {
        let fixed = f.dynamics.fixed_step;
        let wished = fixed.unwrap_or(f.step.wished).min(f.dynamics.largest_step);
        let left = limit - f.step.t0;
        let h = if wished >= left * 0.999 {
            left
        } else if fixed.is_none() && wished > 0.5 * left {
            0.5 * left
        } else {
            wished
        };
        f.step.t1 = if h == left { limit } else { f.step.t0 + h };
        h
    }

    /// v̇ and a at the beginning: a looks ahead along v̈, which a small trial step shows.
    fn begin_alpha(
        &mut self,
        f: &mut Flight<S>,
        weights: Weights,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        let (nq, nv) = (self.mech.nq, self.mech.nv);
        f.alpha.size(nv);
        f.alpha.vd0.copy_from_slice(&f.step.slope(0)[nq..]);
        let h = f.dynamics.fixed_step.unwrap_or(f.step.wished);
        let trial = 1e-3 * h;
        f.step.combine(trial, &[(0, 1.0)]);
        self.load(f);
        self.time = after(f.step.t0 + trial);
        self.accelerate(f, around)?;
        for i in 0..nv {
            let bend = (self.a[i] - f.alpha.vd0[i]) / trial;
            f.alpha.a0[i] = f.alpha.vd0[i] + weights.ahead * h * bend;
            f.alpha.jerk[i] = bend;
        }
        f.alpha.length = h;
        f.alpha.running = true;
        Ok(())
    }

    /// A step of length `h`: its error in tolerances, or the part of it to try next.
    fn try_implicit(
        &mut self,
        f: &mut Flight<S>,
        h: f64,
        weights: Weights,
        around: &mut dyn Surroundings,
    ) -> Result<Result<f64, f64>, MechanismError> {
        self.predict_implicit(f, h, weights);
        for attempt in 0..2 {
            match self.iterate(f, h, weights, around) {
                Ok(Iterated::Converged) => {
                    let error = if f.dynamics.fixed_step.is_some() { 0.0 } else { self.implicit_error(f, h, weights) };
                    if error.is_nan() || error > 1.0 {
                        return Ok(Err((0.8 * error.powf(-1.0 / 3.0)).clamp(0.1, 0.7)));
                    }
                    return Ok(if self.land_implicit(f, around)? { Ok(error) } else { Err(0.25) });
                }
                Ok(Iterated::Failed) if attempt == 0 && !f.jacobian.fresh => {
                    f.jacobian.forget();
                    self.predict_implicit(f, h, weights);
                }
                Ok(Iterated::Failed) => return Ok(Err(0.25)),
                Err(error) if h <= 1e-9 * f.step.t0.abs().max(1e-3) => return Err(error),
                Err(_) => return Ok(Err(0.25)),
            }
        }
        Ok(Err(0.25))
    }

    fn predict_implicit(&mut self, f: &mut Flight<S>, h: f64, w: Weights) {
        let alpha = &mut f.alpha;
        // The step has another length than the last one: a looks ahead by another time.
        let shift = w.ahead * (h - alpha.length);
        for i in 0..alpha.a0.len() {
            alpha.a0[i] += shift * alpha.jerk[i];
            alpha.vd1[i] = alpha.vd0[i] + h * alpha.jerk[i];
            alpha.a1[i] = ((1.0 - w.alpha_f) * alpha.vd1[i] + w.alpha_f * alpha.vd0[i] - w.alpha_m * alpha.a0[i])
                / (1.0 - w.alpha_m);
        }
        alpha.length = h;
        alpha.correction.fill(0.0);
    }

    /// Newton's iteration on motion, velocity constraints and position constraints together.
    fn iterate(
        &mut self,
        f: &mut Flight<S>,
        h: f64,
        w: Weights,
        around: &mut dyn Surroundings,
    ) -> Result<Iterated, MechanismError> {
        let (dv, dq) = (h * w.gamma * w.slope(), h * h * w.beta * w.slope());
        let mut before_size = f64::INFINITY;
        for iteration in 0..MOST_ITERATIONS {
            f.effort.newton_iterations += 1;
            self.put_implicit(f, h, w);
            self.residual_implicit(f, around)?;
            if !f.jacobian.known && self.mech.nv <= LARGE {
                self.take_stiffness(f, around)?;
                f.alpha.matrix_length = 0.0;
            }
            if f.alpha.matrix_length != h {
                self.factor_implicit(f, dv, dq)?;
                f.alpha.matrix_length = h;
            }
            let size = self.correct_implicit(f, dv, dq, w);
            f.jacobian.fresh &= iteration == 0;
            if !size.is_finite() || size > 2.0 * before_size && iteration > 1 {
                return Ok(Iterated::Failed);
            }
            // What no longer shrinks is rounding.
            let stands = size <= 0.1 && size > 0.3 * before_size;
            if size <= CONVERGED || size <= 1e-2 && size < 1e-3 * before_size || stands {
                self.put_implicit(f, h, w);
                return Ok(Iterated::Converged);
            }
            before_size = size;
        }
        Ok(Iterated::Failed)
    }

    /// The state at the end that the present v̇₁ and D make.
    fn put_implicit(&mut self, f: &mut Flight<S>, h: f64, w: Weights) {
        let nq = self.mech.nq;
        self.q.copy_from_slice(&f.step.y0[..nq]);
        for i in 0..self.mech.nv {
            let v0 = f.step.y0[nq + i];
            let (a0, a1) = (f.alpha.a0[i], f.alpha.a1[i]);
            self.scratch.delta[i] = h * v0 + h * h * ((0.5 - w.beta) * a0 + w.beta * a1) + f.alpha.correction[i];
            self.v[i] = v0 + h * ((1.0 - w.gamma) * a0 + w.gamma * a1);
        }
        self.step(1.0);
        self.a.copy_from_slice(&f.alpha.vd1);
        self.time = before(f.step.t1);
    }

    /// Unbalanced forces into `tau`, by the present multipliers.
    fn residual_implicit(&mut self, f: &mut Flight<S>, around: &mut dyn Surroundings) -> Result<(), MechanismError> {
        f.effort.evaluations += 1;
        self.take_drives(f, around)?;
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                self.a[self.mech.nodes[*n].v] = f.acceleration[k];
            }
        }
        self.update_positions();
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        self.stage = crate::solver::Stage::Rates;
        self.ask_inputs(&mut |at, values| around.inputs(at, values))?;
        self.apply_forces();
        if self.has_friction {
            self.reactions_here(f);
            self.update_slip(f);
        }
        dynamics::own_wrenches(&self.mech, &mut self.x);
        let (mut left, efforts) = (std::mem::take(&mut self.tau), std::mem::take(&mut self.efforts));
        self.passes(&f.saddle.prescribed).residual(&efforts, &mut left);
        (self.tau, self.efforts) = (left, efforts);
        Ok(())
    }

    /// `M + dv C + dq K` and the constraints, factored.
    fn factor_implicit(&mut self, f: &mut Flight<S>, dv: f64, dq: f64) -> Result<(), MechanismError> {
        f.effort.factorizations += 1;
        f.mass.evaluate(&self.mech, &self.x);
        f.saddle.fill(&self.mech, &self.rows, &f.mass, &self.x);
        let nv = self.mech.nv;
        let known = f.jacobian.known;
        let tangent = |row: usize, column: usize| {
            let at = row * nv + column;
            if known { dv * f.jacobian.damping[at] + dq * f.jacobian.stiffness[at] } else { 0.0 }
        };
        let regular = if known {
            let matrix = f.alpha.matrix.take();
            let (matrix, ratio) = f.saddle.factor_with_tangent(matrix, tangent);
            f.alpha.matrix = Some(matrix);
            ratio > 1e-14
        } else {
            f.alpha.matrix = None;
            f.saddle.factor()
        };
        if regular { Ok(()) } else { Err(self.missing_mass(f)) }
    }

    /// One correction; its size in tolerances.
    fn correct_implicit(&mut self, f: &mut Flight<S>, dv: f64, dq: f64, w: Weights) -> f64 {
        let nv = self.mech.nv;
        f.load.iter_mut().zip(&self.tau).for_each(|(l, t)| *l = -t);
        self.fill_rates(f);
        f.gamma.iter_mut().for_each(|g| *g /= dv);
        let mut change = std::mem::take(&mut f.alpha.change);
        change.fill(0.0);
        self.solve_implicit(f, &mut change);
        self.lambda.iter_mut().zip(&f.mu).for_each(|(l, m)| *l -= m);
        // Positions: what the change of the accelerations moves them, and back onto the constraints.
        self.rows.residuals(&self.mech, &self.q, &self.x);
        self.fill_closure(f);
        let mut move_by = std::mem::take(&mut f.alpha.move_by);
        move_by.iter_mut().zip(&change).for_each(|(m, y)| *m = dq * y);
        f.saddle.times(&move_by, &mut self.scratch.product);
        f.gamma.iter_mut().zip(&self.scratch.product).for_each(|(g, p)| *g -= p);
        f.load.fill(0.0);
        self.scratch.delta.fill(0.0);
        let mut delta = std::mem::take(&mut self.scratch.delta);
        self.solve_implicit(f, &mut delta);
        for i in 0..nv {
            f.alpha.correction[i] += delta[i];
            f.alpha.vd1[i] += change[i];
            f.alpha.a1[i] += w.slope() * change[i];
        }
        let nq = self.mech.nq;
        let unit = &f.step.unit[nq..];
        let v0 = &f.step.y0[nq..];
        let tolerance = SHARE * f.dynamics.tolerance;
        let speeds = error_norm(change.iter().map(|y| dv * y), unit, [v0, v0], 0, tolerance);
        let places = error_norm((0..nv).map(|i| move_by[i] + delta[i]), unit, [v0, v0], nv, tolerance);
        (f.alpha.change, f.alpha.move_by, self.scratch.delta) = (change, move_by, delta);
        speeds.max(places)
    }

    fn solve_implicit(&mut self, f: &mut Flight<S>, out: &mut [f64]) {
        let Flight { saddle, alpha, load, gamma, mu, .. } = f;
        match &alpha.matrix {
            Some(matrix) => saddle.solve_with(matrix, &mut alpha.right, load, gamma, out, mu),
            None => saddle.solve(load, gamma, out, mu),
        }
    }

    /// Local error in tolerances: what the method leaves out of v̈ in the positions and of v⃛ in the velocities.
    fn implicit_error(&self, f: &Flight<S>, h: f64, w: Weights) -> f64 {
        let (nq, nv) = (self.mech.nq, self.mech.nv);
        let [places, speeds] = w.errors();
        let alpha = &f.alpha;
        let jerk = |i: usize| (alpha.vd1[i] - alpha.vd0[i]) / h;
        let unit = &f.step.unit[nq..];
        let ends = [&f.step.y0[nq..], &self.v[..]];
        let of_places =
            error_norm((0..nv).map(|i| places * h.powi(3) * jerk(i)), unit, ends, nv, SHARE * f.dynamics.tolerance);
        let snap = |i: usize| (jerk(i) - alpha.jerk[i]) / h;
        let of_speeds =
            error_norm((0..nv).map(|i| speeds * h.powi(3) * snap(i)), unit, ends, 0, SHARE * f.dynamics.tolerance);
        of_places.max(of_speeds)
    }

    /// Takes the end of a step, which meets dynamics and constraints as far as the iteration went; rows of the result
    /// are put onto the constraints one by one.
    fn land_implicit(&mut self, f: &mut Flight<S>, around: &mut dyn Surroundings) -> Result<bool, MechanismError> {
        self.take_drives(f, around)?;
        for (k, p) in f.saddle.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                self.a[self.mech.nodes[*n].v] = f.acceleration[k];
            }
        }
        self.update_positions();
        self.store(&mut f.step.y1);
        self.slope_into(f.step.slope_mut(STAGES));
        f.step.between = Between::Hermite;
        self.note_unwrapped();
        Ok(f.step.y1.iter().chain(f.step.slope(STAGES)).all(|x| x.is_finite()))
    }

    fn accept_implicit(&mut self, f: &mut Flight<S>, h: f64, error: f64) {
        f.effort.steps += 1;
        f.effort.implicit_steps += 1;
        let alpha = &mut f.alpha;
        for i in 0..alpha.vd0.len() {
            alpha.jerk[i] = (alpha.vd1[i] - alpha.vd0[i]) / h;
        }
        std::mem::swap(&mut alpha.vd0, &mut alpha.vd1);
        std::mem::swap(&mut alpha.a0, &mut alpha.a1);
        alpha.length = h;
        f.jacobian.fresh = false;
        let factor = if error > 0.0 { (0.9 * error.powf(-1.0 / 3.0)).clamp(0.3, 2.0) } else { 2.0 };
        // A step of nearly the same length keeps its matrix.
        let factor = if (1.0..1.25).contains(&factor) { 1.0 } else { factor };
        let wished = h * factor;
        f.step.wished = if h < f.step.wished { f.step.wished.max(wished) } else { wished };
    }
}
