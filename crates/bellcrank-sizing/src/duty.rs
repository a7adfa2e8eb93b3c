//! The rows a drive goes through.

use crate::SizingError;
use crate::integrals::{durations, steps};

/// One row of a drive's curve, SI.
///
/// A positive effort pushes the coordinate up: it extends a cylinder. That holds for a force that
/// moves something and for one that only holds it: a load that is lowered is still pushed against.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Drive coordinate, m or rad.
    pub position: f64,
    /// Effort of the drive on the machine, N or N·m.
    pub effort: f64,
    /// Rate of the coordinate, m/s or rad/s; 0 in a sweep without speed.
    pub velocity: f64,
    /// Its rate, m/s² or rad/s².
    pub acceleration: f64,
    /// Time, s; all rows have one or none has.
    pub time: Option<f64>,
}

/// What means are taken over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// The times of the rows.
    Time,
    /// Time from position and speed, dt = dx / v with v the mean of both ends.
    Speed,
    /// Equal weight to equal travel: the duty has no time, and its speed does not carry it along its positions.
    Travel,
    /// Equal weight to each row: the drive does not move.
    Rows,
}

/// A drive's curve: rows of finite numbers, at least one, times in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Duty {
    rows: Vec<Row>,
    basis: Basis,
    /// Weight of the step from row i to row i + 1: s, or m or rad.
    weights: Vec<f64>,
    /// Positions have the opposite sign of the machine's.
    mirrored: bool,
}

impl Duty {
    /// A duty of these rows. Fails without rows, at numbers that are not finite, at times that go back.
    pub fn new(rows: Vec<Row>) -> Result<Duty, SizingError> {
        if rows.is_empty() {
            return Err(SizingError::NoRows);
        }
        rows.iter().enumerate().try_for_each(|(number, row)| finite(number, row))?;
        times(&rows)?;
        let (basis, weights) = weights(&rows);
        Ok(Duty { rows, basis, weights, mirrored: false })
    }

    /// A duty of columns of equal length, as a study has them.
    pub fn from_columns(
        position: &[f64],
        effort: &[f64],
        velocity: &[f64],
        acceleration: &[f64],
        time: Option<&[f64]>,
    ) -> Result<Duty, SizingError> {
        let columns = [("effort", effort), ("velocity", velocity), ("acceleration", acceleration)];
        for (column, values) in columns.into_iter().chain(time.map(|time| ("time", time))) {
            if values.len() != position.len() {
                return Err(SizingError::Lengths { column, found: values.len(), expected: position.len() });
            }
        }
        let row = |i: usize| Row {
            position: position[i],
            effort: effort[i],
            velocity: velocity[i],
            acceleration: acceleration[i],
            time: time.map(|time| time[i]),
        };
        Duty::new((0..position.len()).map(row).collect())
    }

    /// The rows.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }
    /// What means are taken over.
    pub fn basis(&self) -> Basis {
        self.basis
    }
    /// How long it takes, s; `None` where neither the rows have times nor the speed gives them.
    pub fn duration(&self) -> Option<f64> {
        matches!(self.basis, Basis::Time | Basis::Speed).then(|| self.weights.iter().sum())
    }
    pub(crate) fn weights(&self) -> &[f64] {
        &self.weights
    }
    /// The same rows after a change that keeps numbers finite and times as they are.
    pub(crate) fn map(&self, change: impl Fn(&Row) -> Row) -> Result<Duty, SizingError> {
        let mapped = Duty::new(self.rows.iter().map(change).collect())?;
        Ok(Duty { mirrored: self.mirrored, ..mapped })
    }
    /// The position as the machine counts it, whichever way round the drive is mounted: for reports.
    pub fn machine_position(&self, position: f64) -> f64 {
        if self.mirrored { -position } else { position }
    }
    /// The same duty for a drive mounted the other way round: what pushed pulls. Reports still tell the machine's
    /// positions.
    #[must_use]
    pub fn reversed(&self) -> Duty {
        let turn = |row: &Row| Row {
            position: -row.position,
            effort: -row.effort,
            velocity: -row.velocity,
            acceleration: -row.acceleration,
            time: row.time,
        };
        Duty { rows: self.rows.iter().map(turn).collect(), mirrored: !self.mirrored, ..self.clone() }
    }
}

fn finite(number: usize, row: &Row) -> Result<(), SizingError> {
    let values = [
        ("position", row.position),
        ("effort", row.effort),
        ("velocity", row.velocity),
        ("acceleration", row.acceleration),
        ("time", row.time.unwrap_or(0.0)),
    ];
    match values.into_iter().find(|(_, value)| !value.is_finite()) {
        Some((value, _)) => Err(SizingError::NotFinite { row: number, value }),
        None => Ok(()),
    }
}

fn times(rows: &[Row]) -> Result<(), SizingError> {
    let timed = rows.iter().filter(|row| row.time.is_some()).count();
    let bare = rows.iter().position(|row| row.time.is_none());
    if let (Some(row), true) = (bare, timed > 0) {
        return Err(SizingError::TimeMissing { row });
    }
    match steps(rows).position(|(a, b)| b.time < a.time) {
        Some(before) => Err(SizingError::TimeGoesBack { row: before + 1 }),
        None => Ok(()),
    }
}

/// The best basis the rows allow. Equal weights stand where nothing else is above zero.
fn weights(rows: &[Row]) -> (Basis, Vec<f64>) {
    let timed: Option<Vec<f64>> = steps(rows).map(|(a, b)| Some(b.time? - a.time?)).collect();
    let travel: Vec<f64> = steps(rows).map(|(a, b)| (b.position - a.position).abs()).collect();
    let some = |weights: &Vec<f64>| weights.iter().sum::<f64>() > 0.0;
    if let Some(weights) = timed.filter(some) {
        (Basis::Time, weights)
    } else if let Some(weights) = durations(rows).filter(some) {
        (Basis::Speed, weights)
    } else if some(&travel) {
        (Basis::Travel, travel)
    } else {
        (Basis::Rows, vec![1.0; rows.len().saturating_sub(1)])
    }
}
