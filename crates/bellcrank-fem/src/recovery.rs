//! Superconvergent patch recovery: a polynomial through the stresses of the elements round each corner node.

use bellcrank_mesh::{Block, Shape};

use crate::Part;
use crate::element::Geometry;
use crate::material::Six;
use crate::vector::V3;

/// Stress in an element of a block where the geometry was last evaluated, for each of some cases.
pub(crate) type Sampler<'a> = &'a (dyn Fn(&Geometry, usize, &[u32], &mut [Six]) + Sync);

/// Smoothed stress at each node for each of `cases` stress fields, node by node; nodes between materials get the mean
/// of the sides.
pub(crate) fn nodal(part: &Part<'_>, cases: usize, sample: Sampler<'_>) -> Vec<Six> {
    let count = part.mesh.nodes.len();
    let (mut sums, mut weights) = (vec![[0.0; 6]; count * cases], vec![0.0; count]);
    for (index, block) in part.mesh.blocks.iter().enumerate() {
        let patches = Patches::new(part, cases, sample, index);
        patches.recover(part, block, |node, stresses| {
            accumulate(&mut sums[node * cases..(node + 1) * cases], stresses);
            weights[node] += 1.0;
        });
    }
    divide(&mut sums, &weights);
    sums
}

fn accumulate(sums: &mut [Six], more: &[Six]) {
    sums.as_flattened_mut().iter_mut().zip(more.as_flattened()).for_each(|(sum, more)| *sum += more);
}

/// Divides the cases of each node by its weight.
fn divide(sums: &mut [Six], weights: &[f64]) {
    let cases = sums.len() / weights.len().max(1);
    for (sums, weight) in sums.chunks_exact_mut(cases.max(1)).zip(weights) {
        if *weight > 0.0 {
            sums.as_flattened_mut().iter_mut().for_each(|s| *s /= weight);
        }
    }
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
    cases: usize,
    places: Vec<V3>,
    /// Of each sample, all cases.
    stresses: Vec<Six>,
    starts: Vec<u32>,
    elements: Vec<u32>,
    terms: usize,
}

impl Patches {
    fn new(part: &Part<'_>, cases: usize, sample: Sampler<'_>, index: usize) -> Self {
        let block = &part.mesh.blocks[index];
        let points = sampling(block.shape);
        let (mut places, mut stresses) = (Vec::new(), Vec::new());
        let (mut geometry, mut here) = (Geometry::default(), vec![[0.0; 6]; cases]);
        for element in block.elements() {
            geometry.set(block.shape, element, &part.mesh.nodes);
            for point in points {
                geometry.at(point);
                places.push(geometry.place());
                sample(&geometry, index, element, &mut here);
                stresses.extend_from_slice(&here);
            }
        }
        let (starts, elements) = touching(block, part.mesh.nodes.len());
        let terms = if block.shape.quadratic() { 10 } else { 4 };
        Self { per_element: points.len(), cases, places, stresses, starts, elements, terms }
    }

    fn of(&self, node: u32) -> &[u32] {
        &self.elements[self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize]
    }

    fn recover(&self, part: &Part<'_>, block: &Block, mut give: impl FnMut(usize, &[Six])) {
        let nodes = &part.mesh.nodes;
        let corners = block.shape.corners();
        let cases = self.cases;
        let (mut sums, mut weights) = (vec![[0.0; 6]; nodes.len() * cases], vec![0.0; nodes.len()]);
        let mut work = Work::default();
        for node in (0..nodes.len() as u32).filter(|&node| !self.of(node).is_empty()) {
            self.gather(block, node, &mut work);
            work.fit.through(self, nodes[node as usize], &work.elements);
            work.mid_sides.clear();
            work.mid_sides.push(node);
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
            for &at in &work.mid_sides {
                let at = at as usize;
                work.fit.add_at(nodes[at], &mut sums[at * cases..(at + 1) * cases]);
                weights[at] += 1.0;
            }
        }
        divide(&mut sums, &weights);
        for node in (0..nodes.len()).filter(|&node| weights[node] > 0.0) {
            give(node, &sums[node * cases..(node + 1) * cases]);
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
    /// The patch's corner node and the mid-side nodes of its edges.
    mid_sides: Vec<u32>,
    fit: Fit,
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

/// Polynomials of the components of each case about a node, in coordinates scaled by the patch.
#[derive(Default)]
struct Fit {
    origin: V3,
    scale: V3,
    terms: usize,
    /// Of each term, all cases.
    coefficients: Vec<Six>,
}

impl Fit {
    fn through(&mut self, patches: &Patches, origin: V3, elements: &[u32]) {
        let (terms, cases) = (patches.terms, patches.cases);
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
        (self.origin, self.terms) = (origin, terms);
        self.scale = reach.map(|reach| if reach > 0.0 { 1.0 / reach } else { 0.0 });
        self.coefficients.clear();
        self.coefficients.resize(terms * cases, [0.0; 6]);
        let mut normal = [[0.0; MOST_TERMS]; MOST_TERMS];
        for sample in samples() {
            let basis = self.basis(patches.places[sample]);
            let stresses = &patches.stresses[sample * cases..(sample + 1) * cases];
            for (i, sums) in self.coefficients.chunks_exact_mut(cases).enumerate() {
                (0..=i).for_each(|j| normal[i][j] += basis[i] * basis[j]);
                add_times(sums, basis[i], stresses);
            }
        }
        self.solve(&mut normal, cases);
    }

    fn basis(&self, at: V3) -> [f64; MOST_TERMS] {
        let [x, y, z]: V3 = std::array::from_fn(|i| (at[i] - self.origin[i]) * self.scale[i]);
        [1.0, x, y, z, x * y, y * z, z * x, x * x, y * y, z * z]
    }

    /// Adds the cases at a place to sums.
    fn add_at(&self, at: V3, sums: &mut [Six]) {
        let basis = self.basis(at);
        for (b, coefficients) in basis.iter().zip(self.coefficients.chunks_exact(sums.len())) {
            add_times(sums, *b, coefficients);
        }
    }

    /// Cholesky on the normal equations, in the order of the basis; a term that the samples do not tell from those
    /// before it is left out.
    fn solve(&mut self, a: &mut [[f64; MOST_TERMS]; MOST_TERMS], cases: usize) {
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
        for i in 0..terms {
            let (before, own) = self.coefficients.split_at_mut(i * cases);
            let own = &mut own[..cases];
            if !kept[i] {
                own.fill([0.0; 6]);
                continue;
            }
            before.chunks_exact(cases).zip(a[i]).for_each(|(known, factor)| add_times(own, -factor, known));
            own.as_flattened_mut().iter_mut().for_each(|x| *x /= a[i][i]);
        }
        for i in (0..terms).rev().filter(|&i| kept[i]) {
            let (own, after) = self.coefficients[i * cases..].split_at_mut(cases);
            after.chunks_exact(cases).zip(&a[i + 1..]).for_each(|(known, row)| add_times(own, -row[i], known));
            own.as_flattened_mut().iter_mut().for_each(|x| *x /= a[i][i]);
        }
    }
}

fn add_times(sums: &mut [Six], factor: f64, more: &[Six]) {
    sums.as_flattened_mut().iter_mut().zip(more.as_flattened()).for_each(|(sum, more)| *sum += factor * more);
}
