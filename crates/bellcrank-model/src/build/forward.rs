//! Numbers of studies of dynamics that cannot be right, or that say two things.

use std::fmt::Arguments;
use std::ops::RangeInclusive;

use bellcrank_doc::Diagnostic;
use bellcrank_multibody::Coordinate;

use super::Numbers;
use super::studies::{above_zero, check_motions, check_rows, held};
use crate::design::{Design, Dynamics, Joint, Quantity, Study, Task};
use crate::motion::{Programme, Schedule};

/// Below, rounding is larger than what the integration may err.
const TOLERANCES: RangeInclusive<f64> = 1e-12..=0.1;

pub(super) fn check(numbers: &mut Numbers<'_>, of: &Dynamics) {
    held(numbers, &of.holds);
    let duration = above_zero(numbers, &of.duration, format_args!("`duration`"));
    let output = of.output_step.as_ref();
    let each = output.and_then(|step| above_zero(numbers, step, format_args!("`output_step`")));
    if let (Some(step), Some(lasts), Some(each)) = (output, duration, each) {
        check_rows(numbers, (step, "output_step"), lasts, each);
    }
    if let Some(tolerance) = &of.tolerance {
        within(numbers, tolerance, &TOLERANCES, format_args!("`tolerance` of a study of dynamics"));
    }
    if let Some(radius) = &of.spectral_radius {
        within(numbers, radius, &(0.0..=1.0), format_args!("`spectral_radius`"));
    }
    for (step, key) in [(&of.step, "step"), (&of.largest_step, "largest_step")] {
        if let Some(step) = step {
            above_zero(numbers, step, format_args!("`{key}`"));
        }
    }
    check_motions(numbers, &of.motions);
    start_velocities(numbers);
}

/// A number from .. to.
pub(super) fn within<T: crate::scalar::Scalar>(
    numbers: &mut Numbers<'_, T>,
    quantity: &Quantity,
    range: &RangeInclusive<f64>,
    what: Arguments<'_>,
) -> T {
    let number = numbers.number(quantity, what);
    if !range.contains(&number.value()) {
        let [from, to, found] = [*range.start(), *range.end(), number.value()].map(plain);
        let message = format!("{what} must lie in {from} to {to}, found {found}");
        numbers.report("out-of-range", quantity.span(), message);
    }
    number
}

/// Without a row of zeros.
fn plain(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-3 { format!("{value:e}") } else { value.to_string() }
}

fn start_velocities(numbers: &mut Numbers<'_>) {
    let design = numbers.design;
    for joint in &design.joints {
        for velocity in joint.start_velocity.iter().flatten() {
            numbers.number(velocity, format_args!("`start_velocity` of joint `{}`", joint.name));
        }
    }
}

/// Start velocities that a motion or `hold` of the study replaces by others: a warning each.
pub(crate) fn idle_velocities(design: &Design, study: &Study) -> Vec<Diagnostic> {
    let Task::Dynamics(of) = &study.task else { return Vec::new() };
    let mut found = Vec::new();
    let mut tell = |c: Coordinate, driven: f64, by: String| {
        let Some((joint, given)) = given(design, c) else { return };
        let value: f64 = given.eval(&study.values);
        if (value - driven).abs() <= 1e-9 * value.abs().max(driven.abs()) {
            return;
        }
        let message =
            format!("`start_velocity` of joint `{}` does not count in study `{}`: {by}", joint.name, study.name);
        found.push(Diagnostic::warning("start-velocity", given.span(), message));
    };
    for hold in &of.holds {
        tell(hold.coordinate, 0.0, "the study holds it".to_owned());
    }
    let start = |c: Coordinate| design.joints.get(c.joint.0)?.start.get(c.index)?.as_ref();
    let from = |c| start(c).map_or(0.0, |start| start.eval(&study.values));
    let schedule = Schedule::new(design, &study.values);
    let programme = Programme::new(design, &of.motions, &schedule, &study.values, &from);
    for track in &programme.tracks {
        let name = track.turns.first().and_then(|turn| design.motions.get(turn.motion)).map_or("", |m| m.name.as_str());
        tell(track.coordinate, track.at(0.0).first, format!("motion `{name}` moves it"));
    }
    found
}

fn given(design: &Design, c: Coordinate) -> Option<(&Joint, &Quantity)> {
    let joint = design.joints.get(c.joint.0)?;
    Some((joint, joint.start_velocity.get(c.index)?.as_ref()?))
}
