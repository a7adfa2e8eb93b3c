//! How a response scatters: worst case, linear estimate, drawn machines, Sobol' indices.
//!
//! The order is the order of reading: [`inputs`] (what scatters), [`linear`] (by exact derivatives), [`machines`] (many
//! deviating machines on several threads), [`corners`], [`drawn`] and [`indices`] (what they are asked).

mod corners;
mod drawn;
mod indices;
mod inputs;
mod linear;
mod machines;

use bellcrank_results::{Findings, SobolIndices, StudyResult, Tolerance as Found, ToleranceInput};
use bellcrank_study::statistics::{Limits, capability};

use super::{Asking, cancelled};
use crate::design::Tolerance;
use crate::progress::Progress;
use crate::trial::{Asked, Undefined};
use drawn::Drawn;
use inputs::Input;
use linear::Linear;
use machines::Machines;

pub(super) fn run(
    asking: &Asking<'_>,
    question: &Tolerance,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<(), Undefined> {
    progress.at(0.0, "differentiating");
    let inputs = inputs::of(asking, question);
    let mut asked = Asked::default();
    asked.response(&question.response);
    let mut trial = asking.trial(asked);
    let nominal = trial.run(&[])?[0];
    let (linear, mut warnings) = Linear::of(asking, &inputs, nominal, &mut trial);

    let indices = question.sobol.then(|| indices::plan(question, &inputs));
    let total = corners::count(&inputs) + question.samples + indices.as_ref().map_or(0, |plan| plan.rows());
    let mut machines = Machines::new(asking, &question.response, &inputs, total, progress);
    let exact = corners::worst(&mut machines, &mut trial, &linear, &mut warnings);
    warnings.extend(exact.and_then(|exact| linear::beside_the_corners(&linear, exact)));
    let limits = limits(asking, question);
    let drawn = (question.samples > 0).then(|| drawn::draw(&mut machines, question, &limits));
    let sobol = indices.and_then(|plan| indices::found(&mut machines, &plan, &mut warnings));
    result.effort = vec![
        ("designs".to_owned(), machines.designs as f64 + 1.0),
        ("positions".to_owned(), (machines.positions + trial.positions) as f64),
    ];
    let stopped = machines.stopped;

    let all = All { asking, question, inputs: &inputs, linear: &linear, limits: &limits };
    let found = all.findings(exact, drawn.as_ref(), sobol.as_deref());
    warnings.extend(drawn.iter().flat_map(|drawn| drawn.warnings(&all, exact)));
    result.warnings.extend(warnings);
    result.findings = Some(Findings::Tolerance(found));
    if stopped { Err(cancelled(&interrupted(question, drawn.as_ref()))) } else { Ok(()) }
}

fn limits(asking: &Asking<'_>, question: &Tolerance) -> Limits {
    let values = asking.study.parameters.values();
    let at = |side: usize| question.limits[side].as_ref().map(|limit| limit.eval(values, &[]));
    Limits { lower: at(0), upper: at(1) }
}

fn interrupted(question: &Tolerance, drawn: Option<&Drawn>) -> String {
    let done = drawn.map_or(0, |drawn| drawn.count);
    format!("after {done} of {} machines; what was found until then is kept", question.samples)
}

/// What the parts of an answer are put together from.
struct All<'a, 'd> {
    asking: &'a Asking<'d>,
    question: &'a Tolerance,
    inputs: &'a [Input],
    linear: &'a Linear,
    limits: &'a Limits,
}

impl All<'_, '_> {
    fn findings(&self, exact: Option<(f64, f64)>, drawn: Option<&Drawn>, sobol: Option<&[SobolIndices]>) -> Found {
        let (linear, limits) = (self.linear, self.limits);
        let asked = limits.lower.is_some() || limits.upper.is_some();
        let by_derivatives = capability(linear.nominal, linear.sigma, limits);
        let capable = match drawn.filter(|drawn| drawn.moments.count() > 1) {
            Some(drawn) => capability(drawn.moments.mean(), drawn.moments.sigma(), limits),
            None => by_derivatives,
        };
        let if_asked = |number: f64| if asked { number } else { f64::NAN };
        let mut rows: Vec<ToleranceInput> =
            (0..self.inputs.len()).map(|i| self.input(i, sobol.and_then(|all| all.get(i).copied()))).collect();
        rows.sort_by(|a, b| weight(b).total_cmp(&weight(a)));
        Found {
            of: self.asking.of.name.clone(),
            response: self.question.response.written().to_owned(),
            nominal: linear.nominal,
            unit: self.asking.unit(self.question.response.value.dimension()),
            limits: (limits.lower, limits.upper),
            inputs: rows,
            worst_case: (linear.nominal - linear.reach, linear.nominal + linear.reach),
            worst_case_exact: exact,
            linear_deviation: linear.sigma,
            linear_yield: if_asked(by_derivatives.normal_yield),
            capability: (if_asked(capable.cp), if_asked(capable.cpk)),
            monte_carlo: drawn.map(|drawn| drawn.told(self.question, limits)),
        }
    }

    fn input(&self, i: usize, sobol: Option<SobolIndices>) -> ToleranceInput {
        let input = &self.inputs[i];
        let parameter = self.asking.parameter(input.parameter);
        let of = self.question.response.value.dimension();
        ToleranceInput {
            name: parameter.name.clone(),
            nominal: input.nominal,
            unit: self.asking.parameter_unit(input.parameter),
            half_width: input.half_width,
            distribution: input.named,
            deviation: input.distribution.sigma(),
            derivative: self.linear.gradient[i],
            derivative_unit: Asking::derivative_unit(of, parameter.dimension),
            variance_share: self.linear.variance_shares[i],
            worst_share: self.linear.worst_shares[i],
            sobol,
        }
    }
}

/// What puts the largest contribution first: its share of the variance; without derivatives its total Sobol' index.
fn weight(input: &ToleranceInput) -> f64 {
    let total = input.sobol.map_or(0.0, |sobol| sobol.total.0);
    [input.variance_share, total].into_iter().find(|share| share.is_finite()).unwrap_or(0.0)
}
