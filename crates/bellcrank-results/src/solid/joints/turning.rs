//! Joints that turn, in space.

use super::super::vector::{V3, along, cross, perpendicular, sub, unit};
use super::super::{Paint, Plan, Shape, Solid};
use super::{axis, on_second, paint, rod};
use crate::DrawnJoint;

/// A pin on the first body in a hub of the second; a driven one has its motor on the pin.
pub(super) fn revolute(plan: &Plan<'_>, joint: &DrawnJoint) -> Vec<Solid> {
    let r = plan.scale.between(joint.first.0, joint.second.0);
    let (first, second) = (joint.first, joint.second);
    let (pin, hub) = (axis(joint), on_second(plan, joint, axis(joint)));
    let on = |at: V3, s: f64, axis: V3| along(at, s * r, axis);
    let mut parts = vec![rod(first.0, on(first.1, -2.1, pin), on(first.1, 2.1, pin), 0.8 * r, Paint::Steel)];
    // A real form has its eye.
    if plan.surface(second.0).is_none() {
        parts.push(rod(second.0, on(second.1, -1.45, hub), on(second.1, 1.45, hub), 1.6 * r, Paint::Body));
    }
    if joint.driven {
        parts.push(rod(first.0, on(first.1, 1.55, pin), on(first.1, 3.6, pin), 1.75 * r, Paint::Drive));
    }
    parts.extend(stand(plan, joint, r));
    parts
}

/// A ball on the first body in a cup of the second.
pub(super) fn ball(plan: &Plan<'_>, joint: &DrawnJoint) -> Vec<Solid> {
    let r = plan.scale.between(joint.first.0, joint.second.0);
    let mut parts = vec![Solid {
        body: joint.first.0,
        shape: Shape::Ball { center: joint.first.1, radius: 1.75 * r },
        paint: paint(joint, Paint::Steel),
    }];
    if joint.kind == "distance" {
        let shape = Shape::Ball { center: joint.second.1, radius: 1.75 * r };
        parts.push(Solid { body: joint.second.0, shape, paint: paint(joint, Paint::Steel) });
    }
    parts.extend(stand(plan, joint, r));
    parts
}

/// Two pins that cross, each in its fork.
fn cross_pins(plan: &Plan<'_>, joint: &DrawnJoint, r: f64) -> [Solid; 2] {
    let (first, second) = (joint.first, joint.second);
    let pin = axis(joint);
    let other =
        unit(cross(toward(plan, second, on_second(plan, joint, pin)), on_second(plan, joint, pin)), perpendicular(pin));
    let on = |at: V3, s: f64, axis: V3| along(at, s * r, axis);
    [
        rod(first.0, on(first.1, -2.2, pin), on(first.1, 2.2, pin), 0.7 * r, Paint::Steel),
        rod(second.0, on(second.1, -2.2, other), on(second.1, 2.2, other), 0.7 * r, Paint::Steel),
    ]
}

/// A cross, a ball in its middle.
pub(super) fn universal(plan: &Plan<'_>, joint: &DrawnJoint) -> Vec<Solid> {
    let r = plan.scale.between(joint.first.0, joint.second.0);
    let middle = Shape::Ball { center: joint.second.1, radius: 1.35 * r };
    let mut parts = vec![Solid { body: joint.second.0, shape: middle, paint: paint(joint, Paint::Body) }];
    parts.extend(cross_pins(plan, joint, r));
    parts.extend(stand(plan, joint, r));
    parts
}

/// A direction in which a body leaves a place, not along `axis`.
fn toward(plan: &Plan<'_>, (body, at): (usize, V3), axis: V3) -> V3 {
    let points = plan.drawing.bodies.get(body).map_or(&[][..], |body| &body.points);
    let away = points.iter().map(|(_, p)| sub(*p, at));
    let sines = away.map(|d| (unit(d, axis), cross(unit(d, axis), axis)));
    let best = sines.max_by(|a, b| super::super::vector::norm(a.1).total_cmp(&super::super::vector::norm(b.1)));
    best.filter(|(_, c)| super::super::vector::norm(*c) > 0.1).map_or(perpendicular(axis), |(d, _)| d)
}

/// A stand where one side is the ground: down to the floor where that is near.
fn stand(plan: &Plan<'_>, joint: &DrawnJoint, r: f64) -> Option<Solid> {
    let (_, at) = [joint.first, joint.second].into_iter().find(|(body, _)| *body == 0)?;
    let foot = along(at, -3.2 * r, plan.drawing.up);
    Some(rod(0, foot, along(at, -0.9 * r, plan.drawing.up), 1.9 * r, Paint::Ground))
}
