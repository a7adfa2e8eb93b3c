//! Lines and arcs between two places.

use bellcrank_math::Real;

use super::vector::{Point, add, constant, cross, distance, dot, left, norm, scale, sub, unit, values};
use crate::Curve;

/// A line or an arc shorter than half a turn; it runs from its first end to its second.
#[derive(Clone, Debug)]
pub(crate) struct Segment<T> {
    pub(crate) ends: [Point<T>; 2],
    pub(crate) curve: Curve<T>,
}

impl<T: Real> Curve<T> {
    /// The numbers without their derivatives.
    pub(crate) fn values(&self) -> Curve<f64> {
        match self {
            Curve::Line => Curve::Line,
            Curve::Arc { center, radius, counter_clockwise } => {
                Curve::Arc { center: values(*center), radius: radius.value(), counter_clockwise: *counter_clockwise }
            }
        }
    }

    /// The same curve run the other way.
    pub(crate) fn reversed(&self) -> Curve<T> {
        match self {
            Curve::Line => Curve::Line,
            Curve::Arc { center, radius, counter_clockwise } => {
                Curve::Arc { center: *center, radius: *radius, counter_clockwise: !counter_clockwise }
            }
        }
    }
}

impl<T: Real> Segment<T> {
    pub(crate) fn line(a: Point<T>, b: Point<T>) -> Self {
        Self { ends: [a, b], curve: Curve::Line }
    }

    pub(crate) fn values(&self) -> Segment<f64> {
        Segment { ends: self.ends.map(values), curve: self.curve.values() }
    }

    pub(crate) fn reversed(&self) -> Self {
        Self { ends: [self.ends[1], self.ends[0]], curve: self.curve.reversed() }
    }

    /// Distance of a place from the whole line or circle, positive to the left of its direction, and the
    /// direction of its steepest growth.
    pub(crate) fn offset(&self, p: Point<T>) -> (T, Point<T>) {
        match &self.curve {
            Curve::Line => {
                let normal = left(unit(sub(self.ends[1], self.ends[0])));
                (dot(normal, sub(p, self.ends[0])), normal)
            }
            Curve::Arc { center, radius, counter_clockwise } => {
                let from = sub(p, *center);
                let r = norm(from);
                let outward = scale(from, T::one() / r);
                let sign = T::from_f64(if *counter_clockwise { -1.0 } else { 1.0 });
                ((r - *radius) * sign, scale(outward, sign))
            }
        }
    }

    /// Nearest place on the whole line or circle.
    pub(crate) fn foot(&self, p: Point<T>) -> Point<T> {
        let (distance, normal) = self.offset(p);
        sub(p, scale(normal, distance))
    }
}

/// The place at distances `offsets` to the left of two curves, near a place where their values meet.
///
/// One step of Newton's method in `T` from a constant: exact in value and first derivatives. Where the curves
/// are tangent, the place follows the first one: along the curves it is free, and no integral over what they
/// bound sees it in first order.
pub(crate) fn meet<T: Real>(curves: [&Segment<T>; 2], offsets: [T; 2], near: Point<f64>) -> Point<T> {
    let p = constant::<T>(near);
    let (a, na) = curves[0].offset(p);
    let (b, nb) = curves[1].offset(p);
    let (a, b) = (offsets[0] - a, offsets[1] - b);
    let det = cross(na, nb);
    if det.value().abs() < 1e-6 {
        return add(p, scale(na, a));
    }
    let step = [(a * nb[1] - b * na[1]) / det, (na[0] * b - nb[0] * a) / det];
    add(p, step)
}

impl Segment<f64> {
    /// Angle run through, positive counter-clockwise; zero for a line.
    pub(crate) fn sweep(&self) -> f64 {
        match &self.curve {
            Curve::Line => 0.0,
            Curve::Arc { center, counter_clockwise, .. } => {
                sweep(*center, self.ends[0], self.ends[1], *counter_clockwise)
            }
        }
    }

    /// Length along it.
    pub(crate) fn length(&self) -> f64 {
        match &self.curve {
            Curve::Line => distance(self.ends[0], self.ends[1]),
            Curve::Arc { radius, .. } => radius * self.sweep().abs(),
        }
    }

    /// Length from its beginning to the foot of a place; negative or longer than the segment when outside.
    pub(crate) fn along(&self, p: Point<f64>) -> f64 {
        match &self.curve {
            Curve::Line => dot(sub(p, self.ends[0]), sub(self.ends[1], self.ends[0])) / self.length(),
            Curve::Arc { center, radius, counter_clockwise } => {
                let half = self.sweep() / 2.0;
                let middle = turned(sub(self.ends[0], *center), half);
                let to = sub(p, *center);
                let angle = cross(middle, to).atan2(dot(middle, to));
                let sign = if *counter_clockwise { 1.0 } else { -1.0 };
                radius * (half.abs() + sign * angle)
            }
        }
    }

    /// Whether a place is on it, within a tolerance.
    pub(crate) fn holds(&self, p: Point<f64>, tolerance: f64) -> bool {
        let along = self.along(p);
        self.offset(p).0.abs() <= tolerance && along >= -tolerance && along <= self.length() + tolerance
    }

    /// Lowest and highest coordinates, widened by a margin.
    pub(crate) fn bounds(&self, margin: f64) -> [Point<f64>; 2] {
        let [a, b] = self.ends;
        let bulge = match &self.curve {
            Curve::Line => 0.0,
            Curve::Arc { .. } => self.length() / 2.0,
        } + margin;
        [[a[0].min(b[0]) - bulge, a[1].min(b[1]) - bulge], [a[0].max(b[0]) + bulge, a[1].max(b[1]) + bulge]]
    }
}

/// A vector turned by an angle.
pub(crate) fn turned(a: Point<f64>, angle: f64) -> Point<f64> {
    let (s, c) = angle.sin_cos();
    [c * a[0] - s * a[1], s * a[0] + c * a[1]]
}

/// Angle from one place to another about a centre, in the direction given: in (-2 pi, 2 pi).
pub(crate) fn sweep(center: Point<f64>, from: Point<f64>, to: Point<f64>, counter_clockwise: bool) -> f64 {
    let (a, b) = (sub(from, center), sub(to, center));
    let angle = cross(a, b).atan2(dot(a, b));
    // Rounding about zero must not become a whole turn: segments are shorter than half a turn.
    match counter_clockwise {
        true if angle < -1e-6 => angle + std::f64::consts::TAU,
        false if angle > 1e-6 => angle - std::f64::consts::TAU,
        _ => angle,
    }
}

/// Arcs from one direction through an angle (rad, positive counter-clockwise), each at most 120 degrees.
pub(crate) fn arcs<T: Real>(center: Point<T>, radius: T, from: Point<T>, to: Point<T>, sweep: f64) -> Vec<Segment<T>> {
    let count = (sweep.abs() / 2.2).ceil().max(1.0);
    let start = values(sub(from, center));
    let size = distance(start, [0.0; 2]);
    let place = |i: usize| {
        if i == 0 {
            return from;
        }
        if i as f64 >= count {
            return to;
        }
        let direction = scale(turned(start, sweep * i as f64 / count), 1.0 / size);
        add(center, scale(constant(direction), radius))
    };
    let curve = Curve::Arc { center, radius, counter_clockwise: sweep > 0.0 };
    (0..count as usize).map(|i| Segment { ends: [place(i), place(i + 1)], curve: curve.clone() }).collect()
}
