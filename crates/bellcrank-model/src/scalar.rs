//! Numbers on the way from parameters to a mechanism: plain, or with exact derivatives.
//!
//! Mechanics counts with [`Real`], expressions with [`Number`]; a [`Scalar`] is both. For `f64` the two are one;
//! dual numbers are strangers to expressions (neither crate knows the other) and wear [`Exact`] there.

#[cfg(test)]
mod tests;

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use bellcrank_doc::Number;
use bellcrank_math::{Dual, Real};

/// A scalar of mechanics that expressions can be evaluated over.
pub(crate) trait Scalar: Real + PartialEq {
    /// The same number as expressions see it.
    type Number: Number + Debug;

    fn of(number: Self::Number) -> Self;
    fn number(self) -> Self::Number;

    /// f(self), given the value and the slope of f. What does not change has no derivative, however steep f is.
    fn chain(self, value: f64, slope: f64) -> Self;
}

impl Scalar for f64 {
    type Number = f64;

    fn of(number: f64) -> f64 {
        number
    }
    fn number(self) -> f64 {
        self
    }
    fn chain(self, value: f64, _slope: f64) -> f64 {
        value
    }
}

impl<const N: usize> Scalar for Dual<N> {
    type Number = Exact<N>;

    fn of(number: Exact<N>) -> Dual<N> {
        number.0
    }
    fn number(self) -> Exact<N> {
        Exact(self)
    }
    fn chain(self, value: f64, slope: f64) -> Dual<N> {
        Dual { re: value, eps: self.eps.map(|e| if e == 0.0 { 0.0 } else { e * slope }) }
    }
}

/// The length of a vector. That of none grows in no direction more than in another: its derivative counts as 0.
pub(crate) fn length<T: Real>(vector: [T; 3]) -> T {
    let square = vector.into_iter().fold(T::zero(), |sum, x| sum + x * x);
    if square.value() == 0.0 { T::zero() } else { square.sqrt() }
}

/// A number of expressions with exact derivatives; its value is bit for bit that of `f64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Exact<const N: usize>(pub(crate) Dual<N>);

impl<const N: usize> Exact<N> {
    fn chain(self, value: f64, slope: f64) -> Exact<N> {
        Exact(self.0.chain(value, slope))
    }

    /// f(self, o), given its value and its two slopes.
    fn chain2(self, slope: f64, o: Exact<N>, other: f64, value: f64) -> Exact<N> {
        Exact((self.0.chain(0.0, slope) + o.0.chain(0.0, other)).with_value(value))
    }
}

impl<const N: usize> From<f64> for Exact<N> {
    fn from(value: f64) -> Exact<N> {
        Exact(Dual::from_re(value))
    }
}

impl<const N: usize> Add for Exact<N> {
    type Output = Exact<N>;
    fn add(self, o: Exact<N>) -> Exact<N> {
        Exact(self.0 + o.0)
    }
}

impl<const N: usize> Sub for Exact<N> {
    type Output = Exact<N>;
    fn sub(self, o: Exact<N>) -> Exact<N> {
        Exact(self.0 - o.0)
    }
}

impl<const N: usize> Mul for Exact<N> {
    type Output = Exact<N>;
    fn mul(self, o: Exact<N>) -> Exact<N> {
        Exact(self.0 * o.0)
    }
}

impl<const N: usize> Div for Exact<N> {
    type Output = Exact<N>;
    fn div(self, o: Exact<N>) -> Exact<N> {
        Exact(self.0 / o.0)
    }
}

impl<const N: usize> Neg for Exact<N> {
    type Output = Exact<N>;
    fn neg(self) -> Exact<N> {
        Exact(-self.0)
    }
}

impl<const N: usize> Number for Exact<N> {
    fn value(self) -> f64 {
        self.0.re
    }
    fn sin(self) -> Exact<N> {
        Exact(self.0.sin_cos().0)
    }
    fn cos(self) -> Exact<N> {
        Exact(self.0.sin_cos().1)
    }
    fn tan(self) -> Exact<N> {
        let tan = self.value().tan();
        self.chain(tan, 1.0 + tan * tan)
    }
    fn asin(self) -> Exact<N> {
        let x = self.value();
        self.chain(x.asin(), 1.0 / (1.0 - x * x).sqrt())
    }
    fn acos(self) -> Exact<N> {
        let x = self.value();
        self.chain(x.acos(), -1.0 / (1.0 - x * x).sqrt())
    }
    fn atan(self) -> Exact<N> {
        let x = self.value();
        self.chain(x.atan(), 1.0 / (1.0 + x * x))
    }
    fn atan2(self, x: Exact<N>) -> Exact<N> {
        let (sin, cos) = (self.value(), x.value());
        let square = sin * sin + cos * cos;
        self.chain2(cos / square, x, -sin / square, sin.atan2(cos))
    }
    fn sqrt(self) -> Exact<N> {
        let root = self.value().sqrt();
        self.chain(root, 0.5 / root)
    }
    fn abs(self) -> Exact<N> {
        Exact(self.0.abs())
    }
    fn powi(self, n: i32) -> Exact<N> {
        let x = self.value();
        let slope = if n == 0 { 0.0 } else { f64::from(n) * x.powi(n.saturating_sub(1)) };
        self.chain(x.powi(n), slope)
    }
    /// A power that vanishes does not change with its exponent, though its logarithm is infinite.
    fn powf(self, n: Exact<N>) -> Exact<N> {
        let (x, k) = (self.value(), n.value());
        let power = x.powf(k);
        let by_base = if k == 0.0 { 0.0 } else { k * x.powf(k - 1.0) };
        let by_exponent = if power == 0.0 { 0.0 } else { power * x.ln() };
        self.chain2(by_base, n, by_exponent, power)
    }
}
