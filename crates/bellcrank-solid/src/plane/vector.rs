//! Vectors in plan.

use bellcrank_math::Real;

/// A place or a direction in plan.
pub(crate) type Point<T> = [T; 2];

pub(crate) fn add<T: Real>(a: Point<T>, b: Point<T>) -> Point<T> {
    [a[0] + b[0], a[1] + b[1]]
}

pub(crate) fn sub<T: Real>(a: Point<T>, b: Point<T>) -> Point<T> {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn scale<T: Real>(a: Point<T>, s: T) -> Point<T> {
    [a[0] * s, a[1] * s]
}

pub(crate) fn dot<T: Real>(a: Point<T>, b: Point<T>) -> T {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn cross<T: Real>(a: Point<T>, b: Point<T>) -> T {
    a[0] * b[1] - a[1] * b[0]
}

pub(crate) fn norm<T: Real>(a: Point<T>) -> T {
    dot(a, a).sqrt()
}

pub(crate) fn unit<T: Real>(a: Point<T>) -> Point<T> {
    scale(a, T::one() / norm(a))
}

/// A quarter turn counter-clockwise.
pub(crate) fn left<T: Real>(a: Point<T>) -> Point<T> {
    [-a[1], a[0]]
}

pub(crate) fn distance(a: Point<f64>, b: Point<f64>) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The numbers without their derivatives.
pub(crate) fn values<T: Real>(a: Point<T>) -> Point<f64> {
    a.map(T::value)
}

/// Constants with these values.
pub(crate) fn constant<T: Real>(a: Point<f64>) -> Point<T> {
    a.map(T::from_f64)
}

/// The angle in (-pi, pi] that differs from this one by whole turns.
pub(crate) fn wrap(angle: f64) -> f64 {
    angle.sin().atan2(angle.cos())
}
