//! Sections of walls: box and I. Area and second moments are exact; torsion, shear and their coefficients are those of
//! thin walls, without fillets.

use bellcrank_math::Real;

use super::rectangle::cowper as rectangle_cowper;
use super::{Section, SectionFault, SectionPoint, ShearRule, below, positive};

/// Outer sizes and walls: `web` stands along z, `flange` lies along y.
struct Walls<T> {
    width: T,
    height: T,
    web: T,
    flange: T,
}

impl<T: Real> Section<T> {
    /// Rectangular box: outer `width` along y and `height` along z, thickness of the upright walls (`web`) and of the lying
    /// ones (`flange`), m. Torsion by Bredt. Points: four outer corners, with the shear flow of the walls that meet there,
    /// then the middles of the walls at +y, −y, +z, −z.
    ///
    /// # Errors
    /// A size that is not positive, walls that fill the box.
    pub fn hollow(width: T, height: T, web: T, flange: T, rule: ShearRule<T>) -> Result<Self, SectionFault> {
        positive(&[("width", width), ("height", height), ("web", web), ("flange", flange)])?;
        let half = T::from_f64(0.5);
        below("web", web, half * width)?;
        below("flange", flange, half * height)?;
        Ok(Walls { width, height, web, flange }.hollow(rule))
    }

    /// I: flanges of `width` along y at ±z, overall `height` along z, thickness of the `web` and of each `flange`, m. Points:
    /// four tips of the flanges, two middles of the flanges, four ends and two middles of the web.
    ///
    /// # Errors
    /// A size that is not positive, a web wider than the flanges, flanges that fill the height.
    pub fn i_beam(width: T, height: T, web: T, flange: T, rule: ShearRule<T>) -> Result<Self, SectionFault> {
        positive(&[("width", width), ("height", height), ("web", web), ("flange", flange)])?;
        below("web", web, width)?;
        below("flange", flange, T::from_f64(0.5) * height)?;
        Ok(Walls { width, height, web, flange }.i_beam(rule))
    }
}

fn cube<T: Real>(x: T) -> T {
    x * x * x
}

/// ∫ z² dA of a rectangle.
fn second<T: Real>(width: T, height: T) -> T {
    width * cube(height) / T::from_f64(12.0)
}

/// Cowper's coefficient for shear along the webs, with m = areas of the flanges over those of the webs and n = width over
/// height of the middle lines; `rest` is what differs between box and I.
fn cowper<T: Real>(poisson: T, m: T, rest: T) -> T {
    let c = T::from_f64;
    let cubic = |a: [f64; 4]| c(a[0]) + m * (c(a[1]) + m * (c(a[2]) + m * c(a[3])));
    let one = c(1.0) + c(3.0) * m;
    let bottom = cubic([12.0, 72.0, 150.0, 90.0]) + poisson * cubic([11.0, 66.0, 135.0, 90.0]) + rest;
    c(10.0) * (c(1.0) + poisson) * one * one / bottom
}

fn cowper_box<T: Real>(poisson: T, m: T, n: T) -> T {
    let c = T::from_f64;
    cowper(poisson, m, c(10.0) * n * n * ((c(3.0) + poisson) * m + c(3.0) * m * m))
}

fn cowper_i<T: Real>(poisson: T, m: T, n: T) -> T {
    let c = T::from_f64;
    let rest = c(30.0) * (m + m * m) + c(5.0) * poisson * (c(8.0) * m + c(9.0) * m * m);
    cowper(poisson, m, n * n * rest)
}

impl<T: Real> Walls<T> {
    /// Width and height of the middle lines.
    fn middle(&self) -> [T; 2] {
        [self.width - self.web, self.height - self.flange]
    }

    fn inside(&self) -> [T; 2] {
        let two = T::from_f64(2.0);
        [self.width - two * self.web, self.height - two * self.flange]
    }

    /// ∫ z dA of the upper flange.
    fn flange_moment(&self) -> T {
        T::from_f64(0.5) * self.width * self.flange * self.middle()[1]
    }

    /// The same section lying on its side.
    fn turned(&self) -> Self {
        Self { width: self.height, height: self.width, web: self.flange, flange: self.web }
    }

    fn hollow(&self, rule: ShearRule<T>) -> Section<T> {
        let [b, h] = self.middle();
        let [inner_b, inner_h] = self.inside();
        let two = T::from_f64(2.0);
        let enclosed = b * h;
        let sides = two * b / self.flange + two * h / self.web;
        let ratio = b * self.flange / (h * self.web);
        let one = T::one();
        let second = [
            second(self.width, self.height) - second(inner_b, inner_h),
            second(self.height, self.width) - second(inner_h, inner_b),
        ];
        Section {
            area: self.width * self.height - inner_b * inner_h,
            second,
            torsion: T::from_f64(4.0) * enclosed * enclosed / sides,
            shear: rule.coefficients(|nu| [cowper_box(nu, one / ratio, h / b), cowper_box(nu, ratio, b / h)]),
            points: self.hollow_points(second, one / (two * enclosed)),
        }
    }

    /// Shear flow in the webs for a unit force along z: at their ends and in their middles, 1/m.
    fn flows(&self, second: T) -> [T; 2] {
        let half = T::from_f64(0.5);
        let end = self.flange_moment();
        let upper = half * self.inside()[1];
        let middle = end + self.web * upper * upper;
        // Two webs share it.
        [half * end / second, half * middle / second]
    }

    /// `flow`: shear flow of a unit torque.
    fn hollow_points(&self, second: [T; 2], flow: T) -> Vec<SectionPoint<T>> {
        let (half, zero, one) = (T::from_f64(0.5), T::zero(), T::one());
        let (y, z) = (half * self.width, half * self.height);
        let [corner_z, middle_z] = self.flows(second[0]);
        let [corner_y, middle_y] = self.turned().flows(second[1]);
        let thin = if self.web.value() < self.flange.value() { self.web } else { self.flange };
        let mut points = Vec::with_capacity(8);
        for (up, right) in [(one, one), (one, -one), (-one, -one), (-one, one)] {
            // One flow passes the corner; it is given as that in the upright wall, upwards.
            points.push(SectionPoint {
                place: [right * y, up * z],
                shear_y: [zero, -(up * right * corner_y / thin)],
                shear_z: [zero, corner_z / thin],
                torsion: [zero, right * flow / thin],
            });
        }
        for sign in [one, -one] {
            let (shear_z, torsion) = ([zero, middle_z / self.web], [zero, sign * flow / self.web]);
            points.push(SectionPoint { place: [sign * y, zero], shear_z, torsion, ..SectionPoint::default() });
        }
        for sign in [one, -one] {
            let (shear_y, torsion) = ([middle_y / self.flange, zero], [-(sign * flow / self.flange), zero]);
            points.push(SectionPoint { place: [zero, sign * z], shear_y, torsion, ..SectionPoint::default() });
        }
        points
    }

    fn i_beam(&self, rule: ShearRule<T>) -> Section<T> {
        let (two, third) = (T::from_f64(2.0), T::from_f64(1.0 / 3.0));
        let inner = self.inside()[1];
        let (flanges, area) = (two * self.width * self.flange, two * self.width * self.flange + inner * self.web);
        let second = [
            second(self.width, self.height) - second(self.width - self.web, inner),
            two * second(self.flange, self.width) + second(inner, self.web),
        ];
        let torsion = third * (two * self.width * cube(self.flange) + inner * cube(self.web));
        let h = self.middle()[1];
        // Along y the flanges carry the shear, as two rectangles.
        let cowper = |nu| {
            let along = cowper_i(nu, flanges / (h * self.web), self.width / h);
            [rectangle_cowper(nu) * flanges / area, along]
        };
        Section { area, second, torsion, shear: rule.coefficients(cowper), points: self.i_points(second, torsion) }
    }

    fn i_points(&self, second: [T; 2], constant: T) -> Vec<SectionPoint<T>> {
        let (half, zero, one) = (T::from_f64(0.5), T::zero(), T::one());
        let (y, z, inner) = (half * self.width, half * self.height, half * self.inside()[1]);
        let (flange, web) = (self.flange / constant, self.web / constant);
        let flat = |place: [T; 2], shear: T, up: T| SectionPoint {
            place,
            shear_y: [shear, zero],
            torsion: [-(up * flange), zero],
            ..SectionPoint::default()
        };
        let upright = |place: [T; 2], moment: T, right: T| SectionPoint {
            place,
            shear_z: [zero, moment / (second[0] * self.web)],
            torsion: [zero, right * web],
            ..SectionPoint::default()
        };
        let across = T::from_f64(0.75) / (self.width * self.flange);
        let (end, middle) = (self.flange_moment(), self.flange_moment() + half * self.web * inner * inner);
        let side = half * self.web;
        let signs = [one, -one];
        let tips = signs.into_iter().flat_map(|up| signs.map(|right| flat([right * y, up * z], zero, up)));
        let middles = signs.into_iter().map(|up| flat([zero, up * z], across, up));
        let ends = signs.into_iter();
        let ends = ends.flat_map(|up| signs.map(|right| upright([right * side, up * inner], end, right)));
        let neutral = signs.into_iter().map(|right| upright([right * side, zero], middle, right));
        tips.chain(middles).chain(ends).chain(neutral).collect()
    }
}
