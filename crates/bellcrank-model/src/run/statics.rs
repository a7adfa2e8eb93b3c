//! Equilibrium at rest, and its stability.

use bellcrank_multibody::{Coordinate, Equilibrium};
use bellcrank_results::Unit;

use super::End;
use super::course::{Laws, Path, Targets};
use super::session::Session;
use crate::design::{Hold, Sweep};
use crate::progress::Progress;

pub(super) fn run<'d>(
    session: &mut Session<'d>,
    sweep: Option<&'d Sweep>,
    holds: &'d [Hold],
    motions: &[usize],
    progress: &mut dyn Progress,
) -> Result<(), End> {
    progress.at(0.0, "assembling");
    let course = session.begin(Path::Rest(sweep), holds, motions)?;
    session.carry(course.actuation.effort.clone());
    session.expect_rows(course.rows, false)?;
    session.result.axis = sweep.map(|_| session.axis_name()).into_iter().collect();
    let laws: Laws<'_> = session.laws(&course);
    let mut targets = Targets::default();
    for row in 0..course.rows {
        progress.at(row as f64 / course.rows as f64, "looking for equilibrium");
        if progress.cancelled() {
            return Err(super::explain::cancelled(row));
        }
        let place = laws.axis(row as f64);
        laws.prescribe(place, &mut targets);
        let hold: Vec<(Coordinate, f64)> =
            course.actuation.position.iter().copied().zip(targets.position.iter().copied()).collect();
        let here = if sweep.is_some() { session.places().at(place) } else { String::new() };
        let found = session.equilibrium(&hold, &here)?;
        tell(session, &found, &here);
    }
    progress.at(1.0, "done");
    Ok(())
}

fn tell(session: &mut Session<'_>, found: &Equilibrium, here: &str) {
    // The last row's stand.
    session.result.scalars = scalars(found);
    match (found.stable, here) {
        (true, _) => {}
        (false, "") => {
            let message = "this equilibrium is not stable: a small push leads away from it";
            session.result.warnings.push(message.to_owned());
        }
        (false, here) => session.notes.add("this equilibrium is not stable", &|| here.to_owned()),
    }
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
