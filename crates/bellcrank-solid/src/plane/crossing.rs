//! Where two segments meet.

use super::segment::Segment;
use super::vector::{Point, add, cross, distance, dot, left, scale, sub, unit};
use crate::Curve;

/// Places where two segments cross or touch. Ends of overlaps of the same line or circle are not among them.
///
/// Tangent curves meet in one place, the foot: a gap or an overlap below the tolerance is none.
pub(crate) fn crossings(a: &Segment<f64>, b: &Segment<f64>, tolerance: f64) -> Vec<Point<f64>> {
    let places = match (&a.curve, &b.curve) {
        (Curve::Line, Curve::Line) => line_line(a, b),
        (Curve::Line, Curve::Arc { center, radius, .. }) => line_circle(a.ends, *center, *radius, tolerance),
        (Curve::Arc { center, radius, .. }, Curve::Line) => line_circle(b.ends, *center, *radius, tolerance),
        (Curve::Arc { center, radius, .. }, Curve::Arc { center: other, radius: size, .. }) => {
            circle_circle((*center, *radius), (*other, *size), tolerance)
        }
    };
    places.into_iter().filter(|p| inside(a, *p, tolerance) && inside(b, *p, tolerance)).collect()
}

fn inside(segment: &Segment<f64>, p: Point<f64>, tolerance: f64) -> bool {
    let along = segment.along(p);
    along >= -tolerance && along <= segment.length() + tolerance
}

fn line_line(a: &Segment<f64>, b: &Segment<f64>) -> Vec<Point<f64>> {
    let (u, v) = (unit(sub(a.ends[1], a.ends[0])), unit(sub(b.ends[1], b.ends[0])));
    let sine = cross(u, v);
    if sine.abs() < 1e-13 {
        return Vec::new();
    }
    let along = cross(sub(b.ends[0], a.ends[0]), v) / sine;
    vec![add(a.ends[0], scale(u, along))]
}

/// Places where a line meets a circle.
pub(crate) fn line_circle(line: [Point<f64>; 2], center: Point<f64>, radius: f64, tolerance: f64) -> Vec<Point<f64>> {
    let u = unit(sub(line[1], line[0]));
    let foot = add(line[0], scale(u, dot(sub(center, line[0]), u)));
    let d = distance(foot, center);
    about(foot, u, radius - d, radius + d, tolerance)
}

/// Places where two circles meet.
pub(crate) fn circle_circle(a: (Point<f64>, f64), b: (Point<f64>, f64), tolerance: f64) -> Vec<Point<f64>> {
    let d = distance(a.0, b.0);
    let (outer, inner) = (a.1 + b.1 - d, d - (a.1 - b.1).abs());
    if d <= tolerance || outer < -tolerance || inner < -tolerance {
        return Vec::new();
    }
    let u = scale(sub(b.0, a.0), 1.0 / d);
    if outer.abs() <= tolerance {
        return vec![add(a.0, scale(u, a.1))];
    }
    if inner.abs() <= tolerance {
        let far = if a.1 > b.1 { a.1 } else { -a.1 };
        return vec![add(a.0, scale(u, far))];
    }
    // Distance of the common chord from the first centre.
    let x = (d * d + (a.1 - b.1) * (a.1 + b.1)) / (2.0 * d);
    about(add(a.0, scale(u, x)), left(u), a.1 - x.abs(), a.1 + x.abs(), 0.0)
}

/// Both places at half a chord from a foot; the foot alone where the chord is none.
fn about(foot: Point<f64>, along: Point<f64>, less: f64, more: f64, tolerance: f64) -> Vec<Point<f64>> {
    if less.abs() <= tolerance {
        return vec![foot];
    }
    if less < 0.0 {
        return Vec::new();
    }
    let half = (less * more).sqrt();
    vec![sub(foot, scale(along, half)), add(foot, scale(along, half))]
}
