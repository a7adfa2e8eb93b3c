//! How a move from 0 to 1 goes in unit time.

use std::f64::consts::TAU;

use super::Jet;

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
        match name {
            "cycloidal" => Some(Profile::Cycloidal),
            "poly5" => Some(Profile::Poly5),
            "trapezoid" => Some(Profile::Trapezoid),
            "s-curve" => Some(Profile::SCurve),
            "linear" => Some(Profile::Linear),
            _ => None,
        }
    }

    /// Share of the way at share `t` (0 to 1) of the time, with both derivatives.
    pub(crate) fn at(self, t: f64) -> Jet {
        let jet = match self {
            Profile::Cycloidal => cycloidal(t),
            Profile::Poly5 => poly5(t),
            // The second half is the first one backwards: the end is met exactly.
            Profile::Trapezoid => mirrored(TRAPEZOID, t),
            Profile::SCurve => mirrored(S_CURVE, t),
            Profile::Linear => Jet::variable(t),
        };
        if t == 1.0 { Jet { value: 1.0, ..jet } } else { jet }
    }
}

fn cycloidal(t: f64) -> Jet {
    let (s, c) = (TAU * t).sin_cos();
    Jet::new(t - s / TAU, 1.0 - c, TAU * s)
}

fn poly5(t: f64) -> Jet {
    let rest = 1.0 - t;
    Jet::new(t * t * t * (10.0 + t * (6.0 * t - 15.0)), 30.0 * t * t * rest * rest, 60.0 * t * rest * (1.0 - 2.0 * t))
}

fn mirrored(pieces: &[Piece], t: f64) -> Jet {
    if t <= 0.5 {
        return integrated(pieces, t);
    }
    let back = integrated(pieces, 1.0 - t);
    Jet::new(1.0 - back.value, back.first, -back.second)
}

/// Position, velocity and acceleration after the time `t`, from rest.
fn integrated(pieces: &[Piece], t: f64) -> Jet {
    let mut now = Jet::default();
    let mut left = t;
    for piece in pieces {
        let dt = left.min(piece.lasts);
        now = Jet::new(
            now.value + dt * (now.first + dt * (piece.from / 2.0 + dt * piece.jerk / 6.0)),
            now.first + dt * (piece.from + dt * piece.jerk / 2.0),
            piece.from + dt * piece.jerk,
        );
        left -= dt;
        if left <= 0.0 {
            break;
        }
    }
    now
}
