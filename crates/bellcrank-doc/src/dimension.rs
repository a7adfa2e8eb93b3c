//! Physical dimensions: exponents over length, mass, time, angle and temperature.

use std::ops::{Div, Mul};

/// Exponents are kept in twelfths so that square and cube roots stay exact.
const WHOLE: i16 = 12;
const LENGTH: usize = 0;
const MASS: usize = 1;
const TIME: usize = 2;
const ANGLE: usize = 3;
const TEMPERATURE: usize = 4;

/// A dimension: length^a · mass^b · time^c · angle^d · temperature^e.
///
/// Angle is a dimension of its own, so that an angle is never taken for a length or a count.
/// Where engineers drop radians, [`Dimension::agrees`] drops them too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension([i16; 5]);

impl Dimension {
    /// A count, a ratio.
    pub const NONE: Dimension = Dimension::of(0, 0, 0, 0, 0);
    /// m
    pub const LENGTH: Dimension = Dimension::of(1, 0, 0, 0, 0);
    /// m^2
    pub const AREA: Dimension = Dimension::of(2, 0, 0, 0, 0);
    /// m^3
    pub const VOLUME: Dimension = Dimension::of(3, 0, 0, 0, 0);
    /// kg
    pub const MASS: Dimension = Dimension::of(0, 1, 0, 0, 0);
    /// s
    pub const TIME: Dimension = Dimension::of(0, 0, 1, 0, 0);
    /// rad
    pub const ANGLE: Dimension = Dimension::of(0, 0, 0, 1, 0);
    /// K
    pub const TEMPERATURE: Dimension = Dimension::of(0, 0, 0, 0, 1);
    /// 1/s
    pub const FREQUENCY: Dimension = Dimension::of(0, 0, -1, 0, 0);
    /// m/s
    pub const VELOCITY: Dimension = Dimension::of(1, 0, -1, 0, 0);
    /// m/s^2
    pub const ACCELERATION: Dimension = Dimension::of(1, 0, -2, 0, 0);
    /// rad/s
    pub const ANGULAR_VELOCITY: Dimension = Dimension::of(0, 0, -1, 1, 0);
    /// rad/s^2
    pub const ANGULAR_ACCELERATION: Dimension = Dimension::of(0, 0, -2, 1, 0);
    /// N
    pub const FORCE: Dimension = Dimension::of(1, 1, -2, 0, 0);
    /// N*m
    pub const MOMENT: Dimension = Dimension::of(2, 1, -2, 0, 0);
    /// J; the same exponents as a moment
    pub const ENERGY: Dimension = Dimension::MOMENT;
    /// W
    pub const POWER: Dimension = Dimension::of(2, 1, -3, 0, 0);
    /// kg*m^2
    pub const INERTIA: Dimension = Dimension::of(2, 1, 0, 0, 0);
    /// Pa
    pub const PRESSURE: Dimension = Dimension::of(-1, 1, -2, 0, 0);
    /// kg/m^3
    pub const DENSITY: Dimension = Dimension::of(-3, 1, 0, 0, 0);
    /// N/m
    pub const STIFFNESS: Dimension = Dimension::of(0, 1, -2, 0, 0);
    /// N*s/m
    pub const DAMPING: Dimension = Dimension::of(0, 1, -1, 0, 0);
    /// N*m/rad
    pub const TORSIONAL_STIFFNESS: Dimension = Dimension::of(2, 1, -2, -1, 0);
    /// N*m*s/rad
    pub const TORSIONAL_DAMPING: Dimension = Dimension::of(2, 1, -1, -1, 0);

    /// Whole exponents of length, mass, time, angle, temperature (each within ±1000).
    #[must_use]
    pub const fn of(length: i16, mass: i16, time: i16, angle: i16, temperature: i16) -> Dimension {
        Dimension([length * WHOLE, mass * WHOLE, time * WHOLE, angle * WHOLE, temperature * WHOLE])
    }

    /// Exponents of length, mass, time, angle, temperature.
    pub(crate) fn exponents(self) -> [f64; 5] {
        self.0.map(|e| f64::from(e) / f64::from(WHOLE))
    }

    /// Whether all exponents are zero.
    #[must_use]
    pub fn is_none(self) -> bool {
        self == Dimension::NONE
    }

    /// `self^(exponent)`; `None` when the result has no exponents in twelfths or leaves their range.
    #[must_use]
    pub fn power(self, exponent: f64) -> Option<Dimension> {
        let mut result = Dimension::NONE;
        for (to, from) in result.0.iter_mut().zip(self.0) {
            let exact = f64::from(from) * exponent;
            // 1/3 is not exact in binary; a rounding this small is meant as the fraction.
            let whole = exact.round();
            if (exact - whole).abs() > 1e-9 || whole.abs() > f64::from(MAX_EXPONENT) {
                return None;
            }
            *to = whole as i16;
        }
        Some(result)
    }

    /// Whether a value of this dimension may stand where `other` is wanted.
    ///
    /// Exponents must be equal, except that of angle: engineers write the moment of a torsion
    /// spring in N*m and its stiffness in N*m or N*m/rad, and r*phi is a length. So angle counts
    /// only for what is made of angle, time and temperature alone: an angle is no count, and
    /// 10 Hz no angular velocity.
    #[must_use]
    pub fn agrees(self, other: Dimension) -> bool {
        let strict = self.0[LENGTH] == 0 && self.0[MASS] == 0;
        let kind = |d: Dimension| (d.0[LENGTH], d.0[MASS], d.0[TIME], d.0[TEMPERATURE]);
        kind(self) == kind(other) && (!strict || self.0[ANGLE] == other.0[ANGLE])
    }

    /// Of two dimensions that agree, the one with less angle in it.
    #[must_use]
    pub(crate) fn plainer(self, other: Dimension) -> Dimension {
        if other.0[ANGLE].abs() < self.0[ANGLE].abs() { other } else { self }
    }

    /// Product, `None` when an exponent leaves the range (`x^90*x^90`).
    #[must_use]
    pub fn times(self, other: Dimension) -> Option<Dimension> {
        combine(self, other, 1)
    }

    /// Quotient, `None` when an exponent leaves the range.
    #[must_use]
    pub fn over(self, other: Dimension) -> Option<Dimension> {
        combine(self, other, -1)
    }
}

/// Exponents beyond ±100 mean a slip, not a quantity.
const MAX_EXPONENT: i16 = 100 * WHOLE;

fn combine(a: Dimension, b: Dimension, sign: i16) -> Option<Dimension> {
    let mut result = a;
    for (to, from) in result.0.iter_mut().zip(b.0) {
        *to += sign * from;
        if to.abs() > MAX_EXPONENT {
            return None;
        }
    }
    Some(result)
}

impl Mul for Dimension {
    type Output = Dimension;

    /// For dimensions known to be small; exponents stop at ±100.
    fn mul(self, other: Dimension) -> Dimension {
        self.times(other).unwrap_or(self)
    }
}

impl Div for Dimension {
    type Output = Dimension;

    /// For dimensions known to be small; exponents stop at ±100.
    fn div(self, other: Dimension) -> Dimension {
        self.over(other).unwrap_or(self)
    }
}

#[cfg(test)]
mod tests {
    use super::Dimension as D;

    #[test]
    fn angle_counts_only_where_nothing_else_tells() {
        let agree = [
            (D::MOMENT, D::TORSIONAL_STIFFNESS),
            (D::INERTIA * D::ANGULAR_ACCELERATION, D::MOMENT),
            (D::LENGTH * D::ANGLE, D::LENGTH),
            (D::LENGTH * D::ANGULAR_VELOCITY, D::VELOCITY),
        ];
        let differ = [
            (D::ANGLE, D::NONE),
            (D::FREQUENCY, D::ANGULAR_VELOCITY),
            (D::LENGTH, D::ANGLE),
            (D::FORCE, D::MOMENT),
            (D::ANGULAR_ACCELERATION, D::ANGULAR_VELOCITY),
        ];
        assert!(agree.iter().all(|&(a, b)| a.agrees(b) && b.agrees(a)));
        assert!(differ.iter().all(|&(a, b)| !a.agrees(b) && !b.agrees(a)));
    }

    #[test]
    fn powers_and_words() {
        assert_eq!(D::AREA.power(0.5), Some(D::LENGTH));
        assert_eq!(D::VOLUME.power(1.0 / 3.0), Some(D::LENGTH));
        assert_eq!(D::LENGTH.power(0.001), None);
        assert_eq!(D::LENGTH.power(200.0), None);
        assert_eq!(D::ANGLE.phrase(), "an angle");
        assert_eq!((D::MASS * D::LENGTH).phrase(), "a value in kg*m");
        assert_eq!((D::MASS / D::LENGTH / D::ANGLE).unit(), "kg/(m*rad)");
        assert_eq!(D::LENGTH.power(0.5).map(D::unit), Some("m^0.5".to_owned()));
    }
}
