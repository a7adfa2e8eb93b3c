//! Full rectangle.

use bellcrank_math::Real;

use super::{Section, SectionFault, SectionPoint, ShearRule, positive};

impl<T: Real> Section<T> {
    /// Full rectangle: `width` along y, `height` along z, m. Points: four corners, then the middles of the sides at +y, −y,
    /// +z, −z with torsion by Saint-Venant and shear 1.5 V/A.
    ///
    /// # Errors
    /// A size that is not positive.
    pub fn rectangle(width: T, height: T, rule: ShearRule<T>) -> Result<Self, SectionFault> {
        positive(&[("width", width), ("height", height)])?;
        let area = width * height;
        let twelfth = T::from_f64(1.0 / 12.0);
        let twist = Twist::of(width, height);
        Ok(Self {
            area,
            second: [twelfth * area * height * height, twelfth * area * width * width],
            torsion: twist.constant,
            shear: rule.coefficients(|poisson| [cowper(poisson); 2]),
            points: points(width, height, &twist),
        })
    }
}

/// Shear coefficient of a rectangle after Cowper: the same for every ratio of the sides.
pub(super) fn cowper<T: Real>(poisson: T) -> T {
    let c = T::from_f64;
    c(10.0) * (c(1.0) + poisson) / (c(12.0) + c(11.0) * poisson)
}

fn points<T: Real>(width: T, height: T, twist: &Twist<T>) -> Vec<SectionPoint<T>> {
    let half = T::from_f64(0.5);
    let (y, z) = (half * width, half * height);
    let mut points: Vec<SectionPoint<T>> =
        [[y, z], [-y, z], [-y, -z], [y, -z]].map(|place| SectionPoint { place, ..SectionPoint::default() }).to_vec();
    let mean = T::from_f64(1.5) / (width * height);
    let zero = T::zero();
    for sign in [T::one(), -T::one()] {
        let torsion = [zero, sign * twist.at_y];
        points.push(SectionPoint {
            place: [sign * y, zero],
            shear_z: [zero, mean],
            torsion,
            ..SectionPoint::default()
        });
    }
    for sign in [T::one(), -T::one()] {
        let torsion = [-sign * twist.at_z, zero];
        points.push(SectionPoint {
            place: [zero, sign * z],
            shear_y: [mean, zero],
            torsion,
            ..SectionPoint::default()
        });
    }
    points
}

/// Saint-Venant's torsion. Source: S. P. Timoshenko and J. N. Goodier, *Theory of Elasticity*, 3rd edition, art. 109.
struct Twist<T> {
    /// J, m⁴.
    constant: T,
    /// Shear stress in the middle of the sides at ±y and at ±z for a torque of 1, 1/m³.
    at_y: T,
    at_z: T,
}

impl<T: Real> Twist<T> {
    fn of(width: T, height: T) -> Self {
        let upright = height.value() >= width.value();
        let (long, short) = if upright { (height, width) } else { (width, height) };
        let (constant, on_long, on_short) = series(long, short);
        // The longer sides of an upright rectangle are those at ±y.
        let (at_y, at_z) = if upright { (on_long, on_short) } else { (on_short, on_long) };
        Self { constant, at_y, at_z }
    }
}

/// J and the stresses a torque in the middle of the longer and of the shorter sides. The sums over odd n are taken of the
/// small differences from their limits for a thin strip, which fall like exp(−nπ).
fn series<T: Real>(long: T, short: T) -> (T, T, T) {
    const ZETA_5: f64 = 1.036_927_755_143_37;
    const CATALAN: f64 = 0.915_965_594_177_219;
    let c = T::from_f64;
    let pi = std::f64::consts::PI;
    let (mut fifth, mut on_long, mut on_short) = (c(ZETA_5 * 31.0 / 32.0), T::zero(), c(CATALAN));
    for k in 0..12 {
        let n = f64::from(2 * k + 1);
        let small = (-(c(n * pi / 2.0) * long / short)).exp();
        let share = T::one() / (T::one() + small * small);
        // 1 − tanh and 1 / cosh.
        let (gap, bell) = (c(2.0) * small * small * share, c(2.0) * small * share);
        fifth -= gap * c(n.powi(-5));
        on_long += bell * c(1.0 / (n * n));
        on_short -= gap * c(if k % 2 == 0 { 1.0 } else { -1.0 } / (n * n));
    }
    let ratio = short / long;
    let constant = long * short * short * short * (c(1.0 / 3.0) - c(64.0 / pi.powi(5)) * ratio * fifth);
    let eight = c(8.0 / (pi * pi));
    (constant, short / constant * (T::one() - eight * on_long), short / constant * eight * on_short)
}
