//! Sizes that elements should have, from how wrong the stress in them is.

use bellcrank_mesh::{Mesh, Shape};

use crate::Stress;
use crate::vector::{self, V3};

/// By how much one refinement changes a size at most: smaller, larger.
const LIMITS: [f64; 2] = [0.25, 1.5];

/// Size of each element, block by block: the mean length of its edges, of a wedge of those of its triangles, m.
pub fn element_sizes(mesh: &Mesh) -> Vec<f64> {
    let mut sizes = Vec::with_capacity(mesh.element_count());
    for block in &mesh.blocks {
        let edges = match block.shape {
            Shape::Wedge6 | Shape::Wedge15 => &block.shape.edges()[..6],
            _ => block.shape.edges(),
        };
        for element in block.elements() {
            let length = |[a, b]: [u8; 2]| {
                let [a, b] = [a, b].map(|corner| mesh.nodes[element[corner as usize] as usize]);
                vector::norm(vector::sub(a, b))
            };
            sizes.push(edges.iter().map(|&edge| length(edge)).sum::<f64>() / edges.len() as f64);
        }
    }
    sizes
}

/// The largest estimated error of the stress in each element, block by block, Pa.
pub fn element_stress_errors(mesh: &Mesh, stress: &Stress) -> Vec<f64> {
    let elements = mesh.blocks.iter().flat_map(|block| block.elements());
    elements.map(|nodes| nodes.iter().map(|&node| stress.spread[node as usize]).fold(0.0, f64::max)).collect()
}

/// Sizes with which the errors would become what is allowed where they fall as h^order:
/// h (allowed / error)^(1 / order), at least a quarter of the present size and at most half as much again.
pub fn wanted_sizes(sizes: &[f64], errors: &[f64], allowed: &[f64], order: f64) -> Vec<f64> {
    let wanted = |((size, error), allowed): ((&f64, &f64), &f64)| {
        let ratio = if *error > 0.0 { (allowed / error).powf(1.0 / order) } else { LIMITS[1] };
        size * ratio.clamp(LIMITS[0], LIMITS[1])
    };
    sizes.iter().zip(errors).zip(allowed).map(wanted).collect()
}

/// A size by place: that of the nearest element.
#[derive(Clone, Debug, Default)]
pub struct SizeField {
    /// Centres and sizes, as a balanced tree: the middle of each range splits it along an axis in turn.
    points: Vec<(V3, f64)>,
}

impl SizeField {
    /// Sizes of the elements of a mesh, block by block, m.
    pub fn new(mesh: &Mesh, sizes: &[f64]) -> Self {
        let mut points = Vec::with_capacity(sizes.len());
        for block in &mesh.blocks {
            for element in block.elements() {
                let corners = &element[..block.shape.corners()];
                let sum = corners.iter().fold([0.0; 3], |sum, &node| vector::add(sum, mesh.nodes[node as usize]));
                points.push((vector::scale(sum, 1.0 / corners.len() as f64), sizes[points.len()]));
            }
        }
        Self::of_points(points)
    }

    /// Sizes at places, m.
    pub fn of_points(mut points: Vec<(V3, f64)>) -> Self {
        split(&mut points, 0);
        Self { points }
    }

    /// The size at the nearest place; infinite where there is none.
    pub fn at(&self, place: V3) -> f64 {
        self.nearest(place).map_or(f64::INFINITY, |(_, size)| size)
    }

    /// The nearest place and its size.
    pub fn nearest(&self, place: V3) -> Option<(V3, f64)> {
        let mut best = (f64::INFINITY, None);
        search(&self.points, 0, place, &mut best);
        best.1
    }
}

fn split(points: &mut [(V3, f64)], axis: usize) {
    if points.len() < 2 {
        return;
    }
    let middle = points.len() / 2;
    points.select_nth_unstable_by(middle, |a, b| a.0[axis].total_cmp(&b.0[axis]));
    let (low, high) = points.split_at_mut(middle);
    split(low, (axis + 1) % 3);
    split(&mut high[1..], (axis + 1) % 3);
}

fn search(points: &[(V3, f64)], axis: usize, place: V3, best: &mut (f64, Option<(V3, f64)>)) {
    let middle = points.len() / 2;
    let Some(&(at, size)) = points.get(middle) else { return };
    let apart = vector::sub(at, place);
    let square = vector::dot(apart, apart);
    if square < best.0 {
        *best = (square, Some((at, size)));
    }
    let next = (axis + 1) % 3;
    let (near, far) = match place[axis] < at[axis] {
        true => (&points[..middle], &points[middle + 1..]),
        false => (&points[middle + 1..], &points[..middle]),
    };
    search(near, next, place, best);
    if apart[axis] * apart[axis] < best.0 {
        search(far, next, place, best);
    }
}

#[cfg(test)]
mod tests {
    use super::{SizeField, wanted_sizes};

    #[test]
    fn sizes_follow_the_order_within_limits() {
        let wanted = wanted_sizes(&[1.0, 1.0, 1.0, 2.0], &[4.0, 1000.0, 0.0, 1.0], &[1.0; 4], 2.0);
        assert_eq!(wanted, [0.5, 0.25, 1.5, 2.0]);
    }

    #[test]
    fn the_nearest_is_that_of_a_search_of_all() {
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let points: Vec<([f64; 3], f64)> = (0..300)
            .map(|k| ([random(), 0.1 * random(), if k % 3 == 0 { 0.0 } else { random() }], f64::from(k)))
            .collect();
        let field = SizeField::of_points(points.clone());
        for _ in 0..200 {
            let place = [2.0 * random() - 0.5, random(), random()];
            let square = |at: &[f64; 3]| (0..3).map(|i| (at[i] - place[i]).powi(2)).sum::<f64>();
            let nearest = points.iter().min_by(|a, b| square(&a.0).total_cmp(&square(&b.0)));
            assert_eq!(Some(field.at(place)), nearest.map(|point| point.1));
        }
        assert!(SizeField::default().at([0.0; 3]).is_infinite());
    }
}
