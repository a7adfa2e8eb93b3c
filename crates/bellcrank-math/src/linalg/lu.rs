//! LU factorization of a square matrix within a band, partial pivoting.
//!
//! A dense matrix is the case where the band is everything. Long chains of loops, ordered by
//! [`band_ordering`](super::band_ordering), have a band of a few columns and cost O(n).

/// Calls an inlined kernel with its size as a constant where it is small, so that loops unroll.
macro_rules! sized {
    ($n:expr, $size:ident => $call:expr) => {
        match $n {
            1 => {
                let $size = 1;
                $call
            }
            2 => {
                let $size = 2;
                $call
            }
            3 => {
                let $size = 3;
                $call
            }
            4 => {
                let $size = 4;
                $call
            }
            5 => {
                let $size = 5;
                $call
            }
            6 => {
                let $size = 6;
                $call
            }
            8 => {
                let $size = 8;
                $call
            }
            $size => $call,
        }
    };
}

/// A square matrix and, after [`BandLu::factor`], its factors. No allocation after [`BandLu::new`].
#[derive(Clone, Debug)]
pub struct BandLu {
    n: usize,
    below: usize,
    above: usize,
    stride: usize,
    shift: usize,
    dense: bool,
    a: Vec<f64>,
    pivots: Vec<usize>,
    scale: f64,
}

impl BandLu {
    /// Room for an `n`×`n` matrix with `below` and `above` off-diagonals.
    pub fn new(n: usize, below: usize, above: usize) -> Self {
        let (below, above) = (below.min(n.saturating_sub(1)), above.min(n.saturating_sub(1)));
        let width = 2 * below + above + 1;
        let dense = width >= n;
        let (stride, shift) = if dense { (n, 0) } else { (width - 1, below) };
        let len = if dense { n * n } else { n * width };
        Self { n, below, above: above + below, stride, shift, dense, a: vec![0.0; len], pivots: vec![0; n], scale: 0.0 }
    }
    /// Number of rows.
    pub fn size(&self) -> usize {
        self.n
    }
    /// Sets every entry to zero, before filling.
    pub fn clear(&mut self) {
        self.a.fill(0.0);
    }
    /// Adds to the entry in row `i`, column `j`, which must lie in the band.
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        let k = self.at(i, j);
        self.a[k] += value;
    }
    /// Where the entry of row `i`, column `j` is kept, for [`BandLu::entries`].
    pub fn place(&self, i: usize, j: usize) -> usize {
        self.at(i, j)
    }
    /// The storage, for filling by places worked out before.
    pub fn entries(&mut self) -> &mut [f64] {
        &mut self.a
    }
    #[inline]
    fn at(&self, i: usize, j: usize) -> usize {
        i * self.stride + j + self.shift
    }
    #[inline]
    fn last_row(&self, k: usize) -> usize {
        (k + self.below).min(self.n - 1)
    }
    #[inline]
    fn last_column(&self, k: usize) -> usize {
        (k + self.above).min(self.n - 1)
    }

    /// Factors in place. Returns the ratio of the smallest to the largest pivot: 0 when singular.
    pub fn factor(&mut self) -> f64 {
        if self.n == 0 {
            return 1.0;
        }
        if self.dense {
            return self.factor_dense();
        }
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
        for k in 0..self.n {
            let p = self.pivot_row(k);
            self.pivots[k] = p;
            if p != k {
                self.swap_rows(k, p);
            }
            let d = self.a[self.at(k, k)];
            smallest = smallest.min(d.abs());
            largest = largest.max(d.abs());
            if d != 0.0 {
                self.eliminate(k, 1.0 / d);
            }
        }
        self.scale = largest;
        if self.n == 0 {
            1.0
        } else if largest > 0.0 {
            smallest / largest
        } else {
            0.0
        }
    }

    /// The same on whole rows: no band to mind, which is what small systems are.
    fn factor_dense(&mut self) -> f64 {
        sized!(self.n, n => self.factor_rows(n))
    }

    #[inline(always)]
    fn factor_rows(&mut self, n: usize) -> f64 {
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
        for k in 0..n {
            let mut p = k;
            let mut size = self.a[k * n + k].abs();
            for (i, row) in self.a.chunks_exact(n).enumerate().skip(k + 1) {
                let here = row[k].abs();
                if here > size {
                    (p, size) = (i, here);
                }
            }
            self.pivots[k] = p;
            let (top, bottom) = self.a.split_at_mut((k + 1) * n);
            let pivot = &mut top[k * n..];
            if p != k {
                let other = &mut bottom[(p - k - 1) * n..(p - k) * n];
                pivot[k..].swap_with_slice(&mut other[k..]);
            }
            (smallest, largest) = (smallest.min(size), largest.max(size));
            if size > 0.0 {
                eliminate_dense(&pivot[k..], bottom, n, k);
            }
        }
        self.scale = largest;
        if n == 0 {
            1.0
        } else if largest > 0.0 {
            smallest / largest
        } else {
            0.0
        }
    }

    #[inline]
    fn pivot_row(&self, k: usize) -> usize {
        let mut best = (k, self.a[self.at(k, k)].abs());
        for i in k + 1..=self.last_row(k) {
            let size = self.a[self.at(i, k)].abs();
            if size > best.1 {
                best = (i, size);
            }
        }
        best.0
    }

    #[inline]
    fn swap_rows(&mut self, k: usize, p: usize) {
        for j in k..=self.last_column(k) {
            let (x, y) = (self.at(k, j), self.at(p, j));
            self.a.swap(x, y);
        }
    }

    #[inline]
    fn eliminate(&mut self, k: usize, inverse: f64) {
        let last = self.last_column(k);
        let (from, width) = (self.at(k, k) + 1, last - k);
        for i in k + 1..=self.last_row(k) {
            let start = self.at(i, k);
            let (upper, lower) = self.a.split_at_mut(start);
            let l = lower[0] * inverse;
            lower[0] = l;
            if l != 0.0 {
                for (x, u) in lower[1..=width].iter_mut().zip(&upper[from..from + width]) {
                    *x -= l * u;
                }
            }
        }
    }

    /// Solves `A x = b` in place.
    pub fn solve(&self, b: &mut [f64]) {
        if self.n == 0 {
            return;
        }
        if self.dense {
            return self.solve_dense(&mut b[..self.n]);
        }
        for k in 0..self.n {
            b.swap(k, self.pivots[k]);
            let x = b[k];
            for i in k + 1..=self.last_row(k).max(k) {
                b[i] -= self.a[self.at(i, k)] * x;
            }
        }
        for k in (0..self.n).rev() {
            let row = self.at(k, k);
            let mut x = b[k];
            for j in k + 1..=self.last_column(k) {
                x -= self.a[row + j - k] * b[j];
            }
            b[k] = x / self.a[row];
        }
    }

    fn solve_dense(&self, b: &mut [f64]) {
        sized!(self.n, n => self.solve_rows(n, b))
    }

    #[inline(always)]
    fn solve_rows(&self, n: usize, b: &mut [f64]) {
        let b = &mut b[..n];
        for k in 0..n {
            b.swap(k, self.pivots[k]);
            let x = b[k];
            for (row, b) in self.a.chunks_exact(n).zip(b.iter_mut()).skip(k + 1) {
                *b -= row[k] * x;
            }
        }
        for (k, row) in self.a.chunks_exact(n).enumerate().rev() {
            let (done, rest) = b.split_at_mut(k + 1);
            let s: f64 = row[k + 1..].iter().zip(rest.iter()).map(|(a, b)| a * b).sum();
            done[k] = (done[k] - s) / row[k];
        }
    }

    fn solve_transposed_dense(&self, b: &mut [f64]) {
        sized!(self.n, n => self.solve_rows_transposed(n, b))
    }

    #[inline(always)]
    fn solve_rows_transposed(&self, n: usize, b: &mut [f64]) {
        let b = &mut b[..n];
        for (k, row) in self.a.chunks_exact(n).enumerate() {
            let (done, rest) = b.split_at_mut(k + 1);
            let x = done[k] / row[k];
            done[k] = x;
            row[k + 1..].iter().zip(rest).for_each(|(a, b)| *b -= a * x);
        }
        for k in (0..n).rev() {
            let below = self.a.chunks_exact(n).zip(b.iter()).skip(k + 1);
            let s: f64 = below.map(|(row, b)| row[k] * b).sum();
            b[k] -= s;
            b.swap(k, self.pivots[k]);
        }
    }

    /// Solves `Aᵀ x = b` in place.
    pub fn solve_transposed(&self, b: &mut [f64]) {
        if self.n == 0 {
            return;
        }
        if self.dense {
            return self.solve_transposed_dense(&mut b[..self.n]);
        }
        for k in 0..self.n {
            let row = self.at(k, k);
            let x = b[k] / self.a[row];
            b[k] = x;
            for j in k + 1..=self.last_column(k) {
                b[j] -= self.a[row + j - k] * x;
            }
        }
        for k in (0..self.n).rev() {
            let mut x = b[k];
            for i in k + 1..=self.last_row(k) {
                x -= self.a[self.at(i, k)] * b[i];
            }
            b[k] = x;
            b.swap(k, self.pivots[k]);
        }
    }

    /// Sign of the determinant: −1, 0 or 1.
    pub fn determinant_sign(&self) -> f64 {
        (0..self.n).fold(1.0, |sign, k| {
            let d = self.a[self.at(k, k)];
            let flip = if self.pivots[k] == k { 1.0 } else { -1.0 };
            if d == 0.0 { 0.0 } else { sign * flip * d.signum() }
        })
    }

    /// Largest pivot of the last factorization, a cheap measure of the matrix' size.
    pub fn scale(&self) -> f64 {
        self.scale
    }
}

/// Takes the pivot row (from column `k` on) off every row below.
#[inline(always)]
fn eliminate_dense(pivot: &[f64], bottom: &mut [f64], n: usize, k: usize) {
    let inverse = 1.0 / pivot[0];
    for row in bottom.chunks_exact_mut(n) {
        let row = &mut row[k..];
        // Larger systems of machines are mostly zeros; in small ones the question costs more than it saves.
        if n > 8 && row[0] == 0.0 {
            continue;
        }
        let l = row[0] * inverse;
        row[0] = l;
        row[1..].iter_mut().zip(&pivot[1..]).for_each(|(x, u)| *x -= l * u);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Deterministic numbers in −1..1 without a generator of ours.
    fn noise(i: usize) -> f64 {
        let x = (i as f64 * 12.9898).sin() * 43758.5453;
        2.0 * (x - x.floor()) - 1.0
    }

    fn filled(n: usize, below: usize, above: usize) -> (BandLu, Vec<Vec<f64>>) {
        let mut lu = BandLu::new(n, below, above);
        let mut a = vec![vec![0.0; n]; n];
        for i in 0..n {
            for j in i.saturating_sub(below)..(i + above + 1).min(n) {
                // A heavier diagonal keeps long random bands well conditioned; pivoting still happens.
                a[i][j] = noise(i * n + j + 7 * n) + if i == j { 1.5 } else { 0.0 };
                lu.add(i, j, a[i][j]);
            }
        }
        (lu, a)
    }

    #[test]
    fn solves_both_ways_dense_and_banded() {
        for (n, below, above) in [(1, 0, 0), (5, 4, 4), (9, 2, 1), (40, 3, 5), (200, 4, 2)] {
            let (mut lu, a) = filled(n, below, above);
            assert!(lu.factor() > 0.0);
            let x: Vec<f64> = (0..n).map(|i| noise(i + 3)).collect();
            let mut b: Vec<f64> = a.iter().map(|row| row.iter().zip(&x).map(|(a, x)| a * x).sum()).collect();
            let mut c: Vec<f64> = (0..n).map(|j| (0..n).map(|i| a[i][j] * x[i]).sum()).collect();
            lu.solve(&mut b);
            lu.solve_transposed(&mut c);
            for i in 0..n {
                assert!((b[i] - x[i]).abs() < 1e-8 && (c[i] - x[i]).abs() < 1e-8, "n {n} row {i}");
            }
        }
    }

    #[test]
    fn nothing_to_solve_is_regular() {
        let mut lu = BandLu::new(0, 0, 0);
        assert_eq!(lu.factor(), 1.0);
        lu.solve(&mut []);
        lu.solve_transposed(&mut []);
        assert_eq!(lu.determinant_sign(), 1.0);
    }

    #[test]
    fn a_singular_matrix_says_so() {
        let mut lu = BandLu::new(2, 1, 1);
        for (i, j, x) in [(0, 0, 1.0), (0, 1, 2.0), (1, 0, 2.0), (1, 1, 4.0)] {
            lu.add(i, j, x);
        }
        assert_eq!(lu.factor(), 0.0);
        assert_eq!(lu.determinant_sign(), 0.0);
    }
}
