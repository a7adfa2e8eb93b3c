//! How many parts are good, and how capable a process is.

use crate::sampling::normal::{probability, quantile};

/// A share with its confidence interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proportion {
    /// Good ones over all; NaN of none.
    pub estimate: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// Share of `good` among `total` with the two-sided interval of E. Wilson (J. Am. Stat. Assoc. 22 (1927) 209), which is
/// sensible at 0 and 100 %, too. `confidence` between 0 and 1, e.g. 0.95. More good ones than all count as all.
#[must_use]
pub fn wilson(good: u64, total: u64, confidence: f64) -> Proportion {
    if total == 0 {
        return Proportion { estimate: f64::NAN, low: 0.0, high: 1.0 };
    }
    let (n, p) = (total as f64, good.min(total) as f64 / total as f64);
    let z = quantile(0.5 + 0.5 * confidence);
    let z2 = z * z / n;
    let centre = (p + 0.5 * z2) / (1.0 + z2);
    let half = (p * (1.0 - p) * z2 + 0.25 * z2 * z2).sqrt() / (1.0 + z2);
    // At the ends the interval ends there exactly, not within rounding.
    let low = if good == 0 { 0.0 } else { (centre - half).max(0.0) };
    let high = if good >= total { 1.0 } else { (centre + half).min(1.0) };
    Proportion { estimate: p, low, high }
}

/// Specification limits; either may be absent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Least good value.
    pub lower: Option<f64>,
    /// Greatest good value.
    pub upper: Option<f64>,
}

impl Limits {
    /// Whether a value is good; NaN is not.
    #[must_use]
    pub fn holds(&self, x: f64) -> bool {
        !x.is_nan() && self.lower.is_none_or(|l| x >= l) && self.upper.is_none_or(|u| x <= u)
    }
}

/// Process capability (ISO 22514-2, 6.2: with 6 σ as the width of the process).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capability {
    /// (upper − lower) / 6σ; NaN unless there are two limits.
    pub cp: f64,
    /// Distance from the mean to the nearer limit over 3σ; infinite without limits.
    pub cpk: f64,
    /// Share of good ones if the distribution were normal.
    pub normal_yield: f64,
}

/// Capability of a process of given mean and standard deviation. With σ = 0 the indices are infinite with the sign of the
/// distance to the limit.
#[must_use]
pub fn capability(mean: f64, sigma: f64, limits: &Limits) -> Capability {
    let below = limits.lower.map_or(f64::INFINITY, |l| (mean - l) / sigma);
    let above = limits.upper.map_or(f64::INFINITY, |u| (u - mean) / sigma);
    let cp = match (limits.lower, limits.upper) {
        (Some(l), Some(u)) => (u - l) / (6.0 * sigma),
        _ => f64::NAN,
    };
    let cpk = if below.is_nan() || above.is_nan() { f64::NAN } else { below.min(above) / 3.0 };
    Capability { cp, cpk, normal_yield: 1.0 - probability(-below) - probability(-above) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wilson_intervals_agree_with_published_ones() {
        // R. Newcombe, Stat. Med. 17 (1998) 857, table I, method 3.
        let table =
            [(81, 263, 0.2553, 0.3662), (15, 148, 0.0624, 0.1605), (0, 20, 0.0, 0.1611), (1, 29, 0.0061, 0.1718)];
        for (good, total, low, high) in table {
            let p = wilson(good, total, 0.95);
            assert!((p.low - low).abs() < 5.1e-5 && (p.high - high).abs() < 5.1e-5, "{good}/{total} {p:?}");
        }
        assert_eq!(wilson(20, 20, 0.95).high, 1.0);
        assert!(wilson(0, 0, 0.95).estimate.is_nan());
        assert_eq!(wilson(9, 7, 0.95).estimate, 1.0);
    }

    #[test]
    fn capability_of_three_sigma_is_one() {
        let both = Limits { lower: Some(-0.3), upper: Some(0.3) };
        let c = capability(0.0, 0.1, &both);
        assert!((c.cp - 1.0).abs() < 1e-12 && (c.cpk - 1.0).abs() < 1e-12);
        assert!((c.normal_yield - 0.997_300_203_936_739_8).abs() < 1e-14);
        let c = capability(0.1, 0.1, &both);
        assert!((c.cp - 1.0).abs() < 1e-12 && (c.cpk - 2.0 / 3.0).abs() < 1e-12);
        let one = capability(0.0, 0.1, &Limits { lower: None, upper: Some(0.2) });
        assert!(one.cp.is_nan() && (one.cpk - 2.0 / 3.0).abs() < 1e-12);
        assert!((one.normal_yield - 0.977_249_868_051_820_8).abs() < 1e-14);
        assert!(both.holds(0.3) && !both.holds(0.31) && !both.holds(f64::NAN));
        assert_eq!(capability(0.0, 0.0, &both).cpk, f64::INFINITY);
    }
}
