//! Checked expressions: written text in, compiled arithmetic out.

mod ast;
mod check;
mod function;
mod parse;
mod program;
mod read;
#[cfg(test)]
mod tests;
mod token;

use crate::{Diagnostic, Dimension, Number, ParameterSet, Span};

pub(crate) use ast::{Node, NodeKind, Parsed, Tolerance};
pub(crate) use check::{Known, Resolve};
pub(crate) use function::reserved;
pub(crate) use parse::{parse, parse_difference, parse_unit, plain};
pub(crate) use read::{Purpose, condition, constraint, half_width, nominal, parsed, response};
pub(crate) use token::Written;

use program::{Op, Program};

/// Numbers beyond this mean a slip, and their products overflow.
pub(crate) const HUGE: f64 = 1e150;

/// Names of quantities that change along a run (`time`, `joint.B.position`).
pub trait Signals {
    /// Index and dimension of a signal. Called for each use of a name, and again for reports.
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
    program: Program,
    dimension: Dimension,
    span: Span,
    written: String,
}

impl Expression {
    /// A constant without text (a default); `span` is where its absence can be blamed.
    #[must_use]
    pub fn constant(value: f64, dimension: Dimension, span: Span) -> Expression {
        let program = Program { ops: vec![Op::Constant(value)] };
        Expression { program, dimension, span, written: String::new() }
    }

    /// The SI value, given the values of all parameters (in the order of their set) and of all
    /// signals (by the indices given by [`Signals::lookup`]). A missing one counts as NaN. No
    /// allocation. Division by zero gives inf or NaN: the caller's check.
    pub fn eval<N: Number>(&self, parameters: &[N], signals: &[N]) -> N {
        self.program.eval(parameters, signals)
    }

    /// The SI value over parameters alone, or the report that it is not finite with these values
    /// (or is one of a signal).
    pub fn finite(&self, parameters: &[f64]) -> Result<f64, Diagnostic> {
        let value: f64 = self.eval(parameters, &[]);
        if value.is_finite() {
            return Ok(value);
        }
        Err(Diagnostic::error(
            "not-finite",
            self.span,
            format!("with these parameters this is {value}, not a finite number"),
        ))
    }

    /// Its dimension: the one wanted by who read it, where one was.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dimension
    }

    /// Whether it may stand where `wanted` is: the dimensions agree, or it is a literal 0.
    #[must_use]
    pub fn fits(&self, wanted: Dimension) -> bool {
        self.dimension.agrees(wanted) || (self.dimension.is_none() && self.as_constant() == Some(0.0))
    }

    /// Its place.
    #[must_use]
    pub fn span(&self) -> Span {
        self.span
    }

    /// The text as written; empty for [`Expression::constant`].
    #[must_use]
    pub fn written(&self) -> &str {
        &self.written
    }

    /// Its value when it depends on nothing.
    #[must_use]
    pub fn as_constant(&self) -> Option<f64> {
        match self.program.ops.as_slice() {
            [Op::Constant(value)] => Some(*value),
            _ => None,
        }
    }

    /// Indices of the parameters it uses, ascending, each once.
    #[must_use]
    pub fn parameters(&self) -> Vec<usize> {
        self.used(|op| match op {
            Op::Parameter(i) => Some(*i as usize),
            _ => None,
        })
    }

    /// Indices of the signals it uses, ascending, each once.
    #[must_use]
    pub fn signals(&self) -> Vec<usize> {
        self.used(|op| match op {
            Op::Signal(i) => Some(*i as usize),
            _ => None,
        })
    }

    /// Gives parameters other indices: `new_index[old]`.
    pub(crate) fn renumber(&mut self, new_index: &[usize]) {
        for op in &mut self.program.ops {
            if let Op::Parameter(i) = op {
                *i = new_index.get(*i as usize).map_or(*i, |&new| new as u32);
            }
        }
    }

    fn used(&self, index: impl Fn(&Op) -> Option<usize>) -> Vec<usize> {
        let mut used: Vec<usize> = self.program.ops.iter().filter_map(index).collect();
        used.sort_unstable();
        used.dedup();
        used
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

impl Comparison {
    /// Whether the relation holds; false with a NaN.
    #[must_use]
    pub fn holds(self, left: f64, right: f64) -> bool {
        match self {
            Comparison::Less => left < right,
            Comparison::LessOrEqual => left <= right,
            Comparison::Greater => left > right,
            Comparison::GreaterOrEqual => left >= right,
            Comparison::Equal => left == right,
        }
    }
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
    /// Where the study's axis (its swept coordinate, or time) has the value of
    /// [`Reduction::place`].
    At,
}

/// `max(abs(drive.slide.force))`, `at(drive.slide.force, 15 deg)`: a curve and how it is reduced.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// How.
    pub kind: ReductionKind,
    /// The curve, over parameters and signals.
    pub curve: Expression,
    /// The place on the study's axis, over parameters: with [`ReductionKind::At`], and only there.
    /// Its dimension is what was written; [`Reduction::check_place`] asks whether it fits.
    pub place: Option<Expression>,
    /// Place of the whole call in the text.
    pub span: Span,
}

impl Reduction {
    /// Whether the place fits a study's axis: an angle or a length where a coordinate is swept, a
    /// time where time runs (0 fits all). True without a place.
    pub fn check_place(&self, axis: Dimension) -> Result<(), Diagnostic> {
        match &self.place {
            Some(place) if !place.fits(axis) => {
                let found = place.dimension();
                let message = format!("`at` needs {} here, found {}", axis.phrase(), found.phrase());
                let error = Diagnostic::error("dimension", place.span(), message);
                Err(error.hint("the place is a value of what the study goes over: its swept coordinate, or time"))
            }
            _ => Ok(()),
        }
    }
}

/// One number of a run: arithmetic over reductions.
#[derive(Clone, Debug)]
pub struct Response {
    /// Over parameters and, as signal `i`, the value of `reductions[i]`.
    pub value: Expression,
    /// The reductions in the order of their indices; none where the value is one of parameters
    /// alone (`l5 + l31`).
    pub reductions: Vec<Reduction>,
}

impl Response {
    /// The text as written.
    #[must_use]
    pub fn written(&self) -> &str {
        self.value.written()
    }

    /// Its place.
    #[must_use]
    pub fn span(&self) -> Span {
        self.value.span()
    }
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

impl Constraint {
    /// The text as written, both sides.
    #[must_use]
    pub fn written(&self) -> &str {
        self.left.written()
    }

    /// Its place, both sides.
    #[must_use]
    pub fn span(&self) -> Span {
        self.left.span().to(self.right.span())
    }

    /// What both sides measure.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.left.dimension()
    }
}
