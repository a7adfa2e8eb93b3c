//! Incomplete Cholesky factors: those entries of L where the matrix has some.
//!
//! Meijerink & van der Vorst (1977), "An iterative solution method for linear systems of which the coefficient matrix is a
//! symmetric M-matrix"; the shift is Manteuffel's (1980), "An incomplete factorization technique for positive definite linear
//! systems".

use super::SymmetricMatrix;
use super::factor::NotPositive;

/// L Lᵀ near A + α diag A, with L as sparse as the lower triangle of A.
#[derive(Clone, Debug)]
pub struct Incomplete<'a> {
    matrix: &'a SymmetricMatrix,
    values: Vec<f64>,
    /// α: zero unless the factorization broke down without.
    pub shift: f64,
}

/// The first shift tried after a breakdown; each further one is four times the one before.
const FIRST_SHIFT: f64 = 1e-3;
/// A shift at which any positive definite matrix has long become diagonally dominant.
const LAST_SHIFT: f64 = 1e5;
/// A pivot below this share of its diagonal is a breakdown.
const SMALLEST: f64 = 1e-3;

impl<'a> Incomplete<'a> {
    /// The factor of a matrix, with the smallest shift of a series that works.
    ///
    /// # Errors
    /// When an entry of the diagonal is not positive.
    pub fn new(matrix: &'a SymmetricMatrix) -> Result<Self, NotPositive> {
        let diagonal = |row: usize| matrix.values[matrix.starts[row]];
        // Also when it is not a number.
        if let Some(row) =
            (0..matrix.size).find(|&row| diagonal(row).partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater))
        {
            return Err(NotPositive { row, pivot: diagonal(row), diagonal: diagonal(row) });
        }
        let mut shift = 0.0;
        loop {
            match factor(matrix, shift) {
                Ok(values) => return Ok(Self { matrix, values, shift }),
                Err(broken) if shift > LAST_SHIFT => return Err(broken),
                Err(_) => shift = if shift == 0.0 { FIRST_SHIFT } else { 4.0 * shift },
            }
        }
    }

    /// x ← (L Lᵀ)⁻¹ x.
    pub fn apply(&self, x: &mut [f64]) {
        let SymmetricMatrix { size, starts, rows, .. } = self.matrix;
        for column in 0..*size {
            let (start, end) = (starts[column], starts[column + 1]);
            let own = x[column] / self.values[start];
            x[column] = own;
            for entry in start + 1..end {
                x[rows[entry] as usize] -= self.values[entry] * own;
            }
        }
        for column in (0..*size).rev() {
            let (start, end) = (starts[column], starts[column + 1]);
            let below: f64 = (start + 1..end).map(|entry| self.values[entry] * x[rows[entry] as usize]).sum();
            x[column] = (x[column] - below) / self.values[start];
        }
    }
}

/// The entries of L by columns, each column passed on to those to its right once it is done.
fn factor(matrix: &SymmetricMatrix, shift: f64) -> Result<Vec<f64>, NotPositive> {
    let SymmetricMatrix { size, starts, rows, .. } = matrix;
    let mut values = matrix.values.clone();
    (0..*size).for_each(|column| values[starts[column]] *= 1.0 + shift);
    for column in 0..*size {
        let (start, end) = (starts[column], starts[column + 1]);
        let (pivot, diagonal) = (values[start], matrix.values[start]);
        if pivot < SMALLEST * diagonal || pivot.is_nan() {
            return Err(NotPositive { row: column, pivot, diagonal });
        }
        values[start..end].iter_mut().for_each(|value| *value /= pivot.sqrt());
        let (done, ahead) = values.split_at_mut(end);
        for entry in start + 1..end {
            let target = rows[entry] as usize;
            let below = entry..end;
            subtract(
                &mut ahead[starts[target] - end..starts[target + 1] - end],
                &rows[starts[target]..starts[target + 1]],
                &done[below.clone()],
                &rows[below],
            );
        }
    }
    Ok(values)
}

/// Column ← column − other · (first of other), where the column has entries. Rows of both ascend.
fn subtract(column: &mut [f64], rows: &[u32], other: &[f64], other_rows: &[u32]) {
    let factor = other[0];
    let mut at = 0;
    for (value, row) in other.iter().zip(other_rows) {
        while at < rows.len() && rows[at] < *row {
            at += 1;
        }
        if at < rows.len() && rows[at] == *row {
            column[at] -= factor * value;
        }
    }
}
