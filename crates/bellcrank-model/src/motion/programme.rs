//! What moves when: for each coordinate the motions that take it from place to place, one after another.

use bellcrank_multibody::Coordinate;

use super::schedule::duration;
use super::{Jet, Running, Schedule};
use crate::design::{Design, Values, moved};
use crate::scalar::Scalar;

/// Motions that act together, with numbers.
#[derive(Debug)]
pub(crate) struct Programme<'d, T = f64> {
    /// In the order of [`moved`].
    pub(crate) tracks: Vec<Track<'d, T>>,
}

/// What one coordinate does.
#[derive(Debug)]
pub(crate) struct Track<'d, T> {
    pub(crate) coordinate: Coordinate,
    /// In the order of time; at least one.
    pub(crate) turns: Vec<Turn<'d, T>>,
}

/// A motion of one coordinate at its time.
#[derive(Debug)]
pub(crate) struct Turn<'d, T> {
    /// Its place in the design.
    pub(crate) motion: usize,
    pub(crate) begins: T,
    /// `None` when it never ends.
    pub(crate) ends: Option<T>,
    pub(crate) running: Running<'d, T>,
}

impl<'d, T: Scalar> Programme<'d, T> {
    /// The programme of the motions `acting`, when they begin as `schedule` says and each coordinate is at
    /// `from(coordinate)` before. A motion whose start is not known begins at time 0.
    pub(crate) fn new(
        design: &'d Design,
        acting: &[usize],
        schedule: &Schedule<T>,
        values: &Values<T>,
        from: &dyn Fn(Coordinate) -> T,
    ) -> Programme<'d, T> {
        let coordinates = moved(acting.iter().filter_map(|&motion| design.motions.get(motion)));
        let track = |coordinate| track(design, acting, schedule, values, coordinate, from(coordinate));
        Programme { tracks: coordinates.into_iter().map(track).collect() }
    }

    /// Times, s, in order, at which some coordinate does not move smoothly: motions and segments begin and end, or
    /// an acceleration jumps inside of one.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        let turns = self.tracks.iter().flat_map(|track| &track.turns);
        let mut breaks: Vec<f64> =
            turns.flat_map(|turn| turn.running.breaks().into_iter().map(|since| turn.begins.value() + since)).collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|b, a| *b - *a <= EPS * b.abs().max(1.0));
        breaks
    }
}

/// Times closer than this, relative to them and to 1 s, count as one: sums of the same times differ by rounding.
pub(crate) const EPS: f64 = 1e-9;

fn track<'d, T: Scalar>(
    design: &'d Design,
    acting: &[usize],
    schedule: &Schedule<T>,
    values: &Values<T>,
    coordinate: Coordinate,
    from: T,
) -> Track<'d, T> {
    let mut times: Vec<(usize, usize, T)> = Vec::new();
    for &motion in acting {
        let of = design.motions.get(motion).map_or(&[][..], |motion| &motion.coordinates);
        if let Some(i) = of.iter().position(|&c| c == coordinate) {
            times.push((motion, i, schedule.begin(motion).unwrap_or(T::zero())));
        }
    }
    times.sort_by(|a, b| a.2.value().total_cmp(&b.2.value()));
    let mut from = from;
    let turn = |(motion, i, begins): (usize, usize, T)| {
        let law = &design.motions[motion].law;
        let running = Running::new(law, i, values, from);
        from = running.end().unwrap_or(from);
        Turn { motion, begins, ends: duration(law, values).map(|lasts| begins + lasts), running }
    };
    Track { coordinate, turns: times.into_iter().map(turn).collect() }
}

impl<T: Scalar> Track<'_, T> {
    /// Position, velocity and acceleration at a time, s. Where one motion follows another at once, the later counts.
    pub(crate) fn at(&self, time: T) -> Jet<T> {
        let slack = EPS * time.value().abs().max(1.0);
        let begun = self.turns.partition_point(|turn| turn.begins.value() <= time.value() + slack);
        let Some(turn) = self.turns.get(begun.saturating_sub(1)) else { return Jet::default() };
        let since = time - turn.begins;
        // Rounding must not decide whether a motion has begun.
        let since = if begun > 0 { since.with_value(since.value().max(0.0)) } else { since };
        turn.running.at(since)
    }
}
