//! Mass properties of a mesh.

use crate::Mesh;
use crate::element::{Element, Tabulated, determinant};

/// Mass properties of a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshMass {
    /// Volume in m³.
    pub volume: f64,
    /// Mass in kg.
    pub mass: f64,
    /// Centre of mass in m.
    pub center: [f64; 3],
    /// Inertia matrix about the centre of mass, in kg m²; products of inertia with their minus sign.
    pub inertia: [[f64; 3]; 3],
}

impl Mesh {
    /// Volume, mass, centre of mass and inertia for a density in kg/m³, by the integration rules of the elements'
    /// mass matrices.
    pub fn mass_properties(&self, density: f64) -> MeshMass {
        // Places are taken from the first node: a part far from its origin loses no digits.
        let origin = self.nodes.first().copied().unwrap_or_default();
        let (mut volume, mut first, mut second) = (0.0, [0.0; 3], [[0.0; 3]; 3]);
        for block in &self.blocks {
            let rule: Vec<Tabulated> =
                block.shape.mass_points().iter().map(|p| Tabulated::at(block.shape, p.at, p.weight)).collect();
            for nodes in block.elements() {
                let element = Element::new(nodes, &self.nodes);
                for point in &rule {
                    let (place, tangents) = element.combine(&point.n, &point.d);
                    let part = point.weight * determinant(tangents);
                    let at: [f64; 3] = std::array::from_fn(|i| place[i] - origin[i]);
                    volume += part;
                    for i in 0..3 {
                        first[i] += part * at[i];
                        (0..3).for_each(|j| second[i][j] += part * at[i] * at[j]);
                    }
                }
            }
        }
        about_center(volume, first, second, density, origin)
    }
}

fn about_center(volume: f64, first: [f64; 3], second: [[f64; 3]; 3], density: f64, origin: [f64; 3]) -> MeshMass {
    let mean = first.map(|moment| moment / volume);
    let central: [[f64; 3]; 3] =
        std::array::from_fn(|i| std::array::from_fn(|j| second[i][j] - volume * mean[i] * mean[j]));
    let trace = central[0][0] + central[1][1] + central[2][2];
    let inertia =
        std::array::from_fn(|i| std::array::from_fn(|j| density * (if i == j { trace } else { 0.0 } - central[i][j])));
    let center = std::array::from_fn(|i| origin[i] + mean[i]);
    MeshMass { volume, mass: density * volume, center, inertia }
}
