//! Checked expressions: written text in, compiled arithmetic out.

use crate::{Dimension, Number, ParameterSet, Span};

/// Names of quantities that change along a run (`time`, `joint.B.position`).
pub trait Signals {
    /// Index and dimension of a signal; called once for each use of a name.
    fn lookup(&mut self, name: &str) -> Option<(usize, Dimension)>;
    /// All names, for hints.
    fn names(&self) -> Vec<String>;
}

/// Where no signal may be used.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoSignals;

impl Signals for NoSignals {
    fn lookup(&mut self, _name: &str) -> Option<(usize, Dimension)> {
        None
    }
    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

/// The names an expression may use.
pub struct Scope<'a> {
    /// Parameters.
    pub parameters: &'a ParameterSet,
    /// Signals.
    pub signals: &'a mut dyn Signals,
}

/// A checked, compiled expression. Evaluates to SI.
#[derive(Clone, Debug)]
pub struct Expression {
    dimension: Dimension,
    span: Span,
}

impl Expression {
    /// A constant without text (a default); `span` is where its absence can be blamed.
    #[must_use]
    pub fn constant(value: f64, dimension: Dimension, span: Span) -> Expression {
        todo!()
    }

    /// The SI value, given the values of all parameters (in the order of their set) and of all
    /// signals (by the indices given by [`Signals::lookup`]). A missing one counts as NaN. No
    /// allocation. Division by zero gives inf or NaN: the caller's check.
    pub fn eval<N: Number>(&self, parameters: &[N], signals: &[N]) -> N {
        todo!()
    }

    /// Its dimension: the one wanted by who read it, where one was.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Its place.
    #[must_use]
    pub fn span(&self) -> Span {
        self.span
    }

    /// The text as written.
    #[must_use]
    pub fn written(&self) -> &str {
        todo!()
    }

    /// Its value when it depends on nothing.
    #[must_use]
    pub fn as_constant(&self) -> Option<f64> {
        todo!()
    }

    /// Indices of the parameters it uses, ascending, each once.
    #[must_use]
    pub fn parameters(&self) -> Vec<usize> {
        todo!()
    }

    /// Indices of the signals it uses, ascending, each once.
    #[must_use]
    pub fn signals(&self) -> Vec<usize> {
        todo!()
    }
}

/// `< <= > >= ==`
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `==`
    Equal,
}

/// A comparison of two values at one instant (`stop_when`).
#[derive(Clone, Debug)]
pub struct Condition {
    /// Left side.
    pub left: Expression,
    /// Relation.
    pub comparison: Comparison,
    /// Right side, of the same dimension.
    pub right: Expression,
}

/// How a curve becomes one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReductionKind {
    /// Smallest.
    Min,
    /// Largest.
    Max,
    /// Mean over the sweep or over time.
    Mean,
    /// Root of the mean square.
    Rms,
    /// Largest minus smallest.
    Range,
    /// At the start.
    First,
    /// At the end.
    Last,
}

/// `max(abs(drive.slide.force))`: a curve and how it is reduced.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// How.
    pub kind: ReductionKind,
    /// The curve, over parameters and signals.
    pub curve: Expression,
    /// Place of the whole call.
    pub span: Span,
}

/// One number of a run: arithmetic over reductions.
#[derive(Clone, Debug)]
pub struct Response {
    /// Over parameters and, as signal `i`, the value of `reductions[i]`.
    pub value: Expression,
    /// The reductions in the order of their indices.
    pub reductions: Vec<Reduction>,
}

/// A comparison of two numbers of a run (`subject_to`).
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Left side, over parameters and the values of `reductions` as signals.
    pub left: Expression,
    /// Relation.
    pub comparison: Comparison,
    /// Right side, likewise, of the same dimension.
    pub right: Expression,
    /// The reductions of both sides.
    pub reductions: Vec<Reduction>,
}
