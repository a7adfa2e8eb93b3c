//! Singular values and eigenvalues of small dense matrices, for questions asked once a study.

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
}
