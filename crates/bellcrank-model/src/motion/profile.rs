//! How a move from 0 to 1 goes in unit time.

use std::f64::consts::TAU;

use super::Jet;
use crate::scalar::Scalar;

/// The shape of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Profile {
    /// τ − sin(2πτ)/2π: acceleration a full sine wave, no jump in it.
    Cycloidal,
    /// 10τ³ − 15τ⁴ + 6τ⁵: velocity and acceleration vanish at both ends.
    Poly5,
    /// Constant acceleration for a third, constant velocity for a third, constant deceleration for a third.
    Trapezoid,
    /// The trapezoid with its accelerations ramped: a ninth up, a ninth held, a ninth down.
    SCurve,
    /// Constant velocity; jumps at both ends.
    Linear,
}

/// A stretch of time with acceleration `from + jerk·t`.
struct Piece {
    lasts: f64,
    from: f64,
    jerk: f64,
}

const fn piece(lasts: f64, from: f64, jerk: f64) -> Piece {
    Piece { lasts, from, jerk }
}

const THIRD: f64 = 1.0 / 3.0;
const NINTH: f64 = 1.0 / 9.0;
const TRAPEZOID: &[Piece] = &[piece(THIRD, 4.5, 0.0), piece(THIRD, 0.0, 0.0), piece(THIRD, -4.5, 0.0)];
const PEAK: f64 = 6.75;
const JERK: f64 = 60.75;
const S_CURVE: &[Piece] = &[
    piece(NINTH, 0.0, JERK),
    piece(NINTH, PEAK, 0.0),
    piece(NINTH, PEAK, -JERK),
    piece(THIRD, 0.0, 0.0),
    piece(NINTH, 0.0, -JERK),
    piece(NINTH, -PEAK, 0.0),
    piece(NINTH, -PEAK, JERK),
];

impl Profile {
    /// The profile of a name of the format.
    pub(crate) fn named(name: &str) -> Option<Profile> {
        let all = [Profile::Cycloidal, Profile::Poly5, Profile::Trapezoid, Profile::SCurve, Profile::Linear];
        all.into_iter().find(|profile| profile.name() == name)
    }

    /// Its name in the format.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Profile::Cycloidal => "cycloidal",
            Profile::Poly5 => "poly5",
            Profile::Trapezoid => "trapezoid",
            Profile::SCurve => "s-curve",
            Profile::Linear => "linear",
        }
    }

    /// Shares of the time inside of the move at which the acceleration or its rate jumps.
    pub(crate) fn breaks(self) -> &'static [f64] {
        match self {
            Profile::Trapezoid => &[THIRD, 2.0 * THIRD],
            Profile::SCurve => &[NINTH, 2.0 * NINTH, THIRD, 2.0 * THIRD, 7.0 * NINTH, 8.0 * NINTH],
            Profile::Cycloidal | Profile::Poly5 | Profile::Linear => &[],
        }
    }

    /// Share of the way at share `t` (0 to 1) of the time, with both derivatives.
    pub(crate) fn at<T: Scalar>(self, t: T) -> Jet<T> {
        let jet = match self {
            Profile::Cycloidal => cycloidal(t),
            Profile::Poly5 => poly5(t),
            // The second half is the first one backwards: the end is met exactly.
            Profile::Trapezoid => mirrored(TRAPEZOID, t),
            Profile::SCurve => mirrored(S_CURVE, t),
            Profile::Linear => Jet::variable(t),
        };
        if t.value() == 1.0 { Jet { value: jet.value.with_value(1.0), ..jet } } else { jet }
    }
}

fn cycloidal<T: Scalar>(t: T) -> Jet<T> {
    let turn = T::from_f64(TAU);
    let (s, c) = (turn * t).sin_cos();
    Jet::new(t - s / turn, T::one() - c, turn * s)
}

fn poly5<T: Scalar>(t: T) -> Jet<T> {
    let c = T::from_f64;
    let rest = c(1.0) - t;
    Jet::new(
        t * t * t * (c(10.0) + t * (c(6.0) * t - c(15.0))),
        c(30.0) * t * t * rest * rest,
        c(60.0) * t * rest * (c(1.0) - c(2.0) * t),
    )
}

fn mirrored<T: Scalar>(pieces: &[Piece], t: T) -> Jet<T> {
    if t.value() <= 0.5 {
        return integrated(pieces, t);
    }
    let back = integrated(pieces, T::one() - t);
    Jet::new(T::one() - back.value, back.first, -back.second)
}

/// Position, velocity and acceleration after the time `t`, from rest.
fn integrated<T: Scalar>(pieces: &[Piece], t: T) -> Jet<T> {
    let c = T::from_f64;
    let mut now = Jet::default();
    let mut left = t;
    for piece in pieces {
        let dt = if left.value() <= piece.lasts { left } else { c(piece.lasts) };
        now = Jet::new(
            now.value + dt * (now.first + dt * (c(piece.from / 2.0) + dt * c(piece.jerk) / c(6.0))),
            now.first + dt * (c(piece.from) + dt * c(piece.jerk) / c(2.0)),
            c(piece.from) + dt * c(piece.jerk),
        );
        left -= dt;
        if left.value() <= 0.0 {
            break;
        }
    }
    now
}
