//! Vectors in space, single precision: pictures need no more.

pub(crate) type V3 = [f32; 3];

pub(crate) fn add(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scaled(a: V3, by: f32) -> V3 {
    a.map(|x| by * x)
}

pub(crate) fn dot(a: V3, b: V3) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn length(a: V3) -> f32 {
    dot(a, a).sqrt()
}

/// Of length one; zero stays zero.
pub(crate) fn unit(a: V3) -> V3 {
    let length = length(a);
    if length > 0.0 { scaled(a, 1.0 / length) } else { a }
}

/// `a x + b y + c z` of three axes.
pub(crate) fn combined(axes: &[V3; 3], [a, b, c]: V3) -> V3 {
    add(add(scaled(axes[0], a), scaled(axes[1], b)), scaled(axes[2], c))
}

/// Least and largest coordinates of finite places; nothing without any.
pub(crate) fn bounds(places: impl Iterator<Item = V3>) -> Option<(V3, V3)> {
    places.filter(|p| p.iter().all(|x| x.is_finite())).fold(None, |bounds, p| {
        let (low, high) = bounds.unwrap_or((p, p));
        Some((std::array::from_fn(|k| low[k].min(p[k])), std::array::from_fn(|k| high[k].max(p[k]))))
    })
}
