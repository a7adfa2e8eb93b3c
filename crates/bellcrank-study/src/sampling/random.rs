//! Random numbers without a state: number k of sample i of a seed is a function of the three.

/// A good 64-bit mixing of one word (the finalizer of SplitMix64, Steele, Lea and Flood, OOPSLA 2014, variant 13 of
/// D. Stafford).
#[must_use]
pub fn mix(word: u64) -> u64 {
    let word = word.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    word ^ (word >> 31)
}

/// A number in the open interval (0, 1) that depends on seed, sample and dimension alone.
#[must_use]
pub fn unit(seed: u64, sample: u64, dimension: u64) -> f64 {
    to_unit(mix(mix(mix(seed) ^ sample) ^ dimension))
}

/// Sample `index` of independent uniform numbers in the open unit cube.
#[must_use]
pub fn random_point(seed: u64, index: u64, dimensions: usize) -> Vec<f64> {
    (0..dimensions as u64).map(|j| unit(seed, index, j)).collect()
}

/// The upper 52 bits as the middle of one of 2^52 equal cells: never 0, never 1.
pub(crate) fn to_unit(word: u64) -> f64 {
    ((word >> 12) as f64 + 0.5) * (1.0 / (1u64 << 52) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_inside_the_open_interval_and_even() {
        assert!(to_unit(0) > 0.0 && to_unit(u64::MAX) < 1.0);
        let n = 100_000;
        let mean = (0..n).map(|i| unit(7, i, 3)).sum::<f64>() / n as f64;
        let product = (0..n).map(|i| (unit(7, i, 3) - 0.5) * (unit(7, i, 4) - 0.5)).sum::<f64>() / n as f64;
        assert!((mean - 0.5).abs() < 4.0 * 0.289 / (n as f64).sqrt());
        assert!(product.abs() < 4.0 / 12.0 / (n as f64).sqrt());
    }
}
