//! Joints that slide: a rod in a barrel, or a block on its guide.

use super::super::bodies::{height, raised};
use super::super::travel::Travel;
use super::super::vector::{V3, along, cross, perpendicular, turned_back, unit};
use super::super::{Paint, Plan, Shape, Solid};
use super::{on_second, paint, rod};
use crate::DrawnJoint;

pub(super) fn slider(plan: &Plan<'_>, joint: &DrawnJoint) -> Vec<Solid> {
    let Some(travel) = Travel::of(joint, plan.animation) else { return Vec::new() };
    let has_form = plan.block(joint.second.0).is_some();
    if joint.kind != "point-on-line" && !has_form && travel.is_cylinder() {
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
    let (near, far) = travel.apart();
    // A long way leaves little between the foot and the mouth of the barrel, and less of the rod in it.
    let (mouth, rod_length) = if far < 1.75 * near { (0.84 * near, 0.97 * near) } else { (0.95 * near, 0.99 * near) };
    let z = layer(plan, joint);
    // Small cylinders are thin: two ends 100 mm apart hold no barrel of 60.
    let r = plan.scale.between(joint.first.0, joint.second.0).min(0.07 * near);
    let axis = travel.axis.map(|x| x * travel.side());
    let back = on_second(plan, joint, axis);
    let (foot, end) = (raised(joint.first.1, z), raised(joint.second.1, z));
    let mut parts = vec![
        rod(joint.first.0, along(foot, 0.04 * near, axis), along(foot, mouth, axis), 1.7 * r, Paint::Body),
        rod(
            joint.first.0,
            along(foot, mouth - 1.1 * r, axis),
            along(foot, mouth, axis),
            1.9 * r,
            paint(joint, Paint::Steel),
        ),
        rod(joint.second.0, end, along(end, -rod_length, back), 0.75 * r, Paint::Steel),
    ];
    for (body, at) in [(joint.first.0, foot), (joint.second.0, end)] {
        let shape = Shape::Ball { center: at, radius: 1.5 * r };
        parts.push(Solid { body, shape, paint: Paint::Body });
    }
    parts
}

/// A guide on the first body over the whole way, a block on the second unless that has a form of its own.
fn block(plan: &Plan<'_>, joint: &DrawnJoint, travel: &Travel) -> Vec<Solid> {
    let r = plan.scale.between(joint.first.0, joint.second.0);
    let z = layer(plan, joint);
    let mut parts = vec![guide(plan, joint, travel, r, z)];
    if plan.block(joint.second.0).is_none() {
        parts.push(carriage(plan, joint, raised(joint.second.1, z), r));
    }
    parts
}

/// A rail where the second body cannot turn on it, else a round bar.
fn guide(plan: &Plan<'_>, joint: &DrawnJoint, travel: &Travel, r: f64, z: f64) -> Solid {
    let body = joint.first.0;
    let paint = if body == 0 { Paint::Ground } else { Paint::Steel };
    let on = |s: f64| raised(along(travel.origin, s, travel.axis), z);
    let (from, to) = (travel.low - 4.0 * r, travel.high + 4.0 * r);
    if joint.kind != "prismatic" {
        return rod(body, on(from), on(to), 0.7 * r, paint);
    }
    let across = sideways(plan, body, travel.axis);
    let size = [to - from, 1.5 * r, 1.5 * r];
    let shape = Shape::Block { center: on((from + to) / 2.0), along: travel.axis, across, size };
    Solid { body, shape, paint }
}

/// What runs on the guide.
fn carriage(plan: &Plan<'_>, joint: &DrawnJoint, at: V3, r: f64) -> Solid {
    let axis = unit(on_second(plan, joint, super::axis(joint)), [1.0, 0.0, 0.0]);
    let paint = paint(joint, Paint::Body);
    let body = joint.second.0;
    let shape = match joint.kind.as_str() {
        "point-on-line" => Shape::Ball { center: at, radius: 1.7 * r },
        "prismatic" => {
            let size = [4.6 * r, 3.0 * r, if plan.planar() { 2.0 * r } else { 3.0 * r }];
            Shape::Block { center: at, along: axis, across: sideways(plan, body, axis), size }
        }
        _ => return rod(body, along(at, -2.2 * r, axis), along(at, 2.2 * r, axis), 1.6 * r, paint),
    };
    Solid { body, shape, paint }
}

/// A direction on a body across an axis of it: in the plane, or level in the first frame where that is possible.
fn sideways(plan: &Plan<'_>, body: usize, axis: V3) -> V3 {
    if plan.planar() {
        return cross([0.0, 0.0, 1.0], axis);
    }
    let pose = plan.animation.frames.first().and_then(|frame| frame.get(body));
    let up = pose.map_or(plan.drawing.up, |pose| turned_back(pose.quaternion, plan.drawing.up));
    unit(cross(up, axis), perpendicular(axis))
}
