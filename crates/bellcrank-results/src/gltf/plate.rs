//! Flat links as triangles: the outline that a disc leaves around a convex polygon, twice, and the rim between.

use super::mesh::{AROUND, Mesh, direction, frame};
use crate::solid::vector::{V3, along, dot, sub};

/// Adds a plate; `points` are counter-clockwise about `normal`.
pub(super) fn push(mesh: &mut Mesh, points: &[V3], normal: V3, radius: f64, thickness: f64) {
    let rim = rim(points, normal, radius);
    if rim.len() < 3 {
        return;
    }
    let side = |s: f64| rim.iter().map(|(at, _)| along(*at, s * thickness / 2.0, normal)).collect::<Vec<V3>>();
    let (top, bottom) = (side(1.0), side(-1.0));
    mesh.push_convex(&top, normal);
    let reversed: Vec<V3> = bottom.iter().rev().copied().collect();
    mesh.push_convex(&reversed, normal.map(|x| -x));
    let start = mesh.positions.len() as u32;
    for ((high, low), (_, out)) in top.iter().zip(&bottom).zip(&rim) {
        mesh.vertex(*high, *out);
        mesh.vertex(*low, *out);
    }
    let count = rim.len() as u32;
    for k in 0..count {
        let (a, b) = (start + 2 * k, start + 2 * ((k + 1) % count));
        mesh.triangle(a, a + 1, b + 1);
        mesh.triangle(a, b + 1, b);
    }
}

/// Places of the outline and their outward directions: an arc around every corner.
fn rim(points: &[V3], normal: V3, radius: f64) -> Vec<(V3, V3)> {
    let (x, y) = frame(normal);
    let count = points.len();
    // Outward direction of the edge that leaves corner k, in turns from x.
    let outward = |k: usize| {
        let edge = sub(points[(k + 1) % count], points[k % count]);
        (dot(edge, y).atan2(dot(edge, x)) / std::f64::consts::TAU) - 0.25
    };
    let mut rim = Vec::new();
    for (k, corner) in points.iter().enumerate() {
        let (from, turn) = match count {
            1 => (0.0, 1.0),
            _ => {
                let from = outward(k + count - 1);
                (from, (outward(k) - from).rem_euclid(1.0))
            }
        };
        let steps = (turn * f64::from(AROUND)).ceil().max(1.0) as u32;
        // A full turn ends where it began.
        for step in 0..=steps - u32::from(count == 1) {
            let out = direction(x, y, from + turn * f64::from(step) / f64::from(steps));
            rim.push((along(*corner, radius, out), out));
        }
    }
    rim
}
