//! Joints in numbers.

use bellcrank_doc::Diagnostic;
use bellcrank_multibody::{Joint as JointNumbers, JointKind, Place};

use super::Numbers;
use crate::design::{Direction, Joint, JointShape, Quantity};

pub(super) fn joints(numbers: &mut Numbers<'_>, points: &[Vec<Place<f64>>]) -> Vec<JointNumbers<f64>> {
    let design = numbers.design;
    design.joints.iter().map(|joint| one(numbers, joint, points)).collect()
}

fn one(numbers: &mut Numbers<'_>, joint: &Joint, points: &[Vec<Place<f64>>]) -> JointNumbers<f64> {
    let kind = kind(numbers, joint);
    let place = |at: crate::design::PointRef| points[at.body][at.point].clone();
    let places = joint.connects.map(|[a, b]| [place(a), place(b)]);
    let what = format!("`start` of joint `{}`", joint.name);
    let mut start = |value: &Option<Quantity>| value.as_ref().map(|value| numbers.number(value, &what));
    let start: Vec<Option<f64>> = joint.start.iter().map(&mut start).collect();
    JointNumbers { kind, places, start, at_start: joint.at_start }
}

fn kind(numbers: &mut Numbers<'_>, joint: &Joint) -> JointKind<f64> {
    let mut axis_of = |direction: &Direction| axis(numbers, joint, direction);
    match &joint.shape {
        JointShape::Revolute { axis } => JointKind::Revolute { axis: axis_of(axis) },
        JointShape::Prismatic { axis } => JointKind::Prismatic { axis: axis_of(axis) },
        JointShape::Cylindrical { axis } => JointKind::Cylindrical { axis: axis_of(axis) },
        JointShape::Screw { axis, pitch } => {
            let axis = axis_of(axis);
            JointKind::Screw { axis, pitch: numbers.number(pitch, &format!("`pitch` of joint `{}`", joint.name)) }
        }
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
            ratio: numbers.number(ratio, &format!("`ratio` of joint `{}`", joint.name)),
            offset: offset
                .as_ref()
                .map_or(0.0, |offset| numbers.number(offset, &format!("`offset` of joint `{}`", joint.name))),
        },
    }
}

/// In the plane hinges turn about z (or -z: backwards), and slides stay in it.
fn axis(numbers: &mut Numbers<'_>, joint: &Joint, direction: &Direction) -> [f64; 3] {
    let axis = numbers.direction(direction, &format!("the axis of joint `{}`", joint.name));
    if !numbers.design.planar || axis == [0.0; 3] {
        return axis;
    }
    let about_z = axis[0] == 0.0 && axis[1] == 0.0;
    let report = |message: String, hint: &str| Diagnostic::error("not-in-plane", direction.span, message).hint(hint);
    if joint.kind == "revolute" && !about_z {
        let message = format!("joint `{}` turns about an axis other than z", joint.name);
        numbers.faults.push(report(
            message,
            "in the plane every hinge turns about z; leave `axis` out, or give `\"-z\"` to count backwards",
        ));
    } else if joint.kind != "revolute" && axis[2] != 0.0 {
        let message = format!("the axis of joint `{}` leaves the plane", joint.name);
        numbers.faults.push(report(
            message,
            "in the plane an axis is `\"x\"`, `\"y\"`, either with a minus, or a vector `[x, y]`",
        ));
    }
    axis
}

fn held_length(numbers: &mut Numbers<'_>, joint: &Joint, length: &Quantity) -> f64 {
    let what = format!("`length` of joint `{}`", joint.name);
    let value = numbers.number(length, &what);
    if value <= 0.0 {
        let message = format!("{what} is not positive");
        let hint = "two points that stay together are a `revolute` or `spherical` joint";
        numbers.faults.push(Diagnostic::error("negative", length.span(), message).hint(hint));
    }
    value
}
