//! Rotation matrices (rows) in plain numbers.

use bellcrank_math::{matrix_from_quaternion, matrix_from_rpy};

/// Rotation matrix, rows.
pub(super) type Matrix = [[f64; 3]; 3];

pub(super) const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Turned by `angle` about `axis`, which has a length but not that of one.
pub(super) fn about(axis: [f64; 3], angle: f64) -> Matrix {
    let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (s, c) = (angle / 2.0).sin_cos();
    let [x, y, z] = axis.map(|component| component / length * s);
    matrix_from_quaternion(&[c, x, y, z])
}

/// The rotation of a quaternion (w, x, y, z) of any length but 0.
pub(super) fn from_quaternion(quaternion: [f64; 4]) -> Option<Matrix> {
    let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
    (length > 0.0).then(|| matrix_from_quaternion(&quaternion.map(|x| x / length)))
}

/// R = Rz(yaw) Ry(pitch) Rx(roll).
pub(super) fn from_rpy(rpy: [f64; 3]) -> Matrix {
    matrix_from_rpy(&rpy)
}

pub(super) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(super) fn apply(a: &Matrix, v: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|k| a[i][k] * v[k]).sum())
}
