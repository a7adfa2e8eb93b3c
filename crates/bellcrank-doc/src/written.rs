//! A value as it is written: a number, or the text of an expression.

use std::borrow::Cow;

use crate::expression::{self, HUGE, Node, NodeKind, Parsed, Purpose, Resolve, Written};
use crate::{Diagnostic, Diagnostics, Expression, Span, Value, ValueKind};

/// A number or an expression text, not looked into yet.
#[derive(Clone, Debug)]
pub(crate) struct WrittenValue<'t> {
    pub(crate) text: Cow<'t, str>,
    pub(crate) span: Span,
    origin: Option<usize>,
    /// Set for a TOML number.
    number: Option<f64>,
}

impl<'t> WrittenValue<'t> {
    /// The value of `what`, which must be a number or a string.
    pub(crate) fn of(value: &'t Value, what: &str, diagnostics: &mut Diagnostics) -> Option<WrittenValue<'t>> {
        match &value.kind {
            ValueKind::String(text) => {
                let written = Written::of(text, value.span);
                Some(WrittenValue::text(written))
            }
            ValueKind::Integer(number) => WrittenValue::number(*number as f64, value.span, what, diagnostics),
            ValueKind::Float(number) => WrittenValue::number(*number, value.span, what, diagnostics),
            ValueKind::Faulty => None,
            _ => {
                let message = format!("{what} needs a value, found {}", value.describe());
                let error = Diagnostic::error("wrong-type", value.span, message);
                diagnostics.push(error.hint("a value is a number, or a string as `\"35 mm\"` or `\"l1/2\"`"));
                None
            }
        }
    }

    pub(crate) fn text(written: Written<'t>) -> WrittenValue<'t> {
        WrittenValue { text: Cow::Borrowed(written.text), span: written.span, origin: written.origin, number: None }
    }

    /// The same, living on its own.
    pub(crate) fn into_owned(self) -> WrittenValue<'static> {
        let WrittenValue { text, span, origin, number } = self;
        WrittenValue { text: Cow::Owned(text.into_owned()), span, origin, number }
    }

    fn number(value: f64, span: Span, what: &str, diagnostics: &mut Diagnostics) -> Option<WrittenValue<'t>> {
        if !value.is_finite() || value.abs() > HUGE {
            let found =
                if value.is_finite() { format!("{value:e}, too large to mean anything") } else { value.to_string() };
            let message = format!("{what} needs a finite number, found {found}");
            diagnostics.push(Diagnostic::error("not-finite", span, message));
            return None;
        }
        Some(WrittenValue { text: Cow::Owned(value.to_string()), span, origin: None, number: Some(value) })
    }

    /// The text with its place.
    pub(crate) fn written(&self) -> Written<'_> {
        Written { text: &self.text, span: self.span, origin: self.origin }
    }

    pub(crate) fn parse(&self, diagnostics: &mut Diagnostics) -> Option<Parsed> {
        if let Some(number) = self.number {
            let left = Node::leaf(NodeKind::Number(number), self.span);
            return Some(Parsed { left, tolerance: None, right: None });
        }
        expression::parse(self.written()).map_err(|fault| diagnostics.push(fault)).ok()
    }

    /// The checked value of a difference (2 degC are 2 K).
    pub(crate) fn difference(
        &self,
        purpose: Purpose<'_>,
        names: &mut dyn Resolve,
        diagnostics: &mut Diagnostics,
    ) -> Option<Expression> {
        let tree = match self.number {
            Some(_) => self.parse(diagnostics)?,
            None => expression::parse_difference(self.written()).map_err(|fault| diagnostics.push(fault)).ok()?,
        };
        expression::parsed(&tree, &self.text, purpose, names, diagnostics)
    }

    /// The checked value.
    pub(crate) fn value(
        &self,
        purpose: Purpose<'_>,
        names: &mut dyn Resolve,
        diagnostics: &mut Diagnostics,
    ) -> Option<Expression> {
        let tree = self.parse(diagnostics)?;
        expression::parsed(&tree, &self.text, purpose, names, diagnostics)
    }
}
