//! How the second place of a sliding joint moves on the first body.

use super::scale::some_frames;
use super::vector::{V3, along, dot, norm, place, sub, turned_back, unit};
use crate::{Animation, DrawnJoint};

/// Path of the second place along the axis, seen from the first body.
pub(super) struct Travel {
    /// Axis of length one, first body.
    pub(super) axis: V3,
    /// Smallest and largest distance from the first place along the axis, m.
    pub(super) low: f64,
    pub(super) high: f64,
    /// Where the path would cross the plane of the first place, first body, m.
    pub(super) origin: V3,
    /// How far the path passes by the first place, m.
    pub(super) aside: f64,
}

impl Travel {
    /// Nothing where there is no frame.
    pub(super) fn of(joint: &DrawnJoint, animation: &Animation) -> Option<Travel> {
        let axis = unit(joint.axis, [0.0, 0.0, 1.0]);
        let (first, at) = joint.first;
        let seen: Vec<V3> = some_frames(animation)
            .filter_map(|frame| {
                let pose = frame.get(first)?;
                let end = place(frame.get(joint.second.0)?, joint.second.1);
                Some(sub(turned_back(pose.quaternion, sub(end, pose.position)), at))
            })
            .collect();
        let start = *seen.first()?;
        let by_side = along(start, -dot(axis, start), axis);
        let places = seen.iter().map(|d| dot(axis, *d));
        Some(Travel {
            low: places.clone().fold(f64::INFINITY, f64::min),
            high: places.fold(f64::NEG_INFINITY, f64::max),
            axis,
            origin: along(at, 1.0, by_side),
            aside: norm(by_side),
        })
    }

    /// The two ends stay apart, and a rod can be pulled from a barrel all the way.
    pub(super) fn is_cylinder(&self) -> bool {
        let (near, far) = self.apart();
        self.low * self.high > 0.0 && far < 1.9 * near && self.aside < 0.15 * near
    }

    /// Smallest and largest distance of the two ends, m.
    pub(super) fn apart(&self) -> (f64, f64) {
        let (a, b) = (self.low.abs(), self.high.abs());
        (a.min(b), a.max(b))
    }

    /// 1 where the second place lies on the positive side of the axis, else -1.
    pub(super) fn side(&self) -> f64 {
        if self.low + self.high < 0.0 { -1.0 } else { 1.0 }
    }
}
