//! Single values.

use std::cell::RefCell;
use std::ops::RangeInclusive;

use super::Fields;
use crate::expression::{self, Purpose};
use crate::written::WrittenValue;
use crate::{
    Condition, Constraint, Diagnostic, Diagnostics, Dimension, Expression, NoSignals, ParameterSet, Response, Scope,
    Signals, Span, Spanned, Value, ValueKind, nearest,
};

/// What all readings of a file share: its parameters, and the diagnostics so far.
///
/// The `what` of its methods names the value in messages, as "`length` of joint `B`".
pub struct Reader<'p> {
    parameters: &'p ParameterSet,
    diagnostics: RefCell<Diagnostics>,
}

impl<'p> Reader<'p> {
    /// No diagnostics yet.
    #[must_use]
    pub fn new(parameters: &'p ParameterSet) -> Reader<'p> {
        Reader { parameters, diagnostics: RefCell::new(Diagnostics::new()) }
    }

    /// The parameters that values may use.
    #[must_use]
    pub fn parameters(&self) -> &'p ParameterSet {
        self.parameters
    }

    /// Adds a diagnostic.
    pub fn report(&self, diagnostic: Diagnostic) {
        self.diagnostics.borrow_mut().push(diagnostic);
    }

    /// Number of errors so far.
    #[must_use]
    pub fn errors(&self) -> usize {
        self.diagnostics.borrow().errors()
    }

    /// What was reported.
    #[must_use]
    pub fn finish(self) -> Diagnostics {
        self.diagnostics.into_inner()
    }

    /// A value of the given dimension over the parameters. It is finite with their values.
    pub fn quantity(&self, value: &Value, what: &str, dimension: Dimension) -> Option<Expression> {
        self.signal_quantity(value, what, dimension, &mut NoSignals)
    }

    /// The same, which may also use signals; then it is the caller's to check that it is finite.
    pub fn signal_quantity(
        &self,
        value: &Value,
        what: &str,
        dimension: Dimension,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        self.expression(value, Purpose { what, dimension: Some(dimension) }, signals)
    }

    /// A difference of values of the given dimension over the parameters, as a tolerance is one: 2 degC are 2 K.
    pub fn difference(&self, value: &Value, what: &str, dimension: Dimension) -> Option<Expression> {
        self.collect(|own| {
            let written = WrittenValue::of(value, what, own)?;
            let mut scope = Scope { parameters: self.parameters, signals: &mut NoSignals };
            written.difference(Purpose { what, dimension: Some(dimension) }, &mut scope, own)
        })
    }

    /// A value of any dimension, over the parameters and signals.
    pub fn any_quantity(&self, value: &Value, what: &str, signals: &mut dyn Signals) -> Option<Expression> {
        self.expression(value, Purpose { what, dimension: None }, signals)
    }

    fn expression(&self, value: &Value, purpose: Purpose<'_>, signals: &mut dyn Signals) -> Option<Expression> {
        self.collect(|own| {
            let written = WrittenValue::of(value, purpose.what, own)?;
            let mut scope = Scope { parameters: self.parameters, signals };
            written.value(purpose, &mut scope, own)
        })
    }

    /// A list of values, one for each of `dimensions`.
    pub fn vector(&self, value: &Value, what: &str, dimensions: &[Dimension]) -> Option<Vec<Expression>> {
        self.signal_vector(value, what, dimensions, &mut NoSignals)
    }

    /// The same, which may also use signals.
    pub fn signal_vector(
        &self,
        value: &Value,
        what: &str,
        dimensions: &[Dimension],
        signals: &mut dyn Signals,
    ) -> Option<Vec<Expression>> {
        let values = self.list_of(value, what, &[dimensions.len()])?;
        let mut read =
            |(value, dimension): (&Value, &Dimension)| self.signal_quantity(value, what, *dimension, signals);
        // All are read before giving up, for the errors of each.
        let read: Vec<Option<Expression>> = values.iter().zip(dimensions).map(&mut read).collect();
        read.into_iter().collect()
    }

    /// A list of values of one dimension, as many as one of `lengths`.
    pub fn uniform_vector(
        &self,
        value: &Value,
        what: &str,
        dimension: Dimension,
        lengths: &[usize],
    ) -> Option<Vec<Expression>> {
        let values = self.list_of(value, what, lengths)?;
        self.vector(value, what, &vec![dimension; values.len()])
    }

    /// A list of one of some lengths.
    fn list_of<'a>(&self, value: &'a Value, what: &str, lengths: &[usize]) -> Option<&'a [Value]> {
        let values = self.list(value, what)?;
        if lengths.contains(&values.len()) {
            return Some(values);
        }
        let values_wanted = if lengths == [1] { "value" } else { "values" };
        let lengths: Vec<String> = lengths.iter().map(usize::to_string).collect();
        let message = format!("{what} needs {} {values_wanted}, found {}", lengths.join(" or "), values.len());
        self.report(Diagnostic::error("wrong-length", value.span, message));
        None
    }

    /// Text.
    pub fn string<'a>(&self, value: &'a Value, what: &str) -> Option<Spanned<&'a str>> {
        match value.as_str() {
            Some(text) => Some(Spanned { value: text, span: value.span }),
            None => self.wrong_type(value, what, "a string"),
        }
    }

    /// A list of texts.
    pub fn strings<'a>(&self, value: &'a Value, what: &str) -> Option<Vec<Spanned<&'a str>>> {
        let values = self.list(value, what)?;
        let read: Vec<Option<Spanned<&'a str>>> = values.iter().map(|v| self.string(v, what)).collect();
        read.into_iter().collect()
    }

    /// A list.
    pub fn list<'a>(&self, value: &'a Value, what: &str) -> Option<&'a [Value]> {
        value.as_list().or_else(|| self.wrong_type(value, what, "a list"))
    }

    /// `true` or `false`.
    pub fn boolean(&self, value: &Value, what: &str) -> Option<Spanned<bool>> {
        match value.kind {
            ValueKind::Boolean(truth) => Some(Spanned { value: truth, span: value.span }),
            _ => self.wrong_type(value, what, "true or false"),
        }
    }

    /// A whole number within a range.
    pub fn integer(&self, value: &Value, what: &str, range: RangeInclusive<i64>) -> Option<Spanned<i64>> {
        let number = match value.kind {
            ValueKind::Integer(number) => number,
            ValueKind::Float(number) => {
                let message = format!("{what} needs a whole number, found {number}");
                self.report(Diagnostic::error("wrong-type", value.span, message));
                return None;
            }
            _ => return self.wrong_type(value, what, "a whole number"),
        };
        if range.contains(&number) {
            return Some(Spanned { value: number, span: value.span });
        }
        let wanted = match (*range.start(), *range.end()) {
            (start, i64::MAX) => format!("at least {start}"),
            (start, end) => format!("{start} to {end}"),
        };
        let message = format!("{what} needs a whole number, {wanted}; found {number}");
        self.report(Diagnostic::error("out-of-range", value.span, message));
        None
    }

    /// A table, to be read field by field; `what` names it, as "joint `B`".
    pub fn fields<'a>(&'a self, value: &'a Value, what: &str) -> Option<Fields<'a>> {
        match value.as_table() {
            Some(table) => Some(Fields::new(self, table, what)),
            None => self.wrong_type(value, what, "a table"),
        }
    }

    /// One of some names.
    pub fn one_of<'n>(&self, value: &Value, what: &str, names: &[&'n str]) -> Option<Spanned<&'n str>> {
        let written = self.string(value, what)?;
        if let Some(name) = names.iter().find(|n| **n == written.value) {
            return Some(Spanned { value: name, span: written.span });
        }
        let message = format!("{what} cannot be `{}`", written.value);
        let error = Diagnostic::error("unknown-choice", value.span, message);
        let error = error.did_you_mean(nearest(written.value, names.iter().copied()));
        self.report(error.hint(format!("known: {}", quoted(names))));
        None
    }

    /// A number of a run (`response`, `minimize`).
    pub fn response(&self, value: &Value, what: &str, signals: &mut dyn Signals) -> Option<Response> {
        self.collect(|own| {
            let written = WrittenValue::of(value, what, own)?;
            let mut scope = Scope { parameters: self.parameters, signals };
            expression::response(written.written(), what, &mut scope, own)
        })
    }

    /// A comparison of numbers of a run (an entry of `subject_to`).
    pub fn constraint(&self, value: &Value, what: &str, signals: &mut dyn Signals) -> Option<Constraint> {
        self.collect(|own| {
            let written = WrittenValue::of(value, what, own)?;
            let mut scope = Scope { parameters: self.parameters, signals };
            expression::constraint(written.written(), what, &mut scope, own)
        })
    }

    /// A comparison at one instant (`stop_when`).
    pub fn condition(&self, value: &Value, what: &str, signals: &mut dyn Signals) -> Option<Condition> {
        self.collect(|own| {
            let written = WrittenValue::of(value, what, own)?;
            let mut scope = Scope { parameters: self.parameters, signals };
            expression::condition(written.written(), what, &mut scope, own)
        })
    }

    /// Runs a reading with diagnostics of its own, so that callbacks into `signals` may report too.
    fn collect<T>(&self, read: impl FnOnce(&mut Diagnostics) -> Option<T>) -> Option<T> {
        let mut own = self.diagnostics.borrow().branch();
        let result = read(&mut own);
        self.diagnostics.borrow_mut().append(own);
        result
    }

    fn wrong_type<T>(&self, value: &Value, what: &str, wanted: &str) -> Option<T> {
        if !matches!(value.kind, ValueKind::Faulty) {
            let message = format!("{what} needs {wanted}, found {}", value.describe());
            self.report(Diagnostic::error("wrong-type", value.span, message));
        }
        None
    }

    pub(super) fn missing(&self, key: &str, what: &str, span: Span, hint: Option<String>) {
        let report = Diagnostic::error("missing-key", span, format!("`{key}` is missing in {what}"));
        self.report(match hint {
            Some(hint) => report.hint(hint),
            None => report,
        });
    }
}

/// `a`, `b`, `c`
pub(crate) fn quoted(names: &[&str]) -> String {
    names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>().join(", ")
}
