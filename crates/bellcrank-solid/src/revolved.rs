//! Pins, bushes and other bodies of revolution.

use bellcrank_math::Real;

use crate::plane::outline::{crossing_sides, doubled_area};
use crate::plane::vector::{distance, values};
use crate::{Fault, MassProperties, Moments, Part};

/// A closed profile turned once about an axis; lengths in m.
#[derive(Clone, Debug)]
pub struct Revolved<T> {
    /// Origin of the profile's coordinates.
    pub base: [T; 3],
    /// Direction of the axis, of length one.
    pub axis: [T; 3],
    /// Corners `[r, h]`: distance from the axis (not negative) and height along it, in order, either way round.
    pub profile: Vec<[T; 2]>,
}

impl<T: Real> Revolved<T> {
    /// Integrals over the solid, in the axes of `base` and `axis`. Fails with everything wrong with the profile.
    pub fn moments(&self) -> Result<Moments<T>, Vec<Fault>> {
        let corners = self.checked()?;
        let length = self.axis.iter().fold(T::zero(), |sum, a| sum + *a * *a).sqrt();
        let [a, b, c] = self.axis.map(|x| x / length);
        let [volume, along, along2, across2] = profile_integrals(&corners);
        let square = |a: T| across2 * (T::one() - a * a) + along2 * a * a;
        let product = |a: T, b: T| (along2 - across2) * a * b;
        let about_base = Moments {
            volume,
            first: [a, b, c].map(|a| a * along),
            second: [square(a), square(b), square(c), product(b, c), product(c, a), product(a, b)],
        };
        Ok(about_base.shifted(self.base))
    }

    /// Mass properties at a density in kg/m³; exact. Fails as [`Revolved::moments`] does.
    pub fn mass_properties(&self, density: T) -> Result<MassProperties<T>, Vec<Fault>> {
        Ok(self.moments()?.mass_properties(density))
    }

    /// Corners counter-clockwise in (r, h), those within rounding of the axis on it.
    pub(crate) fn checked(&self) -> Result<Vec<[T; 2]>, Vec<Fault>> {
        let part = Part::Profile;
        let numbers = self.base.iter().chain(&self.axis).chain(self.profile.iter().flatten());
        if numbers.into_iter().any(|x| !x.value().is_finite()) {
            return Err(vec![Fault::NotFinite { part }]);
        }
        let mut faults = self.axis_faults();
        let places: Vec<[f64; 2]> = self.profile.iter().map(|p| values(*p)).collect();
        let count = places.len();
        if count < 3 {
            faults.push(Fault::TooFewCorners { part, count });
            return Err(faults);
        }
        let extent = places.iter().flatten().fold(0.0, |a: f64, x| a.max(x.abs()));
        if !(1e-6..=1e6).contains(&extent) {
            faults.push(Fault::Extent { extent });
            return Err(faults);
        }
        let tolerance = 1e-9 * extent;
        faults.extend(profile_faults(&places, tolerance));
        if !faults.is_empty() {
            return Err(faults);
        }
        let on_axis = |[r, h]: [T; 2]| [if r.value() < tolerance { r.with_value(0.0) } else { r }, h];
        let mut corners: Vec<[T; 2]> = self.profile.iter().map(|p| on_axis(*p)).collect();
        if doubled_area(&places) < 0.0 {
            corners.reverse();
        }
        Ok(corners)
    }

    fn axis_faults(&self) -> Vec<Fault> {
        let length = self.axis.iter().map(|a| a.value() * a.value()).sum::<f64>().sqrt();
        let wrong = (length - 1.0).abs() > 1e-6;
        let far = self.base.iter().fold(0.0, |a: f64, x| a.max(x.value().abs()));
        let axis = wrong.then_some(Fault::Axis { length });
        axis.into_iter().chain((far > 1e6).then_some(Fault::Extent { extent: far })).collect()
    }
}

fn profile_faults(places: &[[f64; 2]], tolerance: f64) -> Vec<Fault> {
    let part = Part::Profile;
    let n = places.len();
    let mut faults = Vec::new();
    let on_axis = |i: usize| places[i % n][0].abs() <= tolerance;
    for (i, [radius, _]) in places.iter().enumerate() {
        if *radius < -tolerance {
            faults.push(Fault::NegativeRadius { corner: i, radius: *radius });
        }
        if on_axis(i) && !on_axis(i + 1) && !on_axis(i + n - 1) {
            faults.push(Fault::TouchesAxis { corner: i });
        }
    }
    let short: Vec<usize> = (0..n).filter(|i| distance(places[*i], places[(i + 1) % n]) < 20.0 * tolerance).collect();
    faults.extend(short.iter().map(|i| Fault::SideOfNoLength { part, corner: (i + 1) % n }));
    if short.is_empty() {
        faults.extend(crossing_sides(places, tolerance).into_iter().map(|sides| Fault::SidesCross { part, sides }));
    }
    faults
}

/// Integrals over the solid of 1, h, h² and of the square of one coordinate across the axis.
///
/// By Green's theorem they are integrals along the sides of r²/2, r² h/2, r² h²/2 by 2 pi dh and of r⁴/4 by pi dh:
/// polynomials of degree four, for which three points of Gauss are exact.
fn profile_integrals<T: Real>(corners: &[[T; 2]]) -> [T; 4] {
    let n = T::from_f64;
    let points = [(0.5 - 0.15_f64.sqrt(), 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + 0.15_f64.sqrt(), 5.0 / 18.0)];
    let mut sums = [T::zero(); 4];
    for ([r, h], [s, k]) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let (out, up) = (*s - *r, *k - *h);
        for (t, weight) in points {
            let (r, h) = (*r + out * n(t), *h + up * n(t));
            let weight = up * n(weight * std::f64::consts::PI);
            let rr = r * r;
            let terms = [rr, rr * h, rr * h * h, rr * rr * n(0.25)];
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term * weight);
        }
    }
    sums
}
