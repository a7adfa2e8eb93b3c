//! The numbers that expressions are evaluated over.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number: `f64`, or one that carries derivatives along.
///
/// Comparisons (`min`, `max`, `sign`, `<`) look at [`Number::value`] only.
pub trait Number:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The value without derivatives.
    fn value(self) -> f64;
    /// Sine; argument in radians.
    fn sin(self) -> Self;
    /// Cosine; argument in radians.
    fn cos(self) -> Self;
    /// Tangent; argument in radians.
    fn tan(self) -> Self;
    /// Arc sine, radians.
    fn asin(self) -> Self;
    /// Arc cosine, radians.
    fn acos(self) -> Self;
    /// Arc tangent, radians.
    fn atan(self) -> Self;
    /// Angle of the point (x = `x`, y = `self`), radians.
    fn atan2(self, x: Self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// Magnitude; the derivative at 0 is the implementor's choice.
    fn abs(self) -> Self;
    /// Whole power.
    fn powi(self, n: i32) -> Self;
    /// General power.
    fn powf(self, n: Self) -> Self;
}

impl Number for f64 {
    fn value(self) -> f64 {
        self
    }
    fn sin(self) -> f64 {
        f64::sin(self)
    }
    fn cos(self) -> f64 {
        f64::cos(self)
    }
    fn tan(self) -> f64 {
        f64::tan(self)
    }
    fn asin(self) -> f64 {
        f64::asin(self)
    }
    fn acos(self) -> f64 {
        f64::acos(self)
    }
    fn atan(self) -> f64 {
        f64::atan(self)
    }
    fn atan2(self, x: f64) -> f64 {
        f64::atan2(self, x)
    }
    fn sqrt(self) -> f64 {
        f64::sqrt(self)
    }
    fn abs(self) -> f64 {
        f64::abs(self)
    }
    fn powi(self, n: i32) -> f64 {
        f64::powi(self, n)
    }
    fn powf(self, n: f64) -> f64 {
        f64::powf(self, n)
    }
}
