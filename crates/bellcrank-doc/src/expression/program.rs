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
        match self.ops.last() {
            Some(&op) => Given { ops: &self.ops, parameters, signals }.of(op),
            None => N::from(f64::NAN),
        }
    }
}

/// What an evaluation looks things up in.
struct Given<'a, N> {
    ops: &'a [Op],
    parameters: &'a [N],
    signals: &'a [N],
}

impl<N: Number> Given<'_, N> {
    /// Constants and names end here, without a call; most expressions are little else.
    #[inline(always)]
    fn of(&self, op: Op) -> N {
        let given = |all: &[N], i: u32| all.get(i as usize).copied().unwrap_or_else(|| N::from(f64::NAN));
        match op {
            Op::Constant(c) => N::from(c),
            Op::Parameter(i) => given(self.parameters, i),
            Op::Signal(i) => given(self.signals, i),
            arithmetic => self.arithmetic(arithmetic),
        }
    }

    #[inline(always)]
    fn at(&self, at: At) -> N {
        self.of(self.ops.get(at as usize).copied().unwrap_or(Op::Constant(f64::NAN)))
    }

    /// Recursion is bounded by the parser's depth of trees.
    #[inline(never)]
    fn arithmetic(&self, op: Op) -> N {
        match op {
            Op::Constant(_) | Op::Parameter(_) | Op::Signal(_) => N::from(f64::NAN),
            Op::Negate(a) => -self.at(a),
            Op::Add(a, b) => self.at(a) + self.at(b),
            Op::Subtract(a, b) => self.at(a) - self.at(b),
            Op::Multiply(a, b) => self.at(a) * self.at(b),
            Op::Divide(a, b) => self.at(a) / self.at(b),
            Op::PowerWhole(a, n) => self.at(a).powi(n),
            Op::Power(a, b) => self.at(a).powf(self.at(b)),
            Op::One(function, a) => one(function, self.at(a)),
            Op::Two(function, a, b) => two(function, self.at(a), self.at(b)),
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
