//! From the keys of an asking study to what it asks.

use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Entry, Expression, Parameter, ParameterSet, Reduction, Response, Span};

use super::{AskKeys, Asked, optimize, sizing_of, sweep, tolerance_of};
use crate::design::{Ask, Question, Sensitivity};
use crate::read::PartReader;
use crate::signals::Signal;

/// Samples of a curve, unless given.
const POINTS: usize = 41;

/// One asking study, while its keys are put together.
pub(crate) struct Asking<'a> {
    pub(crate) entry: &'a Entry,
    pub(crate) kind: &'static str,
    pub(crate) part: PartReader<'a>,
    pub(crate) asked: &'a Asked<'a>,
    /// Of the asked study, with what this one sets.
    pub(crate) parameters: &'a ParameterSet,
    pub(crate) signals: &'a Arc<[Signal]>,
}

/// What the study asks; `None` after an error. All of it is checked before giving up.
pub(crate) fn ask(asking: &Asking<'_>, keys: AskKeys) -> Option<Ask> {
    let question = match asking.kind {
        "sensitivity" => Question::Sensitivity(sensitivity(asking, keys)?),
        "optimize" => Question::Optimize(optimize::optimize(asking, keys)?),
        "sweep" => Question::Designs(sweep::designs(asking, keys)?),
        "tolerance" => Question::Tolerance(tolerance_of::tolerance(asking, keys)?),
        "sizing" => Question::Sizing(sizing_of::sizing(asking, *keys.sizing)?),
        other => unreachable!("`{other}` is in `ASKING`, but nobody reads it"),
    };
    Some(Ask { of: asking.asked.name.to_owned(), signals: asking.signals.clone(), question })
}

fn sensitivity(asking: &Asking<'_>, keys: AskKeys) -> Option<Sensitivity> {
    let response = asking.response(keys.response.optional()?);
    let parameters = keys.parameters.or_else(|| asking.plain_parameters());
    let points = keys.points.optional().map(|points| points.map_or(Some(POINTS), |p| usize::try_from(p.value).ok()));
    let parameters = parameters?;
    if parameters.is_empty() && !asking.has_faulty_parameters() {
        let message = format!("study `{}` has no parameters to vary", asking.entry.key);
        let hint = "give the file some in `[parameters]`, as `l1 = \"300 mm\"`";
        asking.error("no-parameters", asking.entry.key_span, message, hint);
        return None;
    }
    Some(Sensitivity { response: response?, parameters, points: points?? })
}

impl Asking<'_> {
    pub(super) fn report(&self, report: Diagnostic) {
        self.part.reader.report(report);
    }

    pub(super) fn error(&self, code: &'static str, span: Span, message: String, hint: impl Into<String>) {
        self.report(Diagnostic::error(code, span, message).hint(hint));
    }

    /// A response that the asked study can answer.
    pub(super) fn response(&self, response: Option<Response>) -> Option<Response> {
        response.filter(|response| self.answers(&response.reductions))
    }

    pub(super) fn answers(&self, reductions: &[Reduction]) -> bool {
        !self.asked.refuses(reductions, self.signals)
    }

    /// All parameters that are numbers, not made of others.
    pub(super) fn plain_parameters(&self) -> Vec<usize> {
        let all = self.parameters.all().iter().enumerate();
        all.filter(|(_, parameter)| parameter.expression.parameters().is_empty()).map(|(index, _)| index).collect()
    }

    /// Whether some could not be read: what would be said of all is then not certain.
    pub(super) fn has_faulty_parameters(&self) -> bool {
        let table = self.part.part.table.get("parameters").and_then(|entry| entry.value.as_table());
        table.is_some_and(|table| table.len() > self.parameters.all().len())
    }

    pub(super) fn parameter(&self, index: usize) -> Option<&Parameter> {
        self.parameters.all().get(index)
    }

    /// The value of an expression in this study; one that is not finite is reported.
    pub(super) fn number(&self, expression: &Expression) -> Option<f64> {
        expression.finite(self.parameters.values()).map_err(|report| self.report(report)).ok()
    }

    /// The same of one that may be absent; the outer `None` after an error.
    pub(super) fn optional_number(&self, expression: Option<&Expression>) -> Option<Option<f64>> {
        match expression {
            Some(expression) => self.number(expression).map(Some),
            None => Some(None),
        }
    }
}

/// A value as the author of a parameter would write it.
pub(super) fn shown(parameter: &Parameter, si: f64) -> String {
    parameter.value_as_written(si, "").unwrap_or_else(|| si.to_string())
}
