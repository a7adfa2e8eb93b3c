//! Over time: motions prescribe coordinates, drives carry the efforts.

use bellcrank_math::Real;
use bellcrank_multibody::{Actuation, Coordinate};

use super::End;
use super::session::Session;
use super::sweep::STRIDE;
use crate::design::{Hold, Law, Prescribed, Quantity};
use crate::measure::Measure;
use crate::motion::Running;
use crate::progress::Progress;

/// What the study says.
pub(super) struct Plan<'p> {
    pub(super) duration: &'p Quantity,
    pub(super) step: &'p Quantity,
    pub(super) motions: &'p [usize],
    pub(super) drives: Option<&'p [Coordinate]>,
    pub(super) holds: &'p [Hold],
}

pub(super) fn run(session: &mut Session<'_>, plan: &Plan<'_>, progress: &mut dyn Progress) -> Result<(), End> {
    let design = session.design;
    let motions: Vec<&Prescribed> = plan.motions.iter().filter_map(|&index| design.motions.get(index)).collect();
    progress.at(0.0, "assembling");
    assemble(session, &motions, plan.holds)?;
    let moved = motions.iter().flat_map(|motion| motion.coordinates.iter().copied());
    let prescribed: Vec<Coordinate> = moved.chain(plan.holds.iter().map(|hold| hold.coordinate)).collect();
    let effort = match plan.drives {
        // Held coordinates rest by an effort of their own, whatever else drives the machine.
        Some(drives) => drives.iter().copied().chain(plan.holds.iter().map(|hold| hold.coordinate)).collect(),
        None => prescribed.clone(),
    };
    session.prepare(&Actuation { position: prescribed.clone(), rate: prescribed, effort })?;
    let times = Times::new(session.value(plan.duration), session.value(plan.step));
    session.expect_rows(times.rows, true)?;
    session.result.axis = vec!["time".to_owned()];
    warn_of_short_tables(session, &motions, times.duration);
    warn_of_moved_starts(session, &motions);
    let held = session.held(plan.holds);
    let rest = plan.holds.iter().map(|hold| {
        let place = held.iter().find(|(coordinate, _)| *coordinate == hold.coordinate);
        place.map_or_else(|| session.place(hold.coordinate), |(_, place)| *place)
    });
    let rest: Vec<f64> = rest.collect();
    let running = motions.iter().map(|motion| {
        let from = motion.coordinates.first().map_or(0.0, |&c| session.place(c));
        (Running::new(&motion.law, &session.study.values, from), motion.coordinates.len())
    });
    let running: Vec<(Running<'_>, usize)> = running.collect();
    rows(session, progress, &times, &running, &rest)
}

/// Assembles where motions begin: those that say where they are at time 0 are met, the others start from the file's
/// start.
fn assemble(session: &mut Session<'_>, motions: &[&Prescribed], holds: &[Hold]) -> Result<(), End> {
    let mut needed = session.held(holds);
    let mut wished = Vec::new();
    for motion in motions {
        match &motion.law {
            Law::Expressions(_) | Law::Table(_) => {
                let running = Running::new(&motion.law, &session.study.values, 0.0);
                let at = |(i, &c): (usize, &Coordinate)| (c, running.at(i, 0.0).value);
                needed.extend(motion.coordinates.iter().enumerate().map(at));
            }
            Law::Segments(_) | Law::Velocity(_) => {
                wished.extend(motion.coordinates.iter().filter_map(|&c| Some((c, session.start(c)?))));
            }
        }
    }
    session.assemble(&needed, &wished)
}

/// The instants of the rows: equal steps, the end exact.
pub(crate) struct Times<T = f64> {
    duration: T,
    step: T,
    pub(crate) rows: usize,
}

impl<T: Real> Times<T> {
    pub(crate) fn new(duration: T, step: T) -> Times<T> {
        // A step that fits but for rounding does not leave a sliver at the end.
        let steps = (duration.value() / step.value() - 1e-9).ceil().max(1.0);
        Times { duration, step, rows: steps as usize + 1 }
    }

    pub(crate) fn at(&self, row: usize) -> T {
        if row + 1 >= self.rows { self.duration } else { T::from_f64(row as f64) * self.step }
    }
}

fn rows(
    session: &mut Session<'_>,
    progress: &mut dyn Progress,
    times: &Times,
    running: &[(Running<'_>, usize)],
    rest: &[f64],
) -> Result<(), End> {
    let count = running.iter().map(|(_, count)| count).sum::<usize>() + rest.len();
    let (mut targets, mut velocity, mut acceleration) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
    let moving = count - rest.len();
    targets[moving..].copy_from_slice(rest);
    for row in 0..times.rows {
        let time = times.at(row);
        if row % STRIDE == 0 {
            progress.at(row as f64 / times.rows as f64, "stepping in time");
            if progress.cancelled() {
                return Err(super::explain::cancelled(row));
            }
        }
        let mut next = 0;
        for (motion, count) in running {
            for i in 0..*count {
                let jet = motion.at(i, time);
                (targets[next], velocity[next], acceleration[next]) = (jet.value, jet.first, jet.second);
                next += 1;
            }
        }
        let unit = session.design.units.of(Measure::Time);
        let here = || format!("time = {}", super::explain::shown(time, &unit));
        let moved = session.move_to(time, &targets, &here)?;
        if moved.passed_change_point {
            session.notes.add("a change point was passed: the branch of the mechanism is not certain beyond it", &here);
        }
        let moved = session.solve_row(&velocity, &acceleration, &here);
        if moved.passed_dead_position && row > 0 {
            session.notes.add("a dead position of the drives was passed", &here);
        }
    }
    progress.at(1.0, "done");
    Ok(())
}

/// Segments and velocities count from the start: where the start of the file does not close, they begin elsewhere.
fn warn_of_moved_starts(session: &mut Session<'_>, motions: &[&Prescribed]) {
    for motion in motions.iter().filter(|m| matches!(m.law, Law::Segments(_) | Law::Velocity(_))) {
        for &c in &motion.coordinates {
            let (Some(start), place) = (session.start(c), session.place(c)) else { continue };
            if (place - start).abs() > 1e-6 * start.abs().max(place.abs()).max(1e-3) {
                let namer = session.namer();
                let (name, place, start) = (&motion.name, namer.place(c, place), namer.place(c, start));
                let message =
                    format!("motion `{name}` begins at {place}: its start of {start} does not fit the other joints");
                session.result.warnings.push(message);
            }
        }
    }
}

fn warn_of_short_tables(session: &mut Session<'_>, motions: &[&Prescribed], duration: f64) {
    for motion in motions {
        if let Law::Table(spline) = &motion.law
            && (spline.span().0 > 0.0 || spline.span().1 < duration)
        {
            let (from, to) = spline.span();
            let (from, to) = (session.shown(from, Measure::Time), session.shown(to, Measure::Time));
            let message =
                format!("motion `{}` has a table from {from} to {to}; outside of it the joint rests", motion.name);
            session.result.warnings.push(message);
        }
    }
}
