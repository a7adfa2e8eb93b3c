//! Rotation matrices (rows) in numbers.

use bellcrank_math::{Real, matrix_from_quaternion};

use crate::scalar::length;

/// Rotation matrix, rows.
pub(super) type Matrix<T> = [[T; 3]; 3];

pub(super) fn identity<T: Real>() -> Matrix<T> {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { T::one() } else { T::zero() }))
}

/// Turned by `angle` about `axis`, which has a length but not that of one.
pub(super) fn about<T: Real>(axis: [T; 3], angle: T) -> Matrix<T> {
    let length = length(axis);
    let (s, c) = (angle / T::from_f64(2.0)).sin_cos();
    let [x, y, z] = axis.map(|component| component / length * s);
    matrix_from_quaternion(&[c, x, y, z])
}

/// The rotation of a quaternion (w, x, y, z) of any length but 0.
pub(super) fn from_quaternion<T: Real>(quaternion: [T; 4]) -> Option<Matrix<T>> {
    let square = quaternion.iter().fold(T::zero(), |sum, &x| sum + x * x);
    (square.value() > 0.0).then(|| {
        let length = square.sqrt();
        matrix_from_quaternion(&quaternion.map(|x| x / length))
    })
}

pub(super) fn product<T: Real>(a: &Matrix<T>, b: &Matrix<T>) -> Matrix<T> {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j]))
}

pub(super) fn apply<T: Real>(a: &Matrix<T>, v: [T; 3]) -> [T; 3] {
    a.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}
