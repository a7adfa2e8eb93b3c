//! Numbers that can be computed with, but that no real machine has: a warning each.

use bellcrank_doc::Diagnostic;

use super::Numbers;
use crate::design::{Body, Design, Over, Study, Sweep, Task, Values};

/// Slack of the inequalities below, relative to the largest moment: numbers of a CAD program are rounded.
const SLACK: f64 = 1e-6;

/// Mass properties that contradict each other.
pub(crate) fn implausible(design: &Design, values: &Values) -> Vec<Diagnostic> {
    let Some(built) = super::build(design, values, &mut Vec::new()) else { return Vec::new() };
    let bodies = design.bodies.iter().zip(&built.blueprint.bodies);
    let mut found: Vec<Diagnostic> =
        bodies.filter_map(|(body, numbers)| mass(body, numbers).or_else(|| inertia(body, numbers))).collect();
    found.extend(super::solids::warnings(design, values, &built));
    found
}

fn mass(body: &Body, numbers: &bellcrank_multibody::Body<f64>) -> Option<Diagnostic> {
    let inertia = body.inertia.as_ref()?.first()?;
    let turns = numbers.inertia.iter().flatten().any(|entry| *entry != 0.0);
    if !turns || body.mass.is_some() {
        return None;
    }
    let message = format!("body `{}` has an inertia, but no mass", body.name);
    Some(Diagnostic::warning("no-mass", inertia.span(), message).hint("give `mass`, or take `inertia` out"))
}

/// A body in space: its tensor is positive, and each moment at most the sum of the other two.
fn inertia(body: &Body, numbers: &bellcrank_multibody::Body<f64>) -> Option<Diagnostic> {
    let values = body.inertia.as_ref().filter(|values| values.len() >= 3)?;
    let tensor: Vec<Vec<f64>> = numbers.inertia.iter().map(|row| row.to_vec()).collect();
    let (mut moments, _) = bellcrank_math::linalg::dense::symmetric_eigen(&tensor)?;
    moments.sort_by(f64::total_cmp);
    let &[small, middle, large] = moments.as_slice() else { return None };
    let slack = SLACK * large.abs();
    let warning = |code, message: String| {
        let first = values.first()?.span();
        let span = values.last().map_or(first, |last| first.to(last.span()));
        Some(Diagnostic::warning(code, span, message))
    };
    let name = &body.name;
    if small < -slack {
        let message =
            format!("`inertia` of body `{name}` is not positive: about one axis it is {} kg*m^2", rounded(small));
        let report = warning("inertia", message)?;
        return Some(report.hint("products of inertia are tensor entries: Ixy = -sum(m x y)"));
    }
    if large > small + middle + slack {
        let message = format!(
            "`inertia` of body `{name}` belongs to no body: the largest principal moment, {} kg*m^2, is above \
             the sum of the others, {} kg*m^2",
            rounded(large),
            rounded(small + middle)
        );
        return warning("inertia", message);
    }
    None
}

/// Four digits are enough to see what is meant.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// A sweep that goes nowhere.
pub(crate) fn implausible_study(design: &Design, study: &Study) -> Option<Diagnostic> {
    let sweep = swept(&study.task)?;
    let (from, to) = (at(design, &study.values, sweep, true), at(design, &study.values, sweep, false));
    (from == to).then(|| {
        let message = format!("the sweep of study `{}` begins and ends at one place", study.name);
        Diagnostic::warning("no-sweep", sweep.to.span(), message)
    })
}

fn at(design: &Design, values: &Values, sweep: &Sweep, first: bool) -> f64 {
    let mut faults = Vec::new();
    let end = if first { &sweep.from } else { &sweep.to };
    Numbers { design, values, faults: &mut faults }.number(end, format_args!(""))
}

fn swept(task: &Task) -> Option<&Sweep> {
    match task {
        Task::Motion { over: Over::Positions { sweep, .. }, .. } | Task::Statics { sweep: Some(sweep), .. } => {
            Some(sweep)
        }
        _ => None,
    }
}
