//! A joint as a sequence of elementary motions.
//!
//! Every joint that can carry a body in the tree is a chain of turns, slides, screws and balls; the
//! recursions know only these four.

use crate::{BuildError, JointId, JointKind};
use bellcrank_math::{Real, Space};

/// An elementary motion about or along the axis of its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Motion<T> {
    /// Rigid.
    Fixed,
    /// About z.
    Turn,
    /// Along the slide axis ([`Space::slide_axis`]).
    Slide,
    /// About z, advancing along it by this much a radian (space only).
    Screw(T),
    /// Any turn: a unit quaternion, and three angular velocities along the axes before the turn.
    Ball,
}

impl<T> Motion<T> {
    /// Velocity components.
    pub(crate) fn dofs(&self) -> usize {
        match self {
            Motion::Fixed => 0,
            Motion::Turn | Motion::Slide | Motion::Screw(_) => 1,
            Motion::Ball => 3,
        }
    }
    /// Position numbers.
    pub(crate) fn numbers(&self) -> usize {
        if matches!(self, Motion::Ball) { 4 } else { self.dofs() }
    }
}

/// An elementary motion and the orientation of its frame in the joint's frame at zero coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step<S: Space> {
    pub(crate) motion: Motion<S::T>,
    pub(crate) align: S::Rotation,
    /// −1 where the asked axis is opposite to the one that the step turns about.
    pub(crate) sign: f64,
}

/// How many coordinates a joint shows.
pub(crate) fn coordinate_count<T: Real>(kind: &JointKind<T>, planar: bool) -> usize {
    match kind {
        JointKind::Revolute { .. } | JointKind::Prismatic { .. } | JointKind::Screw { .. } => 1,
        JointKind::Distance { .. } | JointKind::PointOnLine { .. } => 1,
        JointKind::Cylindrical { .. } | JointKind::Universal { .. } => 2,
        JointKind::Spherical | JointKind::Planar => 3,
        JointKind::Modes { count } => *count,
        JointKind::Free | JointKind::Elastic => {
            if planar {
                3
            } else {
                6
            }
        }
        JointKind::Weld | JointKind::Coupler { .. } => 0,
    }
}

/// The elementary motions of a joint, or `None` for a constraint that carries no body.
pub(crate) fn steps_of<S: Space>(joint: JointId, kind: &JointKind<S::T>) -> Result<Option<Vec<Step<S>>>, BuildError> {
    use JointKind as K;
    let planar = S::DIM == 2;
    let spatial_only = matches!(kind, K::Cylindrical { .. } | K::Screw { .. } | K::Universal { .. } | K::Spherical);
    if planar && spatial_only {
        return Err(BuildError::NotInPlane(joint));
    }
    let along = |axis: &[S::T; 3], motion| -> Result<Step<S>, BuildError> {
        Ok(Step { motion, align: joint_alignment::<S>(joint, axis, motion)?, sign: turn_sign::<S>(axis, motion) })
    };
    let one = S::T::one();
    let o = S::T::zero();
    let (x, y, z) = ([one, o, o], [o, one, o], [o, o, one]);
    Ok(Some(match kind {
        K::Revolute { axis } => vec![along(axis, Motion::Turn)?],
        K::Prismatic { axis } => vec![along(axis, Motion::Slide)?],
        K::Cylindrical { axis } => vec![along(axis, Motion::Slide)?, along(axis, Motion::Turn)?],
        K::Screw { axis, pitch } => {
            let lead = *pitch * S::T::from_f64(0.5 / std::f64::consts::PI);
            vec![along(axis, Motion::Screw(lead))?]
        }
        K::Universal { axis, axis2 } => {
            perpendicular(joint, axis, axis2)?;
            vec![along(axis, Motion::Turn)?, along(axis2, Motion::Turn)?]
        }
        K::Spherical => vec![Step { motion: Motion::Ball, align: S::identity(), sign: 1.0 }],
        K::Planar => vec![along(&x, Motion::Slide)?, along(&y, Motion::Slide)?, along(&z, Motion::Turn)?],
        K::Free if planar => vec![along(&x, Motion::Slide)?, along(&y, Motion::Slide)?, along(&z, Motion::Turn)?],
        K::Free => vec![
            along(&x, Motion::Slide)?,
            along(&y, Motion::Slide)?,
            along(&z, Motion::Slide)?,
            Step { motion: Motion::Ball, align: S::identity(), sign: 1.0 },
        ],
        K::Elastic if planar => vec![along(&x, Motion::Slide)?, along(&y, Motion::Slide)?, along(&z, Motion::Turn)?],
        K::Elastic => vec![
            along(&x, Motion::Slide)?,
            along(&y, Motion::Slide)?,
            along(&z, Motion::Slide)?,
            along(&x, Motion::Turn)?,
            along(&y, Motion::Turn)?,
            along(&z, Motion::Turn)?,
        ],
        K::Modes { count } => vec![along(&x, Motion::Slide)?; *count],
        K::Weld => vec![Step { motion: Motion::Fixed, align: S::identity(), sign: 1.0 }],
        K::Distance { .. } | K::PointOnLine { .. } | K::Coupler { .. } => return Ok(None),
    }))
}

/// In the plane everything turns about +z; an axis along −z counts backwards.
fn turn_sign<S: Space>(axis: &[S::T; 3], motion: Motion<S::T>) -> f64 {
    if S::DIM == 2 && matches!(motion, Motion::Turn) && axis[2].value() < 0.0 { -1.0 } else { 1.0 }
}

fn perpendicular<T: Real>(joint: JointId, a: &[T; 3], b: &[T; 3]) -> Result<(), BuildError> {
    let (a, b) = (a.map(Real::value), b.map(Real::value));
    let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    let cos = dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
    if cos.is_nan() {
        return Err(BuildError::NoAxis(joint));
    }
    if cos.abs() > 1e-9 {
        return Err(BuildError::NotPerpendicular { joint, angle: cos.clamp(-1.0, 1.0).acos() });
    }
    Ok(())
}

/// The rotation whose motion axis (z for turns, the slide axis for slides) is `axis`.
pub(crate) fn joint_alignment<S: Space>(
    joint: JointId,
    axis: &[S::T; 3],
    motion: Motion<S::T>,
) -> Result<S::Rotation, BuildError> {
    if S::DIM == 2 && matches!(motion, Motion::Turn) {
        return Ok(S::identity());
    }
    let length = axis.iter().fold(S::T::zero(), |s, x| s + *x * *x).sqrt();
    if !(length.value() > 0.0 && length.value().is_finite()) {
        return Err(BuildError::NoAxis(joint));
    }
    let a = axis.map(|x| x / length);
    if S::DIM == 2 {
        return along_in_plane::<S>(joint, &a);
    }
    Ok(S::from_matrix(&frame_about(&a)))
}

fn along_in_plane<S: Space>(joint: JointId, a: &[S::T; 3]) -> Result<S::Rotation, BuildError> {
    if a[2].value().abs() > 1e-12 {
        return Err(BuildError::AxisOutOfPlane(joint));
    }
    let (o, one) = (S::T::zero(), S::T::one());
    Ok(S::from_matrix(&[[a[0], -a[1], o], [a[1], a[0], o], [o, o, one]]))
}

/// Rows of a rotation whose third column is the unit vector `a`; the identity for z.
fn frame_about<T: Real>(a: &[T; 3]) -> [[T; 3]; 3] {
    let smallest = (0..3).fold(0, |b, i| if a[i].value().abs() < a[b].value().abs() { i } else { b });
    let mut x = [T::zero(); 3];
    for (i, xi) in x.iter_mut().enumerate() {
        let e = if i == smallest { T::one() } else { T::zero() };
        *xi = e - a[i] * a[smallest];
    }
    let n = (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
    let x = x.map(|v| v / n);
    let y = [a[1] * x[2] - a[2] * x[1], a[2] * x[0] - a[0] * x[2], a[0] * x[1] - a[1] * x[0]];
    std::array::from_fn(|i| [x[i], y[i], a[i]])
}
