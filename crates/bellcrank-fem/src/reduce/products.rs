//! Products of the columns with the stiffness and the mass.

use bellcrank_math::linalg::dense;

use super::problem::Problem;
use super::share;
use crate::ShapeIntegrals;
use crate::vector::V3;

impl Problem<'_> {
    /// Nodal forces K u of fields.
    pub(super) fn times_stiffness(&self, fields: &[Vec<V3>]) -> Vec<Vec<V3>> {
        let flat: Vec<f64> = fields.iter().flat_map(|field| field.as_flattened().iter().copied()).collect();
        let mut forces = vec![0.0; flat.len()];
        self.stiffness.multiply(&flat, &mut forces);
        let size = self.stiffness.size.max(1);
        forces.chunks_exact(size).map(|one| one.as_chunks::<3>().0.to_vec()).collect()
    }

    /// Integrals of places and columns over the mass, by its consistent matrix: Uᵀ M U with the columns 1, x, y, z and the
    /// components of each φ.
    pub(super) fn integrals(&self, columns: &[Vec<V3>], threads: usize) -> ShapeIntegrals {
        let nodes = &self.part.mesh.nodes;
        let mut fields = vec![1.0; nodes.len()];
        for field in std::iter::once(nodes).chain(columns) {
            (0..3).for_each(|i| fields.extend(field.iter().map(|u| u[i])));
        }
        let count = 4 + 3 * columns.len();
        let products = self.products(&fields, count, threads);
        let at = |i: usize, j: usize| 0.5 * (products[i * count + j] + products[j * count + i]);
        let block = |i: usize, j: usize| -> [V3; 3] {
            std::array::from_fn(|a| std::array::from_fn(|b| at(1 + 3 * i + a, 1 + 3 * j + b)))
        };
        let column = |j: usize| std::array::from_fn(|b| at(0, 1 + 3 * j + b));
        let n = columns.len();
        ShapeIntegrals {
            mass: at(0, 0),
            first: column(0),
            second: block(0, 0),
            flow: (1..=n).map(column).collect(),
            placed: (1..=n).map(|e| block(0, e)).collect(),
            products: (0..n * n).map(|ef| block(1 + ef / n, 1 + ef % n)).collect(),
        }
    }

    /// Uᵀ M U, by columns; threads share its columns.
    fn products(&self, fields: &[f64], count: usize, threads: usize) -> Vec<f64> {
        let size = self.mass.size;
        let pieces = share::each(count.div_ceil(TOGETHER), threads, |piece| {
            let own = &fields[piece * TOGETHER * size..((piece + 1) * TOGETHER).min(count) * size];
            let mut heavy = vec![0.0; own.len()];
            self.mass.multiply(own, &mut heavy);
            dense::transposed_product(fields, &heavy, size)
        });
        pieces.concat()
    }
}

/// Fields multiplied together, whatever the number of threads.
const TOGETHER: usize = 32;

/// Aᵀ B of fields, by rows.
pub(super) fn table(a: &[Vec<V3>], b: &[Vec<V3>]) -> Vec<f64> {
    let flat = |fields: &[Vec<V3>]| -> Vec<f64> { fields.iter().flat_map(|f| f.as_flattened()).copied().collect() };
    let rows = a.first().map_or(0, |field| 3 * field.len());
    // By columns, Bᵀ A is Aᵀ B by rows.
    dense::transposed_product(&flat(b), &flat(a), rows)
}
