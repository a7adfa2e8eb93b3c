//! What a number must do to pass through joints, forces and recursions.

use std::fmt::Debug;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A scalar: `f64`, or a [`Dual`](crate::Dual) that carries derivatives along.
///
/// Comparisons go through [`Real::value`], so a branch taken is that of the plain number.
pub trait Real:
    Copy
    + Debug
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
{
    /// A constant: its derivatives are zero.
    fn from_f64(x: f64) -> Self;
    /// The number without its derivatives.
    fn value(self) -> f64;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in rad.
    fn sin_cos(self) -> (Self, Self);
    /// Angle in rad of the point (`x`, `self`).
    fn atan2(self, x: Self) -> Self;
    /// Arc cosine in rad.
    fn acos(self) -> Self;
    /// Exponential.
    fn exp(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Absolute value; the derivative at 0 is that of +x.
    fn abs(self) -> Self;
    /// The number `x` with the derivatives of `self`.
    fn with_value(self, x: f64) -> Self;
    /// Zero, and so is every derivative.
    fn is_zero(self) -> bool;
    /// Zero.
    fn zero() -> Self {
        Self::from_f64(0.0)
    }
    /// One.
    fn one() -> Self {
        Self::from_f64(1.0)
    }
}

impl Real for f64 {
    fn from_f64(x: f64) -> Self {
        x
    }
    fn value(self) -> f64 {
        self
    }
    fn sqrt(self) -> Self {
        self.sqrt()
    }
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }
    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }
    fn acos(self) -> Self {
        self.acos()
    }
    fn exp(self) -> Self {
        self.exp()
    }
    fn tanh(self) -> Self {
        self.tanh()
    }
    fn abs(self) -> Self {
        self.abs()
    }
    fn with_value(self, x: f64) -> Self {
        x
    }
    fn is_zero(self) -> bool {
        self == 0.0
    }
}
