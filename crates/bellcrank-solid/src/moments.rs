//! Integrals over plane regions and solids in closed form, by Green's theorem.

use bellcrank_math::Real;

use crate::Curve;
use crate::plane::segment::Segment;
use crate::plane::vector::{Point, cross, dot, scale, sub};

/// Integrals over a solid of 1, of the coordinates and of their products.
#[derive(Clone, Copy, Debug, Default)]
pub struct Moments<T> {
    /// Of 1: the volume, m³.
    pub volume: T,
    /// Of x, y, z: m⁴.
    pub first: [T; 3],
    /// Of xx, yy, zz, yz, zx, xy: m⁵.
    pub second: [T; 6],
}

/// What a solid weighs and how it resists turning, in its own axes.
#[derive(Clone, Copy, Debug)]
pub struct MassProperties<T> {
    /// Volume, m³.
    pub volume: T,
    /// Mass, kg.
    pub mass: T,
    /// Centre of mass, m.
    pub center: [T; 3],
    /// Inertia about the centre of mass, kg·m²: symmetric, off-diagonal terms are minus the products of inertia.
    pub inertia: [[T; 3]; 3],
}

impl<T: Real> Moments<T> {
    /// Adds another solid's, `factor` times.
    pub(crate) fn add(&mut self, other: &Moments<T>, factor: T) {
        self.volume += other.volume * factor;
        self.first.iter_mut().zip(other.first).for_each(|(a, b)| *a += b * factor);
        self.second.iter_mut().zip(other.second).for_each(|(a, b)| *a += b * factor);
    }

    /// Moments after the solid is shifted.
    pub(crate) fn shifted(&self, [a, b, c]: [T; 3]) -> Moments<T> {
        let (v, [x, y, z], s) = (self.volume, self.first, self.second);
        let square = |xx: T, x: T, a: T| xx + a * x + a * x + a * a * v;
        let product = |xy: T, x: T, y: T, a: T, b: T| xy + a * y + b * x + a * b * v;
        Moments {
            volume: v,
            first: [x + a * v, y + b * v, z + c * v],
            second: [
                square(s[0], x, a),
                square(s[1], y, b),
                square(s[2], z, c),
                product(s[3], y, z, b, c),
                product(s[4], z, x, c, a),
                product(s[5], x, y, a, b),
            ],
        }
    }

    /// Mass properties at a density in kg/m³.
    pub fn mass_properties(&self, density: T) -> MassProperties<T> {
        let center = self.first.map(|x| x / self.volume);
        let about = self.shifted(center.map(|x| -x)).second.map(|s| s * density);
        let [xx, yy, zz, yz, zx, xy] = about;
        MassProperties {
            volume: self.volume,
            mass: self.volume * density,
            center,
            inertia: [[yy + zz, -xy, -zx], [-xy, zz + xx, -yz], [-zx, -yz, xx + yy]],
        }
    }
}

/// Integrals over a plane region of 1, x, y, xx, yy, xy.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Plane<T>(pub(crate) [T; 6]);

impl<T: Real> Plane<T> {
    pub(crate) fn add(&mut self, other: &Plane<T>) {
        self.0.iter_mut().zip(other.0).for_each(|(a, b)| *a += b);
    }

    /// What the piece of a line or circle between two places adds to a boundary, run with the region on its left.
    ///
    /// The places may lie beside the curve by nothing but derivatives: the way from a place to its foot on the curve
    /// counts, so that a closed chain stays closed, and every piece moves as its own curve does.
    pub(crate) fn boundary(whole: &Segment<T>, ends: [Point<T>; 2]) -> Self {
        let feet = ends.map(|p| whole.foot(p));
        let mut sum = match &whole.curve {
            Curve::Line => line(feet),
            Curve::Arc { center, radius, .. } => arc(feet, *center, *radius),
        };
        sum.add(&line([ends[0], feet[0]]));
        sum.add(&line([feet[1], ends[1]]));
        sum
    }

    /// Moments of the region between two heights.
    pub(crate) fn between(&self, low: T, high: T) -> Moments<T> {
        let third = T::from_f64(1.0 / 3.0);
        let (l2, h2) = (low * low, high * high);
        self.with([high - low, (h2 - l2) * T::from_f64(0.5), (h2 * high - l2 * low) * third])
    }

    /// What the region in a thin layer at a height adds for each of its thickness.
    pub(crate) fn at(&self, z: T) -> Moments<T> {
        self.with([T::one(), z, z * z])
    }

    fn with(&self, [h, hz, hzz]: [T; 3]) -> Moments<T> {
        let [a, x, y, xx, yy, xy] = self.0;
        Moments {
            volume: a * h,
            first: [x * h, y * h, a * hz],
            second: [xx * h, yy * h, a * hzz, y * hz, x * hz, xy * h],
        }
    }
}

/// Integrals of x, x²/2, xy, x³/3, xy², x²y/2 by dy along a straight line: two points of Gauss are exact.
fn line<T: Real>([a, b]: [Point<T>; 2]) -> Plane<T> {
    let along = sub(b, a);
    let mut sum = Plane::default();
    for t in [0.5 - 0.75_f64.sqrt() / 3.0, 0.5 + 0.75_f64.sqrt() / 3.0] {
        let t = T::from_f64(t);
        let (x, y) = (a[0] + along[0] * t, a[1] + along[1] * t);
        let weight = along[1] * T::from_f64(0.5);
        let third = T::from_f64(1.0 / 3.0);
        let half = T::from_f64(0.5);
        sum.add(&Plane([x, x * x * half, x * y, x * x * x * third, x * y * y, x * x * y * half].map(|f| f * weight)));
    }
    sum
}

/// The same along an arc shorter than half a turn, in polar coordinates about its centre.
fn arc<T: Real>(ends: [Point<T>; 2], center: Point<T>, r: T) -> Plane<T> {
    let [from, to] = ends.map(|p| scale(sub(p, center), T::one() / r));
    let angle = cross(from, to).atan2(dot(from, to));
    let n = T::from_f64;
    let change = |f: &dyn Fn(T, T) -> T| f(to[0], to[1]) - f(from[0], from[1]);
    // sin 4θ, of c = cos θ and s = sin θ.
    let sin4 = |c: T, s: T| n(4.0) * s * c * (c * c - s * s);
    // j_mn: integral of u^m v^n dv with u = r cos θ, v = r sin θ.
    let (r2, r3) = (r * r, r * r * r);
    let j00 = r * change(&|_, s| s);
    let j10 = r2 * n(0.5) * (angle + change(&|c, s| s * c));
    let j01 = r2 * n(0.5) * change(&|_, s| s * s);
    let j20 = r3 * change(&|_, s| s - s * s * s * n(1.0 / 3.0));
    let j11 = r3 * n(-1.0 / 3.0) * change(&|c, _| c * c * c);
    let j02 = r3 * n(1.0 / 3.0) * change(&|_, s| s * s * s);
    let j30 = r2 * r2 * (angle * n(0.375) + change(&|c, s| s * c * n(0.5) + sin4(c, s) * n(1.0 / 32.0)));
    let j21 = r2 * r2 * n(-0.25) * change(&|c, _| c * c * c * c);
    let j12 = r2 * r2 * (angle * n(0.125) - change(&|c, s| sin4(c, s) * n(1.0 / 32.0)));
    let [x, y] = center;
    let (two, three) = (n(2.0), n(3.0));
    let xx = x * x * j00 + two * x * j10 + j20;
    Plane([
        x * j00 + j10,
        xx * n(0.5),
        x * y * j00 + y * j10 + x * j01 + j11,
        (x * x * x * j00 + three * x * x * j10 + three * x * j20 + j30) * n(1.0 / 3.0),
        x * (y * y * j00 + two * y * j01 + j02) + y * y * j10 + two * y * j11 + j12,
        (y * xx + x * x * j01 + two * x * j11 + j21) * n(0.5),
    ])
}
