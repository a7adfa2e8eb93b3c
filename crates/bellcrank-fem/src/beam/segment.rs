//! What goes in: constants of a beam a length, and where it lies.

use bellcrank_math::Real;

/// Constants of a prismatic beam about the principal axes y and z of its section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<T = f64> {
    /// E·A, N.
    pub axial: T,
    /// G·A_y, G·A_z with the shear areas, N; `None` lets sections stay perpendicular to the axis (Euler and Bernoulli).
    pub shear: [Option<T>; 2],
    /// G·J, N·m².
    pub torsion: T,
    /// E·I_y (bends in the plane of x and z), E·I_z (in that of x and y), N·m².
    pub bending: [T; 2],
    /// ρ·A, kg/m.
    pub mass: T,
    /// ρ·I_y = ∫ ρ z² dA, ρ·I_z = ∫ ρ y² dA, kg·m; together they are the inertia about the axis.
    pub rotary: [T; 2],
}

/// A straight piece of beam in a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment<T = f64> {
    /// Constants a length.
    pub line: Line<T>,
    /// m.
    pub length: T,
    /// End 1 in the body, m.
    pub start: [T; 3],
    /// Rotation from the axes of the beam to those of the body: its columns are the beam's x, y, z.
    pub axes: [[T; 3]; 3],
}

/// Why numbers make no beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BeamFault {
    /// A length that is not positive.
    Length(f64),
    /// A stiffness that is not positive: which (`EA`, `GA_y`, `GA_z`, `GJ`, `EI_y`, `EI_z`), and its value.
    Stiffness(&'static str, f64),
    /// A mass a length that is negative: which (`rho A`, `rho I_y`, `rho I_z`), and its value.
    Mass(&'static str, f64),
    /// Axes that are no rotation: the largest component of RᵀR − 1.
    Axes(f64),
    /// Fixed-interface modes asked of a beam without mass, or more than their polynomials resolve: how many.
    Modes(usize),
}

/// Rotation with x along `direction` and y as near to `y` as it can be; `None` if they are parallel or one is zero.
pub fn axes<T: Real>(direction: &[T; 3], y: &[T; 3]) -> Option<[[T; 3]; 3]> {
    let x = unit(direction)?;
    let along = dot(&x, y);
    let y = unit(&std::array::from_fn(|i| y[i] - along * x[i]))?;
    let z = cross(&x, &y);
    Some(std::array::from_fn(|i| [x[i], y[i], z[i]]))
}

pub(super) fn dot<T: Real>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross<T: Real>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit<T: Real>(v: &[T; 3]) -> Option<[T; 3]> {
    let norm = dot(v, v);
    (norm.value() > 1e-24).then(|| v.map(|c| c / norm.sqrt()))
}

impl<T: Real> Line<T> {
    /// Φ = 12 EI / (GA L²) in the planes x–y and x–z: shear against bending; 0 without shear deformation.
    pub(super) fn shear_parameters(&self, length: T) -> [T; 2] {
        std::array::from_fn(|plane| {
            let bending = self.bending[1 - plane];
            let twelve = T::from_f64(12.0);
            self.shear[plane].map_or(T::zero(), |shear| twelve * bending / (shear * length * length))
        })
    }

    /// Stiffnesses that belong to the strains (u', γ_y, γ_z, θ_x', θ_y', θ_z').
    pub(super) fn stiffnesses(&self) -> [T; 6] {
        let shear = self.shear.map(|shear| shear.unwrap_or(T::zero()));
        [self.axial, shear[0], shear[1], self.torsion, self.bending[0], self.bending[1]]
    }

    fn fault(&self) -> Option<BeamFault> {
        let one = T::one();
        let [shear_y, shear_z] = self.shear.map(|shear| shear.unwrap_or(one));
        let [bending_y, bending_z] = self.bending;
        let stiff = [("EA", self.axial), ("GA_y", shear_y), ("GA_z", shear_z), ("GJ", self.torsion)];
        let stiff = stiff.into_iter().chain([("EI_y", bending_y), ("EI_z", bending_z)]);
        let heavy = [("rho A", self.mass), ("rho I_y", self.rotary[0]), ("rho I_z", self.rotary[1])];
        let positive = |x: f64| x > 0.0 && x.is_finite();
        let mut stiff = stiff.map(|(name, x)| (name, x.value())).filter(|(_, x)| !positive(*x));
        let mut heavy =
            heavy.into_iter().map(|(name, x)| (name, x.value())).filter(|(_, x)| *x != 0.0 && !positive(*x));
        let stiff = stiff.next().map(|(name, x)| BeamFault::Stiffness(name, x));
        stiff.or_else(|| heavy.next().map(|(name, x)| BeamFault::Mass(name, x)))
    }
}

impl<T: Real> Segment<T> {
    /// The first thing that is wrong with it.
    pub(super) fn fault(&self) -> Option<BeamFault> {
        let length = self.length.value();
        if !(length > 0.0 && length.is_finite()) {
            return Some(BeamFault::Length(length));
        }
        let skew = self.skew();
        if skew.is_nan() || skew > 1e-9 {
            return Some(BeamFault::Axes(skew));
        }
        self.line.fault()
    }

    /// How far the axes are from a rotation.
    fn skew(&self) -> f64 {
        let r = self.axes.map(|row| row.map(T::value));
        let column = |j: usize| [r[0][j], r[1][j], r[2][j]];
        let pairs = (0..9).map(|k| dot(&column(k / 3), &column(k % 3)) - f64::from(k / 3 == k % 3));
        let left_handed = (dot(&cross(&column(0), &column(1)), &column(2)) - 1.0).abs();
        pairs.map(f64::abs).fold(left_handed, |worst, x| if x.is_nan() { x } else { worst.max(x) })
    }

    /// The same with plain numbers.
    pub(super) fn values(&self) -> Segment {
        let Line { axial, shear, torsion, bending, mass, rotary } = self.line;
        let line = Line {
            axial: axial.value(),
            shear: shear.map(|shear| shear.map(T::value)),
            torsion: torsion.value(),
            bending: bending.map(T::value),
            mass: mass.value(),
            rotary: rotary.map(T::value),
        };
        let (start, axes) = (self.start.map(T::value), self.axes.map(|row| row.map(T::value)));
        Segment { line, length: self.length.value(), start, axes }
    }
}
