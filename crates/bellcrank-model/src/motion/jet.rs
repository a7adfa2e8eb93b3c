//! Numbers that carry their first and second derivative along.

use std::ops::{Add, Div, Mul, Neg, Sub};

use bellcrank_doc::Number;

use crate::scalar::Scalar;

/// f, f′ and f″ at one instant; each may have derivatives of its own, by parameters or by time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Jet<T = f64> {
    pub(crate) value: T,
    pub(crate) first: T,
    pub(crate) second: T,
}

impl<T> Jet<T> {
    pub(crate) const fn new(value: T, first: T, second: T) -> Jet<T> {
        Jet { value, first, second }
    }
}

impl<T: Scalar> Jet<T> {
    /// What stays.
    pub(crate) fn constant(value: T) -> Jet<T> {
        Jet::new(value, T::zero(), T::zero())
    }

    /// The variable itself.
    pub(crate) fn variable(value: T) -> Jet<T> {
        Jet::new(value, T::one(), T::zero())
    }

    /// f(self), given f, f′ and f″ there. What stays has no rates, however steep f is.
    fn chain(self, f: T, slope: T, bend: T) -> Jet<T> {
        let bent = times(self.first, times(self.first, bend));
        Jet::new(f, times(self.first, slope), bent + times(self.second, slope))
    }

    /// A function of expressions at the value.
    fn apply(self, f: fn(T::Number) -> T::Number) -> T {
        T::of(f(self.value.number()))
    }

    fn is_constant(self) -> bool {
        self.first.is_zero() && self.second.is_zero()
    }

    fn exp(self) -> Jet<T> {
        let e = self.value.exp();
        self.chain(e, e, e)
    }

    fn ln(self) -> Jet<T> {
        let x = self.value;
        let slope = T::one() / x;
        self.chain(x.chain(x.value().ln(), slope.value()), slope, -slope * slope)
    }

    /// x^n for a constant n.
    fn power(self, n: T) -> Jet<T> {
        let one = T::one();
        let power = |n: T| T::of(self.value.number().powf(n.number()));
        self.chain(power(n), times(n, power(n - one)), times(n * (n - one), power(n - one - one)))
    }
}

/// A product whose first factor, when it vanishes, does so even where a negative power of 0 stands beside it.
fn times<T: Scalar>(factor: T, o: T) -> T {
    if factor.is_zero() { T::zero() } else { factor * o }
}

impl<T: Scalar> From<f64> for Jet<T> {
    fn from(value: f64) -> Jet<T> {
        Jet::constant(T::from_f64(value))
    }
}

impl<T: Scalar> Add for Jet<T> {
    type Output = Jet<T>;
    fn add(self, o: Jet<T>) -> Jet<T> {
        Jet::new(self.value + o.value, self.first + o.first, self.second + o.second)
    }
}

impl<T: Scalar> Sub for Jet<T> {
    type Output = Jet<T>;
    fn sub(self, o: Jet<T>) -> Jet<T> {
        Jet::new(self.value - o.value, self.first - o.first, self.second - o.second)
    }
}

impl<T: Scalar> Mul for Jet<T> {
    type Output = Jet<T>;
    fn mul(self, o: Jet<T>) -> Jet<T> {
        let two = T::from_f64(2.0);
        Jet::new(
            self.value * o.value,
            self.first * o.value + self.value * o.first,
            self.second * o.value + two * self.first * o.first + self.value * o.second,
        )
    }
}

impl<T: Scalar> Div for Jet<T> {
    type Output = Jet<T>;
    fn div(self, o: Jet<T>) -> Jet<T> {
        let two = T::from_f64(2.0);
        let value = self.value / o.value;
        let first = (self.first - value * o.first) / o.value;
        let second = (self.second - two * first * o.first - value * o.second) / o.value;
        Jet::new(value, first, second)
    }
}

impl<T: Scalar> Neg for Jet<T> {
    type Output = Jet<T>;
    fn neg(self) -> Jet<T> {
        Jet::new(-self.value, -self.first, -self.second)
    }
}

impl<T: Scalar> Number for Jet<T> {
    fn value(self) -> f64 {
        self.value.value()
    }
    fn sin(self) -> Jet<T> {
        let (s, c) = self.value.sin_cos();
        self.chain(s, c, -s)
    }
    fn cos(self) -> Jet<T> {
        let (s, c) = self.value.sin_cos();
        self.chain(c, -s, -c)
    }
    fn tan(self) -> Jet<T> {
        let t = self.apply(Number::tan);
        let slope = T::one() + t * t;
        self.chain(t, slope, T::from_f64(2.0) * t * slope)
    }
    fn asin(self) -> Jet<T> {
        let x = self.value;
        let slope = T::one() / (T::one() - x * x).sqrt();
        self.chain(self.apply(Number::asin), slope, x * slope * slope * slope)
    }
    fn acos(self) -> Jet<T> {
        let x = self.value;
        let slope = -T::one() / (T::one() - x * x).sqrt();
        self.chain(self.apply(Number::acos), slope, x * slope * slope * slope)
    }
    fn atan(self) -> Jet<T> {
        let x = self.value;
        let slope = T::one() / (T::one() + x * x);
        self.chain(self.apply(Number::atan), slope, T::from_f64(-2.0) * x * slope * slope)
    }
    fn atan2(self, x: Jet<T>) -> Jet<T> {
        let y = self;
        let square = x.value * x.value + y.value * y.value;
        let turn = x.value * y.first - y.value * x.first;
        let first = turn / square;
        let rise = x.value * y.second - y.value * x.second;
        let growth = T::from_f64(2.0) * (x.value * x.first + y.value * y.first);
        let angle = T::of(y.value.number().atan2(x.value.number()));
        Jet::new(angle, first, (rise - first * growth) / square)
    }
    fn sqrt(self) -> Jet<T> {
        let root = self.apply(Number::sqrt);
        let slope = T::from_f64(0.5) / root;
        self.chain(root, slope, T::from_f64(-0.5) * slope / self.value)
    }
    fn abs(self) -> Jet<T> {
        if self.value.value() < 0.0 { -self } else { self }
    }
    fn powi(self, n: i32) -> Jet<T> {
        let k = T::from_f64(f64::from(n));
        let power = |by: i32| T::of(self.value.number().powi(n.saturating_sub(by)));
        self.chain(power(0), times(k, power(1)), times(k * (k - T::one()), power(2)))
    }
    fn powf(self, n: Jet<T>) -> Jet<T> {
        if n.is_constant() { self.power(n.value) } else { (n * self.ln()).exp() }
    }
}
