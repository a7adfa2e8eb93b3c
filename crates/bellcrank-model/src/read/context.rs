//! One file while it is read.

use bellcrank_doc::{Diagnostic, Expression, Reader, Span, Spanned, Value};
use bellcrank_multibody::Coordinate;

use super::{Machine, Part};
use crate::design::{Components, Direction, PointRef, Quantity};
use crate::keyed::{Axis, AxisKind};
use crate::measure::Motion;

const TWO_POINTS: &str = "a list of two, as `[\"ground.O\", \"crank.O\"]`";

/// A file, its reader, and the space it is in.
#[derive(Clone, Copy)]
pub(crate) struct PartReader<'a> {
    pub(crate) part: &'a Part,
    pub(crate) reader: &'a Reader<'a>,
    pub(crate) planar: bool,
    /// The machine is in the plane.
    pub(crate) machine_planar: bool,
}

impl<'a> PartReader<'a> {
    /// A planar file that is part of a spatial machine.
    pub(crate) fn is_embedded(&self) -> bool {
        self.planar && !self.machine_planar
    }

    /// Number of dimensions.
    pub(crate) fn space(&self) -> usize {
        if self.planar { 2 } else { 3 }
    }

    pub(crate) fn prefix(&self) -> &'a str {
        &self.part.prefix
    }

    pub(crate) fn full(&self, name: &str) -> String {
        format!("{}{name}", self.part.prefix)
    }

    pub(crate) fn quantity(&self, expression: Expression) -> Quantity {
        Quantity { scope: self.part.scope, expression }
    }

    pub(crate) fn quantities(&self, expressions: Vec<Expression>) -> Vec<Quantity> {
        expressions.into_iter().map(|e| self.quantity(e)).collect()
    }

    pub(crate) fn direction(&self, axis: Axis) -> Direction {
        let components = match axis.kind {
            AxisKind::Letter(letter) => Components::Fixed(match letter {
                "x" => [1.0, 0.0, 0.0],
                "y" => [0.0, 1.0, 0.0],
                "-x" => [-1.0, 0.0, 0.0],
                "-y" => [0.0, -1.0, 0.0],
                "-z" => [0.0, 0.0, -1.0],
                _ => [0.0, 0.0, 1.0],
            }),
            AxisKind::Vector(values) => Components::Given(self.quantities(values)),
        };
        Direction { span: axis.span, components }
    }

    /// The z axis, where none is given.
    pub(crate) fn z(span: Span) -> Direction {
        Direction { span, components: Components::Fixed([0.0, 0.0, 1.0]) }
    }

    /// The point of a reference `body.point`.
    pub(crate) fn point(&self, machine: &Machine, written: Spanned<&str>) -> Option<PointRef> {
        match machine.point(written.value, self.prefix(), written.span) {
            Ok(point) => Some(point),
            Err(diagnostic) => {
                self.reader.report(*diagnostic);
                None
            }
        }
    }

    /// The two points of `connects` or `between`.
    pub(crate) fn pair(&self, machine: &Machine, value: &Value, what: &str) -> Option<[PointRef; 2]> {
        if value.as_str().is_some() {
            let message = format!("{what} needs two points, found one");
            self.reader.report(Diagnostic::error("wrong-type", value.span, message).hint(TWO_POINTS));
            return None;
        }
        let names = self.reader.strings(value, what)?;
        if names.len() != 2 {
            let message = format!("{what} needs two points, found {}", names.len());
            self.reader.report(Diagnostic::error("wrong-length", value.span, message).hint(TWO_POINTS));
            return None;
        }
        let points: Vec<Option<PointRef>> = names.into_iter().map(|name| self.point(machine, name)).collect();
        match points.as_slice() {
            [Some(a), Some(b)] => Some([*a, *b]),
            _ => None,
        }
    }

    /// The coordinate of a reference `joint` or `joint.1`, and what it counts.
    pub(crate) fn coordinate(&self, machine: &Machine, written: Spanned<&str>) -> Option<(Coordinate, Motion)> {
        match machine.coordinate(written.value, self.prefix(), written.span, self.planar) {
            Ok(found) => Some(found),
            // What is wrong with that joint has been told.
            Err(_) if machine.is_faulty(&self.full(written.value)) => None,
            Err(diagnostic) => {
                self.reader.report(*diagnostic);
                None
            }
        }
    }

    /// All coordinates of a reference to a joint, or the one of a reference `joint.1`.
    pub(crate) fn coordinates(&self, machine: &Machine, written: Spanned<&str>) -> Option<Vec<(Coordinate, Motion)>> {
        let joint = machine.joint_names.get(&self.full(written.value));
        let motions = joint.map_or(&[][..], |joint| machine.joints[joint].coordinates(self.planar));
        match joint {
            Some(joint) if motions.len() > 1 => {
                let joint = bellcrank_multibody::JointId(joint);
                let one = |(index, &motion)| (Coordinate { joint, index }, motion);
                Some(motions.iter().enumerate().map(one).collect())
            }
            _ => self.coordinate(machine, written).map(|one| vec![one]),
        }
    }
}
