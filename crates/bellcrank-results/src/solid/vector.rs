//! Vectors and unit quaternions (w, x, y, z), as much as a drawing needs.

use crate::Pose;

pub(crate) type V3 = [f64; 3];

pub(crate) fn add(a: V3, b: V3) -> V3 {
    std::array::from_fn(|k| a[k] + b[k])
}

pub(crate) fn sub(a: V3, b: V3) -> V3 {
    std::array::from_fn(|k| a[k] - b[k])
}

pub(crate) fn scaled(a: V3, s: f64) -> V3 {
    a.map(|x| x * s)
}

/// `a + s·b`.
pub(crate) fn along(a: V3, s: f64, b: V3) -> V3 {
    add(a, scaled(b, s))
}

pub(crate) fn dot(a: V3, b: V3) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

pub(crate) fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn norm(a: V3) -> f64 {
    dot(a, a).sqrt()
}

/// Of length one; `otherwise` where there is no direction.
pub(crate) fn unit(a: V3, otherwise: V3) -> V3 {
    let length = norm(a);
    if length > 1e-12 { scaled(a, 1.0 / length) } else { otherwise }
}

/// A direction of length one perpendicular to the unit vector `a`.
pub(crate) fn perpendicular(a: V3) -> V3 {
    let smallest = (0..3).min_by(|&i, &j| a[i].abs().total_cmp(&a[j].abs())).unwrap_or(0);
    let mut other = [0.0; 3];
    other[smallest] = 1.0;
    unit(cross(a, other), [1.0, 0.0, 0.0])
}

/// `v` turned by the unit quaternion `q`.
pub(crate) fn turned([w, x, y, z]: [f64; 4], v: V3) -> V3 {
    let u = [x, y, z];
    let t = scaled(cross(u, v), 2.0);
    add(along(v, w, t), cross(u, t))
}

/// `v` turned back by the unit quaternion `q`.
pub(crate) fn turned_back([w, x, y, z]: [f64; 4], v: V3) -> V3 {
    turned([w, -x, -y, -z], v)
}

/// A place on a body in the world.
pub(crate) fn place(pose: &Pose, at: V3) -> V3 {
    add(pose.position, turned(pose.quaternion, at))
}
