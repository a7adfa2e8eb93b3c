//! Over positions: one coordinate is swept, one (the same unless given) moves at a given rate.

use bellcrank_math::Real;
use bellcrank_multibody::{Actuation, Coordinate};

use super::End;
use super::session::Session;
use crate::design::{Hold, Quantity, Sweep};
use crate::progress::Progress;
use crate::signals::Source;

/// What the study says.
pub(super) struct Plan<'p> {
    pub(super) sweep: &'p Sweep,
    pub(super) drive: Coordinate,
    pub(super) velocity: &'p Option<Quantity>,
    pub(super) acceleration: &'p Option<Quantity>,
    pub(super) holds: &'p [Hold],
}

/// Ask for progress and cancellation after so many rows.
pub(super) const STRIDE: usize = 64;

pub(super) fn run(session: &mut Session<'_>, plan: &Plan<'_>, progress: &mut dyn Progress) -> Result<(), End> {
    let swept = plan.sweep.coordinate;
    let (from, to) = (session.value(&plan.sweep.from), session.value(&plan.sweep.to));
    progress.at(0.0, "assembling");
    let needed = session.held(plan.holds);
    // A start of the swept coordinate selects the branch where the file says it; the sweep walks from there.
    let at = session.start(swept).unwrap_or(from);
    session.assemble(&needed, &[(swept, at)])?;
    let held: Vec<Coordinate> = plan.holds.iter().map(|hold| hold.coordinate).collect();
    let with = |first: Coordinate| std::iter::once(first).chain(held.iter().copied()).collect::<Vec<_>>();
    let rate = with(plan.drive);
    session.prepare(&Actuation { position: with(swept), rate: rate.clone(), effort: rate.clone() })?;
    session.expect_rows(plan.sweep.points, false)?;
    session.result.axis = vec![session.namer().signal(swept)];
    if session.design.input_signals.iter().any(|signal| signal.source == Source::Time) {
        session
            .result
            .warnings
            .push("forces that depend on `time` are taken at time 0: a sweep has no time".to_owned());
    }
    let mut targets: Vec<f64> = with(swept).iter().map(|&c| session.place(c)).collect();
    for (target, (_, place)) in targets.iter_mut().skip(1).zip(rested(plan.holds, &needed)) {
        *target = place.unwrap_or(*target);
    }
    let mut velocity = vec![0.0; rate.len()];
    let mut acceleration = vec![0.0; rate.len()];
    velocity[0] = plan.velocity.as_ref().map_or(0.0, |v| session.value(v));
    acceleration[0] = plan.acceleration.as_ref().map_or(0.0, |a| session.value(a));
    rows(session, plan, progress, Rows { from, to, targets, velocity, acceleration })
}

/// Places of the held coordinates, where the study or a start says them.
fn rested<'h>(
    holds: &'h [Hold],
    held: &'h [(Coordinate, f64)],
) -> impl Iterator<Item = (Coordinate, Option<f64>)> + 'h {
    holds.iter().map(|hold| {
        let place = held.iter().find(|(coordinate, _)| *coordinate == hold.coordinate);
        (hold.coordinate, place.map(|(_, place)| *place))
    })
}

struct Rows {
    from: f64,
    to: f64,
    /// The swept coordinate first.
    targets: Vec<f64>,
    velocity: Vec<f64>,
    acceleration: Vec<f64>,
}

fn rows(session: &mut Session<'_>, plan: &Plan<'_>, progress: &mut dyn Progress, rows: Rows) -> Result<(), End> {
    let Rows { from, to, mut targets, velocity, acceleration } = rows;
    let last = plan.sweep.points - 1;
    let namer = session.namer();
    let swept = plan.sweep.coordinate;
    for row in 0..=last {
        if row % STRIDE == 0 {
            progress.at(row as f64 / plan.sweep.points as f64, "sweeping");
            if progress.cancelled() {
                return Err(super::explain::cancelled(row));
            }
        }
        let before = targets[0];
        targets[0] = position(from, to, row, last);
        let now = targets[0];
        let between = || {
            format!("{} between {} and {}", namer.signal(swept), namer.place(swept, before), namer.place(swept, now))
        };
        let here = || format!("{} = {}", namer.signal(swept), namer.place(swept, now));
        let moved = session.move_to(0.0, &targets, &here)?;
        if moved.passed_change_point {
            session
                .notes
                .add("a change point was passed: the branch of the mechanism is not certain beyond it", &between);
        }
        let moved = session.solve_row(&velocity, &acceleration, &here);
        if moved.passed_dead_position && row > 0 {
            let message = format!("a dead position of `{}` was passed", namer.coordinate(plan.drive));
            session.notes.add(&message, &between);
        }
    }
    progress.at(1.0, "done");
    Ok(())
}

/// Equal steps, both ends exact.
pub(crate) fn position<T: Real>(from: T, to: T, row: usize, last: usize) -> T {
    let share = row as f64 / last as f64;
    from * T::from_f64(1.0 - share) + to * T::from_f64(share)
}
