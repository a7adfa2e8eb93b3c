//! Quantiles of a sample.

/// The finite numbers of a sample in ascending order.
#[derive(Clone, Debug, PartialEq)]
pub struct Sorted {
    values: Vec<f64>,
}

impl Sorted {
    /// Sorts a sample; NaN and infinite numbers are left out.
    #[must_use]
    pub fn new(mut values: Vec<f64>) -> Self {
        values.retain(|x| x.is_finite());
        values.sort_unstable_by(f64::total_cmp);
        Self { values }
    }

    /// The numbers in ascending order.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// The number below which a share p of the sample lies, linear between the order statistics: definition 7 of R. Hyndman
    /// and Y. Fan, Am. Stat. 50 (1996) 361, as in R, numpy and Excel. NaN for an empty sample or p outside 0 to 1.
    #[must_use]
    pub fn quantile(&self, p: f64) -> f64 {
        if self.values.is_empty() || !(0.0..=1.0).contains(&p) {
            return f64::NAN;
        }
        let place = p * (self.values.len() - 1) as f64;
        let below = place.floor() as usize;
        let (low, high) = (self.values[below], self.values[(below + 1).min(self.values.len() - 1)]);
        low + (place - below as f64) * (high - low)
    }

    /// The median.
    #[must_use]
    pub fn median(&self) -> f64 {
        self.quantile(0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_lie_between_the_numbers() {
        let sorted = Sorted::new(vec![7.0, 1.0, f64::NAN, 3.0, 4.0]);
        // numpy.quantile([1, 3, 4, 7], [0, 0.1, 0.5, 0.9, 1]).
        let expected = [(0.0, 1.0), (0.1, 1.6), (0.5, 3.5), (0.9, 6.1), (1.0, 7.0)];
        assert!(expected.iter().all(|(p, x)| (sorted.quantile(*p) - x).abs() < 1e-14));
        assert!(sorted.quantile(1.1).is_nan() && sorted.quantile(f64::NAN).is_nan());
        assert!(Sorted::new(vec![]).median().is_nan());
    }
}
