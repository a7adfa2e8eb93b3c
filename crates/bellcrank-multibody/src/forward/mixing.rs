//! Fixed points of x = F(x) where plain iteration goes slowly or astray (Anderson 1965; Walker & Ni 2011).

/// Changes that are looked back on.
const DEPTH: usize = 4;

/// The last changes of an iteration.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mixing {
    x: Vec<f64>,
    residual: Vec<f64>,
    moves: [Vec<f64>; DEPTH],
    changes: [Vec<f64>; DEPTH],
    count: usize,
    started: bool,
}

impl Mixing {
    /// Room for `n` numbers.
    pub(crate) fn new(n: usize) -> Self {
        let room = || std::array::from_fn(|_| vec![0.0; n]);
        Self { x: vec![0.0; n], residual: vec![0.0; n], moves: room(), changes: room(), count: 0, started: false }
    }

    pub(crate) fn begin(&mut self) {
        (self.count, self.started) = (0, false);
    }

    /// From x and F(x), which `image` holds, to the next x, which takes the place of `x`.
    pub(crate) fn next(&mut self, x: &mut [f64], image: &[f64]) {
        if self.started {
            self.moves.rotate_right(1);
            self.changes.rotate_right(1);
            for i in 0..x.len() {
                self.moves[0][i] = x[i] - self.x[i];
                self.changes[0][i] = (image[i] - x[i]) - self.residual[i];
            }
            self.count = (self.count + 1).min(DEPTH);
        }
        self.started = true;
        self.x.copy_from_slice(x);
        for i in 0..x.len() {
            self.residual[i] = image[i] - x[i];
        }
        let weights = self.weights();
        for (i, x) in x.iter_mut().enumerate() {
            let back: f64 = (0..self.count).map(|j| weights[j] * (self.moves[j][i] + self.changes[j][i])).sum();
            *x = image[i] - back;
        }
    }

    /// Least squares of the residual by its changes.
    fn weights(&self) -> [f64; DEPTH] {
        let n = self.count;
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let mut gram = [[0.0; DEPTH + 1]; DEPTH];
        for (row, a) in gram.iter_mut().zip(&self.changes).take(n) {
            row.iter_mut().zip(&self.changes).take(n).for_each(|(entry, b)| *entry = dot(a, b));
            row[DEPTH] = dot(a, &self.residual);
        }
        eliminate(&mut gram, n)
    }
}

/// Gauss's elimination on the diagonal; directions that say nothing get no weight.
fn eliminate(gram: &mut [[f64; DEPTH + 1]; DEPTH], n: usize) -> [f64; DEPTH] {
    let top = (0..n).fold(0.0, |m: f64, i| m.max(gram[i][i]));
    let mut used = [false; DEPTH];
    for k in 0..n {
        let pivot = gram[k][k];
        if pivot <= 1e-14 * top {
            continue;
        }
        used[k] = true;
        let row = gram[k];
        for (_, other) in gram.iter_mut().enumerate().take(n).filter(|(i, _)| *i != k) {
            let factor = other[k] / pivot;
            other.iter_mut().zip(&row).for_each(|(o, r)| *o -= factor * r);
        }
    }
    std::array::from_fn(|k| if k < n && used[k] { gram[k][DEPTH] / gram[k][k] } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::Mixing;

    #[test]
    fn a_map_that_plain_iteration_would_leave_is_followed_home() {
        // x = b + A x with eigenvalues beyond 1: the solution is that of (1 − A) x = b.
        let image = |x: &[f64]| vec![1.0 - 1.7 * x[0] + 0.3 * x[1], -0.5 + 0.4 * x[0] + 1.4 * x[1]];
        let (mut x, mut mixing) = (vec![0.0, 0.0], Mixing::new(2));
        mixing.begin();
        for _ in 0..6 {
            let y = image(&x);
            mixing.next(&mut x, &y);
        }
        let y = image(&x);
        assert!((x[0] - y[0]).abs() < 1e-12 && (x[1] - y[1]).abs() < 1e-12, "{x:?}");
    }
}
