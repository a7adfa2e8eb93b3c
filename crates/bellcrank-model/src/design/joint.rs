//! Joints of a checked model.

use bellcrank_doc::Span;
use bellcrank_multibody::Coordinate;

use super::{Direction, PointRef, Quantity};
use crate::measure::Motion;

/// A joint or constraint.
#[derive(Debug)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) span: Span,
    /// As in the file.
    pub(crate) kind: &'static str,
    pub(crate) shape: JointShape,
    pub(crate) connects: Option<[PointRef; 2]>,
    pub(crate) start: Vec<Option<Quantity>>,
    pub(crate) start_velocity: Vec<Option<Quantity>>,
    pub(crate) at_start: bool,
    /// It is of a planar file.
    pub(crate) planar: bool,
}

/// What a joint allows.
#[derive(Debug)]
pub(crate) enum JointShape {
    Revolute { axis: Direction },
    Prismatic { axis: Direction },
    Cylindrical { axis: Direction },
    Screw { axis: Direction, pitch: Quantity },
    Universal { axis: Direction, axis2: Direction },
    Spherical,
    Planar,
    Free,
    Weld,
    Distance { length: Option<Quantity> },
    PointOnLine { axis: Direction },
    Coupler { a: Coordinate, b: Coordinate, ratio: Quantity, offset: Option<Quantity> },
}

impl Joint {
    /// What each coordinate of this joint counts.
    pub(crate) fn coordinates(&self, planar: bool) -> &'static [Motion] {
        let held = matches!(self.shape, JointShape::Distance { length: Some(_) });
        if held { &[] } else { coordinates(self.kind, planar) }
    }
}

/// What each coordinate of a joint kind counts (a `distance` without length).
pub(crate) fn coordinates(kind: &str, planar: bool) -> &'static [Motion] {
    use Motion::{Slide, Turn};
    match kind {
        "revolute" | "screw" => &[Turn],
        "prismatic" | "distance" | "point-on-line" => &[Slide],
        "cylindrical" => &[Slide, Turn],
        "universal" => &[Turn, Turn],
        "spherical" => &[Turn, Turn, Turn],
        "planar" => &[Slide, Slide, Turn],
        "free" if planar => &[Slide, Slide, Turn],
        "free" => &[Slide, Slide, Slide, Turn, Turn, Turn],
        _ => &[],
    }
}

impl Direction {
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        if let super::Components::Given(components) = &self.components {
            components.iter().for_each(visit);
        }
    }
}

impl JointShape {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        match self {
            JointShape::Revolute { axis }
            | JointShape::Prismatic { axis }
            | JointShape::Cylindrical { axis }
            | JointShape::PointOnLine { axis } => axis.each_quantity(visit),
            JointShape::Screw { axis, pitch } => {
                axis.each_quantity(visit);
                visit(pitch);
            }
            JointShape::Universal { axis, axis2 } => {
                axis.each_quantity(visit);
                axis2.each_quantity(visit);
            }
            JointShape::Distance { length } => length.iter().for_each(visit),
            JointShape::Coupler { ratio, offset, .. } => {
                visit(ratio);
                offset.iter().for_each(visit);
            }
            JointShape::Spherical | JointShape::Planar | JointShape::Free | JointShape::Weld => {}
        }
    }
}
