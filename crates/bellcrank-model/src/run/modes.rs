//! Natural frequencies, damping and mode shapes about a position, or about each position of a sweep.

use bellcrank_multibody::{Coordinate, JointId, Linearized};
use bellcrank_results::{Column, Findings, ModeRow, Modes as Found, ShapeRow, Unit};

use super::End;
use super::course::{Course, Laws, Path, Targets};
use super::session::Session;
use crate::design::Modes;
use crate::measure::{Measure, Motion};
use crate::progress::Progress;
use crate::signals::Level;

/// Forces left unbalanced below this, against the largest weight, are those of an equilibrium.
const BALANCED: f64 = 1e-6;

pub(super) fn run<'d>(session: &mut Session<'d>, of: &'d Modes, progress: &mut dyn Progress) -> Result<(), End> {
    progress.at(0.0, "assembling");
    let course = session.begin(Path::Rest(of.sweep.as_ref()), &of.holds, &of.motions)?;
    if of.sweep.is_some() && !of.equilibrium {
        session.prepare(&course.actuation)?;
    }
    session.carry(course.actuation.effort.clone());
    session.expect_rows(course.rows, false)?;
    session.result.axis = of.sweep.iter().map(|_| session.axis_name()).collect();
    let mut frequencies = Frequencies::default();
    for row in 0..course.rows {
        let share = row as f64 / course.rows as f64;
        progress.at(share, "looking for equilibrium");
        if progress.cancelled() {
            return Err(super::explain::cancelled(row));
        }
        let linear = one(session, of, &course, row)?;
        progress.at(share, "linearizing");
        if row == 0 {
            warn(session, of, &linear);
            session.result.findings = Some(Findings::Modes(found(session, of, &linear)));
        }
        frequencies.add(&linear, of.count);
    }
    if of.sweep.is_some() {
        session.beside = frequencies.columns();
    }
    progress.at(1.0, "done");
    Ok(())
}

/// The machine at a row, linearized.
fn one<'d>(session: &mut Session<'d>, of: &'d Modes, course: &Course<'d>, row: usize) -> Result<Linearized, End> {
    let laws: Laws<'_> = session.laws(course);
    let mut targets = Targets::default();
    let place = laws.axis(row as f64);
    laws.prescribe(place, &mut targets);
    let here = if of.sweep.is_some() { session.places().at(place) } else { String::new() };
    if of.equilibrium {
        let hold: Vec<(Coordinate, f64)> =
            course.actuation.position.iter().copied().zip(targets.position.iter().copied()).collect();
        session.equilibrium(&hold, &here)?;
    } else {
        if of.sweep.is_some() {
            session.move_to(0.0, &targets.position, &|| here.clone())?;
        }
        session.record(Level::Position);
    }
    let mut around = session.surroundings(laws, course, (&[], &[]));
    session.linearize(&course.actuation.position, &mut around)
}

/// Natural frequencies and damping, row by row; a mode that a row has not is NaN there.
#[derive(Default)]
struct Frequencies {
    rows: Vec<Vec<[f64; 2]>>,
}

impl Frequencies {
    fn add(&mut self, linear: &Linearized, count: Option<usize>) {
        let modes = linear.modes.iter().take(count.unwrap_or(usize::MAX));
        self.rows.push(modes.map(|mode| [mode.frequency, mode.damping]).collect());
    }

    fn columns(&self) -> Vec<Column> {
        let most = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let column = |mode: usize, part: usize, name: &str, unit: Unit| Column {
            name: format!("mode.{}.{name}", mode + 1),
            unit,
            values: self.rows.iter().map(|row| row.get(mode).map_or(f64::NAN, |of| of[part])).collect(),
        };
        let both = |mode| [column(mode, 0, "frequency", Unit::new("Hz", 1.0)), column(mode, 1, "damping", Unit::one())];
        (0..most).flat_map(both).collect()
    }
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
