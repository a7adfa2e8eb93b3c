//! Mean, variance, skewness and kurtosis of numbers that come one by one.

/// Moments of the numbers seen so far. Numbers that are NaN or infinite are counted apart and otherwise ignored.
///
/// One pass and merging after P. Pébay, *Formulas for Robust, One-Pass Parallel Computation of Covariances and
/// Arbitrary-Order Statistical Moments*, SAND2008-6212, equations 2.1 and 3.1; for one number these are B. Welford's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    count: u64,
    ignored: u64,
    mean: f64,
    m2: f64,
    m3: f64,
    m4: f64,
    least: f64,
    greatest: f64,
}

/// No numbers yet.
impl Default for Moments {
    fn default() -> Self {
        let (least, greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        Self { count: 0, ignored: 0, mean: 0.0, m2: 0.0, m3: 0.0, m4: 0.0, least, greatest }
    }
}

impl Moments {
    /// Moments of all numbers of a slice.
    #[must_use]
    pub fn of(values: &[f64]) -> Self {
        let mut moments = Self::default();
        values.iter().for_each(|x| moments.push(*x));
        moments
    }

    /// Adds a number.
    pub fn push(&mut self, x: f64) {
        if !x.is_finite() {
            self.ignored += 1;
            return;
        }
        self.merge(&Self { count: 1, ignored: 0, mean: x, m2: 0.0, m3: 0.0, m4: 0.0, least: x, greatest: x });
    }

    /// Adds all numbers of another.
    pub fn merge(&mut self, other: &Self) {
        self.ignored += other.ignored;
        if other.count == 0 {
            return;
        }
        let (a, b) = (self.count as f64, other.count as f64);
        let n = a + b;
        let (d, share) = (other.mean - self.mean, (other.mean - self.mean) / n);
        let square = d * share * a * b;
        let m4 = square * share * share * (a * a - a * b + b * b)
            + 6.0 * share * share * (a * a * other.m2 + b * b * self.m2)
            + 4.0 * share * (a * other.m3 - b * self.m3);
        let m3 = square * share * (a - b) + 3.0 * share * (a * other.m2 - b * self.m2);
        self.m4 += other.m4 + m4;
        self.m3 += other.m3 + m3;
        self.m2 += other.m2 + square;
        self.mean += b * share;
        self.count += other.count;
        self.least = self.least.min(other.least);
        self.greatest = self.greatest.max(other.greatest);
    }

    /// How many finite numbers there were.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// How many were NaN or infinite.
    #[must_use]
    pub fn ignored(&self) -> u64 {
        self.ignored
    }

    /// The mean; NaN without numbers.
    #[must_use]
    pub fn mean(&self) -> f64 {
        if self.count == 0 { f64::NAN } else { self.mean }
    }

    /// The least number; NaN without numbers.
    #[must_use]
    pub fn least(&self) -> f64 {
        if self.count == 0 { f64::NAN } else { self.least }
    }

    /// The greatest number; NaN without numbers.
    #[must_use]
    pub fn greatest(&self) -> f64 {
        if self.count == 0 { f64::NAN } else { self.greatest }
    }

    /// Unbiased variance (divided by n − 1); NaN below two numbers.
    #[must_use]
    pub fn variance(&self) -> f64 {
        if self.count < 2 { f64::NAN } else { self.m2 / (self.count - 1) as f64 }
    }

    /// Standard deviation, the root of [`Moments::variance`].
    #[must_use]
    pub fn sigma(&self) -> f64 {
        self.variance().sqrt()
    }

    /// Skewness m₃ / m₂^(3/2); NaN without scatter.
    #[must_use]
    pub fn skewness(&self) -> f64 {
        (self.count as f64).sqrt() * self.m3 / self.m2.powf(1.5)
    }

    /// Kurtosis m₄ / m₂²; 3 for a normal distribution; NaN without scatter.
    #[must_use]
    pub fn kurtosis(&self) -> f64 {
        self.count as f64 * self.m4 / (self.m2 * self.m2)
    }

    /// Standard error of the mean, s/√n.
    #[must_use]
    pub fn mean_error(&self) -> f64 {
        self.sigma() / (self.count as f64).sqrt()
    }

    /// Standard error of the standard deviation for any distribution: the variance of s² is σ⁴ (κ − (n−3)/(n−1)) / n
    /// (H. Cramér, *Mathematical Methods of Statistics*, 1946, equation 27.4.2), that of s by the derivative of the root.
    #[must_use]
    pub fn sigma_error(&self) -> f64 {
        let n = self.count as f64;
        let of_variance = (self.kurtosis() - (n - 3.0) / (n - 1.0)).max(0.0) / n;
        0.5 * self.sigma() * of_variance.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{normal::quantile, unit};

    #[test]
    fn moments_agree_with_their_definitions_and_merge() {
        let x: Vec<f64> = (0..1000).map(|i| 1e6 + unit(3, i, 0).powi(3)).collect();
        let all = Moments::of(&x);
        let mean = x.iter().map(|x| x - 1e6).sum::<f64>() / 1000.0;
        let central = |k: i32| x.iter().map(|x| (x - 1e6 - mean).powi(k)).sum::<f64>() / 1000.0;
        assert!((all.mean() - 1e6 - mean).abs() < 1e-8);
        assert!((all.variance() / (central(2) * 1000.0 / 999.0) - 1.0).abs() < 1e-8);
        assert!((all.skewness() / (central(3) / central(2).powf(1.5)) - 1.0).abs() < 1e-7);
        assert!((all.kurtosis() / (central(4) / central(2).powi(2)) - 1.0).abs() < 1e-7);
        let mut parts = Moments::of(&x[..123]);
        parts.merge(&Moments::of(&x[123..]));
        assert!((parts.kurtosis() / all.kurtosis() - 1.0).abs() < 1e-9 && parts.count() == 1000);
        assert_eq!((parts.least(), parts.greatest()), (all.least(), all.greatest()));
    }

    #[test]
    fn the_error_of_sigma_is_the_scatter_of_sigma() {
        for uniform in [false, true] {
            let shape = |u: f64| if uniform { u } else { quantile(u) };
            let sample = |k: u64| Moments::of(&(0..200).map(|i| shape(unit(k, i, 1))).collect::<Vec<_>>());
            let samples: Vec<Moments> = (0..2000).map(sample).collect();
            let scatter = Moments::of(&samples.iter().map(Moments::sigma).collect::<Vec<_>>()).sigma();
            let said = Moments::of(&samples.iter().map(Moments::sigma_error).collect::<Vec<_>>()).mean();
            assert!((said / scatter - 1.0).abs() < 0.06, "uniform {uniform}: {said} {scatter}");
        }
    }

    #[test]
    fn few_numbers_give_nan_and_odd_ones_are_counted() {
        let none = Moments::default();
        assert!(
            none.mean().is_nan() && none.sigma().is_nan() && none.kurtosis().is_nan() && none.sigma_error().is_nan()
        );
        let one = Moments::of(&[2.5, f64::NAN, f64::INFINITY]);
        assert_eq!((one.mean(), one.count(), one.ignored()), (2.5, 1, 2));
        assert!(one.variance().is_nan() && one.mean_error().is_nan());
    }
}
