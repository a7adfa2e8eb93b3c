//! The compiled form: operations in an array, operands by index.

use super::function::Function;
use crate::Number;

/// Index of an operation.
pub(super) type At = u32;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Op {
    Constant(f64),
    Parameter(u32),
    Signal(u32),
    Negate(At),
    Add(At, At),
    Subtract(At, At),
    Multiply(At, At),
    Divide(At, At),
    /// Whole powers have derivatives at 0 too.
    PowerWhole(At, i32),
    Power(At, At),
    One(Function, At),
    Two(Function, At, At),
}

/// Operations; operands stand before the operations that use them, the result is the last.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Program {
    pub(super) ops: Vec<Op>,
}

impl Program {
    pub(super) fn eval<N: Number>(&self, parameters: &[N], signals: &[N]) -> N {
        match self.ops.len() {
            0 => N::from(f64::NAN),
            n => self.at(n as At - 1, parameters, signals),
        }
    }

    /// The value of one operation. Recursion is bounded by the parser's depth of trees.
    pub(super) fn at<N: Number>(&self, at: At, parameters: &[N], signals: &[N]) -> N {
        let value = |at: At| self.at(at, parameters, signals);
        let given = |all: &[N], i: u32| all.get(i as usize).copied().unwrap_or_else(|| N::from(f64::NAN));
        match self.ops.get(at as usize).copied().unwrap_or(Op::Constant(f64::NAN)) {
            Op::Constant(c) => N::from(c),
            Op::Parameter(i) => given(parameters, i),
            Op::Signal(i) => given(signals, i),
            Op::Negate(a) => -value(a),
            Op::Add(a, b) => value(a) + value(b),
            Op::Subtract(a, b) => value(a) - value(b),
            Op::Multiply(a, b) => value(a) * value(b),
            Op::Divide(a, b) => value(a) / value(b),
            Op::PowerWhole(a, n) => value(a).powi(n),
            Op::Power(a, b) => value(a).powf(value(b)),
            Op::One(function, a) => one(function, value(a)),
            Op::Two(function, a, b) => two(function, value(a), value(b)),
        }
    }
}

fn one<N: Number>(function: Function, a: N) -> N {
    match function {
        Function::Sin => a.sin(),
        Function::Cos => a.cos(),
        Function::Tan => a.tan(),
        Function::Asin => a.asin(),
        Function::Acos => a.acos(),
        Function::Atan => a.atan(),
        Function::Sqrt => a.sqrt(),
        Function::Abs => a.abs(),
        Function::Sign => N::from(sign(a.value())),
        Function::Atan2 | Function::Min | Function::Max => N::from(f64::NAN),
    }
}

fn two<N: Number>(function: Function, a: N, b: N) -> N {
    match function {
        Function::Atan2 => a.atan2(b),
        // A NaN on either side must come out, not be passed over.
        Function::Min if b.value() < a.value() || b.value().is_nan() => b,
        Function::Max if b.value() > a.value() || b.value().is_nan() => b,
        Function::Min | Function::Max => a,
        _ => N::from(f64::NAN),
    }
}

/// -1, 0 or 1; NaN for NaN.
fn sign(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.signum() }
}
