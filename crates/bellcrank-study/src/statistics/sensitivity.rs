//! Which input causes how much of the variance of a result: Sobol' indices.

use super::moments::Moments;
use crate::sampling::{Sobol, mix, random_point};

/// The points at which a result must be known: for every sample a block of d + 2 rows A, B, AB₁ … AB_d, where ABᵢ is A with
/// its i-th coordinate from B (A. Saltelli et al., Comput. Phys. Commun. 181 (2010) 259). Rows are computed from their
/// numbers: row = sample (d + 2) + place.
#[derive(Clone, Debug)]
pub struct Saltelli {
    samples: u64,
    dimensions: usize,
    seed: u64,
    sobol: Option<Sobol>,
}

/// The indices of one input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensitivityIndex {
    /// Share of the variance that fixing this input would remove.
    pub first: f64,
    /// Standard error of `first`.
    pub first_error: f64,
    /// Share that remains when all other inputs are fixed: with all interactions.
    pub total: f64,
    /// Standard error of `total`.
    pub total_error: f64,
}

impl Saltelli {
    /// So many samples of d inputs. Points are Sobol' points up to 32 inputs and random ones beyond.
    #[must_use]
    pub fn new(samples: u64, dimensions: usize, seed: u64) -> Self {
        let sobol = Sobol::new(dimensions.saturating_mul(2), seed).ok();
        Self { samples, dimensions, seed, sobol }
    }

    /// The number of rows, n (d + 2).
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.samples.saturating_mul(self.block() as u64)
    }

    fn block(&self) -> usize {
        self.dimensions + 2
    }

    /// The point of a row in the open unit cube; `None` beyond the last.
    #[must_use]
    pub fn point(&self, row: u64) -> Option<Vec<f64>> {
        if row >= self.rows() {
            return None;
        }
        let (sample, place) = (row / self.block() as u64, (row % self.block() as u64) as usize);
        let d = self.dimensions;
        let both = self.sobol.as_ref().and_then(|sobol| sobol.point(sample));
        let mut a = both.unwrap_or_else(|| random_point(self.seed, sample, 2 * d));
        let b = a.split_off(d);
        match place {
            0 => return Some(a),
            1 => return Some(b),
            _ => a[place - 2] = b[place - 2],
        }
        Some(a)
    }

    /// Indices from the results of all rows in order. Blocks with a result that is not finite are left out, as is a last
    /// one that is not complete. First order after equation (b), total after Jansen's (f) in table 2 of the paper; errors
    /// from `resamples` bootstrap samples of the blocks (0: NaN). NaN where nothing varies.
    #[must_use]
    pub fn indices(&self, results: &[f64], resamples: usize) -> Vec<SensitivityIndex> {
        let whole = results.chunks_exact(self.block());
        let blocks: Vec<&[f64]> = whole.filter(|block| block.iter().all(|y| y.is_finite())).collect();
        let all: Vec<usize> = (0..blocks.len()).collect();
        let best = self.estimate(&blocks, &all);
        let mut scatter = vec![(Moments::default(), Moments::default()); self.dimensions];
        for k in 0..resamples as u64 {
            let pick = |i: &usize| (mix(mix(self.seed ^ k) ^ *i as u64) % blocks.len() as u64) as usize;
            let chosen: Vec<usize> = all.iter().map(pick).collect();
            for (moments, index) in scatter.iter_mut().zip(self.estimate(&blocks, &chosen)) {
                moments.0.push(index.0);
                moments.1.push(index.1);
            }
        }
        let index = |((first, total), scatter): ((f64, f64), (Moments, Moments))| SensitivityIndex {
            first,
            first_error: scatter.0.sigma(),
            total,
            total_error: scatter.1.sigma(),
        };
        best.into_iter().zip(scatter).map(index).collect()
    }

    /// First and total index of each input from the chosen blocks.
    fn estimate(&self, blocks: &[&[f64]], chosen: &[usize]) -> Vec<(f64, f64)> {
        let mut moments = Moments::default();
        for &k in chosen {
            moments.push(blocks[k][0]);
            moments.push(blocks[k][1]);
        }
        let (mean, scale) = (moments.mean(), moments.variance() * chosen.len() as f64);
        let mut sums = vec![(0.0, 0.0); self.dimensions];
        for &k in chosen {
            let (a, b) = (blocks[k][0], blocks[k][1]);
            for (sum, ab) in sums.iter_mut().zip(&blocks[k][2..]) {
                sum.0 += (b - mean) * (ab - a);
                sum.1 += 0.5 * (a - ab).powi(2);
            }
        }
        sums.into_iter().map(|(first, total)| (first / scale, total / scale)).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// T. Ishigami and T. Homma (1990): sin x₁ + a sin² x₂ + b x₃⁴ sin x₁ on −π … π.
    fn ishigami(u: &[f64]) -> f64 {
        let x: Vec<f64> = u.iter().map(|u| PI * (2.0 * u - 1.0)).collect();
        x[0].sin() + 7.0 * x[1].sin().powi(2) + 0.1 * x[2].powi(4) * x[0].sin()
    }

    fn results(design: &Saltelli, f: impl Fn(&[f64]) -> f64) -> Vec<f64> {
        (0..design.rows()).map(|row| f(&design.point(row).unwrap())).collect()
    }

    #[test]
    fn ishigamis_function_has_its_analytic_indices() {
        let (a, b) = (7.0, 0.1);
        let v1 = 0.5 * (1.0 + b * PI.powi(4) / 5.0f64).powi(2);
        let (v2, v13) = (a * a / 8.0, b * b * PI.powi(8) * (1.0 / 18.0 - 1.0 / 50.0));
        let v = v1 + v2 + v13;
        let truth = [(v1 / v, (v1 + v13) / v), (v2 / v, v2 / v), (0.0, v13 / v)];
        assert!((truth[0].0 - 0.3139).abs() < 5e-5 && (truth[1].0 - 0.4424).abs() < 5e-5);
        let design = Saltelli::new(8192, 3, 1);
        let indices = design.indices(&results(&design, ishigami), 50);
        for (index, (first, total)) in indices.iter().zip(truth) {
            assert!(
                (index.first - first).abs() < 0.01 && (index.total - total).abs() < 0.01,
                "{index:?} {first} {total}"
            );
            assert!(index.first_error > 0.0 && index.first_error < 0.03 && index.total_error < 0.03);
        }
    }

    #[test]
    fn errors_cover_the_truth_with_random_points() {
        let mut design = Saltelli::new(512, 2, 0);
        design.sobol = None;
        // x₁ + 2 x₂: indices 0.2 and 0.8.
        let mut inside = 0;
        for seed in 0..100 {
            design.seed = seed;
            let index = design.indices(&results(&design, |u| u[0] + 2.0 * u[1]), 60)[0];
            inside += usize::from((index.first - 0.2).abs() < 2.0 * index.first_error);
        }
        assert!((88..=100).contains(&inside), "{inside}");
    }

    #[test]
    fn odd_results_do_not_panic() {
        let design = Saltelli::new(4, 2, 0);
        assert_eq!(design.rows(), 16);
        assert!(design.point(16).is_none());
        assert!(design.indices(&[], 5)[0].first.is_nan());
        assert!(design.indices(&[1.0; 16], 0)[1].total.is_nan());
        assert!(design.indices(&[f64::NAN; 16], 3)[1].total.is_nan());
        assert!(Saltelli::new(3, 0, 0).indices(&[1.0; 6], 3).is_empty());
        assert!(Saltelli::new(2, 40, 0).point(5).is_some());
    }
}
