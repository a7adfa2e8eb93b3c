//! A motion with numbers: what a run asks at every instant.

use std::sync::Arc;

use super::{Jet, Profile, Spline};
use crate::design::{Law, Quantity, Segment, SegmentKind, Values};
use crate::scalar::Scalar;

/// A motion with numbers.
#[derive(Debug)]
pub(crate) enum Running<'d, T = f64> {
    Segments(Vec<Stretch<T>>),
    Expressions { laws: &'d [Quantity], values: Vec<Vec<Jet<T>>> },
    Table(Arc<Spline>),
    Velocity { from: T, rate: T },
}

/// A segment with numbers.
#[derive(Debug)]
pub(crate) struct Stretch<T> {
    begins: T,
    lasts: T,
    from: T,
    to: T,
    profile: Profile,
}

impl<'d, T: Scalar> Running<'d, T> {
    /// The motion of `law` that starts at the position `from` (unused by laws that say where they are).
    pub(crate) fn new(law: &'d Law, values: &Values<T>, from: T) -> Running<'d, T> {
        match law {
            Law::Segments(segments) => Running::Segments(stretches(segments, values, from)),
            Law::Expressions(laws) => {
                let jets = |law: &Quantity| values.of(law.scope).iter().map(|&v| Jet::constant(T::of(v))).collect();
                Running::Expressions { laws, values: laws.iter().map(jets).collect() }
            }
            Law::Table(spline) => Running::Table(Arc::clone(spline)),
            Law::Velocity(rate) => Running::Velocity { from, rate: rate.eval(values) },
        }
    }

    /// Position, velocity and acceleration of coordinate `i` of the motion. A seed on `time` gives their derivatives
    /// by time, of the acceleration the jerk; at a joint of two pieces those of one side.
    pub(crate) fn at(&self, i: usize, time: T) -> Jet<T> {
        match self {
            Running::Segments(stretches) => along(stretches, time),
            Running::Expressions { laws, values } => match (laws.get(i), values.get(i)) {
                (Some(law), Some(values)) => law.expression.eval(values, &[Jet::variable(time)]),
                _ => Jet::default(),
            },
            Running::Table(spline) => spline.at(time),
            Running::Velocity { from, rate } => Jet::new(*from + *rate * time, *rate, T::zero()),
        }
    }
}

fn stretches<T: Scalar>(segments: &[Segment], values: &Values<T>, from: T) -> Vec<Stretch<T>> {
    let (mut begins, mut from) = (T::zero(), from);
    let stretch = |segment: &Segment| {
        let lasts: T = segment.duration.eval(values);
        let (to, profile) = match &segment.kind {
            SegmentKind::Move { to, profile } => (to.eval(values), *profile),
            SegmentKind::Hold => (from, Profile::Linear),
        };
        let stretch = Stretch { begins, lasts, from, to, profile };
        begins += lasts;
        from = to;
        stretch
    };
    segments.iter().map(stretch).collect()
}

/// At the joint of two segments the later one counts; after the last one everything rests.
fn along<T: Scalar>(stretches: &[Stretch<T>], time: T) -> Jet<T> {
    let next = stretches.partition_point(|s| s.begins.value() <= time.value());
    let Some(now) = stretches.get(next.saturating_sub(1)) else { return Jet::default() };
    let share = (time - now.begins) / now.lasts;
    // The end itself still belongs to the last segment; rounding of a step must not decide that.
    if share.value() > 1.0 + 1e-9 {
        return Jet::constant(now.to);
    }
    let way = now.to - now.from;
    let shape = now.profile.at(share.with_value(share.value().clamp(0.0, 1.0)));
    let value = now.from + way * shape.value;
    let value = if shape.value.value() == 1.0 { value.with_value(now.to.value()) } else { value };
    Jet::new(value, way * shape.first / now.lasts, way * shape.second / (now.lasts * now.lasts))
}
