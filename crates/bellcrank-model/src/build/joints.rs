//! Joints in numbers.

use bellcrank_doc::Diagnostic;
use bellcrank_multibody::{Joint as JointNumbers, JointKind, Place};

use super::Numbers;
use crate::design::{Direction, Joint, JointShape, PointRef, Quantity};
use crate::scalar::Scalar;

/// The joints, in the memory of those before.
pub(super) fn joints<T: Scalar>(
    numbers: &mut Numbers<'_, T>,
    points: &[Vec<Place<T>>],
    joints: &mut Vec<JointNumbers<T>>,
) {
    let design = numbers.design;
    joints.resize_with(design.joints.len(), nothing);
    for (joint, place) in design.joints.iter().zip(joints) {
        let start = std::mem::take(&mut place.start);
        *place = one(numbers, joint, points, start);
    }
}

/// A joint before its numbers are known.
fn nothing<T>() -> JointNumbers<T> {
    JointNumbers { kind: JointKind::Weld, places: None, start: Vec::new(), at_start: false }
}

fn one<T: Scalar>(
    numbers: &mut Numbers<'_, T>,
    joint: &Joint,
    points: &[Vec<Place<T>>],
    mut start: Vec<Option<T>>,
) -> JointNumbers<T> {
    let kind = kind(numbers, joint);
    let place = |at: PointRef| points[at.body][at.point].clone();
    let places = joint.connects.map(|[a, b]| [place(a), place(b)]);
    let what = format_args!("`start` of joint `{}`", joint.name);
    start.clear();
    start.extend(joint.start.iter().map(|value| value.as_ref().map(|value| numbers.number(value, what))));
    JointNumbers { kind, places, start, at_start: joint.at_start }
}

fn kind<T: Scalar>(numbers: &mut Numbers<'_, T>, joint: &Joint) -> JointKind<T> {
    let name = &joint.name;
    let mut axis_of = |direction: &Direction| axis(numbers, joint, direction);
    match &joint.shape {
        JointShape::Revolute { axis } => JointKind::Revolute { axis: axis_of(axis) },
        JointShape::Prismatic { axis } => JointKind::Prismatic { axis: axis_of(axis) },
        JointShape::Cylindrical { axis } => JointKind::Cylindrical { axis: axis_of(axis) },
        JointShape::Screw { axis, pitch } => JointKind::Screw {
            axis: axis_of(axis),
            pitch: numbers.number(pitch, format_args!("`pitch` of joint `{name}`")),
        },
        JointShape::Universal { axis, axis2 } => JointKind::Universal { axis: axis_of(axis), axis2: axis_of(axis2) },
        JointShape::Spherical => JointKind::Spherical,
        JointShape::Planar => JointKind::Planar,
        JointShape::Free => JointKind::Free,
        JointShape::Weld => JointKind::Weld,
        JointShape::Distance { length } => {
            JointKind::Distance { length: length.as_ref().map(|length| held_length(numbers, joint, length)) }
        }
        JointShape::PointOnLine { axis } => JointKind::PointOnLine { axis: axis_of(axis) },
        JointShape::Coupler { a, b, ratio, offset } => JointKind::Coupler {
            a: *a,
            b: *b,
            ratio: numbers.number(ratio, format_args!("`ratio` of joint `{name}`")),
            offset: offset
                .as_ref()
                .map_or(T::zero(), |offset| numbers.number(offset, format_args!("`offset` of joint `{name}`"))),
        },
    }
}

/// In the plane hinges turn about z (or -z: backwards), and slides stay in it.
fn axis<T: Scalar>(numbers: &mut Numbers<'_, T>, joint: &Joint, direction: &Direction) -> [T; 3] {
    let axis = numbers.direction(direction, format_args!("the axis of joint `{}`", joint.name));
    let [x, y, z] = axis.map(T::value);
    if !joint.planar || [x, y, z] == [0.0; 3] {
        return axis;
    }
    let about_z = x == 0.0 && y == 0.0;
    let report = |message: String, hint: &str| Diagnostic::error("not-in-plane", direction.span, message).hint(hint);
    if joint.kind == "revolute" && !about_z {
        let message = format!("joint `{}` turns about an axis other than z", joint.name);
        numbers.faults.push(report(
            message,
            "in the plane every hinge turns about z; leave `axis` out, or give `\"-z\"` to count backwards",
        ));
    } else if joint.kind != "revolute" && z != 0.0 {
        let message = format!("the axis of joint `{}` leaves the plane", joint.name);
        numbers.faults.push(report(
            message,
            "in the plane an axis is `\"x\"`, `\"y\"`, either with a minus, or a vector `[x, y]`",
        ));
    }
    axis
}

fn held_length<T: Scalar>(numbers: &mut Numbers<'_, T>, joint: &Joint, length: &Quantity) -> T {
    let what = format_args!("`length` of joint `{}`", joint.name);
    let value = numbers.number(length, what);
    if value.value() <= 0.0 {
        let message = format!("{what} is not positive");
        let hint = "two points that stay together are a `revolute` or `spherical` joint";
        numbers.faults.push(Diagnostic::error("negative", length.span(), message).hint(hint));
    }
    value
}
