//! The loop: subproblem, trial point, acceptance, trust region.

use std::ops::ControlFlow;

use super::answer::{assemble, undefined_start};
use super::dense::{add_scaled, largest};
use super::hessian::{Hessian, gradient_change};
use super::kkt::Judge;
use super::penalty::{Choice, GREATEST, choose};
use super::point::Point;
use super::problem::{Malformed, Problem};
use super::scaled::Scaled;
use super::solution::{Kkt, Options, Progress, Solution, Status};
use super::subproblem::{Frame, Linear, Step, Weights, solve as solve_step};
use super::trial::{corrected, learn, tangents};

/// Minimizes from `start` (n numbers, put inside the bounds first).
///
/// # Errors
///
/// [`Malformed`] if bounds and start do not fit the problem. Everything else is a [`Status`].
pub fn solve<P: Problem + ?Sized>(problem: &mut P, start: &[f64], options: &Options) -> Result<Solution, Malformed> {
    solve_watched(problem, start, options, &mut |_| ControlFlow::Continue(()))
}

/// [`solve`] that tells where it stands at the start and after every accepted step; `Break` ends it with the best point.
///
/// # Errors
///
/// [`Malformed`] if bounds and start do not fit the problem.
pub fn solve_watched<P: Problem + ?Sized>(
    problem: &mut P,
    start: &[f64],
    options: &Options,
    watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Solution, Malformed> {
    let mut scaled = Scaled::new(problem, start)?;
    let origin = vec![0.0; scaled.free.len()];
    let Ok(mut point) = scaled.evaluate(&origin) else { return Ok(undefined_start(&scaled, &origin)) };
    scaled.scale_functions(&mut point);
    let mut search = Search::new(scaled, point, options);
    let status = search.run(watch);
    Ok(search.finish(status))
}

/// The state of a search.
struct Search<'p, P: Problem + ?Sized> {
    scaled: Scaled<'p, P>,
    options: Options,
    point: Point,
    best: Point,
    hessian: Hessian,
    /// Unseen pieces that refused trial points showed since the last accepted step.
    extra: Linear,
    weights: Weights,
    radius: f64,
    penalty: f64,
    /// One, or zero while only the violation is minimized.
    weight: f64,
    /// Violation at which the search for feasibility began, and how many such searches there were.
    entered: f64,
    restorations: usize,
    restarts: usize,
    rescalings: usize,
    reductions: usize,
    /// Accepted steps in a row whose gain drowned in rounding.
    drowned: usize,
    iterations: usize,
    length: f64,
}

/// A trust region that is none.
const FAR: f64 = 10.0;

/// Whether a trial step was taken.
enum Taken {
    Yes,
    TooSmall,
}

impl<'p, P: Problem + ?Sized> Search<'p, P> {
    fn new(scaled: Scaled<'p, P>, point: Point, options: &Options) -> Self {
        let n = point.u.len();
        let extra = nothing(&point);
        let mut options = *options;
        // Whatever is asked, there is an end, and a beginning.
        options.tolerances.step = options.tolerances.step.max(1e-14);
        let radius = if options.first_step.is_nan() { 0.5 } else { options.first_step.clamp(1e-6, 1e3) };
        Self {
            hessian: Hessian::new(n),
            best: point.clone(),
            options,
            weights: Weights::default(),
            weight: 1.0,
            penalty: 1.0,
            entered: 0.0,
            restorations: 0,
            restarts: 0,
            rescalings: 0,
            reductions: 0,
            drowned: 0,
            iterations: 0,
            length: 0.0,
            scaled,
            point,
            extra,
            radius,
        }
    }

    fn run(&mut self, watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>) -> Status {
        loop {
            let choice = self.choose();
            let kkt = self.judge(&choice);
            if watch(&self.progress(&kkt)).is_break() {
                return Status::Interrupted;
            }
            if let Some(status) = self.decide(&kkt, &choice) {
                return status;
            }
            if self.iterations >= self.options.iterations {
                return Status::IterationLimit;
            }
            if self.is_stiff(&choice, &kkt) {
                self.restarts += 1;
                self.restart(self.weight);
                continue;
            }
            if matches!(self.advance(choice), Taken::TooSmall)
                && let Some(status) = self.give_up()
            {
                return status;
            }
        }
    }

    /// A tiny free step far from optimality: the learnt curvature is far too great.
    fn is_stiff(&self, choice: &Choice, kkt: &Kkt) -> bool {
        let tiny = largest(&choice.step.d) < 1e-9 && !choice.step.held;
        tiny && kkt.stationarity > 1e4 * self.options.tolerances.optimality && self.restarts < 3
    }

    fn tolerance(&self) -> f64 {
        self.options.tolerances.feasibility
    }

    fn violation(&self) -> f64 {
        self.point.worst_violation(&self.scaled.relations)
    }

    /// Distances from the point to the bounds.
    fn distances(&self) -> (Vec<f64>, Vec<f64>) {
        let lower = self.scaled.lower.iter().zip(&self.point.u).map(|(l, u)| (l - u).min(0.0)).collect();
        let upper = self.scaled.upper.iter().zip(&self.point.u).map(|(h, u)| (h - u).max(0.0)).collect();
        (lower, upper)
    }

    /// A step from `linear`, with the penalty that it needs.
    fn step_of(&self, linear: &Linear, radius: f64) -> Choice {
        let now = self.point.violations(&self.scaled.relations);
        self.with_frame(radius, |frame| choose(linear, frame, now, 0.1 * self.tolerance()))
    }

    fn with_frame<T>(&self, radius: f64, ask: impl FnOnce(&Frame) -> T) -> T {
        let (lower, upper) = self.distances();
        ask(&Frame {
            relations: &self.scaled.relations,
            hessian: &self.hessian.b,
            weight: self.weight,
            penalty: self.penalty,
            radius,
            lower: &lower,
            upper: &upper,
        })
    }

    fn choose(&mut self) -> Choice {
        let mut linear = tangents(&self.point);
        linear.objective.extend(self.extra.objective.iter().cloned());
        for (pieces, extra) in linear.constraints.iter_mut().zip(&self.extra.constraints) {
            pieces.extend(extra.iter().cloned());
        }
        let mut choice = self.step_of(&linear, self.radius);
        self.penalty = choice.penalty;
        if choice.step.held {
            // The wall of the trust region takes part of the force: ask for the multipliers without it.
            choice.step.weights = self.with_frame(self.radius.max(FAR), |frame| solve_step(&linear, frame)).weights;
        }
        choice
    }

    /// Residuals at the current point with the multipliers of the step. Pieces that only trial points showed do not count.
    fn judge(&mut self, choice: &Choice) -> Kkt {
        let mut weights = choice.step.weights.clone();
        weights.objective.truncate(self.point.objective.len());
        for (w, pieces) in weights.constraints.iter_mut().zip(&self.point.constraints) {
            w.truncate(pieces.len());
        }
        let (lower, upper) = self.distances();
        let judge = Judge { relations: &self.scaled.relations, lower: &lower, upper: &upper };
        let mut kkt = judge.residuals(&self.point, &weights);
        kkt.stationarity /= self.reference();
        self.weights = weights;
        kkt
    }

    /// What the gradient is compared with: its size at the start is one; where gradient and curvature have become much
    /// smaller, these.
    fn reference(&self) -> f64 {
        if self.hessian.is_fresh() { 1.0 } else { self.point.gradient_size().max(self.hessian.size()).clamp(1e-6, 1.0) }
    }

    fn progress(&self, kkt: &Kkt) -> Progress {
        Progress {
            iteration: self.iterations,
            evaluations: self.scaled.counts.evaluations,
            objective: self.point.raw.objective,
            violation: self.scaled.raw_violation(&self.point),
            optimality: kkt.stationarity,
            step: self.length,
        }
    }

    /// Whether the search ends here; also switches between minimizing the merit and the violation alone.
    fn decide(&mut self, kkt: &Kkt, choice: &Choice) -> Option<Status> {
        let tolerance = self.options.tolerances.optimality;
        let stationary = kkt.stationarity <= tolerance && kkt.complementarity <= 0.01 * tolerance;
        let feasible = kkt.feasibility <= self.tolerance();
        let restoring = self.weight == 0.0;
        // As long as the linearized constraints can be met better, a step says more than the gradients.
        let lasting = choice.step.violation > 0.9 * self.point.violations(&self.scaled.relations);
        match (feasible, stationary) {
            (true, true) if !restoring => Some(Status::Converged),
            (false, true) if restoring && lasting => Some(Status::Infeasible),
            (true, _) if restoring => self.leave_restoration(),
            (false, _) if restoring && self.point.violations(&self.scaled.relations) < 0.1 * self.entered => {
                self.leave_restoration()
            }
            (false, _) if !restoring && (stationary && lasting || choice.stuck || self.penalty >= GREATEST) => {
                self.restore()
            }
            _ => None,
        }
    }

    /// Minimizes the violation alone from here.
    fn restore(&mut self) -> Option<Status> {
        if self.restorations >= 5 {
            return Some(Status::Infeasible);
        }
        self.restorations += 1;
        self.entered = self.point.violations(&self.scaled.relations);
        self.restart(0.0);
        None
    }

    fn leave_restoration(&mut self) -> Option<Status> {
        self.restart(1.0);
        None
    }

    fn restart(&mut self, weight: f64) {
        self.weight = weight;
        self.penalty = 1.0;
        self.hessian = Hessian::new(self.point.u.len());
        self.radius = self.radius.max(0.1);
        self.extra = nothing(&self.point);
        self.drowned = 0;
    }

    /// No step helps: look for feasibility, or start once more without the learnt curvature.
    fn give_up(&mut self) -> Option<Status> {
        let feasible = self.violation() <= self.tolerance();
        match (feasible, self.weight > 0.0) {
            (false, true) => self.restore(),
            (false, false) => Some(Status::Infeasible),
            (true, _) if self.restarts < 2 && self.drowned == 0 => {
                self.restarts += 1;
                self.restart(1.0);
                None
            }
            (true, _) => Some(Status::StepTooSmall),
        }
    }

    /// Merit: w f + ρ Σ violations.
    fn merit(&self, point: &Point) -> f64 {
        self.weight * point.value() + self.penalty * point.violations(&self.scaled.relations)
    }

    /// Differences of the merit below this are rounding: of the objective, and of constraints whose terms are of size one.
    fn noise(&self) -> f64 {
        let constraints = self.scaled.relations.len() as f64 + self.point.violations(&self.scaled.relations);
        8.0 * f64::EPSILON * (self.weight * self.point.value().abs() + self.penalty * constraints)
    }

    fn at(&self, d: &[f64]) -> Vec<f64> {
        let mut u = self.point.u.clone();
        add_scaled(&mut u, 1.0, d);
        u
    }

    /// Tries steps, shorter and shorter, until one is taken.
    fn advance(&mut self, mut choice: Choice) -> Taken {
        loop {
            let length = largest(&choice.step.d);
            if length <= self.options.tolerances.step || self.drowned > 12 {
                return Taken::TooSmall;
            }
            match self.scaled.evaluate(&self.at(&choice.step.d)) {
                Err(_) => self.radius = 0.3 * length,
                Ok(trial) => {
                    if self.try_step(&choice.step, trial) {
                        return Taken::Yes;
                    }
                }
            }
            choice = self.choose();
        }
    }

    /// Takes the trial point, or its correction, or learns from it and shortens the trust region.
    fn try_step(&mut self, step: &Step, trial: Point) -> bool {
        let ratio = self.ratio(step, &trial);
        if ratio >= 1e-3 {
            self.resize(ratio, step);
            self.take(&step.d, &step.weights, trial);
            return true;
        }
        if let Some((d, corrected)) = self.correct(step, &trial)
            && let ratio = self.ratio(step, &corrected)
            && ratio >= 1e-3
        {
            self.resize(ratio, step);
            self.take(&d, &step.weights, corrected);
            return true;
        }
        self.refuse(step, &trial);
        false
    }

    /// Gain over predicted gain.
    fn ratio(&self, step: &Step, trial: &Point) -> f64 {
        let now = self.merit(&self.point);
        let noise = self.noise();
        (now - self.merit(trial) + noise) / ((now - step.merit).max(0.0) + noise).max(f64::MIN_POSITIVE)
    }

    fn resize(&mut self, ratio: f64, step: &Step) {
        let length = largest(&step.d);
        if ratio > 0.5 && step.held {
            self.radius = (2.0 * self.radius).min(1e3);
        } else if ratio < 0.25 {
            self.radius = (0.5 * length).max(0.25 * self.radius);
        }
    }

    fn take(&mut self, d: &[f64], weights: &Weights, trial: Point) {
        let gain = self.merit(&self.point) - self.merit(&trial);
        self.drowned = if gain.abs() <= self.noise() { self.drowned + 1 } else { 0 };
        self.learn_curvature(d, weights, &trial);
        self.length = largest(d);
        self.iterations += 1;
        self.point = trial;
        self.lower_penalty();
        self.follow_scales();
        self.extra = nothing(&self.point);
        if self.is_better(&self.point) {
            self.best = self.point.clone();
        }
    }

    /// A penalty far above the multipliers keeps the steps on the curved constraints and short. It goes down a limited
    /// number of times, so that in the end there is one merit.
    fn lower_penalty(&mut self) {
        let greatest = self.weights.constraints.iter().flatten().fold(0.0, |m: f64, w| m.max(w.abs()));
        let wanted = 1.5 * greatest + 1e-3;
        if self.weight > 0.0 && self.reductions < 100 && self.penalty > 1.5 * wanted {
            self.penalty = wanted.max(0.3 * self.penalty);
            self.reductions += 1;
        }
    }

    /// A start far away may have scaled a constraint badly. The best point is judged in the new scaling, too.
    fn follow_scales(&mut self) {
        if self.rescalings < 10 && self.scaled.follow_constraints(&mut self.point) {
            self.rescalings += 1;
            self.scaled.apply_constraint_scales(&mut self.best);
        }
    }

    fn learn_curvature(&mut self, d: &[f64], weights: &Weights, trial: &Point) {
        let mut own = weights.clone();
        own.objective.truncate(self.point.objective.len());
        for (w, pieces) in own.constraints.iter_mut().zip(&self.point.constraints) {
            w.truncate(pieces.len());
        }
        let y = gradient_change(&self.point, trial, &own, d);
        self.hessian.update(d, &y);
    }

    fn is_better(&self, point: &Point) -> bool {
        let relations = &self.scaled.relations;
        let (new, old) = (point.worst_violation(relations), self.best.worst_violation(relations));
        match (new <= self.tolerance(), old <= self.tolerance()) {
            (true, true) => point.value() <= self.best.value(),
            (false, false) => point.violations(relations) <= self.best.violations(relations),
            (feasible, _) => feasible,
        }
    }

    /// The second-order correction, where there is something to correct.
    fn correct(&mut self, step: &Step, trial: &Point) -> Option<(Vec<f64>, Point)> {
        let kinks = self.point.objective.len() > 1 || trial.objective.len() > 1;
        if !kinks && trial.violations(&self.scaled.relations) <= step.violation + self.tolerance() {
            return None;
        }
        let d = self.step_of(&corrected(&self.point, trial, &step.d), self.radius).step.d;
        let point = self.scaled.evaluate(&self.at(&d)).ok()?;
        Some((d, point))
    }

    fn refuse(&mut self, step: &Step, trial: &Point) {
        self.learn_curvature(&step.d, &step.weights, trial);
        learn(&mut self.extra, &self.scaled.relations, &self.point, trial, &step.d);
        self.radius = 0.3 * largest(&step.d);
    }

    fn finish(mut self, status: Status) -> Solution {
        if status == Status::Converged || self.is_better(&self.point) {
            self.best = self.point.clone();
        }
        let feasible = self.best.worst_violation(&self.scaled.relations) <= self.tolerance();
        let status = if feasible && status == Status::Infeasible { Status::StepTooSmall } else { status };
        self.weight = if status == Status::Infeasible { 0.0 } else { 1.0 };
        self.point = self.best.clone();
        self.extra = nothing(&self.point);
        let choice = self.choose();
        self.judge(&choice);
        self.answer(status)
    }

    /// A search that ran out of steps at a point that meets the tolerances has converged.
    fn final_status(&self, status: Status, kkt: &Kkt) -> Status {
        let tolerance = self.options.tolerances.optimality;
        let good = kkt.feasibility <= self.tolerance()
            && kkt.stationarity <= tolerance * self.reference()
            && kkt.complementarity <= 0.01 * tolerance;
        let ended = matches!(status, Status::StepTooSmall | Status::IterationLimit);
        if good && ended { Status::Converged } else { status }
    }

    /// Residuals and multipliers at the answer: those of the last step or those from the gradients alone, the better ones.
    fn answer(&self, status: Status) -> Solution {
        let (lower, upper) = self.distances();
        let judge = Judge { relations: &self.scaled.relations, lower: &lower, upper: &upper };
        let of_step = judge.residuals(&self.point, &self.weights);
        let fitted = judge.least_squares(&self.point, self.penalty.max(1.0) * 10.0);
        let of_fit = judge.residuals(&self.point, &fitted);
        let fit_wins = of_fit.worst() < of_step.worst();
        let (weights, kkt) = if fit_wins { (&fitted, of_fit) } else { (&self.weights, of_step) };
        let status = self.final_status(status, &kkt);
        assemble(&self.scaled, &self.point, weights, kkt, status, self.iterations)
    }
}

fn nothing(point: &Point) -> Linear {
    Linear { objective: Vec::new(), constraints: vec![Vec::new(); point.constraints.len()] }
}
