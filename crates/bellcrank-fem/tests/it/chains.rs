//! Straight chains of beam segments, assembled densely: what an engine makes of them at small deflections.

use bellcrank_fem::beam::{Beam, Line, Segment};
use bellcrank_math::linalg::dense;

pub(crate) const STRAIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub(crate) type Matrix = Vec<Vec<f64>>;

/// Six coordinates a node, then the modes of each segment.
pub(crate) struct Chain {
    pub(crate) stiffness: Matrix,
    pub(crate) mass: Matrix,
    /// Work of the tensions against shortening.
    pub(crate) geometric: Matrix,
    pub(crate) nodes: usize,
}

/// `k` equal segments from the origin, with `modes` each; `tension` over the fraction of the length of their middles.
pub(crate) fn chain(line: Line, length: f64, k: usize, modes: usize, tension: impl Fn(usize) -> f64) -> Chain {
    let part = length / k as f64;
    let beam = |i: usize| {
        let start = [i as f64 * part, 0.0, 0.0];
        Segment { line, length: part, start, axes: STRAIGHT }.reduce(modes).expect("a beam")
    };
    let size = 6 * (k + 1) + modes * k;
    let zero = || vec![vec![0.0; size]; size];
    let mut chain = Chain { stiffness: zero(), mass: zero(), geometric: zero(), nodes: k + 1 };
    (0..k).for_each(|i| chain.add(&beam(i), i, tension(i)));
    chain
}

impl Chain {
    fn add(&mut self, beam: &Beam, i: usize, tension: f64) {
        let n = beam.coordinates();
        let place = |e: usize| if e < 12 { 6 * i + e } else { 6 * self.nodes + i * (n - 12) + e - 12 };
        let mass = beam.inertia.mass_matrix();
        let [along] = beam.shortenings.as_slice() else { panic!("a beam along x shortens along x only") };
        assert_eq!(along.along, 6);
        for e in 0..n {
            for f in 0..n {
                let (row, column) = (place(e), place(f));
                self.stiffness[row][column] += beam.stiffness[e * n + f];
                self.mass[row][column] += mass[e * n + f];
                self.geometric[row][column] += tension * along.matrix[e * n + f];
            }
        }
    }

    /// All coordinates of bending in the plane x–y but those (node, 0 for v or 1 for its turn) that are held.
    pub(crate) fn bending(&self, held: &[(usize, usize)]) -> Vec<usize> {
        let node = |node: usize| [(node, 0), (node, 1)];
        let free = (0..self.nodes).flat_map(node).filter(|key| !held.contains(key));
        let modes = 6 * self.nodes..self.stiffness.len();
        free.map(|(node, what)| 6 * node + if what == 0 { 1 } else { 5 }).chain(modes).collect()
    }
}

pub(crate) fn part(matrix: &Matrix, keep: &[usize]) -> Matrix {
    keep.iter().map(|&i| keep.iter().map(|&j| matrix[i][j]).collect()).collect()
}

pub(crate) fn sum(a: &Matrix, factor: f64, b: &Matrix) -> Matrix {
    a.iter().zip(b).map(|(a, b)| a.iter().zip(b).map(|(a, b)| a + factor * b).collect()).collect()
}

/// Rising λ of A x = λ B x with B positive definite.
pub(crate) fn generalized(a: &Matrix, b: &Matrix) -> Vec<f64> {
    dense::generalized_eigen(a, b).expect("positive definite").0
}

/// Natural frequencies in Hz of bending in the plane x–y with some coordinates held.
pub(crate) fn frequencies(chain: &Chain, held: &[(usize, usize)]) -> Vec<f64> {
    let keep = chain.bending(held);
    let stiffness = sum(&chain.stiffness, 1.0, &chain.geometric);
    let squares = generalized(&part(&stiffness, &keep), &part(&chain.mass, &keep));
    squares.into_iter().map(|square| square.abs().sqrt() / std::f64::consts::TAU).collect()
}
