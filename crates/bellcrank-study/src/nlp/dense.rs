//! Two small dense factorizations on slices, row by row.

/// Product of two vectors; the shorter length counts.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// y += a x.
pub(crate) fn add_scaled(y: &mut [f64], a: f64, x: &[f64]) {
    y.iter_mut().zip(x).for_each(|(y, x)| *y += a * x);
}

/// Greatest magnitude, zero if empty.
pub(crate) fn largest(a: &[f64]) -> f64 {
    a.iter().fold(0.0, |m, x| f64::max(m, x.abs()))
}

/// y = A x for a symmetric n × n matrix.
pub(crate) fn times(a: &[f64], x: &[f64]) -> Vec<f64> {
    let n = x.len().max(1);
    a.chunks_exact(n).map(|row| dot(row, x)).collect()
}

/// Factors the n × n symmetric positive semidefinite `a` in its lower triangle, A = L Lᵀ. A pivot that vanishes against its
/// diagonal is made huge: the unknown stays zero (the usual remedy in interior-point methods, S. Wright, SIAM J. Optim. 9
/// (1999) 1159).
pub(crate) fn cholesky(a: &mut [f64], n: usize) {
    for j in 0..n {
        let (above, row_j) = a.split_at_mut(j * n);
        for k in 0..j {
            let row_k = &above[k * n..k * n + k];
            row_j[k] = (row_j[k] - dot(&row_j[..k], row_k)) / above[k * n + k];
        }
        let squares = dot(&row_j[..j], &row_j[..j]);
        let pivot = row_j[j] - squares;
        row_j[j] = if pivot > 1e-30 + 1e-16 * row_j[j].abs() { pivot.sqrt() } else { 1e64 };
    }
}

/// Solves L Lᵀ x = b in place.
pub(crate) fn cholesky_solve(l: &[f64], b: &mut [f64]) {
    let n = b.len();
    for i in 0..n {
        b[i] = (b[i] - dot(&l[i * n..i * n + i], &b[..i])) / l[i * n + i];
    }
    for i in (0..n).rev() {
        let x = b[i] / l[i * n + i];
        b[i] = x;
        add_scaled(&mut b[..i], -x, &l[i * n..i * n + i]);
    }
}

/// Solves A x = b in place by elimination with row pivoting and one refinement; `None` if A is singular to working
/// precision.
pub(crate) fn solve(a: &[f64], b: &[f64]) -> Option<Vec<f64>> {
    let n = b.len();
    let mut lu = a.to_vec();
    let order = eliminate(&mut lu, n)?;
    let mut x = substitute(&lu, &order, b);
    let residual: Vec<f64> = (0..n).map(|i| b[i] - dot(&a[i * n..i * n + n], &x)).collect();
    add_scaled(&mut x, 1.0, &substitute(&lu, &order, &residual));
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// L U of the rows in the order that is returned.
fn eliminate(a: &mut [f64], n: usize) -> Option<Vec<usize>> {
    let mut order: Vec<usize> = (0..n).collect();
    let size = largest(a);
    for k in 0..n {
        let p = (k..n).max_by(|&i, &j| a[i * n + k].abs().total_cmp(&a[j * n + k].abs()))?;
        if a[p * n + k].abs() <= 1e-13 * size {
            return None;
        }
        swap_rows(a, n, k, p);
        order.swap(k, p);
        let (above, below) = a.split_at_mut((k + 1) * n);
        let pivot = &above[k * n..];
        for row in below.chunks_exact_mut(n) {
            let factor = row[k] / pivot[k];
            row[k] = factor;
            add_scaled(&mut row[k + 1..], -factor, &pivot[k + 1..n]);
        }
    }
    Some(order)
}

fn swap_rows(a: &mut [f64], n: usize, i: usize, j: usize) {
    if i != j {
        (0..n).for_each(|k| a.swap(i * n + k, j * n + k));
    }
}

fn substitute(lu: &[f64], order: &[usize], b: &[f64]) -> Vec<f64> {
    let n = order.len();
    let mut x: Vec<f64> = order.iter().map(|&i| b[i]).collect();
    for i in 0..n {
        x[i] -= dot(&lu[i * n..i * n + i], &x[..i]);
    }
    for i in (0..n).rev() {
        x[i] = (x[i] - dot(&lu[i * n + i + 1..i * n + n], &x[i + 1..])) / lu[i * n + i];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: [f64; 9] = [4.0, 1.2, -0.7, 1.2, 3.1, 0.4, -0.7, 0.4, 2.5];

    #[test]
    fn both_factorizations_solve_the_same_system() {
        let b = [1.3, -2.1, 0.6];
        let mut l = A;
        cholesky(&mut l, 3);
        let mut x = b;
        cholesky_solve(&l, &mut x);
        let y = solve(&A, &b).unwrap();
        for i in 0..3 {
            assert!((x[i] - y[i]).abs() < 1e-14);
            assert!((dot(&A[3 * i..3 * i + 3], &x) - b[i]).abs() < 1e-14);
        }
    }

    #[test]
    fn a_singular_matrix_is_refused_and_its_unknown_stays_zero() {
        let a = [1.0, 1.0, 1.0, 1.0];
        assert_eq!(solve(&a, &[1.0, 1.0]), None);
        let mut l = a;
        cholesky(&mut l, 2);
        let mut x = [3.0, 3.0];
        cholesky_solve(&l, &mut x);
        assert!((x[0] - 3.0).abs() < 1e-14 && x[1].abs() < 1e-14);
    }
}
