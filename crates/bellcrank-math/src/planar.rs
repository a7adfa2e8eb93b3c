//! The plane: x and y, turning about z.

use crate::{Real, Space, Vector};
use std::marker::PhantomData;

/// The x-y plane with scalar `T`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Planar<T>(PhantomData<T>);

/// (cos, sin) of the turn about z.
#[derive(Clone, Copy, Debug)]
pub struct Turn<T> {
    cos: T,
    sin: T,
}

impl<T: Real> Space for Planar<T> {
    type T = T;
    type With<U: Real> = Planar<U>;
    type Vector = Vector<T, 2>;
    type Angular = Vector<T, 1>;
    type Rotation = Turn<T>;
    type Inertia = Vector<T, 1>;
    const DIM: usize = 2;
    const ANG: usize = 1;
    const SLIDE: usize = 0;

    fn identity() -> Turn<T> {
        Turn { cos: T::one(), sin: T::zero() }
    }
    #[inline(always)]
    fn compose(a: &Turn<T>, b: &Turn<T>) -> Turn<T> {
        Turn { cos: a.cos * b.cos - a.sin * b.sin, sin: a.sin * b.cos + a.cos * b.sin }
    }
    fn transpose(r: &Turn<T>) -> Turn<T> {
        Turn { cos: r.cos, sin: -r.sin }
    }
    #[inline(always)]
    fn rotate(r: &Turn<T>, v: Vector<T, 2>) -> Vector<T, 2> {
        Vector([r.cos * v[0] - r.sin * v[1], r.sin * v[0] + r.cos * v[1]])
    }
    #[inline(always)]
    fn rotate_angular(_: &Turn<T>, w: Vector<T, 1>) -> Vector<T, 1> {
        w
    }
    #[inline(always)]
    fn rotate_back(r: &Turn<T>, v: Vector<T, 2>) -> Vector<T, 2> {
        Vector([r.cos * v[0] + r.sin * v[1], r.cos * v[1] - r.sin * v[0]])
    }
    #[inline(always)]
    fn rotate_angular_back(_: &Turn<T>, w: Vector<T, 1>) -> Vector<T, 1> {
        w
    }
    #[inline(always)]
    fn along_turn(w: Vector<T, 1>) -> T {
        w[0]
    }
    #[inline(always)]
    fn add_along_turn(w: &mut Vector<T, 1>, k: T) {
        w[0] += k;
    }
    #[inline(always)]
    fn cross_turn(_: Vector<T, 1>, _: T) -> Vector<T, 1> {
        Vector([T::zero()])
    }
    #[inline(always)]
    fn turn_cross(k: T, r: Vector<T, 2>) -> Vector<T, 2> {
        Vector([-(k * r[1]), k * r[0]])
    }
    #[inline(always)]
    fn inertia_turn(j: &Vector<T, 1>, k: T) -> Vector<T, 1> {
        *j * k
    }
    #[inline(always)]
    fn column(r: &Turn<T>, i: usize) -> Vector<T, 2> {
        if i == 0 { Vector([r.cos, r.sin]) } else { Vector([-r.sin, r.cos]) }
    }
    #[inline(always)]
    fn turn(r: &Turn<T>, (sin, cos): (T, T)) -> Turn<T> {
        Self::compose(r, &Turn { cos, sin })
    }
    #[inline(always)]
    fn turn_axis(_: &Turn<T>) -> Vector<T, 1> {
        Vector([T::one()])
    }
    #[inline(always)]
    fn slide_axis(r: &Turn<T>) -> Vector<T, 2> {
        Vector([r.cos, r.sin])
    }
    #[inline(always)]
    fn cross(w: Vector<T, 1>, r: Vector<T, 2>) -> Vector<T, 2> {
        Vector([-w[0] * r[1], w[0] * r[0]])
    }
    #[inline(always)]
    fn moment(r: Vector<T, 2>, f: Vector<T, 2>) -> Vector<T, 1> {
        Vector([r[0] * f[1] - r[1] * f[0]])
    }
    #[inline(always)]
    fn cross_angular(_: Vector<T, 1>, _: Vector<T, 1>) -> Vector<T, 1> {
        Vector([T::zero()])
    }
    #[inline(always)]
    fn apply_inertia(j: &Vector<T, 1>, _: &Turn<T>, w: Vector<T, 1>) -> Vector<T, 1> {
        Vector([j[0] * w[0]])
    }
    #[inline(always)]
    fn inertia_times(j: &Vector<T, 1>, w: Vector<T, 1>) -> Vector<T, 1> {
        Vector([j[0] * w[0]])
    }
    #[inline(always)]
    fn add_inertia(a: &Vector<T, 1>, b: &Vector<T, 1>) -> Vector<T, 1> {
        *a + *b
    }
    #[inline(always)]
    fn moved_inertia(m: T, h: Vector<T, 2>, r: Vector<T, 2>) -> Vector<T, 1> {
        Vector([r.dot(h) * T::from_f64(2.0) + m * r.dot(r)])
    }
    fn vector(v: &[T; 3]) -> Vector<T, 2> {
        Vector([v[0], v[1]])
    }
    fn angular(v: &[T; 3]) -> Vector<T, 1> {
        Vector([v[2]])
    }
    fn spread(v: Vector<T, 2>) -> [T; 3] {
        [v[0], v[1], T::zero()]
    }
    fn spread_angular(w: Vector<T, 1>) -> [T; 3] {
        crate::frame::spread_angular(w)
    }
    fn inertia(j: &[[T; 3]; 3]) -> Vector<T, 1> {
        Vector([j[2][2]])
    }
    fn turn_inertia(j: &Vector<T, 1>, _: &Turn<T>) -> Vector<T, 1> {
        *j
    }
    fn from_matrix(r: &[[T; 3]; 3]) -> Turn<T> {
        Turn { cos: r[0][0], sin: r[1][0] }
    }
    fn to_matrix(r: &Turn<T>) -> [[T; 3]; 3] {
        let (o, l) = (T::zero(), T::one());
        [[r.cos, -r.sin, o], [r.sin, r.cos, o], [o, o, l]]
    }
    fn from_quaternion(q: &[T; 4]) -> Turn<T> {
        Self::from_matrix(&crate::matrix_from_quaternion(q))
    }
}
