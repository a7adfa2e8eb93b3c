//! From a segment to the data of a flexible body.

use bellcrank_math::Real;

use super::bubbles::{Bubble, bubbles, points};
use super::quadrature::gauss;
use super::segment::{BeamFault, Line, Segment, cross, dot};
use super::shapes::{Shape, end_shapes, rotate};
use crate::numbering::rigid_motions;
use crate::reduce::damping;
use crate::{ShapeIntegrals, Shortening};

/// A segment as a flexible body. Columns: displacement of end 1 along x, y, z of the body, its turns about them, the same
/// of end 2, then fixed-interface modes, mass-normalized.
#[derive(Clone, Debug)]
pub struct Beam<T = f64> {
    /// n × n by rows, N/m and so on; between ends and modes exactly zero, ω² on the diagonal of the modes.
    pub stiffness: Vec<T>,
    /// Places and shapes over the mass.
    pub inertia: ShapeIntegrals<T>,
    /// Second-order displacement of end 2 against end 1: three components, those that vanish left out.
    pub shortenings: Vec<Shortening<T>>,
    /// Of the fixed-interface modes, ascending, Hz.
    pub frequencies: Vec<f64>,
    pub(super) segment: Segment<T>,
    pub(super) bubbles: Vec<Bubble>,
    /// ∫ (v'ᵉ v'ᶠ + w'ᵉ w'ᶠ) dx, n × n by rows, m.
    pub(super) curve: Vec<T>,
}

impl<T: Real> Line<T> {
    /// Elastic energy of two shapes a length.
    pub(super) fn strain_product(&self, a: &Shape<T>, b: &Shape<T>) -> T {
        let stiffness = self.stiffnesses();
        (0..6).fold(T::zero(), |sum, i| sum + stiffness[i] * a.strain[i] * b.strain[i])
    }

    /// Kinetic energy of two shapes a length, both in the axes of the beam.
    pub(super) fn mass_product(&self, a: &Shape<T>, b: &Shape<T>) -> T {
        let [about_y, about_z] = self.rotary;
        let polar = [about_y + about_z, about_y, about_z];
        let turning = (0..3).fold(T::zero(), |sum, i| sum + polar[i] * a.turned[i] * b.turned[i]);
        self.mass * dot(&a.moved, &b.moved) + turning
    }
}

impl<T: Real> Segment<T> {
    /// As a flexible body with `modes` fixed-interface modes.
    ///
    /// # Errors
    /// The first number that makes no beam.
    pub fn reduce(&self, modes: usize) -> Result<Beam<T>, BeamFault> {
        if let Some(fault) = self.fault() {
            return Err(fault);
        }
        let bubbles = bubbles(&self.values(), modes).ok_or(BeamFault::Modes(modes))?;
        let n = 12 + modes;
        let frequencies = bubbles.iter().map(|bubble| bubble.square.sqrt() / std::f64::consts::TAU).collect();
        let mut beam = Beam {
            stiffness: vec![T::zero(); n * n],
            inertia: ShapeIntegrals::zero(n),
            shortenings: Vec::new(),
            frequencies,
            segment: *self,
            bubbles,
            curve: vec![T::zero(); n * n],
        };
        for (xi, weight) in gauss(points(modes)) {
            beam.sum(xi, T::from_f64(weight) * self.length);
        }
        beam.shortenings = beam.shortened();
        Ok(beam)
    }
}

impl<T: Real> Beam<T> {
    /// Number of coordinates n.
    pub fn coordinates(&self) -> usize {
        12 + self.bubbles.len()
    }

    /// Damping matrix, n × n by rows, that gives every mode of the free segment the damping ratio `ratio`, as that of a
    /// reduced solid does; without derivatives. `None` where a coordinate has no mass.
    pub fn damping(&self, ratio: f64) -> Option<Vec<f64>> {
        let values = |m: &[T]| m.iter().map(|x| x.value()).collect::<Vec<f64>>();
        let (stiffness, mass) = (values(&self.stiffness), values(&self.inertia.mass_matrix()));
        let massless = (0..self.coordinates()).any(|i| mass[i * self.coordinates() + i] <= 0.0);
        (!massless).then(|| damping(&stiffness, &mass, &self.rigid_motions(), ratio))
    }

    /// Coordinates of displacements along x, y, z of the body and of turns about axes through its origin.
    fn rigid_motions(&self) -> Vec<Vec<f64>> {
        let Segment { start, length, axes, .. } = self.segment.values();
        let mut motions = vec![vec![0.0; self.coordinates()]; 6];
        for end in 0..2 {
            let point = std::array::from_fn(|i| start[i] + end as f64 * length * axes[i][0]);
            for (k, (motion, field)) in motions.iter_mut().zip(rigid_motions(point)).enumerate() {
                motion[6 * end..6 * end + 3].copy_from_slice(&field);
                if k >= 3 {
                    motion[6 * end + k] = 1.0;
                }
            }
        }
        motions
    }

    /// Shape of every column at ξ = x/L; motion in the axes of the body.
    pub(super) fn shapes(&self, xi: f64) -> Vec<Shape<T>> {
        let Segment { line, length, axes, .. } = &self.segment;
        let ends = end_shapes(xi, *length, line.shear_parameters(*length));
        let mut shapes = vec![Shape::default(); 12];
        for (column, shape) in shapes.iter_mut().enumerate() {
            // A unit vector of the body has the components `axes[direction]` in the beam.
            let (first, direction) = (column - column % 3, column % 3);
            (0..3).for_each(|i| shape.add(axes[direction][i], &ends[first + i]));
        }
        shapes.extend(self.bubbles.iter().map(|bubble| bubble.shape(xi, *length)));
        shapes.iter().map(|shape| shape.placed(axes)).collect()
    }

    /// Adds what a slice of length `dx` at ξ brings.
    fn sum(&mut self, xi: f64, dx: T) {
        let shapes = self.shapes(xi);
        let Segment { line, length, start, axes } = self.segment;
        let n = shapes.len();
        for (e, a) in shapes.iter().enumerate() {
            for (f, b) in shapes.iter().enumerate() {
                self.curve[e * n + f] += dx * (a.slope[0] * b.slope[0] + a.slope[1] * b.slope[1]);
                // What is in equilibrium with forces at its ends does no work on what vanishes there.
                if (e < 12) == (f < 12) {
                    self.stiffness[e * n + f] += dx * line.strain_product(a, b);
                }
            }
        }
        let ahead = rotate(&axes, &[T::from_f64(xi) * length, T::zero(), T::zero()]);
        let place = std::array::from_fn(|i| start[i] + ahead[i]);
        let moved: Vec<[T; 3]> = shapes.iter().map(|shape| shape.moved).collect();
        self.inertia.add(dx * line.mass, &place, &moved);
        // ∫ ρ y² dA along y moves by θ × y, ∫ ρ z² dA along z by θ × z.
        for (across, j) in [(1, line.rotary[1]), (2, line.rotary[0])] {
            let side = [axes[0][across], axes[1][across], axes[2][across]];
            let moved: Vec<[T; 3]> = shapes.iter().map(|shape| cross(&shape.turned, &side)).collect();
            self.inertia.add_spread(dx * j, &side, &moved);
        }
    }

    fn shortened(&self) -> Vec<Shortening<T>> {
        let direction = self.segment.axes.map(|row| row[0]);
        let scaled = |i: usize| self.curve.iter().map(|c| direction[i] * *c).collect();
        let kept = (0..3).filter(|&i| !direction[i].is_zero());
        kept.map(|i| Shortening { along: 6 + i, matrix: scaled(i) }).collect()
    }
}
