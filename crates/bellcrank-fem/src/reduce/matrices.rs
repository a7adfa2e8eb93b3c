//! Craig–Bampton reduction of small matrices that are given: beams, and tests.

use bellcrank_math::linalg::dense;

use super::free::rows;

/// A reduced pair of matrices.
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedMatrices {
    /// Angular frequencies squared of the fixed-interface modes, ascending, rad²/s².
    pub eigenvalues: Vec<f64>,
    /// The columns, n of them, with a value for every unknown: a constraint mode for each unknown of the boundary in the
    /// order given, then the modes, of unit modal mass, each with its largest component positive.
    pub columns: Vec<Vec<f64>>,
    /// n × n by rows, exactly symmetric; zero between boundary and modes.
    pub stiffness: Vec<f64>,
    /// n × n by rows, exactly symmetric.
    pub mass: Vec<f64>,
}

/// Reduces `stiffness` and `mass` (N × N by rows, symmetric) to the unknowns `boundary` and the `count` lowest modes with
/// these held (all modes, where there are fewer). `None` when what is not on the boundary has no stiffness or no mass of its
/// own.
pub fn reduce_matrices(stiffness: &[f64], mass: &[f64], boundary: &[usize], count: usize) -> Option<ReducedMatrices> {
    let (k, m) = (rows(stiffness), rows(mass));
    let size = k.len();
    let inner: Vec<usize> = (0..size).filter(|i| !boundary.contains(i)).collect();
    let part = |of: &[Vec<f64>]| -> Vec<Vec<f64>> {
        inner.iter().map(|&i| inner.iter().map(|&j| of[i][j]).collect()).collect()
    };
    let held = part(&k);
    let mut columns = Vec::with_capacity(boundary.len() + count);
    for &moved in boundary {
        let force: Vec<f64> = inner.iter().map(|&i| -k[i][moved]).collect();
        let answer = if inner.is_empty() { Vec::new() } else { dense::solve(&held, &force)? };
        let mut column = spread(&inner, &answer, size);
        column[moved] = 1.0;
        columns.push(column);
    }
    let (values, vectors) = dense::generalized_eigen(&held, &part(&m))?;
    let eigenvalues: Vec<f64> = values.into_iter().take(count).collect();
    columns.extend(vectors.iter().take(count).map(|vector| oriented(spread(&inner, vector, size))));
    let modes = eigenvalues.len();
    let mut reduced =
        ReducedMatrices { stiffness: congruent(&k, &columns), mass: congruent(&m, &columns), eigenvalues, columns };
    decouple(&mut reduced.stiffness, &reduced.eigenvalues, boundary.len() + modes);
    Some(reduced)
}

fn spread(places: &[usize], values: &[f64], size: usize) -> Vec<f64> {
    let mut all = vec![0.0; size];
    places.iter().zip(values).for_each(|(&place, &value)| all[place] = value);
    all
}

fn oriented(mut mode: Vec<f64>) -> Vec<f64> {
    let largest = mode.iter().fold(0.0_f64, |most, &u| if u.abs() > most.abs() * 1.000_001 { u } else { most });
    if largest < 0.0 {
        mode.iter_mut().for_each(|u| *u = -*u);
    }
    mode
}

/// Φᵀ A Φ, made exactly symmetric.
fn congruent(matrix: &[Vec<f64>], columns: &[Vec<f64>]) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let images: Vec<Vec<f64>> =
        columns.iter().map(|column| matrix.iter().map(|row| dot(row, column)).collect()).collect();
    let entry = |i: usize, j: usize| 0.5 * (dot(&columns[i], &images[j]) + dot(&columns[j], &images[i]));
    let size = columns.len();
    (0..size * size).map(|at| entry(at / size, at % size)).collect()
}

/// Writes what the theory says of the modes' stiffness: zero but for the eigenvalues on the diagonal.
pub(crate) fn decouple(stiffness: &mut [f64], eigenvalues: &[f64], size: usize) {
    let first = size - eigenvalues.len();
    for (mode, value) in eigenvalues.iter().enumerate() {
        for other in 0..size {
            stiffness[(first + mode) * size + other] = 0.0;
            stiffness[other * size + first + mode] = 0.0;
        }
        stiffness[(first + mode) * (size + 1)] = *value;
    }
}
