//! One element: its geometry at an integration point, its stiffness and mass.

use bellcrank_mesh::{MOST_NODES, Point, Shape};

use crate::material::Six;
use crate::vector::V3;

/// Shape functions and gradients of one element at one place after another.
pub(crate) struct Geometry {
    shape: Shape,
    places: [V3; MOST_NODES],
    natural: [V3; MOST_NODES],
    /// Shape functions where it was last evaluated; as many as the element has nodes.
    values: [f64; MOST_NODES],
    /// Their gradients by x, y, z.
    slopes: [V3; MOST_NODES],
    /// The shape functions, of the element's length.
    pub(crate) n: Vec<f64>,
}

impl Default for Geometry {
    fn default() -> Self {
        let none = [[0.0; 3]; MOST_NODES];
        Self {
            shape: Shape::Tet4,
            places: none,
            natural: none,
            values: [0.0; MOST_NODES],
            slopes: none,
            n: Vec::with_capacity(MOST_NODES),
        }
    }
}

impl Geometry {
    pub(crate) fn set(&mut self, shape: Shape, element: &[u32], nodes: &[V3]) {
        self.shape = shape;
        for (place, &node) in self.places.iter_mut().zip(element) {
            *place = nodes[node as usize];
        }
        self.n.resize(shape.nodes(), 0.0);
    }

    /// Evaluates at an integration point; the determinant of the Jacobian, m³.
    pub(crate) fn at(&mut self, point: &Point) -> f64 {
        self.at_natural(point.at)
    }

    pub(crate) fn at_natural(&mut self, at: V3) -> f64 {
        let count = self.shape.nodes();
        self.shape.evaluate(at, &mut self.values, &mut self.natural);
        self.n.copy_from_slice(&self.values[..count]);
        let mut jacobian = [[0.0; 3]; 3];
        for (place, d) in self.places[..count].iter().zip(&self.natural) {
            for i in 0..3 {
                for j in 0..3 {
                    jacobian[i][j] += d[i] * place[j];
                }
            }
        }
        let (inverse, determinant) = inverted(&jacobian);
        for (slope, d) in self.slopes[..count].iter_mut().zip(&self.natural) {
            *slope = std::array::from_fn(|i| inverse[i][0] * d[0] + inverse[i][1] * d[1] + inverse[i][2] * d[2]);
        }
        determinant
    }

    /// Gradients of the shape functions where it was last evaluated, 1/m.
    pub(crate) fn gradients(&self) -> &[V3] {
        &self.slopes[..self.shape.nodes()]
    }

    /// Where it was last evaluated, m.
    pub(crate) fn place(&self) -> V3 {
        let mut sum = [0.0; 3];
        for (n, place) in self.n.iter().zip(&self.places) {
            (0..3).for_each(|i| sum[i] += n * place[i]);
        }
        sum
    }

    /// Strain of nodal displacements where it was last evaluated.
    pub(crate) fn strain(&self, displacement: impl Fn(usize) -> V3) -> Six {
        let mut strain = [0.0; 6];
        for (k, g) in self.gradients().iter().enumerate() {
            let u = displacement(k);
            strain[0] += g[0] * u[0];
            strain[1] += g[1] * u[1];
            strain[2] += g[2] * u[2];
            strain[3] += g[1] * u[0] + g[0] * u[1];
            strain[4] += g[2] * u[1] + g[1] * u[2];
            strain[5] += g[2] * u[0] + g[0] * u[2];
        }
        strain
    }
}

fn inverted(m: &[V3; 3]) -> ([V3; 3], f64) {
    let c = |i: usize, j: usize| {
        let (a, b, p, q) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[a][p] * m[b][q] - m[a][q] * m[b][p]
    };
    let determinant = (0..3).map(|j| m[0][j] * c(0, j)).sum::<f64>();
    (std::array::from_fn(|i| std::array::from_fn(|j| c(j, i) / determinant)), determinant)
}

/// Bᵀ σ of one node: the force that a stress puts on it, a volume.
pub(crate) fn force_of_stress(g: V3, s: &Six) -> V3 {
    [
        g[0] * s[0] + g[1] * s[3] + g[2] * s[5],
        g[1] * s[1] + g[0] * s[3] + g[2] * s[4],
        g[2] * s[2] + g[1] * s[4] + g[0] * s[5],
    ]
}

/// A 3 x 3 block: rows of the first node, columns of the second.
pub(crate) type Block3 = [[f64; 3]; 3];

/// Blocks of a symmetric element matrix for pairs of nodes a ≤ b, row by row.
pub(crate) struct ElementMatrix {
    pub(crate) blocks: Vec<Block3>,
}

impl ElementMatrix {
    pub(crate) fn new() -> Self {
        Self { blocks: Vec::with_capacity(MOST_NODES * (MOST_NODES + 1) / 2) }
    }

    fn clear(&mut self, nodes: usize) {
        self.blocks.clear();
        self.blocks.resize(nodes * (nodes + 1) / 2, [[0.0; 3]; 3]);
    }

    /// ∫ Bᵀ D B.
    pub(crate) fn stiffness(&mut self, geometry: &mut Geometry, d: &[Six; 6]) {
        self.clear(geometry.shape.nodes());
        let mut db = [[[0.0; 6]; 3]; MOST_NODES];
        for point in geometry.shape.stiffness_points() {
            let volume = geometry.at(point) * point.weight;
            for (db, g) in db.iter_mut().zip(geometry.gradients()) {
                *db = stress_of_node(d, *g, volume);
            }
            let mut place = 0;
            for (a, g) in geometry.gradients().iter().enumerate() {
                for db in &db[a..geometry.shape.nodes()] {
                    let block = &mut self.blocks[place];
                    for (column, stress) in db.iter().enumerate() {
                        let force = force_of_stress(*g, stress);
                        (0..3).for_each(|row| block[row][column] += force[row]);
                    }
                    place += 1;
                }
            }
        }
    }

    /// ∫ ρ Nᵀ N.
    pub(crate) fn mass(&mut self, geometry: &mut Geometry, density: f64) {
        self.clear(geometry.shape.nodes());
        for point in geometry.shape.mass_points() {
            let mass = geometry.at(point) * point.weight * density;
            let mut place = 0;
            for (a, na) in geometry.n.iter().enumerate() {
                for nb in &geometry.n[a..] {
                    (0..3).for_each(|i| self.blocks[place][i][i] += na * nb * mass);
                    place += 1;
                }
            }
        }
    }
}

/// D B of one node, column by column, times a volume.
fn stress_of_node(d: &[Six; 6], g: V3, volume: f64) -> [Six; 3] {
    let g = g.map(|g| g * volume);
    let mix = |row: &Six, x: usize, y: usize, z: usize| g[0] * row[x] + g[1] * row[y] + g[2] * row[z];
    [
        std::array::from_fn(|i| mix(&d[i], 0, 3, 5)),
        std::array::from_fn(|i| mix(&d[i], 3, 1, 4)),
        std::array::from_fn(|i| mix(&d[i], 5, 4, 2)),
    ]
}
