//! Solutions of L Lᵀ x = b with the blocks of the supernodes.

use faer::linalg::{matmul, triangular_solve};
use faer::prelude::Reborrow;
use faer::prelude::ReborrowMut;
use faer::{Accum, MatMut, MatRef, Par};

use super::factor::Cholesky;

/// Right-hand sides solved together.
const TOGETHER: usize = 16;

impl Cholesky {
    /// Solves A x = b in place; `rhs` holds one or more right-hand sides of the matrix's size, one after another.
    ///
    /// # Panics
    /// When the length of `rhs` is no multiple of the matrix's size.
    pub fn solve(&self, rhs: &mut [f64]) {
        let size = self.plan.size.max(1);
        assert_eq!(rhs.len() % size, 0, "right-hand sides of the matrix's size");
        for rhs in rhs.chunks_mut(size * TOGETHER) {
            let count = rhs.len() / size;
            let mut x = self.permute(rhs, count);
            self.forward(&mut x, count);
            self.backward(&mut x, count);
            self.permute_back(&x, rhs, count);
        }
    }

    fn permute(&self, rhs: &[f64], count: usize) -> Vec<f64> {
        let mut x = Vec::with_capacity(rhs.len());
        for b in rhs.chunks_exact(rhs.len() / count) {
            x.extend(self.plan.order.iter().map(|&row| b[row as usize]));
        }
        x
    }

    fn permute_back(&self, x: &[f64], rhs: &mut [f64], count: usize) {
        let size = x.len() / count;
        for (x, b) in x.chunks_exact(size).zip(rhs.chunks_exact_mut(size)) {
            self.plan.order.iter().zip(x).for_each(|(&row, &value)| b[row as usize] = value);
        }
    }

    /// L y = b.
    fn forward(&self, x: &mut [f64], count: usize) {
        let size = self.plan.size;
        let mut products = Vec::new();
        for s in 0..self.plan.supernodes() {
            let (lower, below) = self.block(s);
            let mut x = MatMut::from_column_major_slice_mut(x, size, count);
            let mut own = x.rb_mut().subrows_mut(self.plan.firsts[s], lower.ncols());
            triangular_solve::solve_lower_triangular_in_place(lower, own.rb_mut(), Par::Seq);
            products.resize(below.nrows() * count, 0.0);
            let mut product = MatMut::from_column_major_slice_mut(&mut products, below.nrows(), count);
            matmul::matmul(product.rb_mut(), Accum::Replace, below, own.rb(), 1.0, Par::Seq);
            for c in 0..count {
                for (k, &row) in self.plan.below.get(s).iter().enumerate() {
                    x[(row as usize, c)] -= product[(k, c)];
                }
            }
        }
    }

    /// Lᵀ x = y.
    fn backward(&self, x: &mut [f64], count: usize) {
        let size = self.plan.size;
        let mut gathered = Vec::new();
        for s in (0..self.plan.supernodes()).rev() {
            let (lower, below) = self.block(s);
            gathered.clear();
            for c in 0..count {
                gathered.extend(self.plan.below.get(s).iter().map(|&row| x[c * size + row as usize]));
            }
            let gathered = MatRef::from_column_major_slice(&gathered, below.nrows(), count);
            let x = MatMut::from_column_major_slice_mut(x, size, count);
            let mut own = x.subrows_mut(self.plan.firsts[s], lower.ncols());
            matmul::matmul(own.rb_mut(), Accum::Add, below.transpose(), gathered, -1.0, Par::Seq);
            triangular_solve::solve_upper_triangular_in_place(lower.transpose(), own, Par::Seq);
        }
    }

    /// The triangle of a supernode and what is below it.
    fn block(&self, s: usize) -> (MatRef<'_, f64>, MatRef<'_, f64>) {
        let (columns, rows) = self.plan.shape(s);
        let block = &self.blocks[self.plan.blocks[s]..self.plan.blocks[s + 1]];
        MatRef::from_column_major_slice(block, rows, columns).split_at_row(columns)
    }
}
