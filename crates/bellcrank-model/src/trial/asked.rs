//! The numbers asked of a study: arithmetic over reductions of curves.

use std::ops::Range;

use bellcrank_doc::{Constraint, Expression, Reduction, ReductionKind, Response, Span};

use crate::signals::{Level, Signal};

/// A curve along the rows and how it becomes one number.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub(crate) kind: ReductionKind,
    pub(crate) expression: Expression,
    pub(crate) place: Option<Expression>,
    /// As written.
    pub(crate) text: String,
}

/// Arithmetic over some of the reductions.
#[derive(Clone, Debug)]
struct Outer {
    value: Expression,
    reductions: Range<usize>,
}

/// Everything that is asked of a study.
#[derive(Clone, Debug, Default)]
pub(crate) struct Asked {
    pub(crate) curves: Vec<Curve>,
    outers: Vec<Outer>,
}

impl Asked {
    /// Adds a response; its index is that of its value.
    pub(crate) fn response(&mut self, response: &Response) -> usize {
        let reductions = self.curves(&response.reductions, response.written(), response.span());
        self.outer(&response.value, reductions)
    }

    /// Adds both sides of a constraint; the indices of their values.
    pub(crate) fn constraint(&mut self, constraint: &Constraint) -> [usize; 2] {
        let reductions = self.curves(&constraint.reductions, constraint.written(), constraint.span());
        [&constraint.left, &constraint.right].map(|side| self.outer(side, reductions.clone()))
    }

    fn curves(&mut self, reductions: &[Reduction], written: &str, all: Span) -> Range<usize> {
        let from = self.curves.len();
        self.curves.extend(reductions.iter().map(|reduction| Curve {
            kind: reduction.kind,
            expression: reduction.curve.clone(),
            place: reduction.place.clone(),
            text: part(written, all, reduction.span).to_owned(),
        }));
        from..self.curves.len()
    }

    fn outer(&mut self, value: &Expression, reductions: Range<usize>) -> usize {
        self.outers.push(Outer { value: value.clone(), reductions });
        self.outers.len() - 1
    }

    /// How many numbers are asked.
    pub(crate) fn len(&self) -> usize {
        self.outers.len()
    }

    pub(crate) fn value(&self, index: usize) -> &Expression {
        &self.outers[index].value
    }

    /// The curves that a number depends on.
    pub(crate) fn reductions(&self, index: usize) -> Range<usize> {
        self.outers[index].reductions.clone()
    }

    /// Indices of the signals in use, ascending.
    pub(crate) fn signals(&self) -> Vec<usize> {
        let mut used: Vec<usize> = self.curves.iter().flat_map(|curve| curve.expression.signals()).collect();
        used.sort_unstable();
        used.dedup();
        used
    }

    /// How far a position must be solved for them.
    pub(crate) fn level(&self, signals: &[Signal], level: impl Fn(Signal) -> Level) -> Level {
        let used = self.signals();
        used.iter().filter_map(|&i| signals.get(i)).map(|&signal| level(signal)).max().unwrap_or(Level::Position)
    }
}

/// The part of a text that a span within it is; all of it where the text was written with escapes.
fn part(written: &str, all: Span, of: Span) -> &str {
    let from = of.start.checked_sub(all.start);
    from.and_then(|from| written.get(from..from + (of.end - of.start))).unwrap_or(written)
}
