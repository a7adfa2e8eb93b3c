//! Motion over positions or over time: what is prescribed row by row, and what is said on the way.

use super::End;
use super::course::{Course, Laws, Path, Targets};
use super::programme::moves;
use super::session::Session;
use crate::design::{Hold, Origin, Over};
use crate::measure::Measure;
use crate::motion::{EPS, Programme, Running};
use crate::progress::Progress;
use crate::signals::Source;

/// Ask for progress and cancellation after so many rows.
const STRIDE: usize = 64;

pub(super) fn run<'d>(
    session: &mut Session<'d>,
    over: &'d Over,
    holds: &'d [Hold],
    progress: &mut dyn Progress,
) -> Result<(), End> {
    progress.at(0.0, "assembling");
    let motions: &[usize] = if let Over::Time { motions, .. } = over { motions } else { &[] };
    let course = session.begin(Path::Motion(over), holds, motions)?;
    session.prepare(&course.actuation)?;
    let has_time = matches!(over, Over::Time { .. });
    session.expect_rows(course.rows, has_time)?;
    session.result.axis = vec![session.axis_name()];
    if has_time {
        let last = course.rows.saturating_sub(1) as f64;
        let duration = session.laws(&course).axis(last);
        if let Some(programme) = session.laws(&course).programme() {
            tell_of_motions(session, programme, duration);
        }
    } else {
        warn_of_time(session);
    }
    rows(session, &course, progress)
}

fn rows(session: &mut Session<'_>, course: &Course<'_>, progress: &mut dyn Progress) -> Result<(), End> {
    let laws: Laws<'_> = session.laws(course);
    let mut targets = Targets::default();
    let mut before = f64::NAN;
    for row in 0..course.rows {
        if row % STRIDE == 0 {
            progress.at(row as f64 / course.rows as f64, "moving");
            if progress.cancelled() {
                return Err(super::explain::cancelled(row));
            }
        }
        let now = laws.axis(row as f64);
        laws.prescribe(now, &mut targets);
        one(session, &targets, [before, now], row)?;
        before = now;
    }
    progress.at(1.0, "done");
    Ok(())
}

/// One row; `axis` is the place of the row before and its own.
fn one(session: &mut Session<'_>, targets: &Targets, [before, now]: [f64; 2], row: usize) -> Result<(), End> {
    let says = session.places();
    let here = || says.at(now);
    let between = || if row == 0 { says.at(now) } else { says.between(before, now) };
    let moved = session.move_to(targets.time, &targets.position, &here)?;
    if moved.passed_change_point {
        let message = "a change point was passed: the branch of the mechanism is not certain beyond it";
        session.notes.add(message, &between);
    }
    let moved = session.solve_row(&targets.velocity, &targets.acceleration, &here);
    if moved.passed_dead_position && row > 0 {
        let message = format!("a dead position of {} was passed", says.drives());
        session.notes.add(&message, &between);
    }
    Ok(())
}

fn warn_of_time(session: &mut Session<'_>) {
    if session.design.input_signals.iter().any(|signal| signal.source == Source::Time) {
        let message = "forces that depend on `time` are taken at time 0: a sweep has no time";
        session.result.warnings.push(message.to_owned());
    }
}

/// What moves when, and what the motions do not do as the file may lead one to think.
pub(super) fn tell_of_motions(session: &mut Session<'_>, programme: &Programme<'_>, duration: f64) {
    session.result.programme = moves(session.design, programme);
    warn_of_late_motions(session, programme, duration);
    warn_of_short_tables(session, programme, duration);
    warn_of_moved_starts(session, programme);
}

/// A motion that the study ends before.
fn warn_of_late_motions(session: &mut Session<'_>, programme: &Programme<'_>, duration: f64) {
    let mut told = Vec::new();
    for turn in programme.tracks.iter().flat_map(|track| &track.turns) {
        if turn.begins >= duration * (1.0 - EPS) && !told.contains(&turn.motion) {
            told.push(turn.motion);
            let name = &session.design.motions[turn.motion].name;
            let (begins, end) = (session.shown(turn.begins, Measure::Time), session.shown(duration, Measure::Time));
            let message = format!("motion `{name}` begins at {begins}: the study ends at {end}, before it moves");
            session.result.warnings.push(message);
        }
    }
}

/// Segments and velocities count from the start: where the start of the file does not close, they begin elsewhere.
fn warn_of_moved_starts(session: &mut Session<'_>, programme: &Programme<'_>) {
    for track in &programme.tracks {
        let Some(first) = track.turns.first() else { continue };
        if !matches!(first.running, Running::Segments(_) | Running::Velocity { .. }) {
            continue;
        }
        let c = track.coordinate;
        let (Some(start), place) = (session.start(c), session.place(c)) else { continue };
        if (place - start).abs() > 1e-6 * start.abs().max(place.abs()).max(1e-3) {
            let (namer, name) = (session.namer(), &session.design.motions[first.motion].name);
            let (place, start) = (namer.place(c, place), namer.place(c, start));
            let message =
                format!("motion `{name}` begins at {place}: its start of {start} does not fit the other joints");
            session.result.warnings.push(message);
        }
    }
}

/// A table that says nothing of a time before or after it. One among other motions of its joint need not, nor one with
/// a start of its own.
fn warn_of_short_tables(session: &mut Session<'_>, programme: &Programme<'_>, duration: f64) {
    for track in &programme.tracks {
        let [turn] = track.turns.as_slice() else { continue };
        let motion = &session.design.motions[turn.motion];
        if let (Running::Table(spline), Origin::Zero) = (&turn.running, &motion.start.origin) {
            let (from, to) = (turn.begins + spline.span().0, turn.begins + spline.span().1);
            if from > 0.0 || to < duration {
                let (from, to) = (session.shown(from, Measure::Time), session.shown(to, Measure::Time));
                let message =
                    format!("motion `{}` has a table from {from} to {to}; outside of it the joint rests", motion.name);
                session.result.warnings.push(message);
            }
        }
    }
}
