//! How often numbers fall into equal intervals.

use super::quantiles::Sorted;

/// Counts in equal bins between two ends. A number on the inner edge of two bins counts in the upper one, one on the upper
/// end in the last.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    low: f64,
    high: f64,
    counts: Vec<u64>,
    outside: u64,
}

impl Histogram {
    /// Empty bins, at least one; `None` unless both ends are finite and low < high.
    #[must_use]
    pub fn new(low: f64, high: f64, bins: usize) -> Option<Self> {
        let good = low.is_finite() && high.is_finite() && low < high;
        good.then(|| Self { low, high, counts: vec![0; bins.max(1)], outside: 0 })
    }

    /// Adds a number; outside the ends (or NaN) it is counted apart.
    pub fn push(&mut self, x: f64) {
        if !(self.low..=self.high).contains(&x) {
            self.outside += 1;
            return;
        }
        let share = (x - self.low) / (self.high - self.low);
        let bin = (share * self.counts.len() as f64) as usize;
        let last = self.counts.len() - 1;
        self.counts[bin.min(last)] += 1;
    }

    /// How many numbers fell into each bin.
    #[must_use]
    pub fn counts(&self) -> &[u64] {
        &self.counts
    }

    /// How many fell outside.
    #[must_use]
    pub fn outside(&self) -> u64 {
        self.outside
    }

    /// Edges of the bins, one more than bins.
    #[must_use]
    pub fn edges(&self) -> Vec<f64> {
        let n = self.counts.len();
        let edge =
            |k: usize| if k == n { self.high } else { self.low + (self.high - self.low) * (k as f64 / n as f64) };
        (0..=n).map(edge).collect()
    }
}

/// A good number of bins for a sample: width 2 IQR n^(−1/3) (D. Freedman and P. Diaconis, 1981), between 1 and `most`.
#[must_use]
pub fn freedman_diaconis(sample: &Sorted, most: usize) -> usize {
    let (low, high) = (sample.quantile(0.0), sample.quantile(1.0));
    let width = 2.0 * (sample.quantile(0.75) - sample.quantile(0.25)) / (sample.values().len() as f64).cbrt();
    // Not a number and infinity become 0 and the greatest integer.
    let bins = ((high - low) / width).ceil() as usize;
    bins.clamp(1, most.max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_counted_once() {
        let mut h = Histogram::new(-1.0, 1.0, 4).unwrap();
        [-1.0, -0.5, -0.2, 0.0, 0.49, 0.5, 1.0, 1.1, f64::NAN].iter().for_each(|x| h.push(*x));
        assert_eq!((h.counts(), h.outside()), (&[1, 2, 2, 2][..], 2));
        assert_eq!(h.edges(), [-1.0, -0.5, 0.0, 0.5, 1.0]);
    }

    #[test]
    fn the_number_of_bins_is_sensible() {
        let sample = Sorted::new((0..1000).map(f64::from).collect());
        assert_eq!(freedman_diaconis(&sample, 50), 10);
        assert_eq!(freedman_diaconis(&Sorted::new(vec![3.0; 9]), 50), 1);
        assert_eq!(freedman_diaconis(&Sorted::new(vec![]), 50), 1);
        assert!(Histogram::new(1.0, 1.0, 3).is_none() && Histogram::new(f64::NAN, 1.0, 3).is_none());
        assert_eq!(Histogram::new(0.0, 1.0, 0).unwrap().counts().len(), 1);
    }
}
