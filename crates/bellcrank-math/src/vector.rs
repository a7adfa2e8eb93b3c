//! Short vectors of scalars.

use crate::Real;
use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub, SubAssign};

/// `N` components along some axes: 2 or 3 for places and forces, 1 or 3 for turning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector<T, const N: usize>(pub [T; N]);

impl<T: Real, const N: usize> Vector<T, N> {
    /// All components zero.
    #[inline]
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
    #[inline]
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
impl<T: Real, const N: usize> Add for Vector<T, N> {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + o.0[i]))
    }
}
impl<T: Real, const N: usize> Sub for Vector<T, N> {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] - o.0[i]))
    }
}
impl<T: Real, const N: usize> Neg for Vector<T, N> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}
impl<T: Real, const N: usize> Mul<T> for Vector<T, N> {
    type Output = Self;
    #[inline]
    fn mul(self, k: T) -> Self {
        Self(self.0.map(|x| x * k))
    }
}
impl<T: Real, const N: usize> AddAssign for Vector<T, N> {
    #[inline]
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}
impl<T: Real, const N: usize> SubAssign for Vector<T, N> {
    #[inline]
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}
impl<T, const N: usize> Index<usize> for Vector<T, N> {
    type Output = T;
    #[inline]
    fn index(&self, i: usize) -> &T {
        &self.0[i]
    }
}
impl<T, const N: usize> IndexMut<usize> for Vector<T, N> {
    #[inline]
    fn index_mut(&mut self, i: usize) -> &mut T {
        &mut self.0[i]
    }
}
