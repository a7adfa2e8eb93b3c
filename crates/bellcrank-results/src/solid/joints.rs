//! Joints: pins, balls, crosses, sleeves and barrels.

mod planar;
mod sliding;
mod turning;

use super::vector::{V3, turned, turned_back, unit};
use super::{Paint, Plan, Shape, Solid};
use crate::DrawnJoint;

/// Parts of all joints.
pub(super) fn parts(plan: &Plan<'_>) -> Vec<Solid> {
    plan.drawing.joints.iter().flat_map(|joint| of(plan, joint)).collect()
}

fn of(plan: &Plan<'_>, joint: &DrawnJoint) -> Vec<Solid> {
    match (joint.kind.as_str(), plan.planar()) {
        ("prismatic" | "cylindrical" | "point-on-line", _) => sliding::slider(plan, joint),
        ("screw", false) => [sliding::slider(plan, joint), turning::revolute(plan, joint)].concat(),
        // A rod between its ends changes its length: only its eyes are fixed on the bodies.
        ("distance", _) => turning::ball(plan, joint),
        ("free" | "coupler" | "weld" | "planar", _) => Vec::new(),
        (_, true) => planar::pin(plan, joint),
        ("spherical", _) => turning::ball(plan, joint),
        ("universal", _) => turning::universal(plan, joint),
        _ => turning::revolute(plan, joint),
    }
}

/// Paint of the part that a drive moves.
fn paint(joint: &DrawnJoint, otherwise: Paint) -> Paint {
    if joint.driven { Paint::Drive } else { otherwise }
}

/// A direction on the first body as the second one sees it in the first frame.
fn on_second(plan: &Plan<'_>, joint: &DrawnJoint, direction: V3) -> V3 {
    let pose = |body: usize| plan.animation.frames.first().and_then(|frame| frame.get(body));
    match (pose(joint.first.0), pose(joint.second.0)) {
        (Some(a), Some(b)) => turned_back(b.quaternion, turned(a.quaternion, direction)),
        _ => direction,
    }
}

fn axis(joint: &DrawnJoint) -> V3 {
    unit(joint.axis, [0.0, 0.0, 1.0])
}

/// A bar from `from` to `to` with flat ends.
fn rod(body: usize, from: V3, to: V3, radius: f64, paint: Paint) -> Solid {
    Solid { body, shape: Shape::Rod { from, to, radius, round: false }, paint }
}
