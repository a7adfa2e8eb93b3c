//! Superconvergent patch recovery: a polynomial through the stresses of the elements round each corner node.

use bellcrank_mesh::{Block, Shape};

use crate::element::Geometry;
use crate::material::Six;
use crate::vector::V3;
use crate::{Part, Solution, stress};

/// Smoothed stress at each node; nodes between materials get the mean of the sides.
pub(crate) fn nodal(part: &Part<'_>, solution: &Solution) -> Vec<Six> {
    let count = part.mesh.nodes.len();
    let (mut sums, mut weights) = (vec![[0.0; 6]; count], vec![0.0; count]);
    for (index, block) in part.mesh.blocks.iter().enumerate() {
        let patches = Patches::new(part, solution, index);
        patches.recover(part, block, |node, stress| {
            (0..6).for_each(|i| sums[node][i] += stress[i]);
            weights[node] += 1.0;
        });
    }
    for (sum, weight) in sums.iter_mut().zip(weights) {
        if weight > 0.0 {
            sum.iter_mut().for_each(|s| *s /= weight);
        }
    }
    sums
}

/// Where stresses of an element are most accurate: the points of the rule one lower than the full one (Barlow).
fn sampling(shape: Shape) -> &'static [bellcrank_mesh::Point] {
    match shape {
        Shape::Tet4 | Shape::Tet10 => shape.stiffness_points(),
        Shape::Wedge6 => Shape::Wedge6.stiffness_points(),
        Shape::Wedge15 => Shape::Wedge6.mass_points(),
        Shape::Hex8 | Shape::Hex20 => Shape::Hex8.stiffness_points(),
    }
}

/// Stresses sampled in the elements of a block, and the elements of each corner node.
struct Patches {
    per_element: usize,
    places: Vec<V3>,
    stresses: Vec<Six>,
    starts: Vec<u32>,
    elements: Vec<u32>,
    terms: usize,
}

impl Patches {
    fn new(part: &Part<'_>, solution: &Solution, index: usize) -> Self {
        let block = &part.mesh.blocks[index];
        let points = sampling(block.shape);
        let (mut places, mut stresses) = (Vec::new(), Vec::new());
        let mut geometry = Geometry::default();
        for element in block.elements() {
            geometry.set(block.shape, element, &part.mesh.nodes);
            for point in points {
                geometry.at(point);
                places.push(geometry.place());
                stresses.push(stress::evaluate(part, solution, &geometry, index, element));
            }
        }
        let (starts, elements) = touching(block, part.mesh.nodes.len());
        let terms = if block.shape.quadratic() { 10 } else { 4 };
        Self { per_element: points.len(), places, stresses, starts, elements, terms }
    }

    fn of(&self, node: u32) -> &[u32] {
        &self.elements[self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize]
    }

    fn recover(&self, part: &Part<'_>, block: &Block, mut give: impl FnMut(usize, Six)) {
        let nodes = &part.mesh.nodes;
        let corners = block.shape.corners();
        let (mut sums, mut weights) = (vec![[0.0; 6]; nodes.len()], vec![0.0; nodes.len()]);
        let mut work = Work::default();
        for node in (0..nodes.len() as u32).filter(|&node| !self.of(node).is_empty()) {
            self.gather(block, node, &mut work);
            let fit = Fit::new(self, nodes[node as usize], &work.elements);
            let mut add = |at: u32| {
                let stress = fit.at(nodes[at as usize]);
                (0..6).for_each(|i| sums[at as usize][i] += stress[i]);
                weights[at as usize] += 1.0;
            };
            add(node);
            work.mid_sides.clear();
            for &element in self.of(node) {
                let element = block.element(element as usize);
                for (k, ends) in block.shape.edges().iter().enumerate() {
                    if block.shape.quadratic() && ends.iter().any(|&end| element[end as usize] == node) {
                        work.mid_sides.push(element[corners + k]);
                    }
                }
            }
            work.mid_sides.sort_unstable();
            work.mid_sides.dedup();
            work.mid_sides.iter().for_each(|&at| add(at));
        }
        for (node, (sum, weight)) in sums.into_iter().zip(weights).enumerate() {
            if weight > 0.0 {
                give(node, sum.map(|s| s / weight));
            }
        }
    }

    /// The elements round a node; more rings where there are too few samples for a linear field.
    fn gather(&self, block: &Block, node: u32, work: &mut Work) {
        work.elements.clear();
        work.elements.extend_from_slice(self.of(node));
        let mut rings = 0;
        while work.elements.len() * self.per_element < FEWEST_SAMPLES && rings < 2 {
            let corners: Vec<u32> = work
                .elements
                .iter()
                .flat_map(|&element| block.element(element as usize)[..block.shape.corners()].iter().copied())
                .collect();
            corners.iter().for_each(|&corner| work.elements.extend_from_slice(self.of(corner)));
            work.elements.sort_unstable();
            work.elements.dedup();
            rings += 1;
        }
    }
}

#[derive(Default)]
struct Work {
    elements: Vec<u32>,
    mid_sides: Vec<u32>,
}

/// Elements of each corner node of a block.
fn touching(block: &Block, nodes: usize) -> (Vec<u32>, Vec<u32>) {
    let corners = block.shape.corners();
    let mut starts = vec![0_u32; nodes + 1];
    for element in block.elements() {
        element[..corners].iter().for_each(|&node| starts[node as usize + 1] += 1);
    }
    for node in 0..nodes {
        starts[node + 1] += starts[node];
    }
    let mut fill = starts.clone();
    let mut elements = vec![0; starts[nodes] as usize];
    for (index, element) in block.elements().enumerate() {
        for &node in &element[..corners] {
            elements[fill[node as usize] as usize] = index as u32;
            fill[node as usize] += 1;
        }
    }
    (starts, elements)
}

const MOST_TERMS: usize = 10;

/// One hexahedron's samples: at a corner of the part their trilinear field is better than a wide patch's parabola.
const FEWEST_SAMPLES: usize = 8;

/// What a term must have of its own beside those before it: a curved row of samples tells x² from the others by its
/// sagitta alone, and such a fit is useless outside the samples. Found on Lamé's cylinder and the rotating
/// disc: 3e-2 serves all shapes, 1e-8 gives ten times the error.
const LEAST_PIVOT: f64 = 3e-2;

/// Polynomials of the six components about a node, in coordinates scaled by the patch.
struct Fit {
    origin: V3,
    scale: V3,
    terms: usize,
    coefficients: [Six; MOST_TERMS],
}

impl Fit {
    fn new(patches: &Patches, origin: V3, elements: &[u32]) -> Self {
        let terms = patches.terms;
        let samples = || {
            let of = move |&element: &u32| {
                let first = element as usize * patches.per_element;
                first..first + patches.per_element
            };
            elements.iter().flat_map(of)
        };
        let mut reach: V3 = [0.0; 3];
        for sample in samples() {
            (0..3).for_each(|i| reach[i] = reach[i].max((patches.places[sample][i] - origin[i]).abs()));
        }
        let scale = reach.map(|reach| if reach > 0.0 { 1.0 / reach } else { 0.0 });
        let mut fit = Self { origin, scale, terms, coefficients: [[0.0; 6]; MOST_TERMS] };
        let mut normal = [[0.0; MOST_TERMS]; MOST_TERMS];
        let mut rhs = [[0.0; 6]; MOST_TERMS];
        for sample in samples() {
            let basis = fit.basis(patches.places[sample]);
            for i in 0..terms {
                (0..=i).for_each(|j| normal[i][j] += basis[i] * basis[j]);
                (0..6).for_each(|c| rhs[i][c] += basis[i] * patches.stresses[sample][c]);
            }
        }
        fit.solve(&mut normal, rhs);
        fit
    }

    fn basis(&self, at: V3) -> [f64; MOST_TERMS] {
        let [x, y, z]: V3 = std::array::from_fn(|i| (at[i] - self.origin[i]) * self.scale[i]);
        [1.0, x, y, z, x * y, y * z, z * x, x * x, y * y, z * z]
    }

    fn at(&self, at: V3) -> Six {
        let basis = self.basis(at);
        std::array::from_fn(|c| (0..self.terms).map(|i| basis[i] * self.coefficients[i][c]).sum())
    }

    /// Cholesky on the normal equations, in the order of the basis; a term that the samples do not tell from those
    /// before it is left out.
    fn solve(&mut self, a: &mut [[f64; MOST_TERMS]; MOST_TERMS], mut rhs: [Six; MOST_TERMS]) {
        let terms = self.terms;
        let mut kept = [true; MOST_TERMS];
        for j in 0..terms {
            let before = a[j][j];
            let pivot = before - (0..j).filter(|&k| kept[k]).map(|k| a[j][k] * a[j][k]).sum::<f64>();
            kept[j] = pivot > LEAST_PIVOT * before;
            if !kept[j] {
                continue;
            }
            a[j][j] = pivot.sqrt();
            for i in j + 1..terms {
                let sum: f64 = (0..j).filter(|&k| kept[k]).map(|k| a[i][k] * a[j][k]).sum();
                a[i][j] = (a[i][j] - sum) / a[j][j];
            }
        }
        for c in 0..6 {
            for i in (0..terms).filter(|&i| kept[i]) {
                let sum: f64 = (0..i).filter(|&k| kept[k]).map(|k| a[i][k] * rhs[k][c]).sum();
                rhs[i][c] = (rhs[i][c] - sum) / a[i][i];
            }
            for i in (0..terms).rev().filter(|&i| kept[i]) {
                let sum: f64 = (i + 1..terms).filter(|&k| kept[k]).map(|k| a[k][i] * self.coefficients[k][c]).sum();
                self.coefficients[i][c] = (rhs[i][c] - sum) / a[i][i];
            }
        }
    }
}
