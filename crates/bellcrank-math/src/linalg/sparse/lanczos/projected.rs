//! The operator in its basis of Lanczos vectors: a small dense matrix.

use crate::linalg::dense;

/// T = Qᵀ M (K − σM)⁻¹ M Q, as far as it is known, and what leads out of the basis.
#[derive(Clone, Debug, Default)]
pub(super) struct Projected {
    /// Rows of the upper triangle by columns: column `j` has `j + 1` entries or more.
    columns: Vec<Vec<f64>>,
    /// Coefficients of the next block for the last columns of the basis, by columns.
    coupling: Vec<Vec<f64>>,
    /// Eigenvalues of T, descending, with the bound of each one's residual and its vector.
    pairs: Vec<Ritz>,
}

/// An eigenpair of the projected operator.
#[derive(Clone, Debug)]
struct Ritz {
    value: f64,
    residual: f64,
    vector: Vec<f64>,
}

impl Projected {
    /// Takes the images of the basis's last block: its coefficients in the basis and in the next block.
    pub(super) fn extend(&mut self, inside: Vec<Vec<f64>>, outside: Vec<Vec<f64>>) {
        self.columns.extend(inside);
        self.coupling = outside;
        self.solve();
    }

    fn solve(&mut self) {
        let size = self.columns.len();
        let own = size - self.coupling.len();
        let entry = |i: usize, j: usize| self.columns[i.max(j)][i.min(j)];
        // The last block is symmetric to rounding; of the rest one half is known.
        let mean = |i: usize, j: usize| {
            if i.min(j) >= own { 0.5 * (self.columns[i][j] + self.columns[j][i]) } else { entry(i, j) }
        };
        let rows: Vec<Vec<f64>> = (0..size).map(|i| (0..size).map(|j| mean(i, j)).collect()).collect();
        let Some((values, vectors)) = dense::symmetric_eigen(&rows) else { return };
        self.pairs = values.into_iter().zip(vectors).map(|(value, vector)| self.ritz(value, vector)).collect();
        self.pairs.sort_by(|a, b| b.value.total_cmp(&a.value));
    }

    fn ritz(&self, value: f64, vector: Vec<f64>) -> Ritz {
        let last = &vector[vector.len() - self.coupling.len()..];
        let out = self.out(last);
        Ritz { value, residual: out.iter().map(|x| x * x).sum::<f64>().sqrt(), vector }
    }

    /// Coefficients in the next block of the image of a vector of which these are the last entries.
    fn out(&self, last: &[f64]) -> Vec<f64> {
        let width = self.coupling.first().map_or(0, Vec::len);
        (0..width).map(|i| self.coupling.iter().zip(last).map(|(column, x)| column[i] * x).sum()).collect()
    }

    /// How many of the leading `count` eigenpairs have converged, counted until the first that has not.
    pub(super) fn converged(&self, count: usize, tolerance: f64) -> usize {
        self.pairs.iter().take(count).take_while(|pair| pair.residual <= tolerance * pair.value.abs()).count()
    }

    /// Vectors of the leading eigenpairs, one after another.
    pub(super) fn leading(&self, count: usize) -> Vec<f64> {
        self.pairs.iter().take(count).flat_map(|pair| pair.vector.iter().copied()).collect()
    }

    /// Goes on with the leading eigenvectors for a basis: T is diagonal then.
    pub(super) fn restart(&mut self, keep: usize) {
        self.pairs.truncate(keep);
        let column = |k: usize| (0..=k).map(|i| if i == k { self.pairs[k].value } else { 0.0 }).collect();
        self.columns = (0..self.pairs.len()).map(column).collect();
        self.coupling.clear();
    }
}
