//! `[parameters]`: named values that depend on each other.

mod evaluate;
mod order;
mod read;
mod spread;
#[cfg(test)]
mod tests;

use std::collections::{HashMap, HashSet};

use crate::expression::{HUGE, Known, Purpose, Tolerance, half_width, nominal};
use crate::overrides::Override;
use crate::{Diagnostic, Diagnostics, Dimension, Expression, NoSignals, Scope, Span, Table, nearest};

pub use spread::{Distribution, Spread};

/// One parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// Place of the name in its definition.
    pub span: Span,
    /// What it measures.
    pub dimension: Dimension,
    /// Its definition over the other parameters (an override's, where there is one), without a tolerance.
    pub expression: Expression,
    /// Its definition as written, with the tolerance after `±` where there is one.
    pub written: String,
    /// Lower bound, SI.
    pub min: Option<f64>,
    /// Upper bound, SI.
    pub max: Option<f64>,
    /// Tolerance (half width), SI; not negative. The same as [`Spread::half_width`].
    pub tolerance: Option<f64>,
    /// How the value scatters.
    pub spread: Spread,
    /// The author's note; empty without one.
    pub note: String,
    pub(crate) limits: Limits,
}

/// Bounds as written; they may use other parameters and so move with overrides.
#[derive(Clone, Debug, Default)]
pub(crate) struct Limits {
    pub(crate) min: Option<Expression>,
    pub(crate) max: Option<Expression>,
    pub(crate) tolerance: Option<Expression>,
    pub(crate) sigma: Option<Expression>,
}

/// All parameters of a model, in written order, with their values.
#[derive(Clone, Debug, Default)]
pub struct ParameterSet {
    all: Vec<Parameter>,
    values: Vec<f64>,
    /// Indices, each after all that its definition uses.
    order: Vec<usize>,
    index: HashMap<String, usize>,
    /// Names whose definitions were reported as wrong.
    faulty: HashSet<String>,
}

impl ParameterSet {
    /// Reads a `[parameters]` table; faulty ones are reported, and kept out.
    pub fn read(table: &Table, diagnostics: &mut Diagnostics) -> ParameterSet {
        read::read(table, diagnostics)
    }

    /// In written order; an index of this slice is the index used everywhere.
    #[must_use]
    pub fn all(&self) -> &[Parameter] {
        &self.all
    }

    /// Index of a name.
    #[must_use]
    pub fn index(&self, name: &str) -> Option<usize> {
        self.index.get(name).copied()
    }

    /// A parameter by name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Parameter> {
        self.index(name).and_then(|i| self.all.get(i))
    }

    /// SI values by index.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Indices stay the same: expressions compiled against `self` hold for the result. `Err` has
    /// every fault of the overrides; `Ok` may come with warnings.
    pub fn with_overrides(&self, overrides: &[Override]) -> Result<(ParameterSet, Diagnostics), Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        let mut changed = self.clone();
        for (i, one) in overrides.iter().enumerate() {
            self.report_repeat(one, &overrides[..i], &mut diagnostics);
            changed.redefine(self, one, &mut diagnostics);
        }
        changed.settle(&mut diagnostics);
        if diagnostics.has_errors() { Err(diagnostics) } else { Ok((changed, diagnostics)) }
    }

    /// What an expression learns of a parameter.
    pub(crate) fn known(&self, index: usize) -> Known {
        match (self.all.get(index), self.values.get(index)) {
            (Some(p), Some(&value)) => Known::Parameter { index, dimension: p.dimension, value, defined: p.span },
            _ => Known::Unknown,
        }
    }

    /// Whether a parameter of this name was there, but wrong (and reported): what refers to it is not to blame.
    #[must_use]
    pub fn is_faulty(&self, name: &str) -> bool {
        self.faulty.contains(name)
    }

    fn report_repeat(&self, one: &Override, before: &[Override], diagnostics: &mut Diagnostics) {
        if let Some(first) = before.iter().find(|o| o.name == one.name) {
            let message = format!("`{}` is set twice", one.name);
            diagnostics
                .push(Diagnostic::error("duplicate-name", one.name_span, message).also(first.name_span, "first here"));
        }
    }

    /// Puts the definition of an override in place.
    fn redefine(&mut self, before: &ParameterSet, one: &Override, diagnostics: &mut Diagnostics) {
        let Some(index) = before.index(&one.name) else {
            if !before.is_faulty(&one.name) {
                diagnostics.push(before.unknown(one));
            }
            return;
        };
        let Some(parameter) = self.all.get_mut(index) else { return };
        let what = format!("`{}`", one.name);
        let purpose = Purpose { what: &what, dimension: Some(parameter.dimension) };
        let mut scope = Scope { parameters: before, signals: &mut NoSignals };
        let mut own = diagnostics.branch();
        let tree = one.written.parse(&mut own);
        let nominal = tree.as_ref().and_then(|tree| nominal(tree, &one.written.text, purpose, &mut scope, &mut own));
        if let Some(expression) = nominal {
            parameter.written = one.written.text.clone().into_owned();
            parameter.expression = expression;
        }
        if let Some(tolerance) = tree.as_ref().and_then(|tree| tree.tolerance.as_ref()) {
            parameter.limits.tolerance = before.half_width(index, tolerance, &one.written.text, &mut own);
        }
        let defined = parameter.span;
        diagnostics.append(own.into_iter().map(|d| with_definition(d, &what, defined)).collect());
    }

    /// What stands after the `±` of a definition.
    fn half_width(
        &self,
        index: usize,
        tolerance: &Tolerance,
        text: &str,
        diagnostics: &mut Diagnostics,
    ) -> Option<Expression> {
        let parameter = self.all.get(index)?;
        let what = format!("the tolerance of `{}`", parameter.name);
        let purpose = Purpose { what: &what, dimension: Some(parameter.dimension) };
        let mut scope = Scope { parameters: self, signals: &mut NoSignals };
        half_width(tolerance, text, purpose, &mut scope, diagnostics)
    }

    fn unknown(&self, one: &Override) -> Diagnostic {
        let message = format!("no parameter is named `{}`", one.name);
        let error = Diagnostic::error("unknown-parameter", one.name_span, message);
        let names: Vec<&str> = self.all.iter().map(|p| p.name.as_str()).collect();
        match nearest(&one.name, names.iter().copied()) {
            Some(near) => error.did_you_mean(Some(near)),
            None if names.is_empty() => error.hint("the model has no parameters"),
            None => error.hint(format!("the parameters are {}", listed(&names))),
        }
    }

    /// Orders and evaluates all definitions, and judges the values.
    fn settle(&mut self, diagnostics: &mut Diagnostics) {
        let uses: Vec<Vec<usize>> = self.all.iter().map(|p| p.expression.parameters()).collect();
        let order::Order { order, cycles } = order::order(&uses);
        for cycle in &cycles {
            let links: Vec<order::Link<'_>> = cycle
                .iter()
                .filter_map(|&i| self.all.get(i))
                .map(|p| order::Link { name: &p.name, span: p.expression.span() })
                .collect();
            diagnostics.push(order::cycle_report(&links));
        }
        self.order = order;
        if cycles.is_empty() {
            self.values = self.evaluate::<f64>(&[]);
            self.judge(diagnostics);
        }
    }

    /// Values that are no numbers are errors, values beyond their own bounds warnings.
    fn judge(&mut self, diagnostics: &mut Diagnostics) {
        for (parameter, &value) in self.all.iter_mut().zip(&self.values) {
            if !value.is_finite() || value.abs() > HUGE {
                diagnostics.push(not_finite(parameter, value));
            }
            let at = |e: &Option<Expression>| e.as_ref().map(|e| e.eval(&self.values, &[]));
            parameter.min = at(&parameter.limits.min);
            parameter.max = at(&parameter.limits.max);
            parameter.tolerance = at(&parameter.limits.tolerance);
            parameter.spread.half_width = parameter.tolerance;
            parameter.spread.sigma = at(&parameter.limits.sigma);
            spread::judge(parameter, diagnostics);
            diagnostics.append(outside(parameter, value).into_iter().collect());
        }
    }
}

/// `a`, `b` ...
fn listed(names: &[&str]) -> String {
    let shown: Vec<String> = names.iter().take(12).map(|n| format!("`{n}`")).collect();
    let more = if names.len() > 12 { " ..." } else { "" };
    format!("{}{more}", shown.join(", "))
}

fn with_definition(diagnostic: Diagnostic, what: &str, defined: Span) -> Diagnostic {
    if diagnostic.code == "dimension" {
        diagnostic.also(defined, format!("{what} is defined here"))
    } else {
        diagnostic
    }
}

fn not_finite(parameter: &Parameter, value: f64) -> Diagnostic {
    let message = format!("`{}` is {value:e}, not a number that can be meant", parameter.name);
    Diagnostic::error("not-finite", parameter.expression.span(), message)
}

/// A warning when a value is outside its bounds, an error when the bounds are.
fn outside(parameter: &Parameter, value: f64) -> Option<Diagnostic> {
    let name = &parameter.name;
    let span = parameter.expression.span();
    let bound_span = |e: &Option<Expression>| e.as_ref().map_or(span, Expression::span);
    if let (Some(min), Some(max)) = (parameter.min, parameter.max)
        && min > max
    {
        let message = format!("the lower bound of `{name}` is above its upper bound");
        let error = Diagnostic::error("bounds", bound_span(&parameter.limits.min), message);
        return Some(error.also(bound_span(&parameter.limits.max), "upper bound"));
    }
    // Bounds written with another unit may differ from the value in the last bit.
    let slack = 1e-12 * value.abs();
    let (side, bound) = match (parameter.min, parameter.max) {
        (Some(min), _) if value < min - slack => ("below its lower bound", &parameter.limits.min),
        (_, Some(max)) if value > max + slack => ("above its upper bound", &parameter.limits.max),
        _ => return None,
    };
    let warning = Diagnostic::warning("out-of-bounds", span, format!("`{name}` is {side}"));
    Some(warning.also(bound_span(bound), "the bound"))
}
