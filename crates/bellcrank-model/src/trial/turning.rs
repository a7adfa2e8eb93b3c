//! Angles of bodies in the plane, which signals tell between −π and π: along the rows they run on.

use std::f64::consts::TAU;

use crate::design::Design;
use crate::signals::{PLANAR_ANGLE, Signal, Source};

/// An angle that is followed along the rows.
#[derive(Clone, Debug)]
pub(super) struct Turning {
    /// Index of the signal.
    pub(super) signal: usize,
    /// Its values at the rows so far.
    pub(super) rows: Vec<f64>,
}

/// The angles of bodies among the signals in use.
pub(super) fn turnings(design: &Design, signals: &[Signal], used: &[usize]) -> Vec<Turning> {
    let turns =
        |signal: &Signal| design.planar && matches!(signal.source, Source::Body(_)) && signal.part == PLANAR_ANGLE;
    let found = used.iter().filter(|&&i| signals.get(i).is_some_and(turns));
    found.map(|&signal| Turning { signal, rows: Vec::new() }).collect()
}

impl Turning {
    /// The angle with the whole turns that bring it nearest to that of the row beside it.
    pub(super) fn near(&self, row: f64, angle: f64) -> f64 {
        let beside = self.rows.get(row.round().max(0.0) as usize).or(self.rows.last());
        running_on(beside.copied(), angle)
    }
}

/// The angle nearest to the one before, whole turns added.
pub(crate) fn running_on(before: Option<f64>, angle: f64) -> f64 {
    match before {
        Some(before) if before.is_finite() => angle + TAU * ((before - angle) / TAU).round(),
        _ => angle,
    }
}
