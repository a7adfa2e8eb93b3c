//! What the caller of the solver gives: a problem that can be evaluated at a point.

/// How a constraint function c is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// c(x) ≤ 0.
    AtMostZero,
    /// c(x) = 0.
    Zero,
}

/// One smooth function at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Its value.
    pub value: f64,
    /// Its gradient, one number a variable.
    pub gradient: Vec<f64>,
}

/// A function at a point, as the maximum of smooth pieces. One piece: the function is smooth there.
///
/// A maximum over many positions is given by its local maxima *near* the top, not the top alone: an optimum usually lies
/// where two of them are equally high, and a solver that sees one at a time zig-zags between them. Where neighbouring
/// positions of a grid can change places as the highest, give the neighbours too: a piece too many costs a microsecond, a
/// missing one costs iterations. The number and the order of the pieces may differ from call to call.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// The pieces in any order; at least one. A constraint `= 0` has exactly one.
    pub pieces: Vec<Piece>,
}

impl Function {
    /// A function that is smooth at this point.
    #[must_use]
    pub fn smooth(value: f64, gradient: Vec<f64>) -> Self {
        Self { pieces: vec![Piece { value, gradient }] }
    }

    /// The value: the greatest of the pieces' values; NaN if one of them is NaN or there is none.
    #[must_use]
    pub fn value(&self) -> f64 {
        maximum(&self.pieces)
    }
}

/// The greatest value, NaN if one is NaN or there is none.
pub(crate) fn maximum(pieces: &[Piece]) -> f64 {
    let values = pieces.iter().map(|piece| piece.value);
    values.reduce(|a, b| if a.is_nan() || a > b { a } else { b }).unwrap_or(f64::NAN)
}

/// Objective and constraints at a point with gradients.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// What is minimized.
    pub objective: Function,
    /// One function a relation of [`Problem::relations`].
    pub constraints: Vec<Function>,
}

impl Evaluation {
    /// The values alone.
    #[must_use]
    pub fn values(&self) -> Values {
        let constraints = self.constraints.iter().map(Function::value).collect();
        Values { objective: self.objective.value(), constraints }
    }
}

/// Objective and constraints at a point without gradients.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// What is minimized.
    pub objective: f64,
    /// One value a relation of [`Problem::relations`].
    pub constraints: Vec<f64>,
}

/// The problem has no values at a point, for example because a machine cannot be assembled. The solver steps back.
/// Values or gradients that are NaN or infinite, or of the wrong length, count as undefined, too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Undefined;

/// min f(x) subject to l ≤ x ≤ u and c(x) ≤ 0 or c(x) = 0.
///
/// The answers must depend on `x` alone, not on the calls before: the solver compares values of different calls.
pub trait Problem {
    /// The number of variables, n.
    fn variables(&self) -> usize;

    /// Lower and upper bound of each variable, n pairs; either may be infinite. Equal bounds fix a variable.
    fn bounds(&self) -> &[(f64, f64)];

    /// What each constraint means, in the order of [`Evaluation::constraints`].
    fn relations(&self) -> &[Relation];

    /// Values, gradients and pieces at `x` (n numbers, always inside the bounds).
    ///
    /// # Errors
    ///
    /// [`Undefined`] where the problem has no values.
    fn evaluate(&mut self, x: &[f64]) -> Result<Evaluation, Undefined>;
}

/// The question itself makes no sense, at whatever point.
#[derive(Clone, Debug, PartialEq)]
pub enum Malformed {
    /// As many bounds as variables are needed.
    Bounds {
        /// How many bounds there are.
        found: usize,
        /// The number of variables.
        variables: usize,
    },
    /// As many numbers in the start as variables are needed.
    Start {
        /// How many numbers there are.
        found: usize,
        /// The number of variables.
        variables: usize,
    },
    /// A lower bound above its upper bound, or a bound that is NaN.
    EmptyBound {
        /// Which variable, from 0.
        variable: usize,
    },
    /// A number of the start is NaN or infinite.
    StartNotFinite {
        /// Which variable, from 0.
        variable: usize,
    },
}

impl std::fmt::Display for Malformed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Bounds { found, variables } => write!(f, "{found} bounds for {variables} variables"),
            Self::Start { found, variables } => write!(f, "{found} start values for {variables} variables"),
            Self::EmptyBound { variable } => write!(f, "no number lies between the bounds of variable {variable}"),
            Self::StartNotFinite { variable } => write!(f, "the start of variable {variable} is not finite"),
        }
    }
}

impl std::error::Error for Malformed {}
