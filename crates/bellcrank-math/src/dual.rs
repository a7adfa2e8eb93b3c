//! Forward-mode derivatives: a number and its `N` partial derivatives.

use crate::Real;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A value with `N` derivatives, propagated exactly through arithmetic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<const N: usize> {
    /// The number.
    pub re: f64,
    /// Its derivatives with respect to `N` seeds.
    pub eps: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// The variable with seed `i`: derivative 1 with respect to itself.
    pub fn variable(re: f64, i: usize) -> Self {
        let mut eps = [0.0; N];
        eps[i] = 1.0;
        Self { re, eps }
    }
    /// A constant.
    pub fn from_re(re: f64) -> Self {
        Self { re, eps: [0.0; N] }
    }
    /// Chain rule: `f(self)` given the value and the slope of `f`.
    #[inline]
    fn chain(self, re: f64, slope: f64) -> Self {
        Self { re, eps: self.eps.map(|e| e * slope) }
    }
    #[inline]
    fn zip(self, o: Self, re: f64, f: impl Fn(f64, f64) -> f64) -> Self {
        Self { re, eps: std::array::from_fn(|i| f(self.eps[i], o.eps[i])) }
    }
}

impl<const N: usize> Default for Dual<N> {
    fn default() -> Self {
        Self { re: 0.0, eps: [0.0; N] }
    }
}
impl<const N: usize> Add for Dual<N> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        self.zip(o, self.re + o.re, |a, b| a + b)
    }
}
impl<const N: usize> Sub for Dual<N> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        self.zip(o, self.re - o.re, |a, b| a - b)
    }
}
#[expect(clippy::suspicious_arithmetic_impl, reason = "the rules of differentiation mix the operations")]
impl<const N: usize> Mul for Dual<N> {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        self.zip(o, self.re * o.re, |a, b| a * o.re + self.re * b)
    }
}
#[expect(clippy::suspicious_arithmetic_impl, reason = "the rules of differentiation mix the operations")]
impl<const N: usize> Div for Dual<N> {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let re = self.re / o.re;
        self.zip(o, re, |a, b| (a - re * b) / o.re)
    }
}
impl<const N: usize> Neg for Dual<N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.re, -1.0)
    }
}
impl<const N: usize> AddAssign for Dual<N> {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<const N: usize> SubAssign for Dual<N> {
    #[inline]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl<const N: usize> Real for Dual<N> {
    fn from_f64(re: f64) -> Self {
        Self { re, eps: [0.0; N] }
    }
    fn value(self) -> f64 {
        self.re
    }
    fn sqrt(self) -> Self {
        let r = self.re.sqrt();
        self.chain(r, 0.5 / r)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.re.sin_cos();
        (self.chain(s, c), self.chain(c, -s))
    }
    fn atan2(self, x: Self) -> Self {
        let r2 = self.re * self.re + x.re * x.re;
        self.zip(x, self.re.atan2(x.re), |dy, dx| (x.re * dy - self.re * dx) / r2)
    }
    fn acos(self) -> Self {
        self.chain(self.re.acos(), -1.0 / (1.0 - self.re * self.re).sqrt())
    }
    fn exp(self) -> Self {
        let e = self.re.exp();
        self.chain(e, e)
    }
    fn tanh(self) -> Self {
        let t = self.re.tanh();
        self.chain(t, 1.0 - t * t)
    }
    fn abs(self) -> Self {
        if self.re < 0.0 { -self } else { self }
    }
    fn with_value(self, x: f64) -> Self {
        Self { re: x, eps: self.eps }
    }
    fn is_zero(self) -> bool {
        self.re == 0.0 && self.eps.iter().all(|e| *e == 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope(f: impl Fn(Dual<1>) -> Dual<1>, x: f64) -> (f64, f64) {
        let exact = f(Dual::variable(x, 0)).eps[0];
        let h = 1e-6;
        let at = |x: f64| f(Dual::from_f64(x)).re;
        (exact, (at(x + h) - at(x - h)) / (2.0 * h))
    }

    #[test]
    fn every_function_has_the_slope_of_its_differences() {
        let k = Dual::<1>::from_f64(1.7);
        let cases: [fn(Dual<1>, Dual<1>) -> Dual<1>; 10] = [
            |x, k| x * x * k,
            |x, k| k / (x + k),
            |x, _| x.sqrt(),
            |x, _| x.sin_cos().0,
            |x, _| x.sin_cos().1,
            |x, k| (x * k).atan2(x - k),
            |x, k| (x / (k + k)).acos(),
            |x, _| (-x).exp(),
            |x, k| (x - k).abs(),
            |x, k| x - k * x,
        ];
        for (i, f) in cases.iter().enumerate() {
            let (exact, difference) = slope(|x| f(x, k), 0.37);
            assert!((exact - difference).abs() < 1e-8, "function {i}: {exact} against {difference}");
        }
    }
}
