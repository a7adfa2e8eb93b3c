//! Fixed-interface modes: how a segment vibrates with both ends held, by Ritz's method with Legendre polynomials.
//!
//! Four families that do not mix: along the axis, twist, and bending in two planes. In bending the turn θ and the shear
//! strain γ are expanded and v = ∫ (θ + γ) dx follows, so that a beam without shear deformation only lacks γ.

use bellcrank_math::{Real, linalg::dense};

use super::quadrature::{gauss, legendre};
use super::segment::Segment;
use super::shapes::{Bend, Shape};

/// Beyond this rounding spoils the polynomials.
const MOST: usize = 40;

/// A way to vibrate: sums of polynomials. Its shape is frozen where a length or stiffness carries derivatives.
#[derive(Clone, Debug)]
pub(super) struct Bubble {
    family: Family,
    /// Mass-normalized.
    coefficients: Vec<f64>,
    /// ω², rad²/s².
    pub(super) square: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Family {
    /// Displacement (0) or turn (1) along the axis.
    Along(usize),
    /// In the plane x–y (0) or x–z (1), with shear deformation or without.
    Bending { plane: usize, shear: bool },
}

/// Number of polynomials a field: enough that the highest of `count` modes is converged to rounding.
fn degree(count: usize) -> usize {
    2 * count + 14
}

/// Points that integrate products of these shapes exactly.
pub(super) fn points(count: usize) -> usize {
    if count == 0 { 4 } else { degree(count) + 3 }
}

/// The `count` lowest of all families, in rising order; `None` without mass or beyond [`MOST`].
pub(super) fn bubbles(segment: &Segment, count: usize) -> Option<Vec<Bubble>> {
    if count == 0 {
        return Some(Vec::new());
    }
    let line = &segment.line;
    if count > MOST || line.mass == 0.0 {
        return None;
    }
    let bending = |plane: usize| Family::Bending { plane, shear: line.shear[plane].is_some() };
    let mut families = vec![Family::Along(0), bending(0), bending(1)];
    // Without inertia about its axis a beam does not vibrate in twist.
    if line.rotary != [0.0; 2] {
        families.push(Family::Along(1));
    }
    let mut all = Vec::new();
    for family in families {
        all.extend(family.modes(segment, count)?);
    }
    all.sort_by(|a, b| a.square.total_cmp(&b.square));
    all.truncate(count);
    Some(all)
}

impl Bubble {
    /// In the axes of the beam at ξ = x/L.
    pub(super) fn shape<T: Real>(&self, xi: f64, length: T) -> Shape<T> {
        let degree = self.coefficients.len();
        let basis = self.family.basis(xi, length, degree);
        let mut sum = Shape::default();
        for (coefficient, shape) in self.coefficients.iter().zip(&basis) {
            sum.add(T::from_f64(*coefficient), shape);
        }
        sum
    }
}

impl Family {
    /// Number of functions for `degree` polynomials a field.
    fn size(self, degree: usize) -> usize {
        match self {
            Family::Along(_) => degree,
            Family::Bending { shear: true, .. } => 2 * degree,
            Family::Bending { shear: false, .. } => degree - 1,
        }
    }

    /// `size` functions at ξ that vanish at both ends.
    fn basis<T: Real>(self, xi: f64, length: T, size: usize) -> Vec<Shape<T>> {
        let s = 2.0 * xi - 1.0;
        let p = legendre(size + 3, s);
        // ∫ P_k from −1 to s; it vanishes at 1, too.
        let b = |k: usize| (p[k + 1] - p[k - 1]) / (2.0 * k as f64 + 1.0);
        let slope = |k: usize| T::from_f64(2.0 * p[k]) / length;
        let half = |x: f64| length * T::from_f64(0.5 * x);
        match self {
            Family::Along(what) => (1..=size).map(|k| Shape::along(what, T::from_f64(b(k)), slope(k))).collect(),
            Family::Bending { plane, shear } => {
                let turns = if shear { size / 2 } else { size + 1 };
                // The first turn has a mean, which a constant shear strain takes away.
                let first = if shear { 1 } else { 2 };
                let turn = |k: usize| {
                    let below = if k == 1 { 0.0 } else { b(k - 1) };
                    let deflection = half((b(k + 1) - below) / (2.0 * k as f64 + 1.0));
                    let shear = T::from_f64(if k == 1 { 1.0 / 3.0 } else { 0.0 });
                    Bend { deflection, turn: T::from_f64(b(k)), curvature: slope(k), shear }.shape(plane)
                };
                let sheared = |k: usize| {
                    let (deflection, shear) = (half(b(k)), T::from_f64(p[k]));
                    Bend { deflection, turn: T::zero(), curvature: T::zero(), shear }.shape(plane)
                };
                let sheared = (1..=if shear { turns } else { 0 }).map(sheared);
                (first..=turns).map(turn).chain(sheared).collect()
            }
        }
    }

    fn modes(self, segment: &Segment, count: usize) -> Option<Vec<Bubble>> {
        let size = self.size(degree(count));
        let (stiffness, mass) = self.matrices(segment, size, points(count));
        let lowest = lowest(&stiffness, &mass, count)?;
        Some(lowest.into_iter().map(|(square, coefficients)| Bubble { family: self, coefficients, square }).collect())
    }

    fn matrices(self, segment: &Segment, size: usize, points: usize) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let (mut stiffness, mut mass) = (vec![vec![0.0; size]; size], vec![vec![0.0; size]; size]);
        for (xi, weight) in gauss(points) {
            let basis: Vec<Shape<f64>> = self.basis(xi, segment.length, size);
            for (i, a) in basis.iter().enumerate() {
                for (j, b) in basis.iter().enumerate() {
                    stiffness[i][j] += weight * segment.length * segment.line.strain_product(a, b);
                    mass[i][j] += weight * segment.length * segment.line.mass_product(a, b);
                }
            }
        }
        (stiffness, mass)
    }
}

/// `count` lowest ω² of K x = ω² M x with xᵀMx = 1, as largest 1/ω² of M x = K x / ω²: that keeps the digits of the low
/// ones, and M may be singular.
fn lowest(stiffness: &[Vec<f64>], mass: &[Vec<f64>], count: usize) -> Option<Vec<(f64, Vec<f64>)>> {
    let (inverses, vectors) = dense::generalized_eigen(mass, stiffness)?;
    let pairs = inverses.into_iter().zip(vectors).rev().take(count);
    pairs.map(|(inverse, x)| (inverse > 0.0).then(|| normalized(inverse, &x))).collect()
}

/// xᵀKx = 1 becomes xᵀMx = 1, with its largest coefficient positive.
fn normalized(inverse: f64, x: &[f64]) -> (f64, Vec<f64>) {
    let largest = x.iter().fold(0.0_f64, |top, c| if c.abs() > top.abs() * (1.0 + 1e-9) { *c } else { top });
    let scale = largest.signum() / inverse.sqrt();
    (1.0 / inverse, x.iter().map(|c| c * scale).collect())
}
