//! Stress of a solution: at integration points, smoothed to nodes, and how far the two are apart.

use crate::element::Geometry;
use crate::field::stress_at;
use crate::material::{Six, von_mises};
use crate::recovery;
use crate::vector::V3;
use crate::{Part, Solution};

/// Stress of a solution; components xx, yy, zz, xy, yz, zx in the axes of the mesh, Pa.
#[derive(Clone, Debug)]
pub struct Stress {
    /// Smoothed stress at each node.
    pub nodal: Vec<Six>,
    /// For each node, how far the von Mises stress of the elements round it is from the smoothed one, at most and at any
    /// node of theirs: an estimate of the error of the elements' stress, on the safe side for the smoothed one, Pa.
    pub spread: Vec<f64>,
    /// For each element (block by block), the square of the energy norm of the difference between smoothed and
    /// element stress, J (Zienkiewicz & Zhu 1987).
    pub element_errors: Vec<f64>,
    /// Twice the elastic energy of the smoothed stress, J.
    pub energy: f64,
}

impl Stress {
    /// Recovers the stress of a solution by fitting polynomials to patches of elements (superconvergent patch
    /// recovery, Zienkiewicz & Zhu, Int. J. Num. Meth. Eng. 33 (1992) 1331).
    pub fn new(part: &Part<'_>, solution: &Solution) -> Self {
        let sample = |geometry: &Geometry, block: usize, element: &[u32], here: &mut [Six]| {
            here[0] = evaluate(part, solution, geometry, block, element);
        };
        let nodal = recovery::nodal(part, 1, &sample);
        let (element_errors, energy) = element_errors(part, solution, &nodal);
        let spread = spread(part, solution, &nodal);
        Self { nodal, spread, element_errors, energy }
    }

    /// Estimated error of the whole solution in the energy norm, relative.
    pub fn relative_error(&self) -> f64 {
        let error: f64 = self.element_errors.iter().sum();
        if self.energy > 0.0 { (error / self.energy).sqrt() } else { 0.0 }
    }

    /// Von Mises stress at each node, Pa.
    pub fn von_mises(&self) -> Vec<f64> {
        self.nodal.iter().map(von_mises).collect()
    }
}

/// Stress at the integration points of the stiffness, element after element.
pub fn at_points(part: &Part<'_>, solution: &Solution) -> Vec<Six> {
    let mut stresses = Vec::new();
    each_element(part, |geometry, block, element| {
        for point in part.mesh.blocks[block].shape.stiffness_points() {
            geometry.at(point);
            stresses.push(evaluate(part, solution, geometry, block, element));
        }
    });
    stresses
}

fn each_element(part: &Part<'_>, mut call: impl FnMut(&mut Geometry, usize, &[u32])) {
    let mut geometry = Geometry::default();
    for (index, block) in part.mesh.blocks.iter().enumerate() {
        for element in block.elements() {
            geometry.set(block.shape, element, &part.mesh.nodes);
            call(&mut geometry, index, element);
        }
    }
}

/// Stress where the geometry was last evaluated.
pub(crate) fn evaluate(
    part: &Part<'_>,
    solution: &Solution,
    geometry: &Geometry,
    block: usize,
    element: &[u32],
) -> Six {
    stress_at(geometry, &part.materials[block], element, &solution.displacement, solution.temperature.as_deref())
}

fn element_errors(part: &Part<'_>, solution: &Solution, nodal: &[Six]) -> (Vec<f64>, f64) {
    let compliances: Vec<[Six; 6]> = part.materials.iter().map(crate::Material::compliance).collect();
    let (mut errors, mut energy) = (Vec::new(), 0.0);
    each_element(part, |geometry, block, element| {
        let mut error = 0.0;
        for point in part.mesh.blocks[block].shape.mass_points() {
            let volume = geometry.at(point) * point.weight;
            let smooth = interpolate(nodal, &geometry.n, element);
            let own = evaluate(part, solution, geometry, block, element);
            let difference = std::array::from_fn(|i| smooth[i] - own[i]);
            error += volume * energy_of(&compliances[block], &difference);
            energy += volume * energy_of(&compliances[block], &smooth);
        }
        errors.push(error);
    });
    (errors, energy)
}

fn interpolate(nodal: &[Six], n: &[f64], element: &[u32]) -> Six {
    let mut sum = [0.0; 6];
    for (n, &node) in n.iter().zip(element) {
        (0..6).for_each(|i| sum[i] += n * nodal[node as usize][i]);
    }
    sum
}

fn energy_of(compliance: &[Six; 6], stress: &Six) -> f64 {
    (0..6).map(|i| stress[i] * (0..6).map(|j| compliance[i][j] * stress[j]).sum::<f64>()).sum()
}

fn spread(part: &Part<'_>, solution: &Solution, nodal: &[Six]) -> Vec<f64> {
    let smooth: Vec<f64> = nodal.iter().map(von_mises).collect();
    let mut spread = vec![0.0_f64; nodal.len()];
    each_element(part, |geometry, block, element| {
        let shape = part.mesh.blocks[block].shape;
        let mut worst = 0.0_f64;
        for (k, &node) in element.iter().enumerate() {
            geometry.at_natural(shape.node_coordinates(k));
            let own = von_mises(&evaluate(part, solution, geometry, block, element));
            worst = worst.max((own - smooth[node as usize]).abs());
        }
        element.iter().for_each(|&node| spread[node as usize] = spread[node as usize].max(worst));
    });
    spread
}

/// The largest smoothed von Mises stress among some nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Node.
    pub node: u32,
    /// Its place, m.
    pub at: V3,
    /// Von Mises stress there, Pa.
    pub value: f64,
    /// Estimate of its error, Pa.
    pub error: f64,
}

impl Stress {
    /// The largest von Mises stress among some nodes; `None` where there are none.
    pub fn peak(&self, part: &Part<'_>, nodes: impl IntoIterator<Item = u32>) -> Option<Peak> {
        let value = |node: u32| von_mises(&self.nodal[node as usize]);
        let node = nodes.into_iter().max_by(|&a, &b| value(a).total_cmp(&value(b)))?;
        let at = part.mesh.nodes[node as usize];
        Some(Peak { node, at, value: value(node), error: self.spread[node as usize] })
    }
}
