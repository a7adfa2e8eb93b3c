//! From which side a part is looked at: on its broad face, its long side across.

use bellcrank_results::Contour;

use super::vector::{V3, cross, dot, scaled, sub, unit};

/// Right, up and towards the reader, body axes.
pub(crate) type Axes = [V3; 3];

const BODY: Axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
/// Cosine within which a body axis is taken for a principal one.
const NEAR: f32 = 0.94;
/// Parts less slender than this keep the axis of the body across.
const SLENDER: f32 = 1.8;
/// Parts thicker than this have no broad face.
const THICK: f32 = 0.75;

/// The plan of a part: body axes where they fit, else the principal axes of its surface.
pub(crate) fn plan(contour: &Contour) -> Axes {
    let (spread, principal) = eigen(inertia(contour));
    let toward = if spread[2] > THICK * spread[1] { across(snapped(principal[0])) } else { snapped(principal[2]) };
    let right = if spread[0] > SLENDER * spread[1] { snapped(principal[0]) } else { first_other(toward) };
    let right = unit(sub(right, scaled(toward, dot(right, toward))));
    [right, cross(toward, right), toward]
}

/// The plan as seen from a little to the right and above.
pub(crate) fn tilted(plan: &Axes, turn: f32, height: f32) -> Axes {
    let ((st, ct), (sh, ch)) = (turn.sin_cos(), height.sin_cos());
    [[ct, 0.0, -st], [-sh * st, ch, -sh * ct], [ch * st, sh, ch * ct]].map(|row| super::vector::combined(plan, row))
}

/// The body axis nearest to `axis` where it is near, else `axis`; never pointing backwards.
fn snapped(axis: V3) -> V3 {
    let nearest = BODY.into_iter().find(|body| dot(*body, axis).abs() > NEAR);
    let axis = nearest.unwrap_or(axis);
    let strongest = axis.into_iter().fold(0.0_f32, |most, x| if x.abs() > most.abs() + 1e-3 { x } else { most });
    if strongest < 0.0 { scaled(axis, -1.0) } else { axis }
}

/// The last body axis that lies across `long`.
fn across(long: V3) -> V3 {
    let lies = |axis: &&V3| dot(**axis, long).abs() < 0.5;
    let axis = BODY.iter().rev().find(lies).copied().unwrap_or(BODY[2]);
    unit(sub(axis, scaled(long, dot(axis, long))))
}

/// The first body axis that is not `normal`.
fn first_other(normal: V3) -> V3 {
    BODY.into_iter().find(|axis| dot(*axis, normal).abs() < 0.7).unwrap_or(BODY[0])
}

/// Second moments of the surface about its centroid over its area, m²; exact for flat triangles.
fn inertia(contour: &Contour) -> [[f64; 3]; 3] {
    let mut area = 0.0;
    let (mut first, mut second) = ([0.0; 3], [[0.0; 3]; 3]);
    for t in &contour.triangles {
        let corners = t.map(|node| contour.nodes.get(node as usize).copied().unwrap_or_default());
        let [a, b, c] = corners;
        let weight = f64::from(super::vector::length(cross(sub(b, a), sub(c, a)))).max(0.0);
        let sum: [f64; 3] = std::array::from_fn(|k| corners.iter().map(|p| f64::from(p[k])).sum());
        area += weight;
        for i in 0..3 {
            first[i] += weight * sum[i] / 3.0;
            for j in 0..3 {
                let own: f64 = corners.iter().map(|p| f64::from(p[i]) * f64::from(p[j])).sum();
                second[i][j] += weight * (own + sum[i] * sum[j]) / 12.0;
            }
        }
    }
    let middle = first.map(|m| m / area.max(1e-300));
    std::array::from_fn(|i| std::array::from_fn(|j| second[i][j] / area.max(1e-300) - middle[i] * middle[j]))
}

/// Square roots of the eigenvalues of a symmetric matrix, falling, with their vectors (Jacobi).
fn eigen(mut m: [[f64; 3]; 3]) -> ([f32; 3], Axes) {
    let mut v = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate(&mut m, &mut v, p, q);
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| m[*b][*b].total_cmp(&m[*a][*a]));
    let axis = |k: usize| std::array::from_fn(|row| v[row][k] as f32);
    (order.map(|k| m[k][k].max(0.0).sqrt() as f32), order.map(axis))
}

fn rotate(m: &mut [[f64; 3]; 3], v: &mut [[f64; 3]; 3], p: usize, q: usize) {
    if m[p][q].abs() < 1e-300 {
        return;
    }
    let (s, c) = (0.5 * (2.0 * m[p][q]).atan2(m[p][p] - m[q][q])).sin_cos();
    for row in m.iter_mut().chain(v.iter_mut()) {
        (row[p], row[q]) = (c * row[p] + s * row[q], c * row[q] - s * row[p]);
    }
    let (a, b) = (m[p], m[q]);
    for k in 0..3 {
        (m[p][k], m[q][k]) = (c * a[k] + s * b[k], c * b[k] - s * a[k]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The surface of a block with these half sides, along these axes.
    fn block(half: V3, axes: &Axes) -> Contour {
        let corner = |k: u32| {
            let side = |bit: u32, h: f32| if k & bit == 0 { -h } else { h };
            super::super::vector::combined(axes, [side(1, half[0]), side(2, half[1]), side(4, half[2])])
        };
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|f| [[f[0], f[1], f[2]], [f[0], f[2], f[3]]]).collect();
        Contour { nodes: (0..8).map(corner).collect(), triangles, ..Contour::default() }
    }

    fn assert_near(found: &Axes, expected: &Axes) {
        for (a, b) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((a - b).abs() < 1e-4, "{found:?} against {expected:?}");
        }
    }

    #[test]
    fn plates_are_seen_on_their_face() {
        let [x, y, z] = BODY;
        assert_near(&plan(&block([0.3, 0.2, 0.01], &BODY)), &[x, y, z]);
        assert_near(&plan(&block([0.01, 0.1, 0.4], &BODY)), &[z, scaled(y, -1.0), x]);
    }

    #[test]
    fn long_parts_lie_across() {
        let [x, y, z] = BODY;
        assert_near(&plan(&block([0.5, 0.02, 0.02], &BODY)), &[x, y, z]);
        let (s, c) = 0.7_f32.sin_cos();
        let askew = [[c, s, 0.0], [-s, c, 0.0], z];
        assert_near(&plan(&block([0.5, 0.1, 0.02], &askew)), &askew);
    }

    #[test]
    fn tilting_keeps_the_axes_square() {
        let [right, up, back] = tilted(&BODY, 0.5, 0.4);
        assert!(dot(right, up).abs() < 1e-6 && dot(cross(right, up), back) > 0.999_99);
        assert!(back[0] > 0.0 && back[1] > 0.0);
    }
}
