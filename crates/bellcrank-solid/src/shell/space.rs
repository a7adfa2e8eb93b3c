//! Vectors in space.

pub(crate) type Place = [f64; 3];

pub(crate) fn add(a: Place, b: Place) -> Place {
    std::array::from_fn(|k| a[k] + b[k])
}

pub(crate) fn sub(a: Place, b: Place) -> Place {
    std::array::from_fn(|k| a[k] - b[k])
}

pub(crate) fn scale(a: Place, s: f64) -> Place {
    a.map(|x| x * s)
}

pub(crate) fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Place, b: Place) -> Place {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn norm(a: Place) -> f64 {
    dot(a, a).sqrt()
}

/// The vector of length one in this direction; itself when it has no length.
pub(crate) fn unit(a: Place) -> Place {
    let length = norm(a);
    if length > 0.0 { scale(a, 1.0 / length) } else { a }
}

/// What is left of a vector across a direction of length one.
pub(crate) fn across(a: Place, axis: Place) -> Place {
    sub(a, scale(axis, dot(a, axis)))
}

/// A direction across one of length one.
pub(crate) fn any_across(axis: Place) -> Place {
    let least = (0..3).min_by(|i, j| axis[*i].abs().total_cmp(&axis[*j].abs())).unwrap_or(0);
    let mut along = [0.0; 3];
    along[least] = 1.0;
    unit(across(along, axis))
}
