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

/// Vectors multiplied together: the matrix is read once for all of them.
const TOGETHER: usize = 8;

impl SymmetricMatrix {
    /// y = A x; `x` and `y` hold one or more vectors of length `size`, one after another.
    pub fn multiply(&self, x: &[f64], y: &mut [f64]) {
        let size = self.size.max(1);
        for (x, y) in x.chunks(TOGETHER * size).zip(y.chunks_mut(TOGETHER * size)) {
            match x.len() / size {
                1 => self.multiply_one(x, y),
                2..=4 => self.multiply_some::<4>(x, y),
                _ => self.multiply_some::<TOGETHER>(x, y),
            }
        }
    }

    fn multiply_one(&self, x: &[f64], y: &mut [f64]) {
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

    /// Up to `N` vectors, side by side while at work.
    fn multiply_some<const N: usize>(&self, x: &[f64], y: &mut [f64]) {
        let mut wide_x = vec![[0.0; N]; self.size];
        for (k, x) in x.chunks_exact(self.size).enumerate() {
            wide_x.iter_mut().zip(x).for_each(|(wide, x)| wide[k] = *x);
        }
        let mut wide_y = vec![[0.0; N]; self.size];
        for column in 0..self.size {
            let (start, end) = (self.starts[column], self.starts[column + 1]);
            let own = wide_x[column];
            let mut sum: [f64; N] = std::array::from_fn(|k| self.values[start] * own[k]);
            for (&row, &value) in self.rows[start + 1..end].iter().zip(&self.values[start + 1..end]) {
                let (x, y) = (&wide_x[row as usize], &mut wide_y[row as usize]);
                for k in 0..N {
                    sum[k] += value * x[k];
                    y[k] += value * own[k];
                }
            }
            (0..N).for_each(|k| wide_y[column][k] += sum[k]);
        }
        for (k, y) in y.chunks_exact_mut(self.size).enumerate() {
            y.iter_mut().zip(&wide_y).for_each(|(y, wide)| *y = wide[k]);
        }
    }

    /// A + factor · B for a B with entries only where A has some.
    ///
    /// # Panics
    /// When B has an entry where A has none.
    #[must_use]
    pub fn plus(&self, factor: f64, other: &Self) -> Self {
        let mut sum = self.clone();
        for column in 0..self.size {
            let mut at = self.starts[column];
            for entry in other.starts[column]..other.starts[column + 1] {
                while self.rows[at] < other.rows[entry] {
                    at += 1;
                }
                assert!(
                    at < self.starts[column + 1] && self.rows[at] == other.rows[entry],
                    "a pattern within the other"
                );
                sum.values[at] += factor * other.values[entry];
            }
        }
        sum
    }

    /// Sum of the diagonal.
    pub fn trace(&self) -> f64 {
        self.starts.iter().take(self.size).map(|&start| self.values[start]).sum()
    }
}
