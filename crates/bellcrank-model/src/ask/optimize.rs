//! The best parameters: an optimization over trials with exact gradients.

mod display;
mod problem;
mod told;

use std::ops::ControlFlow;

use bellcrank_results::{Findings, IterationRow, StudyResult};
use bellcrank_study::nlp::{Multistart, Optimum, Options, Status, multistart_watched};

use super::Asking;
use crate::design::Optimize;
use crate::progress::Progress;
use crate::trial::Undefined;
use display::Display;
use problem::Designing;

pub(super) fn run(
    asking: &Asking<'_>,
    question: &Optimize,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<(), Undefined> {
    progress.at(0.0, "optimizing");
    let mut problem = Designing::new(asking, question);
    let start: Vec<f64> = question.variables.iter().map(|v| asking.value(v.parameter)).collect();
    let before = problem.responses(&start);
    problem.scale(before.as_ref().ok().map(Vec::as_slice));
    let options = options(question);
    let mut history: Vec<IterationRow> = Vec::new();
    let mut display = Display::new(asking, question);
    let mut stopped = false;
    let mut watch = |start: usize, at: &bellcrank_study::nlp::Progress| {
        display.row(start, at, progress);
        history.push(row(start, at, question.maximize));
        stopped |= progress.cancelled();
        if stopped { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let within = within(&start, problem.limits());
    let plan = Multistart::new(question.starts, question.seed);
    let optima = multistart_watched(&mut problem, &within, &plan, &options, &mut watch);
    let optima = optima.map_err(|why| Undefined { message: why.to_string(), hints: Vec::new() })?;
    let told =
        told::Told { asking, question, options: &options, start: &start, before: &before, optima: &optima, stopped };
    let found = told.findings(&mut problem, history);
    result.effort = vec![
        ("designs".to_owned(), problem.designs as f64),
        ("positions".to_owned(), problem.positions() as f64),
        (
            "gradient_evaluations".to_owned(),
            optima.iter().flat_map(|o| &o.searches).map(|s| s.solution.gradient_evaluations).sum::<usize>() as f64,
        ),
    ];
    result.warnings.extend(told.warnings(&found, problem.hole.as_ref()));
    let failure = told.failure(&found, &problem);
    result.findings = Some(Findings::Optimization(found));
    failure.map_or(Ok(()), Err)
}

/// The responses of the objective at values of the variables.
pub(crate) fn terms(asking: &Asking<'_>, question: &Optimize, x: &[f64]) -> Result<Vec<f64>, Undefined> {
    let mut numbers = Designing::new(asking, question).responses(x)?;
    numbers.truncate(question.terms.len());
    Ok(numbers)
}

fn options(question: &Optimize) -> Options {
    let mut options = Options::default();
    if let Some(tolerance) = question.tolerance {
        options.tolerances.optimality = tolerance;
    }
    if let Some(iterations) = question.iterations {
        options.iterations = iterations;
    }
    options
}

/// The solver starts inside the bounds, wherever the file stands.
fn within(start: &[f64], bounds: &[(f64, f64)]) -> Vec<f64> {
    start.iter().zip(bounds).map(|(x, (min, max))| x.max(*min).min(*max)).collect()
}

/// What is made small inside is the objective, or its opposite.
fn sign(maximize: bool) -> f64 {
    if maximize { -1.0 } else { 1.0 }
}

fn row(start: usize, at: &bellcrank_study::nlp::Progress, maximize: bool) -> IterationRow {
    IterationRow {
        start,
        iteration: at.iteration,
        evaluations: at.evaluations,
        objective: sign(maximize) * at.objective,
        violation: at.violation,
        optimality: at.optimality,
        step: at.step,
    }
}

/// The status as results name it.
fn named(status: Status) -> &'static str {
    match status {
        Status::Converged => "converged",
        Status::StepTooSmall => "small-step",
        Status::IterationLimit => "iteration-limit",
        Status::Infeasible => "infeasible",
        Status::Interrupted => "interrupted",
        Status::UndefinedStart => "no-start",
    }
}

/// The best of all starts.
fn best(optima: &[Optimum]) -> &bellcrank_study::nlp::Solution {
    // There is at least one start.
    &optima[0].solution
}
