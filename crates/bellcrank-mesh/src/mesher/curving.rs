//! Mid-side nodes of arcs: on the circle, unless a cusp would fold the triangle.

use std::collections::HashMap;

use bellcrank_solid::Curve;

use super::heights::Levels;
use super::plan::Plan;
use super::plane::Plane;

/// Middles of the sides that lie on arcs.
pub(super) struct Curves {
    /// For the two ends of an arc's segment, lower first: its middle on the arc and how far the mid-side node goes
    /// there from the chord's middle (0 to 1), for each half level.
    arcs: HashMap<(u32, u32), Arc>,
}

struct Arc {
    middle: [f64; 2],
    bulge: Vec<f64>,
}

/// A curved triangle keeps this part of the smallest sine of the straight one, or [`ENOUGH`].
const KEPT: f64 = 0.6;
const ENOUGH: f64 = 0.3;
/// A bulge is tried in quarters.
const BULGES: [f64; 5] = [1.0, 0.75, 0.5, 0.25, 0.0];

impl Curves {
    /// Mid-side node of the side between two points, at a half level.
    pub(super) fn middle(&self, plane: &Plane, [a, b]: [u32; 2], half: usize) -> [f64; 2] {
        let straight = mean(plane.points[a as usize], plane.points[b as usize]);
        let Some(arc) = self.arcs.get(&key([a, b])) else { return straight };
        match arc.bulge[half] {
            1.0 => arc.middle,
            bulge => std::array::from_fn(|i| straight[i] + bulge * (arc.middle[i] - straight[i])),
        }
    }
}

fn mean(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]
}

fn key([a, b]: [u32; 2]) -> (u32, u32) {
    (a.min(b), a.max(b))
}

pub(super) fn mid_sides(plan: &Plan, plane: &Plane, levels: &Levels) -> Curves {
    let mut arcs = HashMap::new();
    let mut movable = HashMap::new();
    for segment in &plane.segments {
        if matches!(plan.edge(segment.edge).curve, Curve::Arc { .. }) {
            let arc = Arc { middle: segment.middle, bulge: vec![1.0; 2 * levels.layers() + 1] };
            arcs.insert(key(segment.ends), arc);
            movable.insert(key(segment.ends), plan.bores[segment.edge].is_none());
        }
    }
    let mut curves = Curves { arcs };
    for (&triangle, &pattern) in plane.triangles.iter().zip(&plane.patterns) {
        let bulge = largest_bulge(&curves, &movable, plane, triangle);
        if bulge == 1.0 {
            continue;
        }
        for layer in (0..levels.layers()).filter(|&layer| plan.patterns[pattern][levels.interval[layer]]) {
            for side in sides(triangle).into_iter().map(key).filter(|side| movable.get(side) == Some(&true)) {
                let Some(arc) = curves.arcs.get_mut(&side) else { continue };
                arc.bulge[2 * layer..=2 * layer + 2].iter_mut().for_each(|b| *b = b.min(bulge));
            }
        }
    }
    curves
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

fn largest_bulge(curves: &Curves, movable: &HashMap<(u32, u32), bool>, plane: &Plane, triangle: [u32; 3]) -> f64 {
    if !sides(triangle).into_iter().any(|side| movable.get(&key(side)) == Some(&true)) {
        return 1.0;
    }
    let corners = triangle.map(|corner| plane.points[corner as usize]);
    let middles = |bulge: f64| {
        sides(triangle).map(|[a, b]| {
            let straight = mean(plane.points[a as usize], plane.points[b as usize]);
            match curves.arcs.get(&key([a, b])) {
                None => straight,
                Some(arc) => {
                    let bulge = if movable[&key([a, b])] { bulge } else { 1.0 };
                    std::array::from_fn(|i| straight[i] + bulge * (arc.middle[i] - straight[i]))
                }
            }
        })
    };
    let goal = (KEPT * smallest_sine(corners, middles(0.0))).min(ENOUGH);
    let good = BULGES.into_iter().find(|&bulge| smallest_sine(corners, middles(bulge)) >= goal);
    good.unwrap_or(0.0)
}

/// Smallest sine between the two sides at a corner of a triangle with curved sides; negative where it is folded.
fn smallest_sine(corners: [[f64; 2]; 3], middles: [[f64; 2]; 3]) -> f64 {
    let tangent = |from: usize, to: usize, middle: [f64; 2]| -> [f64; 2] {
        std::array::from_fn(|i| 4.0 * middle[i] - 3.0 * corners[from][i] - corners[to][i])
    };
    let sine = |k: usize| {
        let (next, last) = ((k + 1) % 3, (k + 2) % 3);
        let (u, v) = (tangent(k, next, middles[k]), tangent(k, last, middles[last]));
        (u[0] * v[1] - u[1] * v[0]) / (u[0].hypot(u[1]) * v[0].hypot(v[1]))
    };
    (0..3).map(sine).fold(f64::INFINITY, f64::min)
}
