//! Equilibrium at rest, and its stability.

use bellcrank_multibody::{Coordinate, Equilibrium};
use bellcrank_results::Unit;

use super::End;
use super::session::Session;
use super::sweep::position;
use crate::design::{Hold, Prescribed, Sweep};
use crate::motion::Running;
use crate::progress::Progress;

pub(super) fn run(
    session: &mut Session<'_>,
    sweep: Option<&Sweep>,
    holds: &[Hold],
    motions: &[usize],
    progress: &mut dyn Progress,
) -> Result<(), End> {
    progress.at(0.0, "assembling");
    let design = session.design;
    let mut needed = session.held(holds);
    let motions: Vec<&Prescribed> = motions.iter().filter_map(|&index| design.motions.get(index)).collect();
    needed.extend(motions.iter().flat_map(|motion| at_the_beginning(session, motion)));
    let swept = sweep.map(|sweep| {
        let from = session.value(&sweep.from);
        (sweep.coordinate, session.start(sweep.coordinate).unwrap_or(from))
    });
    session.assemble(&needed, swept.as_slice())?;
    // What rests at its start without one rests where assembly put it.
    let unplaced = holds.iter().map(|hold| hold.coordinate).filter(|c| needed.iter().all(|(held, _)| held != c));
    let unplaced: Vec<(Coordinate, f64)> = unplaced.map(|c| (c, session.place(c))).collect();
    needed.extend(unplaced);
    session.carry(swept.iter().map(|(c, _)| *c).chain(needed.iter().map(|(c, _)| *c)).collect());
    match sweep {
        None => once(session, &needed, progress),
        Some(sweep) => over_positions(session, sweep, &needed, progress),
    }
}

/// Where a motion begins.
fn at_the_beginning(session: &Session<'_>, motion: &Prescribed) -> Vec<(Coordinate, f64)> {
    let from = motion.coordinates.first().and_then(|&c| session.start(c)).unwrap_or(0.0);
    let running = Running::new(&motion.law, &session.study.values, from);
    motion.coordinates.iter().enumerate().map(|(i, &c)| (c, running.at(i, 0.0).value)).collect()
}

fn once(session: &mut Session<'_>, held: &[(Coordinate, f64)], progress: &mut dyn Progress) -> Result<(), End> {
    session.expect_rows(1, false)?;
    progress.at(0.5, "looking for equilibrium");
    let found = session.equilibrium(held, "")?;
    session.result.scalars = scalars(&found);
    if !found.stable {
        session.result.warnings.push("this equilibrium is not stable: a small push leads away from it".to_owned());
    }
    progress.at(1.0, "done");
    Ok(())
}

/// Eigenvalues are per mass of nothing: SI of the coordinates they belong to, which mix lengths and angles.
fn scalars(found: &Equilibrium) -> Vec<(String, f64, Unit)> {
    let mut scalars = vec![
        ("equilibrium.stable".to_owned(), f64::from(u8::from(found.stable)), Unit::one()),
        ("equilibrium.residual".to_owned(), found.residual, Unit::new("N", 1.0)),
    ];
    let stiffness = found.stiffness.iter().enumerate();
    scalars.extend(stiffness.map(|(i, k)| (format!("equilibrium.stiffness.{i}"), *k, Unit::new("SI", 1.0))));
    scalars
}

fn over_positions(
    session: &mut Session<'_>,
    sweep: &Sweep,
    held: &[(Coordinate, f64)],
    progress: &mut dyn Progress,
) -> Result<(), End> {
    session.expect_rows(sweep.points, false)?;
    let namer = session.namer();
    session.result.axis = vec![namer.signal(sweep.coordinate)];
    let (from, to) = (session.value(&sweep.from), session.value(&sweep.to));
    let mut hold = vec![(sweep.coordinate, from)];
    hold.extend_from_slice(held);
    for row in 0..sweep.points {
        progress.at(row as f64 / sweep.points as f64, "looking for equilibrium");
        if progress.cancelled() {
            return Err(super::explain::cancelled(row));
        }
        hold[0].1 = position(from, to, row, sweep.points - 1);
        let here = format!("{} = {}", namer.signal(sweep.coordinate), namer.place(sweep.coordinate, hold[0].1));
        let found = session.equilibrium(&hold, &here)?;
        if !found.stable {
            session.notes.add("this equilibrium is not stable", &|| here.clone());
        }
        if row + 1 == sweep.points {
            session.result.scalars = scalars(&found);
        }
    }
    progress.at(1.0, "done");
    Ok(())
}
