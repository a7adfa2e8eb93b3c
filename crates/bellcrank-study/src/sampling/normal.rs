//! The normal distribution: density, probability, quantile.

use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};

/// Density of the standard normal distribution.
#[must_use]
pub fn density(x: f64) -> f64 {
    (-0.5 * x * x).exp() / (2.0 * PI).sqrt()
}

/// Probability that a standard normal number is at most x, to about 1e-15 relative in the lower tail.
#[must_use]
pub fn probability(x: f64) -> f64 {
    0.5 * complement(-x * FRAC_1_SQRT_2)
}

/// 1 − erf(x): a series near zero (M. Abramowitz and I. Stegun, 7.1.6), a continued fraction beyond (7.1.14).
fn complement(x: f64) -> f64 {
    match x {
        _ if x.is_nan() => f64::NAN,
        _ if x < 2.0 && x > -2.0 => 1.0 - error_series(x),
        _ if x < 0.0 => 2.0 - complement(-x),
        _ if x > 27.3 => 0.0,
        _ => (-x * x).exp() / PI.sqrt() / fraction(x),
    }
}

/// erf x = 2/√π e^(−x²) Σ 2ⁿ x^(2n+1) / (1·3·…·(2n+1)).
fn error_series(x: f64) -> f64 {
    let (mut term, mut sum, mut n) = (x, x, 1.0);
    while f64::abs(term) > 1e-18 * f64::abs(sum) {
        term *= 2.0 * x * x / (2.0 * n + 1.0);
        sum += term;
        n += 1.0;
    }
    2.0 / PI.sqrt() * (-x * x).exp() * sum
}

/// x + (1/2)/(x + 1/(x + (3/2)/(x + …))), from below.
fn fraction(x: f64) -> f64 {
    let terms = (200.0 / x) as u32 + 20;
    (1..=terms).rev().fold(x, |f, k| x + 0.5 * f64::from(k) / f)
}

/// The x with probability u: −∞ at 0, ∞ at 1, NaN outside. To about 1e-15 relative.
///
/// Start: 26.2.23 of Abramowitz and Stegun; then Halley's iteration on the probability of the nearer tail.
#[must_use]
pub fn quantile(u: f64) -> f64 {
    match u {
        _ if !(0.0..=1.0).contains(&u) => f64::NAN,
        0.0 => f64::NEG_INFINITY,
        1.0 => f64::INFINITY,
        0.5 => 0.0,
        _ if u > 0.5 => -lower(1.0 - u),
        _ => lower(u),
    }
}

/// The quantile of 0 < u < ½.
fn lower(u: f64) -> f64 {
    let t = (-2.0 * u.ln()).sqrt();
    let top = 2.515_517 + t * (0.802_853 + t * 0.010_328);
    let mut x = top / (1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308))) - t;
    for _ in 0..3 {
        let step = excess(x, u);
        x -= step / (1.0 + 0.5 * x * step);
    }
    x
}

/// (Φ(x) − u) / φ(x). Near the centre Φ(x) − ½ is added up without cancellation.
fn excess(x: f64, u: f64) -> f64 {
    let difference = if x > -1.0 { (0.5 - u) + 0.5 * error_series(x / SQRT_2) } else { probability(x) - u };
    difference / density(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// M. Wichura, Algorithm AS 241, Appl. Statist. 37 (1988) 477: its three test values; and common tables. The last value
    /// is from the C library's `erfc`.
    #[test]
    fn quantiles_agree_with_published_values() {
        let table = [
            (0.25, -0.674_489_750_196_081_7),
            (0.001, -3.090_232_306_167_814),
            (1e-20, -9.262_340_089_798_408),
            (0.975, 1.959_963_984_540_054),
            (0.05, -1.644_853_626_951_472_9),
            (0.995, 2.575_829_303_548_901),
            (1e-300, -37.047_096_299_361_2),
        ];
        for (u, x) in table {
            assert!(
                (quantile(u) - x).abs() < 2e-15 * x.abs().max(1.0) + if u < 1e-100 { 1e-11 } else { 0.0 },
                "{u}: {}",
                quantile(u)
            );
        }
    }

    #[test]
    fn probability_and_quantile_undo_each_other() {
        for k in 1..1000 {
            let u = f64::from(k) / 1000.0;
            assert!((probability(quantile(u)) - u).abs() < 4e-16, "{u}");
        }
        assert!((probability(-6.0) - 9.865_876_450_376_98e-10).abs() < 1e-23);
        assert!((probability(3.0) - 0.998_650_101_968_369_9).abs() < 1e-15);
        assert!((probability(1.0) - 0.841_344_746_068_542_9).abs() < 1e-15);
    }

    #[test]
    fn ends_are_infinite_and_the_outside_is_nothing() {
        assert_eq!((quantile(0.0), quantile(1.0), quantile(0.5)), (f64::NEG_INFINITY, f64::INFINITY, 0.0));
        assert!(quantile(-0.1).is_nan() && quantile(f64::NAN).is_nan() && probability(f64::NAN).is_nan());
        assert_eq!((probability(f64::INFINITY), probability(f64::NEG_INFINITY)), (1.0, 0.0));
    }
}
