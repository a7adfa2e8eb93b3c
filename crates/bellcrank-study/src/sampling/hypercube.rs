//! A Latin hypercube whose rows are computed from their numbers.

use super::random::{mix, to_unit};

/// n points in the unit cube, one in each of n equal slices of every dimension (M. McKay, R. Beckman and W. Conover,
/// Technometrics 21 (1979) 239). A point is computed from its number: the permutation of each dimension is a keyed one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LatinHypercube {
    points: u64,
    dimensions: usize,
    seed: u64,
}

impl LatinHypercube {
    /// So many points of so many dimensions; two seeds give two hypercubes.
    #[must_use]
    pub fn new(points: u64, dimensions: usize, seed: u64) -> Self {
        Self { points, dimensions, seed }
    }

    /// The number of points.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.points
    }

    /// Point `index` in the open unit cube; `None` beyond the last.
    #[must_use]
    pub fn point(&self, index: u64) -> Option<Vec<f64>> {
        (index < self.points).then(|| (0..self.dimensions).map(|j| self.coordinate(index, j)).collect())
    }

    fn coordinate(&self, index: u64, dimension: usize) -> f64 {
        let key = mix(mix(self.seed) ^ dimension as u64);
        let slice = permuted(index, self.points, key);
        let inside = to_unit(mix(key ^ mix(index)));
        ((slice as f64 + inside) / self.points as f64).min(1.0 - f64::EPSILON / 2.0)
    }
}

/// Place of `index` in a keyed permutation of 0..n: a Feistel network of four rounds on the next even power of two, walked
/// until it falls inside (J. Black and P. Rogaway, CT-RSA 2002, section 4).
fn permuted(index: u64, n: u64, key: u64) -> u64 {
    let bits = (64 - (n - 1).leading_zeros()).max(2).div_ceil(2);
    let mask = (1u64 << bits) - 1;
    let mut at = index;
    loop {
        let (mut left, mut right) = (at >> bits, at & mask);
        for round in 0..4 {
            (left, right) = (right, left ^ (mix(key ^ (round << 60) ^ right) & mask));
        }
        at = (left << bits) | right;
        if at < n {
            return at;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_slice_of_every_dimension_holds_one_point() {
        for n in [1u64, 2, 3, 7, 64, 1000] {
            let cube = LatinHypercube::new(n, 3, 5);
            let points: Vec<_> = (0..n).map(|i| cube.point(i).unwrap()).collect();
            for j in 0..3 {
                let mut slices: Vec<u64> = points.iter().map(|p| (p[j] * n as f64) as u64).collect();
                slices.sort_unstable();
                assert_eq!(slices, (0..n).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn dimensions_are_not_correlated() {
        let cube = LatinHypercube::new(1000, 2, 9);
        let points = (0..1000).map(|i| cube.point(i).unwrap());
        let covariance = points.map(|p| (p[0] - 0.5) * (p[1] - 0.5)).sum::<f64>() / 1000.0;
        assert!((covariance * 12.0).abs() < 0.1, "{covariance}");
    }

    #[test]
    fn empty_cubes_do_not_panic() {
        assert_eq!(LatinHypercube::new(0, 3, 1).point(0), None);
        assert_eq!(LatinHypercube::new(2, 0, 1).point(1), Some(vec![]));
        assert!(LatinHypercube::new(u64::MAX, 1, 1).point(u64::MAX - 1).is_some());
    }
}
