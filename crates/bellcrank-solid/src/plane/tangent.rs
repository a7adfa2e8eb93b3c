//! Circles that touch two curves, and pieces of curves between places on them.

use bellcrank_math::Real;

use super::crossing::{circle_circle, line_circle};
use super::outline::Outline;
use super::segment::{Segment, arcs, sweep};
use super::vector::{Point, add, cross, distance, dot, left, scale, sub, unit, values};
use crate::Curve;

/// Whether two segments are pieces of one line or circle.
pub(crate) fn same(a: &Segment<f64>, b: &Segment<f64>, tolerance: f64) -> bool {
    match (&a.curve, &b.curve) {
        (Curve::Line, Curve::Line) => b.ends.iter().all(|p| a.offset(*p).0.abs() <= 4.0 * tolerance),
        (Curve::Arc { center, radius, .. }, Curve::Arc { center: other, radius: size, .. }) => {
            distance(*center, *other) <= 4.0 * tolerance && (radius - size).abs() <= 4.0 * tolerance
        }
        _ => false,
    }
}

/// Places at distances to the left of two curves.
pub(crate) fn meetings(a: &Segment<f64>, to_a: f64, b: &Segment<f64>, to_b: f64, tolerance: f64) -> Vec<Point<f64>> {
    match (moved(a, to_a), moved(b, to_b)) {
        (Some(Moved::Line(p, q)), Some(Moved::Line(v, w))) => {
            let (d, e) = (unit(sub(q, p)), unit(sub(w, v)));
            let sine = cross(d, e);
            if sine.abs() < 1e-9 { Vec::new() } else { vec![add(p, scale(d, cross(sub(v, p), e) / sine))] }
        }
        (Some(Moved::Line(p, q)), Some(Moved::Circle(c, r))) | (Some(Moved::Circle(c, r)), Some(Moved::Line(p, q))) => {
            line_circle([p, q], c, r, tolerance)
        }
        (Some(Moved::Circle(c, r)), Some(Moved::Circle(d, s))) => circle_circle((c, r), (d, s), tolerance),
        _ => Vec::new(),
    }
}

enum Moved {
    Line(Point<f64>, Point<f64>),
    Circle(Point<f64>, f64),
}

/// A curve moved to its left; `None` for a circle that would have no radius left.
fn moved(segment: &Segment<f64>, by: f64) -> Option<Moved> {
    match &segment.curve {
        Curve::Line => {
            let shift = scale(left(unit(sub(segment.ends[1], segment.ends[0]))), by);
            Some(Moved::Line(add(segment.ends[0], shift), add(segment.ends[1], shift)))
        }
        Curve::Arc { center, radius, counter_clockwise } => {
            let r = if *counter_clockwise { radius - by } else { radius + by };
            (r > 0.0).then_some(Moved::Circle(*center, r))
        }
    }
}

/// Length along a curve from one place on it to another less than half a turn ahead; `None` when it is behind.
pub(crate) fn ahead(curve: &Segment<f64>, from: Point<f64>, to: Point<f64>, tolerance: f64) -> Option<f64> {
    match &curve.curve {
        Curve::Line => {
            let length = dot(sub(to, from), unit(sub(curve.ends[1], curve.ends[0])));
            (length > tolerance).then_some(length)
        }
        Curve::Arc { center, radius, counter_clockwise } => {
            let angle = {
                let (u, v) = (sub(from, *center), sub(to, *center));
                let angle = cross(u, v).atan2(dot(u, v));
                if *counter_clockwise { angle } else { -angle }
            };
            (angle * radius > tolerance).then_some(angle * radius)
        }
    }
}

/// The piece of a curve between two places on it, in its direction.
pub(crate) fn piece<T: Real>(curve: &Segment<T>, from: Point<T>, to: Point<T>) -> Outline<T> {
    match &curve.curve {
        Curve::Line => vec![Segment::line(from, to)],
        Curve::Arc { center, radius, counter_clockwise } => {
            let turn = sweep(values(*center), values(from), values(to), *counter_clockwise);
            arcs(*center, *radius, from, to, turn)
        }
    }
}
