//! Common sections: area, second moments, torsion, shear coefficients, and where their stress is highest.

mod rectangle;
mod ring;
mod walls;

use bellcrank_math::Real;

use super::forces::SectionForces;
use super::segment::Line;

/// Section of a beam about its principal axes y and z.
#[derive(Clone, Debug, PartialEq)]
pub struct Section<T = f64> {
    /// m².
    pub area: T,
    /// I_y = ∫ z² dA, I_z = ∫ y² dA, m⁴.
    pub second: [T; 2],
    /// J with torque = G J × twist a length, m⁴ (not the polar moment, but for circles).
    pub torsion: T,
    /// Shear areas along y and z over the area; `None`: no shear deformation.
    pub shear: Option<[T; 2]>,
    /// Where stress is looked for.
    pub points: Vec<SectionPoint<T>>,
}

/// A place in a section, and its shear stress (τ_xy, τ_xz) for unit shear forces and unit torque.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionPoint<T = f64> {
    /// y, z in m.
    pub place: [T; 2],
    /// For V_y = 1 N, 1/m².
    pub shear_y: [T; 2],
    /// For V_z = 1 N, 1/m².
    pub shear_z: [T; 2],
    /// For a torque of 1 N·m, 1/m³.
    pub torsion: [T; 2],
}

/// Shear coefficients: effective over true area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ShearRule<T = f64> {
    /// By Poisson's ratio, G. R. Cowper, J. Appl. Mech. 33 (1966) 335.
    Cowper(T),
    /// Given, along y and z; 5/6 is the rectangle's of energy (Reissner's).
    Given([T; 2]),
    /// No shear deformation.
    Rigid,
}

/// Why sizes make no section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SectionFault {
    /// A size that is not positive: its name, and its value in m.
    Size(&'static str, f64),
    /// A wall that fills the section: its name, its value in m, and what it must be below.
    Wall(&'static str, f64, f64),
}

impl<T: Real> ShearRule<T> {
    /// Coefficients of a section that has Cowper's by Poisson's ratio.
    fn coefficients(self, cowper: impl FnOnce(T) -> [T; 2]) -> Option<[T; 2]> {
        match self {
            ShearRule::Cowper(poisson) => Some(cowper(poisson)),
            ShearRule::Given(both) => Some(both),
            ShearRule::Rigid => None,
        }
    }
}

impl<T: Real> Section<T> {
    /// Constants of a beam: Young's and shear modulus in Pa, density in kg/m³.
    pub fn line(&self, young: T, shear: T, density: T) -> Line<T> {
        let stiff = |axis: usize| self.shear.map(|both| both[axis] * shear * self.area);
        Line {
            axial: young * self.area,
            shear: [stiff(0), stiff(1)],
            torsion: shear * self.torsion,
            bending: self.second.map(|second| young * second),
            mass: density * self.area,
            rotary: self.second.map(|second| density * second),
        }
    }

    /// Normal stress and shear stresses (σ_x, τ_xy, τ_xz) at a point, Pa.
    pub fn stress(&self, point: &SectionPoint<T>, forces: &SectionForces<T>) -> [T; 3] {
        let [y, z] = point.place;
        let [moment_y, moment_z] = forces.bending;
        let normal = forces.axial / self.area + moment_y * z / self.second[0] - moment_z * y / self.second[1];
        let shear = |i: usize| {
            point.shear_y[i] * forces.shear[0] + point.shear_z[i] * forces.shear[1] + point.torsion[i] * forces.torsion
        };
        [normal, shear(0), shear(1)]
    }

    /// Von Mises' stress at every point, Pa.
    pub fn von_mises(&self, forces: &SectionForces<T>) -> impl Iterator<Item = T> {
        self.points.iter().map(|point| equivalent(&self.stress(point, forces)))
    }
}

fn equivalent<T: Real>([normal, xy, xz]: &[T; 3]) -> T {
    let square = *normal * *normal + T::from_f64(3.0) * (*xy * *xy + *xz * *xz);
    // The root has no derivative where there is no stress.
    if square.value() == 0.0 { T::zero() } else { square.sqrt() }
}

/// Positive sizes, or the first that is not.
fn positive<T: Real>(sizes: &[(&'static str, T)]) -> Result<(), SectionFault> {
    let wrong = sizes.iter().map(|(name, x)| (*name, x.value())).find(|(_, x)| !(*x > 0.0 && x.is_finite()));
    wrong.map_or(Ok(()), |(name, x)| Err(SectionFault::Size(name, x)))
}

fn below<T: Real>(name: &'static str, wall: T, limit: T) -> Result<(), SectionFault> {
    let (wall, limit) = (wall.value(), limit.value());
    if wall < limit { Ok(()) } else { Err(SectionFault::Wall(name, wall, limit)) }
}
