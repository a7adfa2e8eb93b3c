//! When motions begin and end, with numbers.

use crate::design::{Design, Law, Mark, Origin, Prescribed, Quantity, Segment, Values};
use crate::scalar::Scalar;

/// Beginnings of the motions of a design.
#[derive(Debug)]
pub(crate) struct Schedule<T> {
    begins: Vec<Option<T>>,
}

impl<T: Scalar> Schedule<T> {
    /// The beginnings with these numbers.
    pub(crate) fn new(design: &Design, values: &Values<T>) -> Schedule<T> {
        let mut schedule = Schedule { begins: vec![None; design.motions.len()] };
        // Each comes after the one it waits for; those in a circle are not in the order.
        for &motion in &design.motion_order {
            schedule.begins[motion] = schedule.of(design, &design.motions[motion], values);
        }
        schedule
    }

    /// When a motion begins, s; `None` where the file does not say it right.
    pub(crate) fn begin(&self, motion: usize) -> Option<T> {
        self.begins.get(motion).copied().flatten()
    }

    fn of(&self, design: &Design, motion: &Prescribed, values: &Values<T>) -> Option<T> {
        let from = match &motion.start.origin {
            Origin::Zero => T::zero(),
            Origin::Time(time) => time.eval(values),
            Origin::After(mark) => self.mark(design, *mark, values, true)?,
            Origin::With(mark) => self.mark(design, *mark, values, false)?,
            Origin::Unknown => return None,
        };
        let delay = motion.start.delay.as_ref();
        Some(delay.map_or(from, |delay: &Quantity| from + delay.eval(values)))
    }

    /// The beginning or the end of a motion or of one of its segments.
    fn mark(&self, design: &Design, mark: Mark, values: &Values<T>, end: bool) -> Option<T> {
        let begins = self.begin(mark.motion)?;
        let law = &design.motions.get(mark.motion)?.law;
        let since = match (mark.segment, end) {
            (None, false) => Some(T::zero()),
            (None, true) => duration(law, values),
            (Some(segment), _) => elapsed(law, segment + usize::from(end), values),
        };
        Some(begins + since?)
    }
}

/// How long a motion moves, s; `None` when it never ends.
pub(crate) fn duration<T: Scalar>(law: &Law, values: &Values<T>) -> Option<T> {
    match law {
        Law::Segments(segments) => elapsed(law, segments.len(), values),
        Law::Table(spline) => Some(T::from_f64(spline.span().1.max(0.0))),
        Law::Expressions(_) | Law::Velocity(_) => None,
    }
}

/// The time that the first `count` segments take.
fn elapsed<T: Scalar>(law: &Law, count: usize, values: &Values<T>) -> Option<T> {
    let Law::Segments(segments) = law else { return None };
    let lasts = |segment: &Segment| -> T { segment.duration.eval(values) };
    Some(segments.iter().take(count).map(lasts).fold(T::zero(), |sum, lasts| sum + lasts))
}
