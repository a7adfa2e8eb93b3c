//! What can go wrong, by entity id; `bellcrank-model` turns ids into names.

use crate::{Coordinate, JointId};
use std::fmt;

/// A blueprint that makes no mechanism.
#[derive(Clone, Debug, PartialEq)]
pub enum BuildError {
    /// This joint kind has no meaning in the plane.
    NotInPlane(JointId),
    /// An axis of zero length.
    NoAxis(JointId),
    /// An axis of a sliding joint in the plane that points out of it.
    AxisOutOfPlane(JointId),
    /// The axes of a universal joint are not perpendicular; angle between them in rad.
    NotPerpendicular {
        /// The joint.
        joint: JointId,
        /// Angle between the axes, rad.
        angle: f64,
    },
    /// A joint needs two places, or a coupler none.
    Places(JointId),
    /// A body id, joint id or coordinate that does not exist, in this joint.
    Dangling(JointId),
    /// A coordinate used by a force element that does not exist.
    NoCoordinate(Coordinate),
    /// A flexible body whose joints are not in the tree, or whose lists have not one entry a coordinate.
    Flexible(crate::BodyId),
    /// A coordinate that cannot be coupled, driven or sprung alone: one of three angles of a spherical joint.
    Attitude(Coordinate),
}

/// Which of the two square systems is singular.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// The one that finds the position from the prescribed coordinates.
    Position,
    /// The one that finds rates and forces from the drives.
    Drive,
}

/// The mathematics failed.
#[derive(Clone, Debug, PartialEq)]
pub enum MechanismError {
    /// No position closes the loops.
    NotAssembled {
        /// Largest remaining gap, m.
        gap: f64,
        /// Joints that stay open, worst first: gap in m, misalignment in rad.
        open: Vec<(JointId, f64, f64)>,
    },
    /// The drives leave motion free.
    UnderDriven {
        /// Degrees of freedom.
        freedom: usize,
        /// How many coordinates are driven.
        driven: usize,
        /// Coordinates that could still move, most mobile first.
        free: Vec<Coordinate>,
    },
    /// More drives than degrees of freedom, or drives that fight each other.
    OverDriven {
        /// Degrees of freedom.
        freedom: usize,
        /// How many coordinates are driven.
        driven: usize,
        /// Drives that depend on each other.
        conflicting: Vec<Coordinate>,
    },
    /// One of the three angles of a spherical or free joint is prescribed without the others, or out of order;
    /// or the coordinate does not exist.
    AttitudeAlone(Coordinate),
    /// A coordinate is driven twice.
    DrivenTwice(Coordinate),
    /// The continuation could not go on.
    Stopped {
        /// The coordinate that was moved (the first that differs).
        coordinate: Coordinate,
        /// Where it got to, SI.
        reached: f64,
        /// Where it should have gone, SI.
        asked: f64,
        /// Smallest singular value of the position system there, relative to the largest.
        singular_value: f64,
        /// Coordinates that move without bound there, most mobile first.
        mobile: Vec<Coordinate>,
    },
    /// Position is fine, but rates or forces are not determined here.
    Singular {
        /// Which system.
        system: System,
        /// Smallest singular value relative to the largest.
        singular_value: f64,
        /// Coordinates that move while the driven ones rest, most mobile first.
        mobile: Vec<Coordinate>,
    },
    /// The friction iteration did not settle: the joint jams.
    Jammed {
        /// The joint whose friction still changes most.
        joint: JointId,
        /// Relative change in the last iteration.
        change: f64,
    },
    /// No equilibrium was found.
    NoEquilibrium {
        /// Largest unbalanced generalized force, N or N·m.
        residual: f64,
        /// The coordinate it acts on.
        coordinate: Coordinate,
    },
    /// Flexible bodies found no shape that carries their loads: they buckle, or bend too far.
    NotSettled {
        /// The last change of the shapes, in machine sizes.
        part: f64,
    },
    /// Loops that rigid bodies cannot all meet and flexible ones only by bending: shapes cannot be prescribed one by
    /// one.
    BendsToClose {
        /// Shapes that take part.
        equations: usize,
    },
    /// Forces move a coordinate that nothing with mass moves along with: its acceleration is not determined.
    NoMass {
        /// Coordinates that move without moving mass, most mobile first.
        mobile: Vec<Coordinate>,
    },
    /// Velocities at the start that the constraints do not allow.
    VelocityConflict {
        /// The given velocities that do not fit: coordinate, asked, nearest possible, SI.
        conflicting: Vec<(Coordinate, f64, f64)>,
    },
    /// The steps in time became too small.
    StepCollapse {
        /// s.
        time: f64,
        /// Length of the last step tried, s.
        step: f64,
        /// The coordinate that changed most against what was expected of it.
        coordinate: Coordinate,
    },
    /// A hard stop stands in the way of what is driven, or of the start.
    Blocked {
        /// The stop.
        force: crate::ForceId,
        /// s.
        time: f64,
    },
    /// Events follow each other without time between them.
    EventStorm {
        /// s.
        time: f64,
        /// The force elements that switch; empty where conditions of the user do.
        forces: Vec<crate::ForceId>,
    },
    /// A number became infinite or undefined, in this quantity.
    NotFinite(&'static str),
}

impl fmt::Display for MechanismError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}
impl std::error::Error for MechanismError {}
impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}
impl std::error::Error for BuildError {}
