//! What an optimization found, in the words and units of the file.

use bellcrank_doc::{Comparison, Dimension};
use bellcrank_results::{
    Compared, ConstraintRow, FirstOrder, IterationRow, Objective, Optimization, StartRow, Unit, VariableRow,
};
use bellcrank_study::nlp::{Optimum, Options, Search, Solution, Status};

use super::problem::Designing;
use super::{best, named, sign};
use crate::ask::Asking;
use crate::design::Optimize;
use crate::trial::Undefined;

/// Everything there is to tell.
pub(super) struct Told<'a, 'd> {
    pub(super) asking: &'a Asking<'d>,
    pub(super) question: &'a Optimize,
    pub(super) options: &'a Options,
    pub(super) start: &'a [f64],
    /// Responses of the model as it is.
    pub(super) before: &'a Result<Vec<f64>, Undefined>,
    /// The best first.
    pub(super) optima: &'a [Optimum],
    /// By its reader, before all starts were searched from.
    pub(super) stopped: bool,
}

impl Told<'_, '_> {
    pub(super) fn findings(&self, problem: &mut Designing<'_>, iterations: Vec<IterationRow>) -> Optimization {
        let solution = best(self.optima);
        let after = problem.responses(&solution.x).unwrap_or_default();
        Optimization {
            of: self.asking.of.name.clone(),
            objective: self.objective(problem, &after),
            variables: (0..self.start.len()).map(|i| self.variable(i, problem, solution)).collect(),
            constraints: (0..self.question.constraints.len())
                .map(|i| self.constraint(i, problem, solution, &after))
                .collect(),
            compared: self.compared(&after),
            iterations,
            starts: searches(self.optima).map(|search| self.start_row(search)).collect(),
            iteration_count: solution.iterations,
            evaluations: searches(self.optima).map(|search| search.solution.evaluations).sum(),
            failed_designs: searches(self.optima).map(|search| search.solution.undefined).sum(),
            status: named(if self.stopped { Status::Interrupted } else { solution.status }).to_owned(),
            first_order: self.first_order(solution),
            written: None,
        }
    }

    /// What the objective measures: one response its own, a weighted sum nothing.
    fn dimension(&self) -> Dimension {
        match self.question.terms.as_slice() {
            [only] => only.response.value.dimension(),
            _ => Dimension::NONE,
        }
    }

    fn objective(&self, problem: &Designing<'_>, after: &[f64]) -> Objective {
        let value = |numbers: Option<&[f64]>| match numbers {
            Some(numbers) if !numbers.is_empty() => problem.objective(numbers),
            _ => f64::NAN,
        };
        Objective {
            written: self.written(),
            maximize: self.question.maximize,
            start: value(self.before.as_deref().ok()),
            value: value(Some(after)),
            unit: self.asking.unit(self.dimension()),
        }
    }

    fn written(&self) -> String {
        match self.question.terms.as_slice() {
            [only] => only.response.written().to_owned(),
            several => {
                let terms =
                    several.iter().map(|term| format!("{} × {} / its start", term.weight, term.response.written()));
                terms.collect::<Vec<_>>().join(" + ")
            }
        }
    }

    fn variable(&self, i: usize, problem: &Designing<'_>, solution: &Solution) -> VariableRow {
        let index = self.question.variables[i].parameter;
        let parameter = self.asking.parameter(index);
        let lower = solution.active_lower.contains(&i);
        let upper = solution.active_upper.contains(&i);
        let of = |multipliers: &[f64]| multipliers.get(i).copied().unwrap_or(0.0);
        // A bound moved up by ε moves the objective by the multiplier of a lower one, minus that of an upper one.
        let multiplier = of(&solution.multipliers.lower) - of(&solution.multipliers.upper);
        VariableRow {
            name: parameter.name.clone(),
            start: self.start[i],
            value: solution.x[i],
            unit: self.asking.parameter_unit(index),
            bounds: problem.limits()[i],
            bound: if lower { Some("lower") } else { upper.then_some("upper") },
            multiplier: if lower || upper { sign(self.question.maximize) * multiplier } else { 0.0 },
            multiplier_unit: Asking::derivative_unit(self.dimension(), parameter.dimension),
        }
    }

    fn constraint(&self, i: usize, problem: &Designing<'_>, solution: &Solution, after: &[f64]) -> ConstraintRow {
        let constraint = &self.question.constraints[i];
        let turned = matches!(constraint.comparison, Comparison::Greater | Comparison::GreaterOrEqual);
        let (plus, minus) = problem.sides(i);
        let (left, right) = if turned { (minus, plus) } else { (plus, minus) };
        let at = |numbers: &[f64], index: usize| numbers.get(index).copied().unwrap_or(f64::NAN);
        let beyond = at(after, plus) - at(after, minus);
        let equal = constraint.comparison == Comparison::Equal;
        let lambda = solution.multipliers.constraints.get(i).copied().unwrap_or(0.0);
        // c ≤ ε moves the optimum by −λε; a right side on the minus side of c is such an ε.
        let multiplier = if turned { lambda } else { -lambda };
        let slack = 1e-9 * at(after, plus).abs().max(at(after, minus).abs());
        let over = if equal { beyond.abs() } else { beyond.max(0.0) };
        ConstraintRow {
            written: constraint.written().to_owned(),
            left: (self.before.as_deref().map_or(f64::NAN, |before| at(before, left)), at(after, left)),
            right: at(after, right),
            unit: self.asking.unit(constraint.dimension()),
            active: equal || solution.active_constraints.contains(&i),
            violation: if over > slack { over } else { 0.0 },
            multiplier: sign(self.question.maximize) * multiplier,
            multiplier_unit: Asking::derivative_unit(self.dimension(), constraint.dimension()),
        }
    }

    /// The terms of a weighted sum; a single one is the objective itself.
    fn compared(&self, after: &[f64]) -> Vec<Compared> {
        let term = |(i, term): (usize, &crate::design::Term)| Compared {
            name: term.response.written().to_owned(),
            start: self.before.as_ref().map_or(f64::NAN, |before| before[i]),
            value: after.get(i).copied().unwrap_or(f64::NAN),
            unit: self.asking.unit(term.response.value.dimension()),
        };
        self.question.terms.iter().enumerate().map(term).collect()
    }

    fn start_row(&self, search: &Search) -> StartRow {
        let solution = &search.solution;
        StartRow {
            start: search.start,
            from: search.from.clone(),
            point: solution.x.clone(),
            objective: sign(self.question.maximize) * solution.objective,
            violation: solution.violation,
            status: named(solution.status).to_owned(),
        }
    }

    fn first_order(&self, solution: &Solution) -> FirstOrder {
        let (kkt, wanted) = (&solution.kkt, &self.options.tolerances);
        let near = |residual: f64, tolerance: f64| residual <= 10.0 * tolerance.max(1e-8);
        FirstOrder {
            stationarity: kkt.stationarity,
            feasibility: kkt.feasibility,
            complementarity: kkt.complementarity,
            holds: near(kkt.stationarity, wanted.optimality)
                && near(kkt.feasibility, wanted.feasibility)
                && near(kkt.complementarity, wanted.optimality),
        }
    }

    pub(super) fn warnings(&self, found: &Optimization, hole: Option<&Undefined>) -> Vec<String> {
        let solution = best(self.optima);
        let mut warnings = Vec::new();
        match solution.status {
            Status::StepTooSmall => warnings.push(self.stuck(solution, found)),
            Status::IterationLimit => warnings.push(format!(
                "stopped after {} iterations before the tolerances were met; allow more with `iterations`",
                solution.iterations
            )),
            _ => {}
        }
        if solution.objective_gradient == 0.0 && solution.status == Status::Converged {
            warnings.push(format!("`{}` does not depend on the variables here", found.objective.written));
        }
        if let (Err(why), true) = (self.before, solution.status != Status::UndefinedStart) {
            warnings.push(format!("the model as it is gives no value to compare with: {}", why.message));
        }
        warnings.extend(found.variables.iter().filter_map(turned));
        // A search without a start says it as its failure.
        if found.failed_designs > 0 && solution.status != Status::UndefinedStart {
            let (were, them) = if found.failed_designs == 1 { ("design", "it") } else { ("designs", "them") };
            let why = hole.map_or_else(String::new, |hole| format!("; the first: {}", hole.message));
            warnings.push(format!(
                "{} {were} on the way could not be assembled or solved, the search stepped back from {them}{why}",
                found.failed_designs
            ));
        }
        warnings
    }

    /// No step is better: at an optimum that is not met to the last digit, or at the edge of what can be solved.
    fn stuck(&self, solution: &Solution, found: &Optimization) -> String {
        const FAR: f64 = 1e-3;
        let edge = solution.kkt.stationarity > FAR && found.failed_designs > 0;
        if edge {
            "the search got stuck where the next designs cannot be assembled or solved: keep it away from there with \
             bounds or `subject_to`, or look from several `starts`"
        } else {
            "no step improves this design further, though the tolerances are not met: it is good to fewer digits"
        }
        .to_owned()
    }

    /// What ends the study as failed, with all that was found kept.
    pub(super) fn failure(&self, found: &Optimization, problem: &Designing<'_>) -> Option<Undefined> {
        let solution = best(self.optima);
        if self.stopped {
            return Some(super::super::cancelled("during the search; the best design so far is kept"));
        }
        match solution.status {
            Status::Infeasible => Some(Self::infeasible(found)),
            Status::UndefinedStart => {
                let why =
                    problem.hole.clone().unwrap_or_else(|| Undefined { message: String::new(), hints: Vec::new() });
                let message = format!("the search has no design to start from: {}", why.message);
                let mut hints = why.hints;
                hints.push(
                    "start from values that can be assembled, or give several `starts` within the bounds".to_owned(),
                );
                Some(Undefined { message, hints })
            }
            _ => None,
        }
    }

    fn infeasible(found: &Optimization) -> Undefined {
        let by = |row: &ConstraintRow| format!("`{}` by {}", row.written, shown(row.violation, &row.unit));
        let violated: Vec<String> = found.constraints.iter().filter(|row| row.violation > 0.0).map(by).collect();
        let message = format!(
            "no design near here satisfies all constraints; the least violation found is {}",
            violated.join(", ")
        );
        let hint = "widen the bounds, relax a constraint, or look from several `starts`".to_owned();
        Undefined { message, hints: vec![hint] }
    }
}

/// All searches, the best first.
fn searches(optima: &[Optimum]) -> impl Iterator<Item = &Search> {
    optima.iter().flat_map(|optimum| &optimum.searches)
}

/// A length that became negative is hardly meant.
fn turned(row: &VariableRow) -> Option<String> {
    let (name, min) = (&row.name, row.bounds.0);
    let open = min == f64::NEG_INFINITY || row.bounds.1 == f64::INFINITY;
    (open && row.start * row.value < 0.0).then(|| {
        let [start, value] = [row.start, row.value].map(|si| shown(si, &row.unit));
        format!("`{name}` went from {start} to {value}: give it bounds if only one sign makes a machine")
    })
}

fn shown(si: f64, unit: &Unit) -> String {
    crate::run::shown(si, unit)
}
