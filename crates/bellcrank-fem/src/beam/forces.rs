//! Forces in the section of a deformed beam.

use bellcrank_math::Real;

use super::reduce::Beam;

/// What the part ahead does to the section, in the axes of the beam.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionForces<T = f64> {
    /// Tension N, N.
    pub axial: T,
    /// Shear forces V_y, V_z, N.
    pub shear: [T; 2],
    /// Torque about x, N·m.
    pub torsion: T,
    /// M_y, M_z, N·m: stress is `M_y z / I_y − M_z y / I_z`.
    pub bending: [T; 2],
}

impl<T: Real> Beam<T> {
    /// At ξ = x/L for coordinates d of all columns. With `stiffening` the tension counts the second-order strain of the
    /// bent axis, as a body with its [`super::Shortening`]s does.
    ///
    /// Without shear deformation the shear force is the slope of the moment between the ends: exact without modes, a mean
    /// with them.
    pub fn forces(&self, d: &[T], xi: f64, stiffening: bool) -> SectionForces<T> {
        let line = &self.segment.line;
        let mut strain = self.strain(d, xi);
        if stiffening {
            strain[0] += self.longer(d) / self.segment.length;
        }
        let [axial, .., torsion, moment_y, moment_z] = self.stressed(&strain);
        let shear = std::array::from_fn(|plane| {
            line.shear[plane].map_or_else(|| self.slope_of_moment(d, plane), |shear| shear * strain[1 + plane])
        });
        SectionForces { axial, shear, torsion, bending: [moment_y, moment_z] }
    }

    fn stressed(&self, strain: &[T; 6]) -> [T; 6] {
        let stiffness = self.segment.line.stiffnesses();
        std::array::from_fn(|i| stiffness[i] * strain[i])
    }

    fn strain(&self, d: &[T], xi: f64) -> [T; 6] {
        let mut strain = [T::zero(); 6];
        for (shape, d) in self.shapes(xi).iter().zip(d) {
            (0..6).for_each(|i| strain[i] += shape.strain[i] * *d);
        }
        strain
    }

    /// V_y = −M_z', V_z = M_y'.
    fn slope_of_moment(&self, d: &[T], plane: usize) -> T {
        let moment = |xi: f64| self.stressed(&self.strain(d, xi))[5 - plane];
        let slope = (moment(1.0) - moment(0.0)) / self.segment.length;
        if plane == 0 { -slope } else { slope }
    }

    /// ½ dᵀ C d: how much longer the axis is than its chord, m.
    fn longer(&self, d: &[T]) -> T {
        let n = self.coordinates();
        let half = T::from_f64(0.5);
        (0..n * n).fold(T::zero(), |sum, k| sum + half * d[k / n] * self.curve[k] * d[k % n])
    }
}
