//! Storage of a sparse symmetric matrix.

/// A symmetric matrix by its lower triangle, compressed by columns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SymmetricMatrix {
    /// Number of rows and columns.
    pub size: usize,
    /// Where each column begins in `rows` and `values`; one more than there are columns.
    pub starts: Vec<usize>,
    /// Rows of each column, ascending; the diagonal first and always there.
    pub rows: Vec<u32>,
    /// Values, one a row.
    pub values: Vec<f64>,
}

impl SymmetricMatrix {
    /// y = A x; `x` and `y` hold one or more vectors of length `size`, one after another.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        for (x, y) in x.chunks_exact(self.size).zip(y.chunks_exact_mut(self.size)) {
            y.fill(0.0);
            for column in 0..self.size {
                let (start, end) = (self.starts[column], self.starts[column + 1]);
                let (mut sum, own) = (self.values[start] * x[column], x[column]);
                for entry in start + 1..end {
                    let (row, value) = (self.rows[entry] as usize, self.values[entry]);
                    sum += value * x[row];
                    y[row] += value * own;
                }
                y[column] += sum;
            }
        }
    }
}
