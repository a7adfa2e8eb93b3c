//! A clamped (or free) brick of eight-node elements in linear elasticity: the pattern and the numbers of a solid part.

use bellcrank_math::linalg::sparse::SymmetricMatrix;

const YOUNG: f64 = 210e9;
const POISSON: f64 = 0.3;
const DENSITY: f64 = 7850.0;
const SIGNS: [f64; 2] = [-1.0, 1.0];

/// Stiffness and mass, N/m and kg, of `cells` cubes of edge `edge` (m) in each direction; the face x = 0 is clamped if asked.
pub(crate) struct Brick {
    pub(crate) stiffness: SymmetricMatrix,
    pub(crate) mass: SymmetricMatrix,
}

/// Blocks of 3 × 3 between each node and its 27 neighbours.
struct Blocks {
    nodes: [usize; 3],
    stiffness: Vec<[f64; 9]>,
    mass: Vec<f64>,
}

pub(crate) fn brick(cells: [usize; 3], edge: f64, clamped: bool) -> Brick {
    let nodes = cells.map(|n| n + 1);
    let count = nodes[0] * nodes[1] * nodes[2];
    let mut blocks = Blocks { nodes, stiffness: vec![[0.0; 9]; 27 * count], mass: vec![0.0; 27 * count] };
    let (stiffness, mass) = element(edge);
    for x in 0..cells[0] {
        for y in 0..cells[1] {
            for z in 0..cells[2] {
                blocks.add([x, y, z], &stiffness, &mass);
            }
        }
    }
    blocks.compress(clamped)
}

fn corner(k: usize) -> [usize; 3] {
    [k & 1, (k >> 1) & 1, (k >> 2) & 1]
}

impl Blocks {
    fn node(&self, at: [usize; 3]) -> usize {
        (at[0] * self.nodes[1] + at[1]) * self.nodes[2] + at[2]
    }

    fn add(&mut self, at: [usize; 3], stiffness: &[[f64; 24]; 24], mass: &[[f64; 8]; 8]) {
        for a in 0..8 {
            let p = corner(a);
            let node = self.node([at[0] + p[0], at[1] + p[1], at[2] + p[2]]);
            for b in 0..8 {
                let q = corner(b);
                let slot = (0..3).fold(0, |slot, i| slot * 3 + (q[i] + 1 - p[i]));
                self.mass[27 * node + slot] += mass[a][b];
                for i in 0..9 {
                    self.stiffness[27 * node + slot][i] += stiffness[3 * a + i / 3][3 * b + i % 3];
                }
            }
        }
    }

    fn compress(&self, clamped: bool) -> Brick {
        let held = if clamped { self.nodes[1] * self.nodes[2] } else { 0 };
        let count = self.nodes.iter().product::<usize>() - held;
        let empty = SymmetricMatrix { size: 3 * count, starts: vec![0], ..SymmetricMatrix::default() };
        let (mut stiffness, mut mass) = (empty.clone(), empty);
        for column in 0..3 * count {
            let node = column / 3 + held;
            for (slot, other) in self.neighbours(node) {
                for i in 0..3 {
                    let row = 3 * other.wrapping_sub(held) + i;
                    if other < held || row < column {
                        continue;
                    }
                    stiffness.rows.push(row as u32);
                    stiffness.values.push(self.stiffness[27 * node + slot][3 * (column % 3) + i]);
                    if i == column % 3 {
                        mass.rows.push(row as u32);
                        mass.values.push(self.mass[27 * node + slot]);
                    }
                }
            }
            stiffness.starts.push(stiffness.rows.len());
            mass.starts.push(mass.rows.len());
        }
        Brick { stiffness, mass }
    }

    /// Neighbours in ascending order with their slots.
    fn neighbours(&self, node: usize) -> impl Iterator<Item = (usize, usize)> {
        let [_, ny, nz] = self.nodes;
        let at = [node / (ny * nz), node / nz % ny, node % nz];
        let nodes = self.nodes;
        (0..27).filter_map(move |slot| {
            let step = [slot / 9, slot / 3 % 3, slot % 3];
            let to: [usize; 3] = std::array::from_fn(|i| (at[i] + step[i]).wrapping_sub(1));
            (0..3).all(|i| to[i] < nodes[i]).then(|| (slot, (to[0] * ny + to[1]) * nz + to[2]))
        })
    }
}

/// Stiffness and mass of a cube by 2 × 2 × 2 Gauss points.
fn element(edge: f64) -> ([[f64; 24]; 24], [[f64; 8]; 8]) {
    let (mut stiffness, mut mass) = ([[0.0; 24]; 24], [[0.0; 8]; 8]);
    let weight = (edge / 2.0).powi(3);
    for g in 0..8 {
        let point = corner(g).map(|i| SIGNS[i] / 3.0_f64.sqrt());
        let (values, slopes) = shapes(point, edge);
        for a in 0..8 {
            for b in 0..8 {
                mass[a][b] += DENSITY * weight * values[a] * values[b];
                for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
                    stiffness[3 * a + i][3 * b + j] += weight * elasticity(&slopes[a], &slopes[b], i, j);
                }
            }
        }
    }
    (stiffness, mass)
}

fn shapes(point: [f64; 3], edge: f64) -> ([f64; 8], [[f64; 3]; 8]) {
    let (mut values, mut slopes) = ([0.0; 8], [[0.0; 3]; 8]);
    for a in 0..8 {
        let sign = corner(a).map(|i| SIGNS[i]);
        let factor: [f64; 3] = std::array::from_fn(|i| (1.0 + sign[i] * point[i]) / 2.0);
        values[a] = factor[0] * factor[1] * factor[2];
        slopes[a] = std::array::from_fn(|i| sign[i] / edge * factor[(i + 1) % 3] * factor[(i + 2) % 3]);
    }
    (values, slopes)
}

fn elasticity(a: &[f64; 3], b: &[f64; 3], i: usize, j: usize) -> f64 {
    let shear = YOUNG / (2.0 * (1.0 + POISSON));
    let lame = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
    let dot: f64 = (0..3).map(|k| a[k] * b[k]).sum();
    lame * a[i] * b[j] + shear * (a[j] * b[i] + if i == j { dot } else { 0.0 })
}
