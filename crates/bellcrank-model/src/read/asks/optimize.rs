//! `optimize`: objective, variables with bounds, constraints.

use bellcrank_doc::{Constraint, Diagnostic, Expression, Parameter, Response};

use super::AskKeys;
use super::finish::{Asking, shown};
use super::objective::Objective;
use crate::design::{Optimize, Term, Variable};

/// Start of the random numbers, unless given.
pub(super) const SEED: u64 = 1;

pub(super) fn optimize(asking: &Asking<'_>, keys: AskKeys) -> Option<Optimize> {
    let starts = keys.starts.optional().map(|starts| starts.map_or(1, |starts| starts.value));
    let objective = keys.objective.optional().flatten().and_then(|objective| terms(asking, objective));
    let variables = keys.variables.optional().flatten();
    let variables = variables.and_then(|all| checked(asking, all, starts.unwrap_or(1) > 1));
    let constraints = keys.subject_to.or_else(Vec::new).and_then(|all| constraints(asking, all));
    let tolerance = keys.tolerance.optional().map(|tolerance| above_zero(asking, tolerance.as_ref(), "`tolerance`"));
    let iterations = keys.iterations.optional();
    let seed = keys.seed.optional()?.map_or(SEED, |seed| seed.value);
    let (maximize, terms) = objective?;
    Some(Optimize {
        maximize,
        terms,
        variables: variables?,
        constraints: constraints?,
        starts: usize::try_from(starts?).ok()?,
        seed,
        tolerance: tolerance??,
        iterations: iterations?.and_then(|iterations| usize::try_from(iterations.value).ok()),
    })
}

fn terms(asking: &Asking<'_>, objective: Objective) -> Option<(bool, Vec<Term>)> {
    let one = |(response, weight): (Response, Option<Expression>)| {
        let weight = above_zero(asking, weight.as_ref(), "a weight");
        let response = asking.response(Some(response));
        Some(Term { response: response?, weight: weight?.unwrap_or(1.0) })
    };
    Some((objective.maximize, super::keys::all(objective.terms.into_iter().map(one))?))
}

fn constraints(asking: &Asking<'_>, all: Vec<Constraint>) -> Option<Vec<Constraint>> {
    let good: Vec<bool> = all.iter().map(|constraint| asking.answers(&constraint.reductions)).collect();
    good.into_iter().all(|good| good).then_some(all)
}

/// The outer `None` after an error.
fn above_zero(asking: &Asking<'_>, expression: Option<&Expression>, what: &str) -> Option<Option<f64>> {
    let value = asking.optional_number(expression)?;
    match (value, expression) {
        (Some(value), Some(expression)) if value <= 0.0 => {
            let message = format!("{what} must be above zero, found {value}");
            asking.report(Diagnostic::error("out-of-range", expression.span(), message));
            None
        }
        _ => Some(value),
    }
}

fn checked(asking: &Asking<'_>, all: Vec<Variable>, several_starts: bool) -> Option<Vec<Variable>> {
    let good: Vec<bool> = all.iter().map(|one| variable(asking, one, several_starts).is_some()).collect();
    good.into_iter().all(|good| good).then_some(all)
}

/// Reports bounds that cross or are missing, and warns of a start outside of them.
fn variable(asking: &Asking<'_>, variable: &Variable, several_starts: bool) -> Option<()> {
    let parameter = asking.parameter(variable.parameter)?;
    let own = [asking.optional_number(variable.min.as_ref()), asking.optional_number(variable.max.as_ref())];
    let [own_min, own_max] = [own[0]?, own[1]?];
    let (min, max) = (own_min.or(parameter.min), own_max.or(parameter.max));
    if let (Some(low), Some(high)) = (min, max)
        && low > high
    {
        // Bounds of the parameter alone have been judged there.
        if own_min.is_some() || own_max.is_some() {
            crossing(asking, variable, parameter, [low, high]);
        }
        return None;
    }
    let value = *asking.parameters.values().get(variable.parameter)?;
    if let Some(low) = own_min.filter(|&low| value < low - slack(value)) {
        outside(asking, variable.min.as_ref()?, parameter, "below its lower bound", [value, low]);
    }
    if let Some(high) = own_max.filter(|&high| value > high + slack(value)) {
        outside(asking, variable.max.as_ref()?, parameter, "above its upper bound", [value, high]);
    }
    let missing = match (min, max) {
        (None, None) => "no bounds",
        (None, _) => "no lower bound",
        (_, None) => "no upper bound",
        _ => return Some(()),
    };
    if !several_starts {
        return Some(());
    }
    let name = &parameter.name;
    let message = format!("`{name}` has {missing}; several starts are spread between two bounds");
    let report = Diagnostic::error("no-bounds", variable.span, message).also(parameter.span, "defined here");
    asking.report(report.hint(format!(
        "write `variables = {{ {name} = {{ min = ..., max = ... }} }}`, give the parameter `min` and `max`, or take \
         `starts = 1`"
    )));
    None
}

/// Bounds written with another unit may differ from the value in the last bit.
fn slack(value: f64) -> f64 {
    1e-12 * value.abs()
}

fn crossing(asking: &Asking<'_>, variable: &Variable, parameter: &Parameter, [low, high]: [f64; 2]) {
    let name = &parameter.name;
    let (low, high) = (shown(parameter, low), shown(parameter, high));
    let message = format!("the lower bound of `{name}`, {low}, is above its upper bound, {high}");
    let at = |bound: &Option<Expression>| bound.as_ref().map_or(parameter.span, Expression::span);
    let (first, second) = match &variable.min {
        Some(_) => ((at(&variable.min), "lower bound"), (at(&variable.max), "upper bound")),
        None => ((at(&variable.max), "upper bound"), (at(&variable.min), "lower bound")),
    };
    asking.report(Diagnostic::error("bounds", first.0, message).label(first.1).also(second.0, second.1));
}

fn outside(asking: &Asking<'_>, bound: &Expression, parameter: &Parameter, side: &str, [value, limit]: [f64; 2]) {
    let (value, limit) = (shown(parameter, value), shown(parameter, limit));
    let message = format!("`{}` starts at {value}, {side} of {limit}", parameter.name);
    let report = Diagnostic::warning("out-of-bounds", bound.span(), message).also(parameter.span, "its value");
    asking.report(report.hint("the search begins at the bound"));
}
