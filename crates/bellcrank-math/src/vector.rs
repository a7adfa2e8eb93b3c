//! Short vectors of scalars.

use crate::Real;
use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub, SubAssign};

/// `N` components along some axes: 2 or 3 for places and forces, 1 or 3 for turning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<T, const N: usize>(pub [T; N]);

impl<T: Real, const N: usize> Vector<T, N> {
    /// All components zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self([T::default(); N])
    }
    /// Unit vector along axis `i`.
    pub fn unit(i: usize) -> Self {
        let mut v = Self::zero();
        v.0[i] = T::one();
        v
    }
    /// Scalar product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> T {
        let mut s = self.0[0] * o.0[0];
        for i in 1..N {
            s += self.0[i] * o.0[i];
        }
        s
    }
    /// Euclidean length.
    pub fn norm(self) -> T {
        self.dot(self).sqrt()
    }
}

impl<T: Real, const N: usize> Default for Vector<T, N> {
    fn default() -> Self {
        Self::zero()
    }
}
// Plain loops over fixed lengths: the closures of `array::map` and `from_fn` are not always inlined.
impl<T: Real, const N: usize> Add for Vector<T, N> {
    type Output = Self;
    #[inline(always)]
    fn add(mut self, o: Self) -> Self {
        for i in 0..N {
            self.0[i] += o.0[i];
        }
        self
    }
}
impl<T: Real, const N: usize> Sub for Vector<T, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(mut self, o: Self) -> Self {
        for i in 0..N {
            self.0[i] -= o.0[i];
        }
        self
    }
}
impl<T: Real, const N: usize> Neg for Vector<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for i in 0..N {
            self.0[i] = -self.0[i];
        }
        self
    }
}
impl<T: Real, const N: usize> Mul<T> for Vector<T, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(mut self, k: T) -> Self {
        for i in 0..N {
            self.0[i] = self.0[i] * k;
        }
        self
    }
}
impl<T: Real, const N: usize> AddAssign for Vector<T, N> {
    #[inline(always)]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<T: Real, const N: usize> SubAssign for Vector<T, N> {
    #[inline(always)]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}
impl<T, const N: usize> Index<usize> for Vector<T, N> {
    type Output = T;
    #[inline(always)]
    fn index(&self, i: usize) -> &T {
        &self.0[i]
    }
}
impl<T, const N: usize> IndexMut<usize> for Vector<T, N> {
    #[inline(always)]
    fn index_mut(&mut self, i: usize) -> &mut T {
        &mut self.0[i]
    }
}
