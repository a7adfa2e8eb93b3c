//! A motion of one coordinate with numbers: what a run asks at every instant.

use std::sync::Arc;

use super::{EPS, Jet, Profile, Spline};
use crate::design::{Goal, Law, Quantity, Segment, SegmentKind, Values};
use crate::scalar::Scalar;

/// A motion of one coordinate with numbers. Its time counts from its start.
#[derive(Debug)]
pub(crate) enum Running<'d, T = f64> {
    Segments(Vec<Stretch<T>>),
    Expression {
        law: &'d Quantity,
        values: Vec<Jet<T>>,
    },
    Table(Arc<Spline>),
    Velocity {
        from: T,
        rate: T,
    },
    /// Nothing is said of the coordinate: it stays.
    Rest(T),
}

/// A segment with numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch<T> {
    /// Since the start of the motion.
    pub(crate) begins: T,
    pub(crate) lasts: T,
    pub(crate) from: T,
    pub(crate) to: T,
    profile: Profile,
    /// It holds.
    pub(crate) rests: bool,
}

impl<'d, T: Scalar> Running<'d, T> {
    /// The motion that `law` gives its coordinate `i`, from the position `from` (unused by laws that say where they
    /// are).
    pub(crate) fn new(law: &'d Law, i: usize, values: &Values<T>, from: T) -> Running<'d, T> {
        match law {
            Law::Segments(segments) => Running::Segments(stretches(segments, values, from)),
            Law::Expressions(laws) => match laws.get(i) {
                Some(law) => {
                    let values = values.of(law.scope).iter().map(|&v| Jet::constant(T::of(v))).collect();
                    Running::Expression { law, values }
                }
                None => Running::Rest(from),
            },
            Law::Table(spline) => Running::Table(Arc::clone(spline)),
            Law::Velocity(rate) => Running::Velocity { from, rate: rate.eval(values) },
        }
    }

    /// Position, velocity and acceleration at a time since the start, at rest before it. A seed on `time` gives their
    /// derivatives by time, of the acceleration the jerk; at a joint of two pieces those of one side.
    pub(crate) fn at(&self, time: T) -> Jet<T> {
        if time.value() < 0.0 {
            return Jet::constant(self.at(T::zero()).value);
        }
        match self {
            Running::Segments(stretches) => along(stretches, time),
            Running::Expression { law, values } => law.expression.eval(values, &[Jet::variable(time)]),
            Running::Table(spline) => spline.at(within(time, spline.span().1)),
            Running::Velocity { from, rate } => Jet::new(*from + *rate * time, *rate, T::zero()),
            Running::Rest(place) => Jet::constant(*place),
        }
    }

    /// Where it rests in the end; `None` of a motion without one.
    pub(crate) fn end(&self) -> Option<T> {
        match self {
            Running::Segments(stretches) => stretches.last().map(|last| last.to),
            Running::Table(spline) => Some(T::from_f64(spline.last())),
            Running::Rest(place) => Some(*place),
            Running::Expression { .. } | Running::Velocity { .. } => None,
        }
    }

    /// Times since the start at which the acceleration or its rate jumps, but for the inner points of a table, where
    /// the acceleration is continuous.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        let mut breaks = vec![0.0];
        match self {
            Running::Segments(stretches) => breaks.extend(stretches.iter().flat_map(Stretch::breaks)),
            Running::Table(spline) => breaks.extend([spline.span().0, spline.span().1].map(|end| end.max(0.0))),
            Running::Expression { .. } | Running::Velocity { .. } | Running::Rest(_) => {}
        }
        breaks
    }
}

impl<T: Scalar> Stretch<T> {
    /// How it goes, in the word of the format; `None` of a hold.
    pub(crate) fn profile(&self) -> Option<&'static str> {
        (!self.rests).then(|| self.profile.name())
    }

    fn breaks(&self) -> impl Iterator<Item = f64> + use<T> {
        let (begins, lasts) = (self.begins.value(), self.lasts.value());
        let inner = if self.rests { &[][..] } else { self.profile.breaks() };
        inner.iter().map(move |share| begins + lasts * share).chain([begins + lasts])
    }
}

/// A time that rounding has put beyond the end is the end.
fn within<T: Scalar>(time: T, end: f64) -> T {
    let beyond = time.value() - end;
    if beyond > 0.0 && beyond <= EPS * end.max(1.0) { time.with_value(end) } else { time }
}

fn stretches<T: Scalar>(segments: &[Segment], values: &Values<T>, from: T) -> Vec<Stretch<T>> {
    let (mut begins, mut from) = (T::zero(), from);
    let stretch = |segment: &Segment| {
        let lasts: T = segment.duration.eval(values);
        let (to, profile, rests) = match &segment.kind {
            SegmentKind::Move { goal: Goal::To(to), profile } => (to.eval(values), *profile, false),
            SegmentKind::Move { goal: Goal::By(way), profile } => (from + way.eval(values), *profile, false),
            SegmentKind::Hold => (from, Profile::Linear, true),
        };
        let stretch = Stretch { begins, lasts, from, to, profile, rests };
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
