//! Force elements of a checked model.

use bellcrank_doc::Expression;
use bellcrank_multibody::Coordinate;

use super::{PointRef, Quantity, ScopeId};

/// A number of a force element.
#[derive(Clone, Debug)]
pub(crate) enum Load {
    /// Known before the run.
    Fixed(Box<Quantity>),
    /// Worked out at every position: place in [`super::Design::inputs`].
    Input(usize),
    /// Not given.
    Absent(f64),
}

/// An expression over signals that a force element uses.
#[derive(Clone, Debug)]
pub(crate) struct Input {
    pub(crate) scope: ScopeId,
    pub(crate) expression: Expression,
}

/// Axes that a vector is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axes {
    World,
    /// Of the body it acts on.
    Body,
    /// Of a point, wherever it is.
    Point(PointRef),
}

/// A force element.
#[derive(Debug)]
pub(crate) struct Force {
    pub(crate) name: String,
    pub(crate) shape: ForceShape,
}

/// What a force element does.
#[derive(Debug)]
pub(crate) enum ForceShape {
    Point {
        at: PointRef,
        vector: [Load; 3],
        axes: Axes,
    },
    Torque {
        on: usize,
        vector: [Load; 3],
        axes: Axes,
    },
    Effort {
        coordinate: Coordinate,
        value: Load,
    },
    Spring {
        between: [PointRef; 2],
        stiffness: Load,
        damping: Load,
        free_length: Load,
        preload: Load,
    },
    JointSpring {
        coordinate: Coordinate,
        stiffness: Load,
        damping: Load,
        free_position: Load,
        preload: Load,
    },
    Friction {
        coordinate: Coordinate,
        coulomb: Load,
        static_coefficient: Option<Load>,
        stribeck_velocity: Option<Load>,
        viscous: Load,
        radius: Option<Load>,
        smoothing_velocity: Option<Load>,
    },
    Stop {
        coordinate: Coordinate,
        min: Option<Load>,
        max: Option<Load>,
        stiffness: Load,
        damping: Load,
        restitution: Option<Load>,
    },
    Bushing {
        between: [PointRef; 2],
        stiffness: [Load; 6],
        damping: [Load; 6],
    },
}

impl ForceShape {
    /// Every value in it.
    pub(crate) fn each_load(&self, visit: &mut dyn FnMut(&Load)) {
        match self {
            ForceShape::Point { vector, .. } | ForceShape::Torque { vector, .. } => vector.iter().for_each(visit),
            ForceShape::Effort { value, .. } => visit(value),
            ForceShape::Spring { stiffness, damping, free_length: free, preload, .. }
            | ForceShape::JointSpring { stiffness, damping, free_position: free, preload, .. } => {
                [stiffness, damping, free, preload].into_iter().for_each(visit);
            }
            ForceShape::Friction {
                coulomb,
                static_coefficient,
                stribeck_velocity,
                viscous,
                radius,
                smoothing_velocity,
                ..
            } => {
                [coulomb, viscous].into_iter().for_each(&mut *visit);
                [static_coefficient, stribeck_velocity, radius, smoothing_velocity]
                    .into_iter()
                    .flatten()
                    .for_each(visit);
            }
            ForceShape::Stop { min, max, stiffness, damping, restitution, .. } => {
                [stiffness, damping].into_iter().for_each(&mut *visit);
                [min, max, restitution].into_iter().flatten().for_each(visit);
            }
            ForceShape::Bushing { stiffness, damping, .. } => stiffness.iter().chain(damping).for_each(visit),
        }
    }
}
