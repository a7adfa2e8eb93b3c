//! Triangles drawn up through the layers: wedges, or three tetrahedra each.

use std::collections::HashMap;

use super::curving::Curves;
use super::heights::Levels;
use super::plan::Plan;
use super::plane::Plane;
use crate::{Block, Mesh, Shape};

/// Where a node of the mesh comes from: a point of the plane (twice the same) or the side between two, lower first;
/// and the half level that it is on.
pub(super) type Origin = ([u32; 2], usize);

pub(super) fn extrude(
    plan: &Plan,
    plane: &Plane,
    curves: &Curves,
    levels: &Levels,
    shape: Shape,
) -> (Mesh, Vec<Origin>) {
    let items = Items::of(plane, shape.quadratic());
    let halves = 2 * levels.layers() + 1;
    let mut raw: Vec<usize> = Vec::new();
    for (&triangle, &pattern) in plane.triangles.iter().zip(&plane.patterns) {
        for layer in (0..levels.layers()).filter(|&layer| plan.patterns[pattern][levels.interval[layer]]) {
            let key = |a: (u32, usize), b: (u32, usize)| items.place([a.0, b.0]) * halves + 2 * layer + a.1 + b.1;
            match shape {
                Shape::Tet4 | Shape::Tet10 => {
                    tetrahedra(triangle).iter().for_each(|t| element(shape, t, key, &mut raw))
                }
                _ => element(shape, &wedge(triangle), key, &mut raw),
            }
        }
    }
    let (numbers, used) = compact(&raw, items.sides.len() * halves);
    let origin: Vec<Origin> = used.iter().map(|&key| (items.sides[key / halves], key % halves)).collect();
    let place = |&([a, b], half): &Origin| {
        let [x, y] = if a == b { plane.points[a as usize] } else { curves.middle(plane, [a, b], half) };
        [x, y, levels.half(half)]
    };
    let block = Block { name: String::new(), shape, nodes: raw.iter().map(|&key| numbers[key]).collect() };
    let mesh = Mesh { nodes: origin.iter().map(place).collect(), blocks: vec![block], ..Mesh::default() };
    (mesh, origin)
}

/// Points and sides of the plane in the order that their nodes are numbered in.
struct Items {
    sides: Vec<[u32; 2]>,
    places: HashMap<[u32; 2], usize>,
}

impl Items {
    fn of(plane: &Plane, quadratic: bool) -> Items {
        let mut sides: Vec<[u32; 2]> = (0..plane.points.len() as u32).map(|point| [point, point]).collect();
        if quadratic {
            let all = plane.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
            sides.extend(all.map(|[a, b]| [a.min(b), a.max(b)]));
        }
        sides.sort_unstable_by_key(|&[a, b]| (b, a));
        sides.dedup();
        let places = sides.iter().enumerate().map(|(place, &side)| (side, place)).collect();
        Items { sides, places }
    }

    fn place(&self, [a, b]: [u32; 2]) -> usize {
        self.places[&[a.min(b), a.max(b)]]
    }
}

/// Corners of an element: point of the plane, and 0 at the bottom or 1 at the top of the layer.
type Corner = (u32, usize);

fn wedge([a, b, c]: [u32; 3]) -> [Corner; 6] {
    [(a, 0), (b, 0), (c, 0), (a, 1), (b, 1), (c, 1)]
}

/// The diagonals of the wedge's sides start below at the lower point, so neighbours agree on them.
fn tetrahedra(triangle: [u32; 3]) -> [[Corner; 4]; 3] {
    let [p, q, r] = triangle;
    let lowest = p.min(q).min(r);
    let [p, q, r] = if lowest == p {
        [p, q, r]
    } else if lowest == q {
        [q, r, p]
    } else {
        [r, p, q]
    };
    if q < r {
        let (a, b, c) = (p, q, r);
        [[(a, 0), (b, 0), (c, 0), (c, 1)], [(a, 0), (b, 0), (c, 1), (b, 1)], [(a, 0), (a, 1), (b, 1), (c, 1)]]
    } else {
        // The same with the orientation turned back.
        let (a, b, c) = (p, r, q);
        [[(b, 0), (a, 0), (c, 0), (c, 1)], [(b, 0), (a, 0), (c, 1), (b, 1)], [(a, 1), (a, 0), (b, 1), (c, 1)]]
    }
}

/// Keys of an element's nodes; `key` takes the two ends of an edge, or a corner twice.
fn element(shape: Shape, corners: &[Corner], key: impl Fn(Corner, Corner) -> usize, raw: &mut Vec<usize>) {
    raw.extend(corners.iter().map(|&corner| key(corner, corner)));
    if shape.quadratic() {
        raw.extend(shape.edges().iter().map(|&[a, b]| key(corners[a as usize], corners[b as usize])));
    }
}

/// Number of every key that is used, in ascending order, and the keys by number.
fn compact(raw: &[usize], count: usize) -> (Vec<u32>, Vec<usize>) {
    let mut numbers = vec![u32::MAX; count];
    raw.iter().for_each(|&key| numbers[key] = 0);
    let used: Vec<usize> = (0..count).filter(|&key| numbers[key] == 0).collect();
    used.iter().enumerate().for_each(|(number, &key)| numbers[key] = number as u32);
    (numbers, used)
}
