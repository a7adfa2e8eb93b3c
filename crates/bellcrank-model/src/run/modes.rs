//! Natural frequencies, damping and mode shapes about a position.

use bellcrank_multibody::{Coordinate, JointId, Linearized};
use bellcrank_results::{Findings, ModeRow, Modes as Found, ShapeRow, Unit};

use super::End;
use super::course::{Laws, Path, Targets};
use super::session::Session;
use crate::design::Modes;
use crate::measure::{Measure, Motion};
use crate::progress::Progress;
use crate::signals::Level;

/// Forces left unbalanced below this, against the largest weight, are those of an equilibrium.
const BALANCED: f64 = 1e-6;

pub(super) fn run<'d>(session: &mut Session<'d>, of: &'d Modes, progress: &mut dyn Progress) -> Result<(), End> {
    progress.at(0.0, "assembling");
    let course = session.begin(Path::Rest(None), &of.holds, &of.motions)?;
    session.carry(course.actuation.effort.clone());
    session.expect_rows(1, false)?;
    let mut targets = Targets::default();
    let laws: Laws<'_> = session.laws(&course);
    laws.prescribe(0.0, &mut targets);
    if of.equilibrium {
        progress.at(0.2, "looking for equilibrium");
        let hold: Vec<(Coordinate, f64)> =
            course.actuation.position.iter().copied().zip(targets.position.iter().copied()).collect();
        session.equilibrium(&hold, "")?;
    } else {
        session.record(Level::Position);
    }
    progress.at(0.5, "linearizing");
    let mut around = session.surroundings(laws, &course, (&[], &[]));
    let linear = session.linearize(&course.actuation.position, &mut around)?;
    warn(session, of, &linear);
    session.result.findings = Some(Findings::Modes(found(session, of, &linear)));
    progress.at(1.0, "done");
    Ok(())
}

fn found(session: &mut Session<'_>, of: &Modes, linear: &Linearized) -> Found {
    let coordinates = coordinates(session);
    let places: Vec<Coordinate> = coordinates.iter().map(|(c, _)| *c).collect();
    let count = of.count.unwrap_or(usize::MAX).min(linear.modes.len());
    let mut modes = Vec::with_capacity(count);
    for (index, mode) in linear.modes.iter().take(count).enumerate() {
        let shape = session.shape(index, &places);
        let row = |((c, unit), amplitude): (&(Coordinate, Unit), [f64; 2])| ShapeRow {
            coordinate: session.namer().coordinate(*c),
            unit: unit.clone(),
            amplitude,
        };
        modes.push(ModeRow {
            eigenvalue: mode.eigenvalue,
            frequency: mode.frequency,
            damping: mode.damping,
            shape: coordinates.iter().zip(shape).map(row).collect(),
        });
    }
    Found { freedom: linear.freedom, all: linear.modes.len(), at_equilibrium: of.equilibrium, modes }
}

/// Every coordinate of every joint, with the SI unit of its amplitudes.
fn coordinates(session: &Session<'_>) -> Vec<(Coordinate, Unit)> {
    let design = session.design;
    let mut all = Vec::new();
    for (joint, of) in design.joints.iter().enumerate() {
        for (index, motion) in of.coordinates(design.planar).iter().enumerate() {
            let symbol = if *motion == Motion::Turn { "rad" } else { "m" };
            all.push((Coordinate { joint: JointId(joint), index }, Unit::new(symbol, 1.0)));
        }
    }
    all
}

fn warn(session: &mut Session<'_>, of: &Modes, linear: &Linearized) {
    if !of.equilibrium && linear.unbalanced > BALANCED * heaviest(session) {
        let force = session.shown(linear.unbalanced, Measure::Force);
        let message = format!(
            "the position is no equilibrium: forces of up to {force} (or as many N*m) stay unbalanced, and the machine \
             would leave it"
        );
        session.result.warnings.push(message);
    }
    // An equilibrium of many free coordinates is met to rounding.
    let largest = linear.modes.iter().map(|mode| mode.eigenvalue[0].hypot(mode.eigenvalue[1])).fold(0.0, f64::max);
    let unstable = linear.modes.iter().filter(|mode| mode.eigenvalue[0] > 1e-9 * largest).count();
    if unstable > 0 {
        let what = if unstable == 1 { "1 mode grows".to_owned() } else { format!("{unstable} modes grow") };
        session.result.warnings.push(format!("the position is not stable: {what} with time"));
    }
}

/// The largest weight, N; 1 N without any.
fn heaviest(session: &Session<'_>) -> f64 {
    let blueprint = session.blueprint();
    let mass = blueprint.bodies.iter().skip(1).map(|body| body.mass).fold(0.0, f64::max);
    let weight = mass * blueprint.gravity.iter().map(|g| g * g).sum::<f64>().sqrt();
    if weight > 0.0 { weight } else { 1.0 }
}
