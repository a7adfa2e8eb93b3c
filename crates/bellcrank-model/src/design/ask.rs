//! Studies that ask something of another study: derivatives, optima, many designs, scatter, sizes.

use std::sync::Arc;

use bellcrank_doc::{Constraint, Distribution, Expression, ParameterSet, Reduction, Response, Span, Spread};

use super::Sizing;
use crate::signals::Signal;

/// What is asked of which study.
#[derive(Clone, Debug)]
pub(crate) struct Ask {
    /// Name of the study that gives the numbers.
    pub(crate) of: String,
    /// Signals of all responses, by the indices of their expressions.
    pub(crate) signals: Arc<[Signal]>,
    pub(crate) question: Question,
}

/// What is asked.
#[derive(Clone, Debug)]
pub(crate) enum Question {
    Sensitivity(Sensitivity),
    Optimize(Optimize),
    Designs(Designs),
    Tolerance(Tolerance),
    Sizing(Sizing),
}

/// Derivatives of a response.
#[derive(Clone, Debug)]
pub(crate) struct Sensitivity {
    pub(crate) response: Response,
    pub(crate) parameters: Vec<usize>,
    /// Samples of each curve over a parameter's range.
    pub(crate) points: usize,
}

/// A parameter that may change, between bounds over the parameters.
#[derive(Clone, Debug)]
pub(crate) struct Variable {
    pub(crate) parameter: usize,
    pub(crate) span: Span,
    pub(crate) min: Option<Expression>,
    pub(crate) max: Option<Expression>,
}

/// A part of the objective.
#[derive(Clone, Debug)]
pub(crate) struct Term {
    pub(crate) response: Response,
    pub(crate) weight: f64,
}

/// The best parameters.
#[derive(Clone, Debug)]
pub(crate) struct Optimize {
    pub(crate) maximize: bool,
    /// One: the response itself. Several: the sum of weight × response over its value at the start.
    pub(crate) terms: Vec<Term>,
    pub(crate) variables: Vec<Variable>,
    pub(crate) constraints: Vec<Constraint>,
    pub(crate) starts: usize,
    pub(crate) seed: u64,
    pub(crate) tolerance: Option<f64>,
    pub(crate) iterations: Option<usize>,
}

/// A response with the name of its column.
#[derive(Clone, Debug)]
pub(crate) struct NamedResponse {
    pub(crate) name: String,
    pub(crate) response: Response,
}

/// Values of one parameter.
#[derive(Clone, Debug)]
pub(crate) struct Varied {
    pub(crate) parameter: usize,
    pub(crate) span: Span,
    pub(crate) levels: Levels,
}

/// Values that a parameter takes.
#[derive(Clone, Debug)]
pub(crate) enum Levels {
    /// From .. to; the bounds of the parameter where not given, one of which there is then. With so many levels in a
    /// grid.
    Range { from: Option<Expression>, to: Option<Expression>, points: usize },
    /// These.
    List(Vec<Expression>),
}

/// How the designs lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    Grid,
    LatinHypercube,
    Sobol,
    Table,
}

impl Method {
    /// As in the file.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Method::Grid => "grid",
            Method::LatinHypercube => "lhs",
            Method::Sobol => "sobol",
            Method::Table => "table",
        }
    }
}

/// Responses over many designs.
#[derive(Clone, Debug)]
pub(crate) struct Designs {
    pub(crate) responses: Vec<NamedResponse>,
    pub(crate) vary: Vec<Varied>,
    pub(crate) method: Method,
    /// Designs of a table, row by row in the order of `vary`, SI.
    pub(crate) table: Arc<Vec<Vec<f64>>>,
    pub(crate) samples: u64,
    pub(crate) seed: u64,
    /// Two responses, each made small (else large).
    pub(crate) pareto: Option<[(usize, bool); 2]>,
}

/// How a dimension scatters, where the study says other than the parameter: [`Scattered::spread`] is both together.
#[derive(Clone, Debug)]
pub(crate) struct Scattered {
    pub(crate) parameter: usize,
    pub(crate) span: Span,
    pub(crate) half_width: Option<Expression>,
    pub(crate) sigma: Option<Expression>,
    /// That of the study for parameters without one is here, too.
    pub(crate) distribution: Option<Distribution>,
}

/// Scatter of a response.
#[derive(Clone, Debug)]
pub(crate) struct Tolerance {
    pub(crate) response: Response,
    pub(crate) scattered: Vec<Scattered>,
    pub(crate) limits: [Option<Expression>; 2],
    pub(crate) samples: u64,
    pub(crate) seed: u64,
    pub(crate) sobol: bool,
}

impl Scattered {
    /// A parameter of which the study says nothing else.
    pub(crate) fn of(parameter: usize, span: Span) -> Scattered {
        Scattered { parameter, span, half_width: None, sigma: None, distribution: None }
    }

    /// How it scatters: the widths of the study where it gives one, else those of the parameter.
    pub(crate) fn spread(&self, parameters: &ParameterSet, values: &[f64]) -> Spread {
        let own = parameters.all().get(self.parameter).map(|parameter| parameter.spread).unwrap_or_default();
        let at = |width: &Option<Expression>| width.as_ref().map(|width| width.eval(values, &[]));
        let distribution = self.distribution.or(own.distribution);
        match (at(&self.half_width), at(&self.sigma)) {
            (None, None) => Spread { distribution, ..own },
            (half_width, sigma) => Spread { half_width, distribution, sigma },
        }
    }
}

impl Ask {
    /// Parameters that it names or uses.
    pub(crate) fn parameters(&self) -> Vec<usize> {
        let mut all = self.question.named();
        self.question.each_expression(&mut |expression| all.extend(expression.parameters()));
        all.sort_unstable();
        all.dedup();
        all
    }
}

impl Question {
    /// Every expression in it, those of curves and their places among them.
    pub(crate) fn each_expression(&self, visit: &mut dyn FnMut(&Expression)) {
        match self {
            Question::Sensitivity(of) => in_response(&of.response, visit),
            Question::Optimize(of) => {
                of.terms.iter().for_each(|term| in_response(&term.response, visit));
                of.variables.iter().flat_map(|v| [&v.min, &v.max]).flatten().for_each(&mut *visit);
                for constraint in &of.constraints {
                    [&constraint.left, &constraint.right].into_iter().for_each(&mut *visit);
                    in_reductions(&constraint.reductions, visit);
                }
            }
            Question::Designs(of) => {
                of.responses.iter().for_each(|one| in_response(&one.response, visit));
                for varied in &of.vary {
                    match &varied.levels {
                        Levels::Range { from, to, .. } => [from, to].into_iter().flatten().for_each(&mut *visit),
                        Levels::List(values) => values.iter().for_each(&mut *visit),
                    }
                }
            }
            Question::Tolerance(of) => {
                in_response(&of.response, visit);
                of.scattered.iter().flat_map(|s| [&s.half_width, &s.sigma]).flatten().for_each(&mut *visit);
                of.limits.iter().flatten().for_each(&mut *visit);
            }
            Question::Sizing(of) => of.each_expression(visit),
        }
    }

    /// Parameters that it names.
    pub(crate) fn named(&self) -> Vec<usize> {
        match self {
            Question::Sensitivity(of) => of.parameters.clone(),
            Question::Optimize(of) => of.variables.iter().map(|v| v.parameter).collect(),
            Question::Designs(of) => of.vary.iter().map(|v| v.parameter).collect(),
            Question::Tolerance(of) => of.scattered.iter().map(|s| s.parameter).collect(),
            Question::Sizing(_) => Vec::new(),
        }
    }
}

fn in_response(response: &Response, visit: &mut dyn FnMut(&Expression)) {
    visit(&response.value);
    in_reductions(&response.reductions, visit);
}

fn in_reductions(reductions: &[Reduction], visit: &mut dyn FnMut(&Expression)) {
    reductions.iter().flat_map(|r| std::iter::once(&r.curve).chain(&r.place)).for_each(visit);
}
