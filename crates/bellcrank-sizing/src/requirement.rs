//! What a duty asks of its drive.

use crate::integrals::{mean, mean_above, mean_square};
use crate::{Duty, Row};

/// An extreme and where it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Size, never negative.
    pub value: f64,
    /// Drive coordinate there, m or rad; of the first row where nothing is above zero.
    pub position: f64,
    /// Row, from 0.
    pub row: usize,
}

/// What is asked in one direction of motion. Rows at rest belong to neither.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// Largest positive effort, N.
    pub push: Peak,
    /// Largest negative effort, N; its size.
    pub pull: Peak,
    /// Largest speed, m/s; 0 where the duty never moves this way.
    pub speed: Peak,
}

/// What a duty asks, SI. Forces stand for torques, m for rad, where the drive turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Requirement {
    /// Range of positions, m.
    pub stroke: f64,
    /// Smallest position, m.
    pub lowest: f64,
    /// Largest position, m.
    pub highest: f64,
    /// Largest positive effort, N, whether the drive moves with it, against it or not at all.
    pub push: Peak,
    /// Largest negative effort, N, likewise; its size.
    pub pull: Peak,
    /// Largest effort of either sign, N.
    pub effort: Peak,
    /// Root mean square of the effort, N, over the duty's [`crate::Basis`].
    pub rms_effort: f64,
    /// Largest speed, m/s.
    pub speed: Peak,
    /// While the coordinate grows (a cylinder extends).
    pub extending: Motion,
    /// While the coordinate shrinks.
    pub retracting: Motion,
    /// Largest power given to the machine, effort × velocity, W.
    pub power: Peak,
    /// Largest power taken from the machine (braking, lowering), W.
    pub braking_power: Peak,
    /// Mean power given, W, braking counted as zero: what a motor must give on average and heat must come from.
    /// `None` without a time.
    pub mean_power: Option<f64>,
    /// Mean of effort × velocity with its sign, W: what the machine consumes. `None` without a time.
    pub net_power: Option<f64>,
    /// Largest acceleration, m/s².
    pub acceleration: Peak,
    /// How long the duty takes, s, where that is known.
    pub duration: Option<f64>,
}

impl Requirement {
    /// What this duty asks.
    pub fn of(duty: &Duty) -> Requirement {
        let rows = duty.rows();
        let (lowest, highest) = range(rows);
        let power = |row: &Row| row.effort * row.velocity;
        let timed = |value: f64| duty.duration().map(|_| value);
        let over = |f: &dyn Fn(&Row, &Row) -> f64| mean(rows, duty.weights(), f);
        Requirement {
            stroke: highest - lowest,
            lowest,
            highest,
            push: peak(rows, |row| row.effort),
            pull: peak(rows, |row| -row.effort),
            effort: peak(rows, |row| row.effort.abs()),
            rms_effort: over(&|a, b| mean_square(a.effort, b.effort)).sqrt(),
            speed: peak(rows, |row| row.velocity.abs()),
            extending: motion(rows, 1.0),
            retracting: motion(rows, -1.0),
            power: peak(rows, power),
            braking_power: peak(rows, |row| -power(row)),
            mean_power: timed(over(&|a, b| mean_above(power(a), power(b)))),
            net_power: timed(over(&|a, b| (power(a) + power(b)) / 2.0)),
            acceleration: peak(rows, |row| row.acceleration.abs()),
            duration: duty.duration(),
        }
    }
}

fn range(rows: &[Row]) -> (f64, f64) {
    let fold = |pick: fn(f64, f64) -> f64, start| rows.iter().map(|row| row.position).fold(start, pick);
    (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY))
}

fn motion(rows: &[Row], sense: f64) -> Motion {
    let moving = |row: &Row| row.velocity * sense > 0.0;
    let only = |row: &Row, value: f64| if moving(row) { value } else { 0.0 };
    Motion {
        push: peak(rows, |row| only(row, row.effort)),
        pull: peak(rows, |row| only(row, -row.effort)),
        speed: peak(rows, |row| only(row, row.velocity * sense)),
    }
}

/// The first row where `f` is largest; 0 where it is nowhere above zero.
pub(crate) fn peak(rows: &[Row], f: impl Fn(&Row) -> f64) -> Peak {
    let start = Peak { value: 0.0, position: rows.first().map_or(0.0, |row| row.position), row: 0 };
    rows.iter().enumerate().fold(start, |best, (number, row)| {
        let value = f(row);
        if value > best.value { Peak { value, position: row.position, row: number } } else { best }
    })
}
