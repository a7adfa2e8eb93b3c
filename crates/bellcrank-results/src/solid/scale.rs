//! How thick parts are.

use super::vector::{V3, norm, place, sub};
use crate::{Animation, Drawing, SpaceKind};

/// Frames that are looked at for sizes.
const FRAMES: usize = 60;

/// Radii by body.
pub(super) struct Scale {
    /// Radius of a bar where nothing smaller is asked for, m.
    pub(super) bar: f64,
    bodies: Vec<f64>,
    /// How far real forms stand out of the plane, m.
    pub(super) thickest: f64,
}

impl Scale {
    /// Nothing where there is no frame or no size.
    pub(super) fn of(drawing: &Drawing, animation: &Animation) -> Option<Scale> {
        let places = places(drawing, animation);
        let reach = reach(&places);
        if !(reach.is_finite() && reach > 0.0) {
            return None;
        }
        let spans = spans(drawing);
        // A rail of metres does not make a gripper's fingers thick.
        let share = if matches!(drawing.space, SpaceKind::Planar) { 0.021 } else { 0.014 };
        let bar = (share * reach).min(0.11 * median(&spans).unwrap_or(reach));
        let of_body = |span: &f64| if *span > 0.0 { bar.min(0.13 * span) } else { bar };
        Some(Scale { bar, bodies: spans.iter().map(of_body).collect(), thickest: thickest(drawing) })
    }

    /// Radius of the bars of a body, m.
    pub(super) fn radius(&self, body: usize) -> f64 {
        self.bodies.get(body).copied().unwrap_or(self.bar)
    }

    /// Radius that suits both bodies of a joint, m.
    pub(super) fn between(&self, a: usize, b: usize) -> f64 {
        self.radius(a).min(self.radius(b))
    }
}

fn thickest(drawing: &Drawing) -> f64 {
    let points = drawing.bodies.iter().filter_map(|body| body.surface.as_ref()).flat_map(|surface| &surface.points);
    points.map(|p| p[2].abs()).fold(0.0, f64::max)
}

/// Frames spread over the motion.
pub(super) fn some_frames(animation: &Animation) -> impl Iterator<Item = &Vec<crate::Pose>> {
    animation.frames.iter().step_by(animation.frames.len().div_ceil(FRAMES).max(1))
}

/// World places of all that is drawn; points of the ground count only where a joint stands on them.
fn places(drawing: &Drawing, animation: &Animation) -> Vec<V3> {
    let points = drawing.bodies.iter().enumerate().skip(1);
    let mut all: Vec<(usize, V3)> =
        points.flat_map(|(index, body)| body.points.iter().map(move |(_, at)| (index, *at))).collect();
    all.extend(drawing.joints.iter().flat_map(|joint| [joint.first, joint.second]));
    some_frames(animation).flat_map(|frame| all.iter().filter_map(|(b, at)| Some(place(frame.get(*b)?, *at)))).collect()
}

/// Half the diagonal of the box around `places`, m.
fn reach(places: &[V3]) -> f64 {
    let side = |k: usize| {
        let low = places.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
        places.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max) - low
    };
    if places.is_empty() { 0.0 } else { norm([side(0), side(1), side(2)]) / 2.0 }
}

/// Largest distance of two points of each body; 0 for the ground and for single points.
fn spans(drawing: &Drawing) -> Vec<f64> {
    let span = |points: &[(String, V3)]| {
        let from = |(i, (_, a)): (usize, &(String, V3))| {
            points[..i].iter().map(|(_, b)| norm(sub(*a, *b))).fold(0.0, f64::max)
        };
        points.iter().enumerate().map(from).fold(0.0, f64::max)
    };
    let of = |(index, body): (usize, &crate::DrawnBody)| if index == 0 { 0.0 } else { span(&body.points) };
    drawing.bodies.iter().enumerate().map(of).collect()
}

fn median(spans: &[f64]) -> Option<f64> {
    let mut sorted: Vec<f64> = spans.iter().copied().filter(|span| *span > 0.0).collect();
    sorted.sort_by(f64::total_cmp);
    sorted.get(sorted.len() / 2).copied()
}
