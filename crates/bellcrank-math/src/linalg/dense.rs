//! Singular values and eigenvalues of small dense matrices, for questions asked once a study.

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};
use nalgebra::DMatrix;

/// Singular values (descending) with left and right singular vectors of an `m`×`n` matrix.
#[derive(Clone, Debug)]
pub struct Svd {
    /// Singular values, descending.
    pub values: Vec<f64>,
    /// `left[k]`: m components.
    pub left: Vec<Vec<f64>>,
    /// `right[k]`: n components.
    pub right: Vec<Vec<f64>>,
}

/// Singular value decomposition of rows `a`. `None` when it does not converge or is empty.
pub fn svd(a: &[Vec<f64>], columns: usize) -> Option<Svd> {
    if a.is_empty() || columns == 0 || a.iter().flatten().any(|x| !x.is_finite()) {
        return None;
    }
    let matrix = DMatrix::from_fn(a.len(), columns, |i, j| a[i][j]);
    let svd = matrix.try_svd(true, true, f64::EPSILON, 1000)?;
    let (u, vt) = (svd.u?, svd.v_t?);
    let mut order: Vec<usize> = (0..svd.singular_values.len()).collect();
    order.sort_by(|&i, &j| svd.singular_values[j].total_cmp(&svd.singular_values[i]));
    Some(Svd {
        values: order.iter().map(|&k| svd.singular_values[k]).collect(),
        left: order.iter().map(|&k| u.column(k).iter().copied().collect()).collect(),
        right: order.iter().map(|&k| vt.row(k).iter().copied().collect()).collect(),
    })
}

/// Number of singular values above `tolerance` times the largest.
pub fn rank(a: &[Vec<f64>], columns: usize, tolerance: f64) -> usize {
    svd(a, columns).map_or(0, |s| {
        let top = s.values.first().copied().unwrap_or(0.0);
        s.values.iter().filter(|&&x| x > tolerance * top && x > 0.0).count()
    })
}

/// Eigenvalues (real, imaginary) of a square matrix, in no order.
pub fn eigenvalues(a: &[Vec<f64>]) -> Vec<(f64, f64)> {
    let n = a.len();
    if n == 0 || a.iter().flatten().any(|x| !x.is_finite()) {
        return Vec::new();
    }
    let matrix = DMatrix::from_fn(n, n, |i, j| a[i][j]);
    matrix.complex_eigenvalues().iter().map(|z| (z.re, z.im)).collect()
}

/// Eigenvalues and eigenvectors of a symmetric matrix.
pub fn symmetric_eigen(a: &[Vec<f64>]) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
    let n = a.len();
    if a.iter().flatten().any(|x| !x.is_finite()) {
        return None;
    }
    let matrix = DMatrix::from_fn(n, n, |i, j| a[i][j]);
    let eigen = nalgebra::SymmetricEigen::try_new(matrix, f64::EPSILON, 10_000)?;
    let vectors = (0..n).map(|k| eigen.eigenvectors.column(k).iter().copied().collect()).collect();
    Some((eigen.eigenvalues.iter().copied().collect(), vectors))
}

/// Eigenvalues (ascending) and eigenvectors of `k x = λ m x`, `xᵢᵀ m xⱼ = δᵢⱼ`, for symmetric `k` and `m`. `None` when `m` is
/// not positive definite. Rows and columns are scaled by the diagonal of `m` first: their units may differ.
pub fn generalized_eigen(k: &[Vec<f64>], m: &[Vec<f64>]) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
    let n = m.len();
    if n == 0 {
        return Some((Vec::new(), Vec::new()));
    }
    let scale: Vec<f64> = (0..n).map(|i| 1.0 / m[i][i].sqrt()).collect();
    if scale.iter().any(|s| !s.is_finite()) {
        return None;
    }
    let scaled = |a: &[Vec<f64>]| DMatrix::from_fn(n, n, |i, j| 0.5 * (a[i][j] + a[j][i]) * scale[i] * scale[j]);
    let lower = nalgebra::Cholesky::new(scaled(m))?.unpack();
    let half = lower.solve_lower_triangular(&scaled(k))?;
    let standard = lower.solve_lower_triangular(&half.transpose())?;
    let rows: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| 0.5 * (standard[(i, j)] + standard[(j, i)])).collect()).collect();
    let (values, vectors) = symmetric_eigen(&rows)?;
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| values[i].total_cmp(&values[j]));
    let upper = lower.transpose();
    let back = |k: usize| -> Option<Vec<f64>> {
        let x = upper.solve_upper_triangular(&nalgebra::DVector::from_column_slice(&vectors[k]))?;
        Some(x.iter().zip(&scale).map(|(x, s)| x * s).collect())
    };
    let vectors = order.iter().map(|&k| back(k)).collect::<Option<_>>()?;
    Some((order.iter().map(|&k| values[k]).collect(), vectors))
}

/// A basis of what is orthogonal to `known` in the product of the positive definite `m`: `xᵀ m z = 0`.
///
/// Unit vectors lead, the one with the most of its own first, so that the answer does not hang on rounding.
pub fn complement(m: &[Vec<f64>], known: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let n = m.len();
    let mut taken: Vec<(Vec<f64>, Vec<f64>)> = Vec::new();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    // Twice, as what is left after the first time may be small.
    let rest = |mut x: Vec<f64>, taken: &[(Vec<f64>, Vec<f64>)]| {
        for _ in 0..2 {
            for (z, mz) in taken {
                let part = dot(mz, &x);
                x.iter_mut().zip(z).for_each(|(x, z)| *x -= part * z);
            }
        }
        let heavy: Vec<f64> = m.iter().map(|row| dot(row, &x)).collect();
        let length = dot(&x, &heavy).max(0.0).sqrt();
        (x, heavy, length)
    };
    let unit = |(x, heavy, length): (Vec<f64>, Vec<f64>, f64)| {
        (x.iter().map(|x| x / length).collect(), heavy.iter().map(|x| x / length).collect())
    };
    for z in known {
        let own = rest(z.clone(), &taken);
        if own.2 > 0.0 {
            taken.push(unit(own));
        }
    }
    let start = taken.len();
    let mut left: Vec<usize> = (0..n).collect();
    while taken.len() < n {
        // How much of a unit vector, by its own length, is outside of what is taken.
        let share = |&i: &usize| 1.0 - taken.iter().map(|(_, mz)| mz[i] * mz[i]).sum::<f64>() / m[i][i];
        let Some(best) = (0..left.len()).max_by(|&a, &b| share(&left[a]).total_cmp(&share(&left[b]))) else { break };
        let place = left.swap_remove(best);
        let own = rest((0..n).map(|i| f64::from(u8::from(i == place))).collect(), &taken);
        if own.2 > 0.0 {
            taken.push(unit(own));
        }
    }
    taken.split_off(start).into_iter().map(|(x, _)| x).collect()
}

/// Aᵀ B of matrices of `rows` rows that are stored by columns; the product, too.
pub fn transposed_product(a: &[f64], b: &[f64], rows: usize) -> Vec<f64> {
    let (n, m) = (a.len() / rows.max(1), b.len() / rows.max(1));
    let mut product = vec![0.0; n * m];
    let (a, b) = (MatRef::from_column_major_slice(a, rows, n), MatRef::from_column_major_slice(b, rows, m));
    matmul(MatMut::from_column_major_slice_mut(&mut product, n, m), Accum::Replace, a.transpose(), b, 1.0, Par::Seq);
    product
}

/// Aᵀ B of matrices with `columns` columns each that are stored by rows; the product by columns.
pub fn row_product(a: &[f64], b: &[f64], columns: usize) -> Vec<f64> {
    let rows = a.len() / columns.max(1);
    let mut product = vec![0.0; columns * columns];
    let (a, b) = (MatRef::from_row_major_slice(a, rows, columns), MatRef::from_row_major_slice(b, rows, columns));
    let target = MatMut::from_column_major_slice_mut(&mut product, columns, columns);
    matmul(target, Accum::Replace, a.transpose(), b, 1.0, Par::Seq);
    product
}

/// Solves the square system `a x = b`; `None` when singular.
pub fn solve(a: &[Vec<f64>], b: &[f64]) -> Option<Vec<f64>> {
    let n = b.len();
    let matrix = DMatrix::from_fn(n, n, |i, j| a[i][j]);
    let x = matrix.full_piv_lu().solve(&nalgebra::DVector::from_column_slice(b))?;
    x.iter().all(|v| v.is_finite()).then(|| x.iter().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn singular_values_and_rank_of_a_known_matrix() {
        let a = vec![vec![3.0, 0.0], vec![4.0, 5.0]];
        let s = svd(&a, 2).expect("converges");
        assert!((s.values[0] - 45f64.sqrt()).abs() < 1e-14 && (s.values[1] - 5f64.sqrt()).abs() < 1e-14);
        assert_eq!(rank(&[vec![1.0, 2.0], vec![2.0, 4.0]], 2, 1e-12), 1);
    }

    #[test]
    fn eigenvalues_of_a_rotation_are_imaginary() {
        let mut e = eigenvalues(&[vec![0.0, -2.0], vec![2.0, 0.0]]);
        e.sort_by(|a, b| a.1.total_cmp(&b.1));
        assert!((e[0].1 + 2.0).abs() < 1e-14 && (e[1].1 - 2.0).abs() < 1e-14);
    }

    /// Rows of a matrix of numbers that look random.
    fn numbers(rows: usize, columns: usize) -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| ((i * 37 + j * 101 + 7) as f64 * 0.618_034).sin();
        (0..rows).map(|i| (0..columns).map(|j| entry(i, j)).collect()).collect()
    }

    /// A positive definite one, in units that differ by a thousand.
    fn definite(n: usize, shift: f64) -> Vec<Vec<f64>> {
        let a = numbers(n, n);
        let unit = |i: usize| 10f64.powi(3 * (i % 3) as i32 - 3);
        let product = |i: usize, j: usize| (0..n).map(|k| a[k][i] * a[k][j]).sum::<f64>();
        (0..n)
            .map(|i| {
                (0..n).map(|j| (product(i, j) + shift * f64::from(u8::from(i == j))) * unit(i) * unit(j)).collect()
            })
            .collect()
    }

    fn form(x: &[f64], m: &[Vec<f64>], y: &[f64]) -> f64 {
        x.iter().zip(m).map(|(x, row)| x * row.iter().zip(y).map(|(a, y)| a * y).sum::<f64>()).sum()
    }

    #[test]
    fn generalized_eigenvectors_make_both_matrices_diagonal() {
        let (k, m) = (definite(7, 0.0), definite(7, 2.0));
        let (values, vectors) = generalized_eigen(&k, &m).expect("definite");
        assert!(values.is_sorted());
        for i in 0..7 {
            for j in 0..7 {
                let own = f64::from(u8::from(i == j));
                assert!((form(&vectors[i], &m, &vectors[j]) - own).abs() < 1e-11);
                assert!((form(&vectors[i], &k, &vectors[j]) - own * values[i]).abs() < 1e-11 * values[6]);
            }
        }
        assert_eq!(generalized_eigen(&k, &numbers(7, 7)), None);
    }

    #[test]
    fn a_complement_is_orthogonal_in_the_product() {
        let m = definite(9, 0.5);
        let known = numbers(4, 9);
        let found = complement(&m, &known);
        assert_eq!(found.len(), 5);
        for (i, x) in found.iter().enumerate() {
            let size = |z: &[f64]| form(z, &m, z).sqrt();
            assert!(known.iter().all(|z| form(x, &m, z).abs() < 1e-13 * size(z)));
            for (j, y) in found.iter().enumerate() {
                assert!((form(x, &m, y) - f64::from(u8::from(i == j))).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn a_product_with_a_transpose() {
        let (a, b) = (numbers(2, 5), numbers(3, 5));
        let product = transposed_product(&a.concat(), &b.concat(), 5);
        for (i, a) in a.iter().enumerate() {
            for (j, b) in b.iter().enumerate() {
                let sum: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                assert!((product[j * 2 + i] - sum).abs() < 1e-14);
            }
        }
        let (a, b) = (numbers(5, 2), numbers(5, 2).into_iter().rev().collect::<Vec<_>>());
        let product = row_product(&a.concat(), &b.concat(), 2);
        for (at, product) in product.into_iter().enumerate() {
            let sum: f64 = (0..5).map(|k| a[k][at % 2] * b[k][at / 2]).sum();
            assert!((product - sum).abs() < 1e-14);
        }
    }
}
