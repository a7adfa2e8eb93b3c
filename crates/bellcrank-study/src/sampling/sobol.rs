//! Sobol' points with a random scrambling, each computed from its number.
//!
//! I. Sobol', USSR Comput. Math. Math. Phys. 7 (1967) 86; the recurrence of the direction numbers as in P. Bratley and B.
//! Fox, ACM Trans. Math. Softw. 14 (1988) 88, equation 2. Owen's nested scrambling by hashing bits from above: B. Burley,
//! *Practical Hash-based Owen Scrambling*, J. Comput. Graph. Tech. 9 (2020) 1.

use super::random::{mix, to_unit};

/// Polynomials with their first direction numbers m₁, m₂, … for dimension 1 and on (dimension 0 is the van der Corput
/// sequence). The polynomials are the first primitive ones; the numbers were searched for good projections onto two
/// dimensions: as (t, m)-nets, all pairs of the first ten dimensions have t ≤ 4 at 2^14 points, all pairs t ≤ 8.
#[rustfmt::skip]
const DIMENSIONS: [(u32, &[u32]); 63] = [
    (0b11, &[1]),
    (0b111, &[1, 1]),
    (0b1011, &[1, 1, 5]),
    (0b1101, &[1, 3, 1]),
    (0b10011, &[1, 3, 3, 1]),
    (0b11001, &[1, 3, 1, 13]),
    (0b100101, &[1, 1, 1, 15, 23]),
    (0b101001, &[1, 3, 7, 5, 17]),
    (0b101111, &[1, 1, 5, 7, 9]),
    (0b110111, &[1, 1, 3, 13, 13]),
    (0b111011, &[1, 1, 5, 1, 29]),
    (0b111101, &[1, 3, 1, 7, 5]),
    (0b1000011, &[1, 1, 5, 15, 29, 35]),
    (0b1011011, &[1, 3, 7, 13, 15, 37]),
    (0b1100001, &[1, 3, 7, 1, 19, 15]),
    (0b1100111, &[1, 1, 3, 15, 1, 15]),
    (0b1101101, &[1, 3, 3, 9, 27, 25]),
    (0b1110011, &[1, 3, 3, 3, 29, 7]),
    (0b10000011, &[1, 3, 5, 11, 11, 23, 101]),
    (0b10001001, &[1, 1, 7, 5, 13, 39, 17]),
    (0b10001111, &[1, 1, 7, 9, 7, 7, 5]),
    (0b10010001, &[1, 3, 3, 11, 31, 41, 71]),
    (0b10011101, &[1, 1, 3, 11, 15, 51, 121]),
    (0b10100111, &[1, 1, 3, 13, 15, 37, 51]),
    (0b10101011, &[1, 1, 7, 15, 5, 7, 57]),
    (0b10111001, &[1, 1, 3, 3, 17, 15, 3]),
    (0b10111111, &[1, 1, 1, 11, 19, 25, 125]),
    (0b11000001, &[1, 1, 1, 3, 13, 37, 59]),
    (0b11001011, &[1, 1, 1, 3, 1, 5, 101]),
    (0b11010011, &[1, 1, 7, 7, 11, 29, 55]),
    (0b11010101, &[1, 3, 1, 3, 17, 45, 109]),
    (0b11100101, &[1, 1, 3, 5, 5, 51, 67]),
    (0b11101111, &[1, 3, 5, 13, 13, 23, 73]),
    (0b11110001, &[1, 1, 7, 9, 7, 25, 91]),
    (0b11110111, &[1, 1, 5, 5, 23, 21, 9]),
    (0b11111101, &[1, 3, 5, 15, 5, 47, 107]),
    (0b100011101, &[1, 3, 7, 7, 19, 5, 95, 205]),
    (0b100101011, &[1, 1, 7, 15, 29, 49, 65, 85]),
    (0b100101101, &[1, 3, 1, 15, 9, 47, 79, 135]),
    (0b101001101, &[1, 3, 3, 13, 17, 49, 87, 213]),
    (0b101011111, &[1, 1, 1, 9, 11, 27, 79, 151]),
    (0b101100011, &[1, 3, 5, 15, 23, 3, 37, 133]),
    (0b101100101, &[1, 1, 7, 11, 29, 9, 83, 203]),
    (0b101101001, &[1, 1, 5, 15, 25, 35, 33, 113]),
    (0b101110001, &[1, 1, 5, 3, 1, 41, 15, 83]),
    (0b110000111, &[1, 3, 1, 7, 15, 57, 107, 65]),
    (0b110001101, &[1, 3, 3, 13, 7, 63, 21, 209]),
    (0b110101001, &[1, 3, 3, 7, 19, 5, 37, 239]),
    (0b111000011, &[1, 3, 7, 1, 21, 59, 7, 187]),
    (0b111001111, &[1, 3, 5, 5, 17, 59, 107, 165]),
    (0b111100111, &[1, 1, 3, 5, 25, 33, 11, 221]),
    (0b111110101, &[1, 3, 3, 11, 31, 61, 63, 123]),
    (0b1000010001, &[1, 1, 3, 9, 19, 39, 79, 9, 151]),
    (0b1000011011, &[1, 3, 5, 15, 13, 15, 57, 177, 141]),
    (0b1000100001, &[1, 1, 5, 11, 27, 11, 59, 59, 455]),
    (0b1000101101, &[1, 3, 7, 13, 9, 59, 89, 43, 139]),
    (0b1000110011, &[1, 1, 3, 3, 7, 7, 117, 197, 213]),
    (0b1001011001, &[1, 1, 7, 9, 3, 51, 49, 91, 41]),
    (0b1001011111, &[1, 1, 7, 7, 9, 13, 81, 95, 219]),
    (0b1001101001, &[1, 3, 3, 3, 19, 51, 53, 47, 295]),
    (0b1001101111, &[1, 1, 7, 9, 7, 35, 11, 71, 163]),
    (0b1001110111, &[1, 3, 5, 5, 13, 57, 7, 149, 129]),
    (0b1001111101, &[1, 1, 5, 3, 11, 59, 81, 129, 399]),
];

/// Direction numbers of one dimension.
type Directions = [u32; 32];

/// Why there is no such sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SobolError {
    /// More dimensions than there are direction numbers for.
    Dimensions {
        /// What was asked.
        asked: usize,
        /// What there is.
        most: usize,
    },
}

impl std::fmt::Display for SobolError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self::Dimensions { asked, most } = self;
        write!(f, "a Sobol' sequence of {asked} dimensions, {most} are possible")
    }
}

impl std::error::Error for SobolError {}

/// A scrambled Sobol' sequence: up to 64 dimensions, 2^32 points.
#[derive(Clone, Debug)]
pub struct Sobol {
    directions: Vec<Directions>,
    seed: u64,
}

impl Sobol {
    /// The greatest number of dimensions.
    pub const DIMENSIONS: usize = DIMENSIONS.len() + 1;
    /// The number of points.
    pub const POINTS: u64 = 1 << 32;

    /// So many dimensions; every seed gives another scrambling, and each is as even as the plain sequence.
    ///
    /// # Errors
    ///
    /// [`SobolError`] above [`Sobol::DIMENSIONS`].
    pub fn new(dimensions: usize, seed: u64) -> Result<Self, SobolError> {
        if dimensions > Self::DIMENSIONS {
            return Err(SobolError::Dimensions { asked: dimensions, most: Self::DIMENSIONS });
        }
        Ok(Self { directions: (0..dimensions).map(directions).collect(), seed })
    }

    /// Point `index` in the open unit cube; `None` from [`Sobol::POINTS`] on. The first 2^k points are evenest.
    #[must_use]
    pub fn point(&self, index: u64) -> Option<Vec<f64>> {
        let index = u32::try_from(index).ok()?;
        let coordinate = |(j, v): (usize, &Directions)| {
            let key = mix(mix(self.seed) ^ j as u64);
            let high = scrambled(digits(v, index), key);
            // Below the digits of the net everything is random: 20 further bits.
            to_unit((u64::from(high) << 32) | (mix(key ^ u64::from(index)) >> 32))
        };
        Some(self.directions.iter().enumerate().map(coordinate).collect())
    }
}

/// The plain sequence as 32 binary digits.
fn digits(directions: &Directions, index: u32) -> u32 {
    (0..32).filter(|k| index >> k & 1 == 1).fold(0, |x, k| x ^ directions[k])
}

fn directions(dimension: usize) -> Directions {
    let Some(&(polynomial, first)) = dimension.checked_sub(1).and_then(|k| DIMENSIONS.get(k)) else {
        return std::array::from_fn(|k| 1 << (31 - k));
    };
    let degree = first.len();
    let mut m = [0u64; 32];
    for k in 0..32 {
        m[k] = if k < degree { u64::from(first[k]) } else { recurrence(&m, k, polynomial, degree) };
    }
    std::array::from_fn(|k| (m[k] << (31 - k)) as u32)
}

/// m_k = 2 a₁ m_{k−1} ⊕ … ⊕ 2^s m_{k−s} ⊕ m_{k−s}.
fn recurrence(m: &[u64; 32], k: usize, polynomial: u32, degree: usize) -> u64 {
    let last = m[k - degree] ^ (m[k - degree] << degree);
    (1..degree).filter(|i| polynomial >> (degree - i) & 1 == 1).fold(last, |sum, i| sum ^ (m[k - i] << i))
}

/// Each binary digit is flipped or not by a hash of all digits above it.
fn scrambled(x: u32, key: u64) -> u32 {
    let flip = |k: u32| {
        let above = if k == 0 { 0 } else { u64::from(x >> (32 - k)) };
        (mix(key ^ (u64::from(k) << 56) ^ above) >> 63) as u32
    };
    (0..32).fold(x, |y, k| y ^ (flip(k) << (31 - k)))
}

#[cfg(test)]
mod tests;
