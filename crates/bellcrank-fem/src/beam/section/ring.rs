//! Circle and tube.

use bellcrank_math::Real;

use super::{Section, SectionFault, SectionPoint, ShearRule, below, positive};

impl<T: Real> Section<T> {
    /// Full circle, `diameter` in m. Points: eight on the rim, from +y to +z.
    ///
    /// # Errors
    /// A diameter that is not positive.
    pub fn circle(diameter: T, rule: ShearRule<T>) -> Result<Self, SectionFault> {
        positive(&[("diameter", diameter)])?;
        Ok(ring(diameter, T::zero(), rule))
    }

    /// Round tube, `diameter` outside and `wall` in m. Points: eight on the outer rim, from +y to +z; shear by V S / (I t).
    ///
    /// # Errors
    /// A size that is not positive, a wall that fills the tube.
    pub fn tube(diameter: T, wall: T, rule: ShearRule<T>) -> Result<Self, SectionFault> {
        positive(&[("diameter", diameter), ("wall", wall)])?;
        below("wall", wall, T::from_f64(0.5) * diameter)?;
        Ok(ring(diameter, diameter - T::from_f64(2.0) * wall, rule))
    }
}

fn ring<T: Real>(outer: T, inner: T, rule: ShearRule<T>) -> Section<T> {
    let c = T::from_f64;
    let (big, small) = (c(0.5) * outer, c(0.5) * inner);
    let squares = [big * big, small * small];
    let pi = c(std::f64::consts::PI);
    let area = pi * (squares[0] - squares[1]);
    let second = c(0.25) * area * (squares[0] + squares[1]);
    // V (R² + R r + r²) / (3 I): highest on the neutral axis, and falls with the sine of the angle from the force.
    let peak = (squares[0] + big * small + squares[1]) / (c(3.0) * second);
    let torsion = big / (c(2.0) * second);
    let point = |k: i32| {
        let (sine, cosine) = (f64::from(k) * std::f64::consts::FRAC_PI_4).sin_cos();
        let (sine, cosine) = (c(sine), c(cosine));
        SectionPoint {
            place: [big * cosine, big * sine],
            shear_y: [peak * sine * sine, -(peak * sine * cosine)],
            shear_z: [-(peak * sine * cosine), peak * cosine * cosine],
            torsion: [-(torsion * sine), torsion * cosine],
        }
    };
    Section {
        area,
        second: [second; 2],
        torsion: c(2.0) * second,
        shear: rule.coefficients(|poisson| [cowper(poisson, inner / outer); 2]),
        points: (0..8).map(point).collect(),
    }
}

/// Shear coefficient of a tube of ratio m = inner / outer diameter after Cowper; of a circle with m = 0.
fn cowper<T: Real>(poisson: T, m: T) -> T {
    let c = T::from_f64;
    let square = (c(1.0) + m * m) * (c(1.0) + m * m);
    c(6.0) * (c(1.0) + poisson) * square
        / ((c(7.0) + c(6.0) * poisson) * square + (c(20.0) + c(12.0) * poisson) * m * m)
}
