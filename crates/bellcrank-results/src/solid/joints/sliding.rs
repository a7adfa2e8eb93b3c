//! Joints that slide: a rod in a barrel, or a block on its guide.

use super::super::bodies::{height, raised};
use super::super::travel::Travel;
use super::super::vector::{V3, along, cross, perpendicular, unit};
use super::super::{Paint, Plan, Shape, Solid};
use super::{on_second, paint, rod};
use crate::DrawnJoint;

pub(super) fn slider(plan: &Plan<'_>, joint: &DrawnJoint) -> Vec<Solid> {
    let Some(travel) = Travel::of(joint, plan.animation) else { return Vec::new() };
    if joint.kind != "point-on-line" && travel.is_cylinder() {
        cylinder(plan, joint, &travel)
    } else {
        block(plan, joint, &travel)
    }
}

/// Both parts lie in one layer, that of the body that moves.
fn layer(plan: &Plan<'_>, joint: &DrawnJoint) -> f64 {
    height(plan, if joint.first.0 == 0 { joint.second.0 } else { joint.first.0 })
}

/// A barrel on the first body, a rod on the second; at its longest the rod still ends inside.
fn cylinder(plan: &Plan<'_>, joint: &DrawnJoint, travel: &Travel) -> Vec<Solid> {
    let (near, _) = travel.apart();
    let z = layer(plan, joint);
    // Small cylinders are thin: two ends 100 mm apart hold no barrel of 60.
    let r = plan.scale.between(joint.first.0, joint.second.0).min(0.07 * near);
    let axis = travel.axis.map(|x| x * travel.side());
    let back = on_second(plan, joint, axis);
    let (foot, end) = (raised(joint.first.1, z), raised(joint.second.1, z));
    let barrel = Paint::Body;
    let mut parts = vec![
        rod(joint.first.0, along(foot, 0.04 * near, axis), along(foot, 0.84 * near, axis), 1.7 * r, barrel),
        rod(
            joint.first.0,
            along(foot, 0.84 * near, axis),
            along(foot, 0.84 * near + 1.1 * r, axis),
            1.9 * r,
            paint(joint, Paint::Steel),
        ),
        rod(joint.second.0, end, along(end, -0.97 * near, back), 0.75 * r, Paint::Steel),
    ];
    for (body, at) in [(joint.first.0, foot), (joint.second.0, end)] {
        let shape = Shape::Ball { center: at, radius: 1.5 * r };
        parts.push(Solid { body, shape, paint: Paint::Body });
    }
    parts
}

/// A guide on the first body over the whole way, a block on the second.
fn block(plan: &Plan<'_>, joint: &DrawnJoint, travel: &Travel) -> Vec<Solid> {
    let r = plan.scale.between(joint.first.0, joint.second.0);
    let z = layer(plan, joint);
    let on = |s: f64| raised(along(travel.origin, s, travel.axis), z);
    let paint_of_guide = if joint.first.0 == 0 { Paint::Ground } else { Paint::Steel };
    let guide = rod(joint.first.0, on(travel.low - 4.0 * r), on(travel.high + 4.0 * r), 0.7 * r, paint_of_guide);
    vec![guide, carriage(plan, joint, raised(joint.second.1, z), r)]
}

/// What runs on the guide.
fn carriage(plan: &Plan<'_>, joint: &DrawnJoint, at: V3, r: f64) -> Solid {
    let along_second = unit(on_second(plan, joint, super::axis(joint)), [1.0, 0.0, 0.0]);
    let paint = paint(joint, Paint::Body);
    let body = joint.second.0;
    if joint.kind == "point-on-line" {
        return Solid { body, shape: Shape::Ball { center: at, radius: 1.7 * r }, paint };
    }
    if joint.kind != "prismatic" {
        return rod(body, along(at, -2.2 * r, along_second), along(at, 2.2 * r, along_second), 1.6 * r, paint);
    }
    let across = if plan.planar() { cross([0.0, 0.0, 1.0], along_second) } else { upright(plan, joint, along_second) };
    let size = [4.6 * r, 3.0 * r, if plan.planar() { 2.0 * r } else { 3.0 * r }];
    Solid { body, shape: Shape::Block { center: at, along: along_second, across, size }, paint }
}

/// A direction across a guide that is level or upright where that is possible.
fn upright(plan: &Plan<'_>, joint: &DrawnJoint, axis: V3) -> V3 {
    let pose = plan.animation.frames.first().and_then(|frame| frame.get(joint.second.0));
    let up = pose.map_or(plan.drawing.up, |pose| super::super::vector::turned_back(pose.quaternion, plan.drawing.up));
    unit(cross(up, axis), perpendicular(axis))
}
