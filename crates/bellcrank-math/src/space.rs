//! The one algebra under plane and space.

use crate::Real;
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Index, IndexMut, Mul, Neg, Sub, SubAssign};

/// What the recursions need of a component vector.
pub trait Components<T>:
    Copy
    + Debug
    + Default
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Neg<Output = Self>
    + Mul<T, Output = Self>
    + AddAssign
    + SubAssign
    + Index<usize, Output = T>
    + IndexMut<usize>
{
    /// Scalar product.
    fn dot(self, o: Self) -> T;
}

impl<T: Real, const N: usize> Components<T> for crate::Vector<T, N> {
    #[inline]
    fn dot(self, o: Self) -> T {
        crate::Vector::dot(self, o)
    }
}

/// Plane or space: the types and products of the mechanics, so that every recursion is written once.
///
/// In the plane a rotation is (cos, sin), turning quantities have one component and `ω × r` is
/// `(−ω y, ω x)`; in space they are what they always are.
pub trait Space: Copy + Debug + Default + Send + Sync + 'static {
    /// Scalar.
    type T: Real;
    /// The same space over another scalar.
    type With<U: Real>: Space<T = U>;
    /// Places, velocities, forces: 2 or 3 components.
    type Vector: Components<Self::T>;
    /// Angular velocities, moments: 1 or 3 components.
    type Angular: Components<Self::T>;
    /// Rotation.
    type Rotation: Copy + Debug + Send + Sync + 'static;
    /// Moment of inertia about the centre of mass, body axes, kg·m².
    type Inertia: Copy + Debug + Default + Send + Sync + 'static;
    /// Components of a vector.
    const DIM: usize;
    /// Components of an angular quantity.
    const ANG: usize;

    /// No turn.
    fn identity() -> Self::Rotation;
    /// `R₁ R₂`.
    fn compose(a: &Self::Rotation, b: &Self::Rotation) -> Self::Rotation;
    /// `Rᵀ`.
    fn transpose(r: &Self::Rotation) -> Self::Rotation;
    /// `R v`.
    fn rotate(r: &Self::Rotation, v: Self::Vector) -> Self::Vector;
    /// `R w`.
    fn rotate_angular(r: &Self::Rotation, w: Self::Angular) -> Self::Angular;
    /// `Rᵀ v`.
    fn rotate_back(r: &Self::Rotation, v: Self::Vector) -> Self::Vector;
    /// `Rᵀ w`.
    fn rotate_angular_back(r: &Self::Rotation, w: Self::Angular) -> Self::Angular;
    /// Axis `i` of the rotated frame.
    fn column(r: &Self::Rotation, i: usize) -> Self::Vector;
    /// `R` followed by a turn of (sin, cos) about its own z axis.
    fn turn(r: &Self::Rotation, sin_cos: (Self::T, Self::T)) -> Self::Rotation;
    /// The axis that [`Space::turn`] turns about, outer components.
    fn turn_axis(r: &Self::Rotation) -> Self::Angular;
    /// Component along z, where turns turn.
    fn along_turn(w: Self::Angular) -> Self::T;
    /// `ω ← ω + k e_z`.
    fn add_along_turn(w: &mut Self::Angular, k: Self::T);
    /// `ω × k e_z`, zero in the plane.
    fn cross_turn(w: Self::Angular, k: Self::T) -> Self::Angular;
    /// `k e_z × r`.
    fn turn_cross(k: Self::T, r: Self::Vector) -> Self::Vector;
    /// `J e_z k` with the inertia in outer axes.
    fn inertia_turn(j: &Self::Inertia, k: Self::T) -> Self::Angular;
    /// The axis that slides: z in space, x in the plane (where z points out of it).
    fn slide_axis(r: &Self::Rotation) -> Self::Vector;
    /// Index of the column that [`Space::slide_axis`] is.
    const SLIDE: usize;

    /// `ω × r`.
    fn cross(w: Self::Angular, r: Self::Vector) -> Self::Vector;
    /// `r × f`.
    fn moment(r: Self::Vector, f: Self::Vector) -> Self::Angular;
    /// `ω × h`, zero in the plane.
    fn cross_angular(w: Self::Angular, h: Self::Angular) -> Self::Angular;
    /// `R J Rᵀ w`: inertia in body axes applied to outer components.
    fn apply_inertia(j: &Self::Inertia, r: &Self::Rotation, w: Self::Angular) -> Self::Angular;

    /// `J w` with the inertia in outer axes.
    fn inertia_times(j: &Self::Inertia, w: Self::Angular) -> Self::Angular;
    /// `J₁ + J₂`.
    fn add_inertia(a: &Self::Inertia, b: &Self::Inertia) -> Self::Inertia;
    /// What is added to the inertia of a mass `m` with first moment `h` about a point when the reference moves so that
    /// the point lies at `r` from it: `(2 r·h + m r²) 1 − r hᵀ − h rᵀ − m r rᵀ`.
    fn moved_inertia(m: Self::T, h: Self::Vector, r: Self::Vector) -> Self::Inertia;

    /// x, y(, z) of three numbers.
    fn vector(v: &[Self::T; 3]) -> Self::Vector;
    /// z or x, y, z of three numbers.
    fn angular(v: &[Self::T; 3]) -> Self::Angular;
    /// Vector as three numbers.
    fn spread(v: Self::Vector) -> [Self::T; 3];
    /// Angular quantity as three numbers.
    fn spread_angular(w: Self::Angular) -> [Self::T; 3];
    /// Inertia from a symmetric 3×3 tensor; the plane keeps zz.
    fn inertia(j: &[[Self::T; 3]; 3]) -> Self::Inertia;
    /// The inertia seen in a frame turned by `R`: components `R J Rᵀ`.
    fn turn_inertia(j: &Self::Inertia, r: &Self::Rotation) -> Self::Inertia;
    /// Rotation from a 3×3 matrix; the plane keeps the turn about z.
    fn from_matrix(r: &[[Self::T; 3]; 3]) -> Self::Rotation;
    /// Rotation as a 3×3 matrix.
    fn to_matrix(r: &Self::Rotation) -> [[Self::T; 3]; 3];
    /// Rotation from a unit quaternion (w, x, y, z); the plane keeps the turn about z.
    fn from_quaternion(q: &[Self::T; 4]) -> Self::Rotation;
}
