//! Householder QR with column pivoting of a matrix with at least as many rows as columns.
//!
//! With `J P = Q R` and full column rank, `x = P R⁻¹ Qᵀ b` is the least-squares solution of `J x = b`,
//! and `y = Q R⁻ᵀ Pᵀ t` the least-norm solution of `Jᵀ y = t`; the last rows of Qᵀ span the null space
//! of `Jᵀ`. One factorization serves motion and forces of a mechanism with redundant constraints.
//! Golub & Van Loan (2013), Matrix Computations, §5.4.2.

/// An `m`×`n` matrix, `m ≥ n`, and after [`Qr::factor`] its factors, by columns.
#[derive(Clone, Debug)]
pub struct Qr {
    m: usize,
    n: usize,
    a: Vec<f64>,
    diagonal: Vec<f64>,
    order: Vec<usize>,
    norms: Vec<f64>,
    rank: usize,
}

impl Qr {
    /// Room for `m` rows and `n` columns.
    pub fn new(m: usize, n: usize) -> Self {
        let (a, order) = (vec![0.0; m * n], (0..n).collect());
        Self { m, n, a, diagonal: vec![0.0; n], order, norms: vec![0.0; n], rank: 0 }
    }
    /// Rows and columns.
    pub fn shape(&self) -> (usize, usize) {
        (self.m, self.n)
    }
    /// Sets every entry to zero, before filling.
    pub fn clear(&mut self) {
        self.a.fill(0.0);
    }
    /// Adds to the entry in row `i`, column `j`.
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        self.a[j * self.m + i] += value;
    }
    /// Where the entry of row `i`, column `j` is kept, for [`Qr::entries`].
    pub fn place(&self, i: usize, j: usize) -> usize {
        j * self.m + i
    }
    /// The storage, for filling by places worked out before.
    pub fn entries(&mut self) -> &mut [f64] {
        &mut self.a
    }
    /// Number of columns (and rows) found independent by the last factorization.
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Factors in place; pivots below `tolerance` times the largest count as zero.
    /// Returns the ratio of the smallest to the largest pivot.
    pub fn factor(&mut self, tolerance: f64) -> f64 {
        self.order.iter_mut().enumerate().for_each(|(j, o)| *o = j);
        let steps = self.n.min(self.m);
        self.rank = steps;
        let mut first = 0.0;
        let mut ratio: f64 = 1.0;
        for k in 0..steps {
            self.bring_largest(k);
            self.reflect(k);
            let d = self.diagonal[k].abs();
            if k == 0 {
                first = d;
            }
            ratio = if first > 0.0 { ratio.min(d / first) } else { 0.0 };
            if ratio <= tolerance {
                self.rank = k;
                return ratio;
            }
        }
        if self.m < self.n { 0.0 } else { ratio }
    }

    fn column(&self, j: usize) -> &[f64] {
        &self.a[j * self.m..(j + 1) * self.m]
    }

    fn bring_largest(&mut self, k: usize) {
        for j in k..self.n {
            self.norms[j] = self.column(j)[k..].iter().map(|x| x * x).sum();
        }
        let best = (k..self.n).fold(k, |b, j| if self.norms[j] > self.norms[b] { j } else { b });
        if best != k {
            for i in 0..self.m {
                self.a.swap(k * self.m + i, best * self.m + i);
            }
            self.order.swap(k, best);
        }
    }

    /// Householder vector of column `k` in place (first entry in the column, scaled to `vᵀv = 2`).
    fn reflect(&mut self, k: usize) {
        let m = self.m;
        let norm = self.norms_of(k);
        let head = self.a[k * m + k];
        let alpha = if head > 0.0 { -norm } else { norm };
        self.diagonal[k] = alpha;
        let v0 = head - alpha;
        let size = (norm * norm - 2.0 * head * alpha + alpha * alpha).max(0.0).sqrt();
        if size == 0.0 {
            return;
        }
        let scale = std::f64::consts::SQRT_2 / size;
        self.a[k * m + k] = v0;
        self.a[k * m + k..(k + 1) * m].iter_mut().for_each(|x| *x *= scale);
        for j in k + 1..self.n {
            let (left, right) = self.a.split_at_mut(j * m);
            mirror(&left[k * m + k..(k + 1) * m], &mut right[k..m]);
        }
    }

    fn norms_of(&self, k: usize) -> f64 {
        self.column(k)[k..].iter().map(|x| x * x).sum::<f64>().sqrt()
    }

    fn apply_q_transposed(&self, b: &mut [f64]) {
        for k in 0..self.rank {
            mirror(&self.column(k)[k..], &mut b[k..]);
        }
    }
    fn apply_q(&self, b: &mut [f64]) {
        for k in (0..self.rank).rev() {
            mirror(&self.column(k)[k..], &mut b[k..]);
        }
    }

    /// Least-squares `x` (n) of `J x = b` (m). With rank below n, a basic solution: the columns left
    /// over stay at zero. `b` is used up.
    pub fn solve(&mut self, b: &mut [f64], x: &mut [f64]) {
        self.apply_q_transposed(b);
        for k in (0..self.rank).rev() {
            let mut s = b[k];
            for j in k + 1..self.rank {
                s -= self.a[j * self.m + k] * b[j];
            }
            b[k] = s / self.diagonal[k];
        }
        x.fill(0.0);
        for k in 0..self.rank {
            x[self.order[k]] = b[k];
        }
    }

    /// Least-norm `y` (m) of `Jᵀ y = t` (n).
    pub fn solve_transposed(&mut self, t: &[f64], y: &mut [f64]) {
        y.fill(0.0);
        for k in 0..self.rank {
            let mut s = t[self.order[k]];
            for i in 0..k {
                s -= self.a[k * self.m + i] * y[i];
            }
            y[k] = s / self.diagonal[k];
        }
        self.apply_q(y);
    }

    /// Vector `i` of an orthonormal basis of the null space of `Jᵀ`, `i < m − rank`.
    pub fn null_transposed(&self, i: usize, y: &mut [f64]) {
        y.fill(0.0);
        y[self.rank + i] = 1.0;
        self.apply_q(y);
    }

    /// The pivot order of the columns: the first `rank` are independent.
    pub fn order(&self) -> &[usize] {
        &self.order
    }
}

/// `b −= v (vᵀ b)`.
#[inline]
fn mirror(v: &[f64], b: &mut [f64]) {
    let s: f64 = v.iter().zip(b.iter()).map(|(v, b)| v * b).sum();
    v.iter().zip(b.iter_mut()).for_each(|(v, b)| *b -= v * s);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn noise(i: usize) -> f64 {
        let x = (i as f64 * 78.233).sin() * 43758.5453;
        2.0 * (x - x.floor()) - 1.0
    }

    fn matrix(m: usize, n: usize) -> (Qr, Vec<Vec<f64>>) {
        let a: Vec<Vec<f64>> = (0..m).map(|i| (0..n).map(|j| noise(i * n + j + 1)).collect()).collect();
        let mut qr = Qr::new(m, n);
        for (i, row) in a.iter().enumerate() {
            row.iter().enumerate().for_each(|(j, x)| qr.add(i, j, *x));
        }
        (qr, a)
    }

    #[test]
    fn least_squares_least_norm_and_null_space() {
        let (m, n) = (7, 4);
        let (mut qr, a) = matrix(m, n);
        assert!(qr.factor(1e-12) > 0.01);
        let x: Vec<f64> = (0..n).map(|j| noise(j + 50)).collect();
        let mut b: Vec<f64> = a.iter().map(|r| r.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
        let mut found = vec![0.0; n];
        qr.solve(&mut b, &mut found);
        assert!(x.iter().zip(&found).all(|(x, f)| (x - f).abs() < 1e-13));

        let mut y = vec![0.0; m];
        qr.solve_transposed(&x, &mut y);
        for j in 0..n {
            let t: f64 = (0..m).map(|i| a[i][j] * y[i]).sum();
            assert!((t - x[j]).abs() < 1e-13);
        }
        let mut z = vec![0.0; m];
        for k in 0..m - n {
            qr.null_transposed(k, &mut z);
            let along: f64 = z.iter().zip(&y).map(|(z, y)| z * y).sum();
            assert!(along.abs() < 1e-13, "the least-norm solution has no part in the null space");
            for j in 0..n {
                let t: f64 = (0..m).map(|i| a[i][j] * z[i]).sum();
                assert!(t.abs() < 1e-13);
            }
        }
    }

    #[test]
    fn rank_is_seen() {
        let mut qr = Qr::new(5, 3);
        for i in 0..5 {
            let (x, y) = (noise(i), noise(i + 20));
            [x, y, x - 2.0 * y].iter().enumerate().for_each(|(j, v)| qr.add(i, j, *v));
        }
        assert!(qr.factor(1e-12) < 1e-12);
        assert_eq!(qr.rank(), 2);
    }
}
