//! Sums over elements of what a displacement field does: forces of its stresses, forces of its inertia.

use bellcrank_mesh::Block;

use crate::element::{Geometry, force_of_stress};
use crate::material::Six;
use crate::vector::{self, V3};
use crate::{Material, Part};

/// Strain of a temperature at a place with shape functions.
fn thermal(material: &Material, temperature: Option<&[f64]>, n: &[f64], element: &[u32]) -> Six {
    let Some(nodes) = temperature else { return [0.0; 6] };
    let rise: f64 = n.iter().zip(element).map(|(n, &node)| n * nodes[node as usize]).sum();
    let [x, y, z] = material.expansion.map(|a| a * rise);
    [x, y, z, 0.0, 0.0, 0.0]
}

/// Stress where the geometry was last evaluated.
pub(crate) fn stress_at(
    geometry: &Geometry,
    material: &Material,
    element: &[u32],
    displacement: &[V3],
    temperature: Option<&[f64]>,
) -> Six {
    let mut strain = geometry.strain(|k| displacement[element[k] as usize]);
    let free = thermal(material, temperature, &geometry.n, element);
    strain.iter_mut().zip(free).for_each(|(strain, free)| *strain -= free);
    material.stress(&strain)
}

/// Nodal forces of the stresses, ∫ Bᵀ σ, and twice the elastic energy, ∫ σᵀ D⁻¹ σ.
pub(crate) fn internal(part: &Part<'_>, displacement: &[V3], temperature: Option<&[f64]>) -> (Vec<V3>, f64) {
    let mut forces = vec![[0.0; 3]; displacement.len()];
    let mut energy = 0.0;
    each_point(part, |block, material, element, geometry, volume| {
        let _ = block;
        let stress = stress_at(geometry, material, element, displacement, temperature);
        let mut strain = geometry.strain(|k| displacement[element[k] as usize]);
        let free = thermal(material, temperature, &geometry.n, element);
        strain.iter_mut().zip(free).for_each(|(strain, free)| *strain -= free);
        energy += volume * stress.iter().zip(strain).map(|(s, e)| s * e).sum::<f64>();
        for (g, &node) in geometry.gradients().iter().zip(element) {
            vector::accumulate(&mut forces[node as usize], vector::scale(force_of_stress(*g, &stress), volume));
        }
    });
    (forces, energy)
}

/// Nodal forces that hold a part against its thermal strain, ∫ Bᵀ D ε.
pub(crate) fn thermal_forces(part: &Part<'_>, temperature: &[f64], forces: &mut [V3]) {
    each_point(part, |_, material, element, geometry, volume| {
        let stress = material.stress(&thermal(material, Some(temperature), &geometry.n, element));
        for (g, &node) in geometry.gradients().iter().zip(element) {
            vector::accumulate(&mut forces[node as usize], vector::scale(force_of_stress(*g, &stress), volume));
        }
    });
}

fn each_point(part: &Part<'_>, mut call: impl FnMut(&Block, &Material, &[u32], &Geometry, f64)) {
    let mut geometry = Geometry::default();
    for (block, material) in part.mesh.blocks.iter().zip(&part.materials) {
        for element in block.elements() {
            geometry.set(block.shape, element, &part.mesh.nodes);
            for point in block.shape.stiffness_points() {
                let volume = geometry.at(point) * point.weight;
                call(block, material, element, &geometry, volume);
            }
        }
    }
}

/// M u: mass times a field of accelerations (consistent mass).
pub(crate) fn inertia(part: &Part<'_>, field: &[V3]) -> Vec<V3> {
    let mut forces = vec![[0.0; 3]; field.len()];
    let mut geometry = Geometry::default();
    for (block, material) in part.mesh.blocks.iter().zip(&part.materials) {
        for element in block.elements() {
            geometry.set(block.shape, element, &part.mesh.nodes);
            for point in block.shape.mass_points() {
                let mass = geometry.at(point) * point.weight * material.density;
                let mut here = [0.0; 3];
                for (n, &node) in geometry.n.iter().zip(element) {
                    vector::accumulate(&mut here, vector::scale(field[node as usize], *n));
                }
                for (n, &node) in geometry.n.iter().zip(element) {
                    vector::accumulate(&mut forces[node as usize], vector::scale(here, n * mass));
                }
            }
        }
    }
    forces
}
