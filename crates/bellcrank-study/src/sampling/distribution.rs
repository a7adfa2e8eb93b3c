//! How a number scatters about its nominal value.

use super::normal::{density, probability, quantile};

/// A distribution of deviations with mean zero. Widths are taken by magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Anything within ± half_width is equally likely.
    Uniform {
        /// Greatest deviation.
        half_width: f64,
    },
    /// Normal.
    Normal {
        /// Standard deviation.
        sigma: f64,
    },
    /// Normal, but what falls outside is made anew.
    TruncatedNormal {
        /// Standard deviation before the cut.
        sigma: f64,
        /// Greatest deviation.
        half_width: f64,
    },
}

impl Distribution {
    /// The deviation that is not exceeded with probability u in (0, 1): maps points of the unit cube to deviations.
    /// Infinite for a normal one at 0 and 1; NaN outside.
    #[must_use]
    pub fn deviation(&self, u: f64) -> f64 {
        match *self {
            Self::Uniform { half_width } if (0.0..=1.0).contains(&u) => (2.0 * u - 1.0) * half_width.abs(),
            Self::Uniform { .. } => f64::NAN,
            Self::Normal { sigma } => scaled(sigma.abs(), quantile(u)),
            Self::TruncatedNormal { sigma, half_width } => truncated(sigma.abs(), half_width.abs(), u),
        }
    }

    /// Its standard deviation.
    #[must_use]
    pub fn sigma(&self) -> f64 {
        match *self {
            Self::Uniform { half_width } => half_width.abs() / 3f64.sqrt(),
            Self::Normal { sigma } => sigma.abs(),
            Self::TruncatedNormal { sigma, half_width } => {
                let (sigma, k) = (sigma.abs(), half_width.abs() / sigma.abs());
                let inside = 1.0 - 2.0 * probability(-k);
                match k {
                    _ if k.is_nan() => 0.0,
                    // Nearly flat: the formula below would cancel.
                    _ if k < 1e-2 => half_width.abs() / 3f64.sqrt(),
                    _ if k > 40.0 => sigma,
                    _ => sigma * (1.0 - 2.0 * k * density(k) / inside).max(0.0).sqrt(),
                }
            }
        }
    }
}

/// σ x, where no scatter at all beats an infinite quantile.
fn scaled(sigma: f64, x: f64) -> f64 {
    if sigma == 0.0 && !x.is_nan() { 0.0 } else { sigma * x }
}

fn truncated(sigma: f64, half_width: f64, u: f64) -> f64 {
    if !(0.0..=1.0).contains(&u) {
        return f64::NAN;
    }
    if sigma == 0.0 || half_width == 0.0 {
        return 0.0;
    }
    if half_width < 1e-2 * sigma {
        return (2.0 * u - 1.0) * half_width;
    }
    // The lower half serves both: there the probability keeps its digits.
    let (half, sign) = if u > 0.5 { (1.0 - u, -1.0) } else { (u, 1.0) };
    let cut = probability(-half_width / sigma);
    let x = sigma * quantile(cut + half * (1.0 - 2.0 * cut));
    sign * x.max(-half_width)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::unit;

    #[test]
    fn samples_have_the_standard_deviation_that_is_said() {
        let cases = [
            Distribution::Uniform { half_width: 0.3 },
            Distribution::Normal { sigma: 0.2 },
            Distribution::TruncatedNormal { sigma: 0.2, half_width: 0.3 },
            Distribution::TruncatedNormal { sigma: 5.0, half_width: 0.3 },
            Distribution::TruncatedNormal { sigma: 50.0, half_width: 0.3 },
        ];
        for case in cases {
            let n = 200_000;
            let square = (0..n).map(|i| case.deviation(unit(1, i, 0)).powi(2)).sum::<f64>() / n as f64;
            assert!((square.sqrt() / case.sigma() - 1.0).abs() < 0.01, "{case:?}: {}", square.sqrt());
        }
    }

    #[test]
    fn limits_hold_and_nothing_panics() {
        let cut = Distribution::TruncatedNormal { sigma: 1.0, half_width: 2.5 };
        assert!((cut.deviation(0.0) + 2.5).abs() < 1e-12 && (cut.deviation(1.0) - 2.5).abs() < 1e-12);
        assert_eq!(cut.deviation(0.5), 0.0);
        for u in [0.0, 0.3, 1.0, -1.0, f64::NAN] {
            for w in [0.0, -1.0, f64::NAN, f64::INFINITY] {
                let _ = Distribution::Uniform { half_width: w }.deviation(u);
                let _ = Distribution::TruncatedNormal { sigma: w, half_width: 1.0 }.deviation(u);
                let _ = Distribution::TruncatedNormal { sigma: 1.0, half_width: w }.sigma();
                let _ = Distribution::Normal { sigma: w }.deviation(u);
            }
        }
        assert_eq!(Distribution::Normal { sigma: 0.0 }.deviation(0.0), 0.0);
    }
}
