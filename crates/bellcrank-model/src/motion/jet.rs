//! Numbers that carry their first and second derivative along.

use std::ops::{Add, Div, Mul, Neg, Sub};

use bellcrank_doc::Number;

/// f, f′ and f″ at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Jet {
    pub(crate) value: f64,
    pub(crate) first: f64,
    pub(crate) second: f64,
}

impl Jet {
    pub(crate) const fn new(value: f64, first: f64, second: f64) -> Jet {
        Jet { value, first, second }
    }

    /// The variable itself.
    pub(crate) const fn variable(value: f64) -> Jet {
        Jet::new(value, 1.0, 0.0)
    }

    /// f(self), given f, f′ and f″ there.
    fn chain(self, f: f64, slope: f64, bend: f64) -> Jet {
        Jet::new(f, slope * self.first, bend * self.first * self.first + slope * self.second)
    }

    fn is_constant(self) -> bool {
        self.first == 0.0 && self.second == 0.0
    }

    fn exp(self) -> Jet {
        let e = self.value.exp();
        self.chain(e, e, e)
    }

    fn ln(self) -> Jet {
        let x = self.value;
        self.chain(x.ln(), 1.0 / x, -1.0 / (x * x))
    }

    /// x^n for a constant n; terms that vanish do so even where a negative power of 0 stands beside them.
    fn power(self, n: f64) -> Jet {
        let x = self.value;
        let term = |factor: f64, exponent: f64| if factor == 0.0 { 0.0 } else { factor * x.powf(exponent) };
        self.chain(x.powf(n), term(n, n - 1.0), term(n * (n - 1.0), n - 2.0))
    }
}

impl From<f64> for Jet {
    fn from(value: f64) -> Jet {
        Jet::new(value, 0.0, 0.0)
    }
}

impl Add for Jet {
    type Output = Jet;
    fn add(self, o: Jet) -> Jet {
        Jet::new(self.value + o.value, self.first + o.first, self.second + o.second)
    }
}

impl Sub for Jet {
    type Output = Jet;
    fn sub(self, o: Jet) -> Jet {
        self + -o
    }
}

impl Mul for Jet {
    type Output = Jet;
    fn mul(self, o: Jet) -> Jet {
        Jet::new(
            self.value * o.value,
            self.first * o.value + self.value * o.first,
            self.second * o.value + 2.0 * self.first * o.first + self.value * o.second,
        )
    }
}

impl Div for Jet {
    type Output = Jet;
    fn div(self, o: Jet) -> Jet {
        let value = self.value / o.value;
        let first = (self.first - value * o.first) / o.value;
        let second = (self.second - 2.0 * first * o.first - value * o.second) / o.value;
        Jet::new(value, first, second)
    }
}

impl Neg for Jet {
    type Output = Jet;
    fn neg(self) -> Jet {
        Jet::new(-self.value, -self.first, -self.second)
    }
}

impl Number for Jet {
    fn value(self) -> f64 {
        self.value
    }
    fn sin(self) -> Jet {
        let (s, c) = self.value.sin_cos();
        self.chain(s, c, -s)
    }
    fn cos(self) -> Jet {
        let (s, c) = self.value.sin_cos();
        self.chain(c, -s, -c)
    }
    fn tan(self) -> Jet {
        let t = self.value.tan();
        let slope = 1.0 + t * t;
        self.chain(t, slope, 2.0 * t * slope)
    }
    fn asin(self) -> Jet {
        let x = self.value;
        let slope = 1.0 / (1.0 - x * x).sqrt();
        self.chain(x.asin(), slope, x * slope.powi(3))
    }
    fn acos(self) -> Jet {
        let x = self.value;
        let slope = -1.0 / (1.0 - x * x).sqrt();
        self.chain(x.acos(), slope, x * slope.powi(3))
    }
    fn atan(self) -> Jet {
        let x = self.value;
        let slope = 1.0 / (1.0 + x * x);
        self.chain(x.atan(), slope, -2.0 * x * slope * slope)
    }
    fn atan2(self, x: Jet) -> Jet {
        let y = self;
        let square = x.value * x.value + y.value * y.value;
        let turn = x.value * y.first - y.value * x.first;
        let first = turn / square;
        let rise = x.value * y.second - y.value * x.second;
        let growth = 2.0 * (x.value * x.first + y.value * y.first);
        Jet::new(y.value.atan2(x.value), first, (rise - first * growth) / square)
    }
    fn sqrt(self) -> Jet {
        let root = self.value.sqrt();
        let slope = 0.5 / root;
        self.chain(root, slope, -0.5 * slope / self.value)
    }
    fn abs(self) -> Jet {
        if self.value < 0.0 { -self } else { self }
    }
    fn powi(self, n: i32) -> Jet {
        let x = self.value;
        let term = |factor: f64, exponent: i32| if factor == 0.0 { 0.0 } else { factor * x.powi(exponent) };
        let n_f = f64::from(n);
        let lower = |by: i32| n.saturating_sub(by);
        self.chain(x.powi(n), term(n_f, lower(1)), term(n_f * (n_f - 1.0), lower(2)))
    }
    fn powf(self, n: Jet) -> Jet {
        if n.is_constant() { self.power(n.value) } else { (n * self.ln()).exp() }
    }
}
