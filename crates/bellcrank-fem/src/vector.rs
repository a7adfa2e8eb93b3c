//! Three numbers.

pub(crate) type V3 = [f64; 3];

pub(crate) fn add(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scale(a: V3, by: f64) -> V3 {
    [a[0] * by, a[1] * by, a[2] * by]
}

pub(crate) fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn norm(a: V3) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn accumulate(sum: &mut V3, more: V3) {
    *sum = add(*sum, more);
}

/// Solution of a symmetric 3 x 3 system by cofactors; `None` when it is singular to rounding.
pub(crate) fn solve(m: &[V3; 3], b: V3) -> Option<V3> {
    let columns = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
    let determinant = dot(m[0], columns[0]);
    let size = m.iter().map(|row| norm(*row)).fold(0.0, f64::max);
    if determinant.abs() <= 1e-13 * size.powi(3) {
        return None;
    }
    let x: V3 = std::array::from_fn(|i| (0..3).map(|k| columns[k][i] * b[k]).sum::<f64>() / determinant);
    Some(x)
}
