//! A number with its gradient by up to ten variables: exact gradients of the test problems without a slip of the pen.

use std::ops::{Add, Div, Mul, Neg, Sub};

pub(crate) const MOST: usize = 10;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Jet {
    pub(crate) v: f64,
    pub(crate) d: [f64; MOST],
}

impl Jet {
    pub(crate) fn constant(v: f64) -> Self {
        Self { v, d: [0.0; MOST] }
    }

    pub(crate) fn variables(x: &[f64]) -> Vec<Self> {
        let seed = |(i, &v): (usize, &f64)| {
            let mut jet = Self::constant(v);
            jet.d[i] = 1.0;
            jet
        };
        x.iter().enumerate().map(seed).collect()
    }

    fn chain(self, v: f64, slope: f64) -> Self {
        Self { v, d: self.d.map(|d| d * slope) }
    }

    pub(crate) fn powi(self, n: i32) -> Self {
        self.chain(self.v.powi(n), f64::from(n) * self.v.powi(n - 1))
    }

    pub(crate) fn sin(self) -> Self {
        self.chain(self.v.sin(), self.v.cos())
    }

    pub(crate) fn ln(self) -> Self {
        self.chain(self.v.ln(), 1.0 / self.v)
    }

    pub(crate) fn exp(self) -> Self {
        self.chain(self.v.exp(), self.v.exp())
    }
}

fn zip(a: Jet, b: Jet, v: f64, wa: f64, wb: f64) -> Jet {
    Jet { v, d: std::array::from_fn(|i| wa * a.d[i] + wb * b.d[i]) }
}

macro_rules! operator {
    ($trait:ident, $name:ident, $a:ident, $b:ident, $v:expr, $wa:expr, $wb:expr) => {
        impl $trait for Jet {
            type Output = Jet;
            fn $name(self, $b: Jet) -> Jet {
                let $a = self;
                zip($a, $b, $v, $wa, $wb)
            }
        }
        impl $trait<f64> for Jet {
            type Output = Jet;
            fn $name(self, other: f64) -> Jet {
                $trait::$name(self, Jet::constant(other))
            }
        }
        impl $trait<Jet> for f64 {
            type Output = Jet;
            fn $name(self, other: Jet) -> Jet {
                $trait::$name(Jet::constant(self), other)
            }
        }
    };
}

operator!(Add, add, a, b, a.v + b.v, 1.0, 1.0);
operator!(Sub, sub, a, b, a.v - b.v, 1.0, -1.0);
operator!(Mul, mul, a, b, a.v * b.v, b.v, a.v);
operator!(Div, div, a, b, a.v / b.v, 1.0 / b.v, -a.v / (b.v * b.v));

impl Neg for Jet {
    type Output = Jet;
    fn neg(self) -> Jet {
        0.0 - self
    }
}
