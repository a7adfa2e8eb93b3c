//! Vibration of a reduced body that nothing holds.

use std::f64::consts::PI;

use bellcrank_math::linalg::dense;

/// Natural frequencies in Hz, ascending, of matrices that are n × n by rows; those of rigid motions are zero but for rounding. Empty where the mass matrix
/// is not positive definite.
pub fn natural_frequencies(stiffness: &[f64], mass: &[f64]) -> Vec<f64> {
    let pairs = dense::generalized_eigen(&rows(stiffness), &rows(mass));
    pairs.map_or(Vec::new(), |(values, _)| values.iter().map(|v| v.max(0.0).sqrt() / (2.0 * PI)).collect())
}

/// D = M V diag(2 ζ ω) Vᵀ M by rows, with V all eigenvectors but the rigid motions.
///
/// V is sought among what is orthogonal to the rigid motions in the product of the mass, so that D does not feel them:
/// D z = 0 to rounding.
pub(crate) fn damping(stiffness: &[f64], mass: &[f64], rigid: &[Vec<f64>], ratio: f64) -> Vec<f64> {
    let (stiffness, mass) = (rows(stiffness), rows(mass));
    let size = mass.len();
    let elastic = dense::complement(&mass, rigid);
    let heavy: Vec<Vec<f64>> = elastic.iter().map(|x| times(&mass, x)).collect();
    let stiff: Vec<Vec<f64>> = elastic.iter().map(|x| times(&stiffness, x)).collect();
    let table = |left: &[Vec<f64>], right: &[Vec<f64>]| -> Vec<Vec<f64>> {
        left.iter().map(|x| right.iter().map(|y| dot(x, y)).collect()).collect()
    };
    let mut damping = vec![0.0; size * size];
    let Some((values, vectors)) = dense::generalized_eigen(&table(&elastic, &stiff), &table(&elastic, &heavy)) else {
        return damping;
    };
    for (value, vector) in values.iter().zip(&vectors) {
        let factor = 2.0 * ratio * value.max(0.0).sqrt();
        let mode: Vec<f64> = (0..size).map(|i| heavy.iter().zip(vector).map(|(h, c)| h[i] * c).sum()).collect();
        for i in 0..size {
            (0..size).for_each(|j| damping[i * size + j] += factor * mode[i] * mode[j]);
        }
    }
    damping
}

/// Rows of a square matrix.
pub(crate) fn rows(matrix: &[f64]) -> Vec<Vec<f64>> {
    let size = matrix.len().isqrt();
    matrix.chunks_exact(size.max(1)).map(<[f64]>::to_vec).collect()
}

fn times(matrix: &[Vec<f64>], x: &[f64]) -> Vec<f64> {
    matrix.iter().map(|row| dot(row, x)).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
