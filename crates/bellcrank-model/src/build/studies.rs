//! Numbers of studies and motions that cannot be right.

use std::fmt::Arguments;

use bellcrank_doc::Diagnostic;

use super::programme::{left_out, programme_faults};
use super::{Numbers, forward};
use crate::design::{Design, Goal, Law, Origin, Over, Prescribed, Quantity, Segment, SegmentKind, Study, Sweep, Task};

/// Rows that a study over time may have.
const MOST_ROWS: f64 = 1e6;

impl Study {
    /// What is wrong with the numbers of this study.
    pub(crate) fn faults(&self, design: &Design) -> Vec<Diagnostic> {
        let mut faults = Vec::new();
        let mut numbers = Numbers { design, values: &self.values, faults: &mut faults };
        match &self.task {
            Task::Motion { over, holds, .. } => {
                held(&mut numbers, holds);
                check_over(&mut numbers, over);
            }
            Task::Statics { sweep, holds, motions } => {
                held(&mut numbers, holds);
                if let Some(sweep) = sweep {
                    ends(&mut numbers, sweep);
                }
                check_motions(&mut numbers, motions);
            }
            Task::Dynamics(of) => forward::check(&mut numbers, of),
            Task::Modes(of) => {
                held(&mut numbers, &of.holds);
                if let Some(sweep) = &of.sweep {
                    ends(&mut numbers, sweep);
                }
                check_motions(&mut numbers, &of.motions);
            }
            Task::Parts(of) => of.each_quantity(&mut |quantity| {
                numbers.number(quantity, format_args!("a value of study `{}`", self.name));
            }),
            Task::Ask(_) | Task::Later => {}
        }
        let acting = self.task.motions();
        faults.extend(left_out(design, acting, &self.name, self.span));
        // Times that are no numbers have been told.
        if faults.is_empty() {
            faults
                .extend(programme_faults(design, &self.values, acting).into_iter().map(|fault| in_study(fault, self)));
        }
        faults
    }
}

/// What comes of the motions or the parameters of one study is told with it.
fn in_study(fault: Diagnostic, study: &Study) -> Diagnostic {
    fault.also(study.span, "in this study")
}

pub(super) fn held(numbers: &mut Numbers<'_>, holds: &[crate::design::Hold]) {
    for at in holds.iter().filter_map(|hold| hold.at.as_ref()) {
        numbers.number(at, format_args!("the position of `hold`"));
    }
}

fn ends(numbers: &mut Numbers<'_>, sweep: &Sweep) {
    numbers.number(&sweep.from, format_args!("`from` of the sweep"));
    numbers.number(&sweep.to, format_args!("`to` of the sweep"));
}

fn check_over(numbers: &mut Numbers<'_>, over: &Over) {
    match over {
        Over::Positions { sweep, velocity, acceleration, .. } => {
            ends(numbers, sweep);
            for rate in [velocity, acceleration].into_iter().flatten() {
                numbers.number(rate, format_args!("the rate of the drive"));
            }
        }
        Over::Time { duration, step, motions, .. } => {
            let (lasts, each) = (
                above_zero(numbers, duration, format_args!("`duration`")),
                above_zero(numbers, step, format_args!("`step`")),
            );
            if let (Some(lasts), Some(each)) = (lasts, each) {
                check_rows(numbers, (step, "step"), lasts, each);
            }
            check_motions(numbers, motions);
        }
    }
}

/// Rows from the step between them, which has a name.
pub(super) fn check_rows(numbers: &mut Numbers<'_>, (step, key): (&Quantity, &str), lasts: f64, each: f64) {
    if each > lasts {
        numbers.report("out-of-range", step.span(), format!("`{key}` is longer than `duration`"));
    } else if lasts / each > MOST_ROWS {
        let message = format!("{:.0} steps are more than the {MOST_ROWS} that a study may have", lasts / each);
        numbers.report("out-of-range", step.span(), message);
    }
}

pub(super) fn above_zero(numbers: &mut Numbers<'_>, quantity: &Quantity, what: Arguments<'_>) -> Option<f64> {
    let before = numbers.faults.len();
    let value = numbers.number(quantity, what);
    if numbers.faults.len() == before && value <= 0.0 {
        numbers.report("out-of-range", quantity.span(), format!("{what} must be above zero"));
    }
    (value > 0.0).then_some(value)
}

pub(super) fn check_motions(numbers: &mut Numbers<'_>, motions: &[usize]) {
    let design = numbers.design;
    for motion in motions.iter().filter_map(|&index| design.motions.get(index)) {
        check_motion(numbers, motion);
    }
}

fn check_motion(numbers: &mut Numbers<'_>, motion: &Prescribed) {
    match &motion.law {
        Law::Velocity(rate) => {
            numbers.number(rate, format_args!("`velocity` of motion `{}`", motion.name));
        }
        Law::Segments(segments) => segments.iter().for_each(|segment| check_segment(numbers, motion, segment)),
        Law::Expressions(_) | Law::Table(_) => {}
    }
    if let Origin::Time(time) = &motion.start.origin {
        numbers.number(time, format_args!("`start` of motion `{}`", motion.name));
    }
    if let Some(delay) = &motion.start.delay {
        numbers.number(delay, format_args!("`delay` of motion `{}`", motion.name));
    }
}

fn check_segment(numbers: &mut Numbers<'_>, motion: &Prescribed, segment: &Segment) {
    above_zero(numbers, &segment.duration, format_args!("the time of a segment of motion `{}`", motion.name));
    if let SegmentKind::Move { goal, .. } = &segment.kind {
        let key = if matches!(goal, Goal::To(_)) { "to" } else { "by" };
        numbers.number(goal.quantity(), format_args!("`{key}` of a segment of motion `{}`", motion.name));
    }
}
