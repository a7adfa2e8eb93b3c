//! Bodies: flat links in the plane; in space bars along their lines, and plates where joints span a plane.

use super::vector::{V3, along, cross, dot, norm, sub, unit};
use super::{Paint, Plan, Shape, Solid};
use crate::DrawnBody;

/// Thickness of a flat link, and the distance of two layers, by the radius of a bar.
pub(super) const THICK: f64 = 1.1;
pub(super) const STEP: f64 = 1.4;

pub(super) fn parts(plan: &Plan<'_>) -> Vec<Solid> {
    let bodies = plan.drawing.bodies.iter().enumerate().skip(1);
    let of = |(index, body): (usize, &DrawnBody)| match &body.surface {
        Some(surface) => {
            vec![Solid { body: index, shape: Shape::Surface(surface.clone()), paint: Paint::Body }]
        }
        None if plan.planar() => link(plan, index, body),
        None => frame(plan, index, body),
    };
    bodies.flat_map(of).collect()
}

/// Height of a body's layer in the plane, m; 0 in space. Real forms lie where they are, drawn links beside them.
pub(super) fn height(plan: &Plan<'_>, body: usize) -> f64 {
    if !plan.planar() || plan.surface(body).is_some() {
        return 0.0;
    }
    let layer = f64::from(plan.layers.layer(body));
    let room = (plan.scale.thickest - THICK * plan.scale.bar / 2.0).max(0.0);
    layer.signum() * if layer == 0.0 { 0.0 } else { room } + layer * STEP * plan.scale.bar
}

/// Lowest and highest place of a body in the plane, m.
pub(super) fn extent(plan: &Plan<'_>, body: usize) -> [f64; 2] {
    match plan.surface(body) {
        Some(surface) => surface
            .points
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], p| [low.min(p[2]), high.max(p[2])]),
        None => {
            let half = THICK * plan.scale.bar / 2.0;
            [height(plan, body) - half, height(plan, body) + half]
        }
    }
}

/// One plate around the points that have lines.
fn link(plan: &Plan<'_>, index: usize, body: &DrawnBody) -> Vec<Solid> {
    let z = height(plan, index);
    let normal = [0.0, 0.0, 1.0];
    let points: Vec<V3> = lined(body).into_iter().map(|p| [p[0], p[1], z]).collect();
    if points.is_empty() {
        return Vec::new();
    }
    let shape = Shape::Plate {
        points: outline(&points, normal),
        normal,
        radius: plan.scale.radius(index),
        thickness: THICK * plan.scale.bar,
    };
    vec![Solid { body: index, shape, paint: Paint::Body }]
}

/// Points at which a line ends.
fn lined(body: &DrawnBody) -> Vec<V3> {
    let has_line = |(index, _): &(usize, &(String, V3))| body.lines.iter().any(|line| line.contains(index));
    body.points.iter().enumerate().filter(has_line).map(|(_, (_, at))| *at).collect()
}

/// A plate where three joints or more span a plane, and bars along the lines that do not lie in it.
fn frame(plan: &Plan<'_>, index: usize, body: &DrawnBody) -> Vec<Solid> {
    let radius = plan.scale.radius(index);
    let plane = plane(&jointed(plan, index), 0.02 * radius);
    let lies_in = |p: V3| plane.is_some_and(|(origin, normal)| dot(normal, sub(p, origin)).abs() < 0.1 * radius);
    let bar = |(from, to)| Shape::Rod { from, to, radius, round: true };
    let mut shapes: Vec<Shape> = bars(body, lies_in).into_iter().map(bar).collect();
    if let Some((_, normal)) = plane {
        let flat: Vec<V3> = body.points.iter().map(|(_, at)| *at).filter(|at| lies_in(*at)).collect();
        shapes.push(Shape::Plate {
            points: outline(&flat, normal),
            normal,
            radius: 1.6 * radius,
            thickness: 1.2 * radius,
        });
    }
    shapes.extend(plan.block(index).map(|(center, size)| Shape::Block {
        center,
        along: [1.0, 0.0, 0.0],
        across: [0.0, 1.0, 0.0],
        size,
    }));
    shapes.into_iter().map(|shape| Solid { body: index, shape, paint: Paint::Body }).collect()
}

/// The lines that do not lie in the plate; of several from one point to it the shortest.
fn bars(body: &DrawnBody, lies_in: impl Fn(V3) -> bool) -> Vec<(V3, V3)> {
    let place = |index: usize| body.points.get(index).map(|(_, at)| *at);
    let lines = body.lines.iter().filter_map(|[a, b]| Some((place(*a)?, place(*b)?)));
    // Those that end on the plate end there with their second place.
    let lines = lines.map(|(a, b)| if lies_in(a) { (b, a) } else { (a, b) }).filter(|(a, _)| !lies_in(*a));
    let mut sorted: Vec<(V3, V3)> = lines.collect();
    sorted.sort_by(|(a, b), (c, d)| norm(sub(*a, *b)).total_cmp(&norm(sub(*c, *d))));
    let mut standing: Vec<V3> = Vec::new();
    sorted.retain(|(from, to)| {
        let again = lies_in(*to) && standing.contains(from);
        if lies_in(*to) {
            standing.push(*from);
        }
        !again
    });
    sorted
}

/// Different places of a body at which joints are.
fn jointed(plan: &Plan<'_>, index: usize) -> Vec<V3> {
    let mut places: Vec<V3> = Vec::new();
    for (body, at) in plan.drawing.joints.iter().filter(|joint| joint.kind != "free").flat_map(|j| [j.first, j.second])
    {
        if body == index && !places.iter().any(|other| norm(sub(*other, at)) < 1e-6 * plan.scale.bar) {
            places.push(at);
        }
    }
    places
}

/// Origin and normal of the plane in which three places or more lie; nothing where they are on a line or in space.
fn plane(places: &[V3], tolerance: f64) -> Option<(V3, V3)> {
    let origin = *places.first()?;
    let far = places.iter().map(|p| sub(*p, origin)).max_by(|a, b| norm(*a).total_cmp(&norm(*b)))?;
    let normals = places.iter().map(|p| cross(far, sub(*p, origin)));
    let widest = normals.max_by(|a, b| norm(*a).total_cmp(&norm(*b)))?;
    // A narrow triangle is a bent bar.
    if norm(widest) < 0.15 * dot(far, far) {
        return None;
    }
    let normal = unit(widest, [0.0, 0.0, 1.0]);
    places.iter().all(|p| dot(normal, sub(*p, origin)).abs() < tolerance).then_some((origin, normal))
}

/// Convex hull of places in one plane, counter-clockwise about the normal.
fn outline(places: &[V3], normal: V3) -> Vec<V3> {
    let x = super::vector::perpendicular(normal);
    let y = cross(normal, x);
    let flat = |p: &V3| [dot(x, *p), dot(y, *p)];
    let mut sorted: Vec<(V3, [f64; 2])> = places.iter().map(|p| (*p, flat(p))).collect();
    sorted.sort_by(|(_, a), (_, b)| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut outline = half(sorted.iter());
    let back = half(sorted.iter().rev());
    outline.extend(back);
    if outline.is_empty() { places.first().copied().into_iter().collect() } else { outline }
}

/// One side of Andrew's monotone chain, without its last point.
fn half<'a>(points: impl Iterator<Item = &'a (V3, [f64; 2])>) -> Vec<V3> {
    let turn = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let mut chain: Vec<(V3, [f64; 2])> = Vec::new();
    for point in points {
        while chain.len() > 1 && turn(chain[chain.len() - 2].1, chain[chain.len() - 1].1, point.1) <= 0.0 {
            chain.pop();
        }
        chain.push(*point);
    }
    chain.pop();
    chain.into_iter().map(|(place, _)| place).collect()
}

/// A place raised along z, which in the plane is out of it.
pub(super) fn raised(at: V3, z: f64) -> V3 {
    along(at, z, [0.0, 0.0, 1.0])
}
