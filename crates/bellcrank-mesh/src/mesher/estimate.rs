//! How many nodes a mesh will have, before anything is made.

use super::MesherError;
use super::field::Field;
use super::heights::Levels;
use super::outline::{self, Outline};
use super::plan::Plan;
use crate::Shape;

/// Refuses when the divided edges alone have more points than the mesh may have nodes.
pub(super) fn check_outline(plan: &Plan, field: &Field, limit: usize) -> Result<(), MesherError> {
    let estimate: usize = (0..plan.edges.len()).map(|edge| outline::pieces(plan, field, edge)).sum();
    if estimate > limit { Err(MesherError::TooLarge { estimate, limit }) } else { Ok(()) }
}

/// Refuses when the mesh would have more than `limit` nodes. The count is good to about a tenth.
pub(super) fn check(
    plan: &Plan,
    outline: &Outline,
    field: &Field,
    levels: &Levels,
    shape: Shape,
    limit: usize,
) -> Result<(), MesherError> {
    let plane = super::plane::coarse(plan, outline)?;
    let mut estimate = 0.0;
    for (corners, &pattern) in plane.triangles.iter().zip(&plane.patterns) {
        let layers = levels.interval.iter().filter(|&&interval| plan.patterns[pattern][interval]).count();
        let places = corners.map(|corner| plane.points[corner as usize]);
        estimate += triangles(places, field, 0) * nodes_a_triangle(shape, layers as f64);
    }
    let estimate = estimate.ceil() as usize;
    if estimate > limit { Err(MesherError::TooLarge { estimate, limit }) } else { Ok(()) }
}

/// Nodes by triangle of a large mesh: half a corner and one and a half sides each.
fn nodes_a_triangle(shape: Shape, layers: f64) -> f64 {
    match shape {
        Shape::Wedge15 => 2.0 * (layers + 1.0) + 0.5 * layers,
        Shape::Tet10 => 2.0 * (2.0 * layers + 1.0),
        _ => 0.5 * (layers + 1.0),
    }
}

/// Triangles of the wanted size in a triangle: its area by the area that is usual for the size. At least one half
/// of what is there.
fn triangles(places: [[f64; 2]; 3], field: &Field, depth: u32) -> f64 {
    let area = super::smoothing::area(places);
    let [a, b, c] = places;
    let middle = |a: [f64; 2], b: [f64; 2]| [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
    let sizes = [a, b, c, ab, bc, ca].map(|at| field.at(at));
    let (least, most) = sizes.iter().fold((f64::INFINITY, 0.0_f64), |(l, m), &s| (l.min(s), m.max(s)));
    if depth < 8 && most > 1.4 * least && area > least * least {
        let parts = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
        return parts.into_iter().map(|part| triangles(part, field, depth + 1)).sum();
    }
    let mean = sizes.iter().map(|size| size.powi(-2)).sum::<f64>() / 6.0;
    let floor = if depth == 0 { 1.0 } else { 0.0 };
    (area * mean / 0.46).max(floor)
}
