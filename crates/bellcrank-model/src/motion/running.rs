//! A motion with numbers: what a run asks at every instant.

use std::sync::Arc;

use super::{Jet, Profile, Spline};
use crate::design::{Law, Quantity, Segment, SegmentKind, Values};

/// A motion with numbers.
#[derive(Debug)]
pub(crate) enum Running<'d> {
    Segments(Vec<Stretch>),
    Expressions { laws: &'d [Quantity], values: Vec<Vec<Jet>> },
    Table(Arc<Spline>),
    Velocity { from: f64, rate: f64 },
}

/// A segment with numbers.
#[derive(Debug)]
pub(crate) struct Stretch {
    begins: f64,
    lasts: f64,
    from: f64,
    to: f64,
    profile: Profile,
}

impl<'d> Running<'d> {
    /// The motion of `law` that starts at the position `from` (unused by laws that say where they are).
    pub(crate) fn new(law: &'d Law, values: &Values, from: f64) -> Running<'d> {
        match law {
            Law::Segments(segments) => Running::Segments(stretches(segments, values, from)),
            Law::Expressions(laws) => {
                let jets = |law: &Quantity| values.of(law.scope).iter().map(|&v| Jet::from(v)).collect();
                Running::Expressions { laws, values: laws.iter().map(jets).collect() }
            }
            Law::Table(spline) => Running::Table(Arc::clone(spline)),
            Law::Velocity(rate) => Running::Velocity { from, rate: rate.eval(values) },
        }
    }

    /// Position, velocity and acceleration of coordinate `i` of the motion.
    pub(crate) fn at(&self, i: usize, time: f64) -> Jet {
        match self {
            Running::Segments(stretches) => along(stretches, time),
            Running::Expressions { laws, values } => match (laws.get(i), values.get(i)) {
                (Some(law), Some(values)) => law.expression.eval(values, &[Jet::variable(time)]),
                _ => Jet::default(),
            },
            Running::Table(spline) => spline.at(time),
            Running::Velocity { from, rate } => Jet::new(from + rate * time, *rate, 0.0),
        }
    }
}

fn stretches(segments: &[Segment], values: &Values, from: f64) -> Vec<Stretch> {
    let (mut begins, mut from) = (0.0, from);
    let stretch = |segment: &Segment| {
        let lasts = segment.duration.eval(values);
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
fn along(stretches: &[Stretch], time: f64) -> Jet {
    let next = stretches.partition_point(|s| s.begins <= time);
    let Some(now) = stretches.get(next.saturating_sub(1)) else { return Jet::default() };
    let share = (time - now.begins) / now.lasts;
    // The end itself still belongs to the last segment; rounding of a step must not decide that.
    if share > 1.0 + 1e-9 {
        return Jet::from(now.to);
    }
    let way = now.to - now.from;
    let shape = now.profile.at(share.clamp(0.0, 1.0));
    let value = if shape.value == 1.0 { now.to } else { now.from + way * shape.value };
    Jet::new(value, way * shape.first / now.lasts, way * shape.second / (now.lasts * now.lasts))
}
