//! A pin through flat links, and the support under one that stands on the ground.

use super::super::bodies::{STEP, THICK, extent, raised};
use super::super::vector::{V3, along, cross};
use super::super::{Paint, Plan, Shape, Solid};
use super::rod;
use crate::DrawnJoint;

pub(super) fn pin(plan: &Plan<'_>, joint: &DrawnJoint) -> Vec<Solid> {
    let radius = plan.scale.between(joint.first.0, joint.second.0);
    let moving = [joint.first, joint.second].into_iter().filter(|(body, _)| *body != 0);
    let extents: Vec<[f64; 2]> = moving.map(|(body, _)| extent(plan, body)).collect();
    let low = extents.iter().map(|[low, _]| *low).fold(f64::INFINITY, f64::min);
    let high = extents.iter().map(|[_, high]| *high).fold(f64::NEG_INFINITY, f64::max);
    let ground = [joint.first, joint.second].into_iter().find(|(body, _)| *body == 0);
    let behind = (plan.scale.thickest - THICK * plan.scale.bar / 2.0).max(0.0);
    let back = f64::from(plan.layers.back()) * STEP * plan.scale.bar - behind;
    let half = THICK * plan.scale.bar / 2.0;
    let (low, head) = (if ground.is_some() { back - half } else { low }, half / 2.0);
    // The pin turns with neither; it is fixed on the body that moves.
    let (body, at) = if joint.second.0 == 0 { joint.first } else { joint.second };
    let mut parts = vec![rod(body, raised(at, low - head), raised(at, high + head), 0.48 * radius, Paint::Steel)];
    if joint.driven {
        let foot = high;
        parts.push(rod(
            body,
            raised(at, foot),
            raised(at, foot + 0.4 * THICK * plan.scale.bar),
            0.85 * radius,
            Paint::Drive,
        ));
    }
    parts.extend(ground.map(|(_, at)| support(plan, at, radius, back)));
    parts
}

/// A bracket that stands below the pin.
fn support(plan: &Plan<'_>, at: V3, radius: f64, z: f64) -> Solid {
    let (normal, up) = ([0.0, 0.0, 1.0], plan.drawing.up);
    let aside = cross(up, normal);
    let at = raised(at, z);
    let foot = |side: f64| along(along(at, -3.4 * radius, up), side * 1.9 * radius, aside);
    let points = vec![at, foot(-1.0), foot(1.0)];
    let shape = Shape::Plate { points, normal, radius: 0.8 * radius, thickness: THICK * plan.scale.bar };
    Solid { body: 0, shape, paint: Paint::Ground }
}
