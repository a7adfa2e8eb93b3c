//! The stroke to order.

use crate::words::{both, shown};
use crate::{Check, Quantity, Subject};

/// A stroke that reaches, m (rad for a drive that turns between stops).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stroke {
    /// The shortest standard stroke that is long enough.
    Standard(f64),
    /// No standard stroke is; this one can be ordered, in whole millimetres.
    Special(f64),
    /// Neither; this is the longest there is.
    TooShort(f64),
}

/// Rounding errors forgiven, m.
const ROUNDING: f64 = 1e-9;

impl Stroke {
    /// The stroke for a travel out of the standard strokes, in any order, and the longest that can be ordered, m.
    pub fn of(strokes: &[f64], max_stroke: Option<f64>, needed: f64) -> Stroke {
        let enough = |stroke: &f64| *stroke >= needed - ROUNDING;
        let standard = strokes.iter().copied().filter(enough).reduce(f64::min);
        let special = ((needed - ROUNDING) * 1e3).ceil() / 1e3;
        let longest = strokes.iter().copied().chain(max_stroke).fold(0.0, f64::max);
        match (standard, max_stroke) {
            (Some(stroke), _) => Stroke::Standard(stroke),
            (None, Some(max)) if needed <= max + ROUNDING => Stroke::Special(special.min(max)),
            _ => Stroke::TooShort(longest),
        }
    }
    /// Its length, m.
    pub fn length(self) -> f64 {
        match self {
            Stroke::Standard(length) | Stroke::Special(length) | Stroke::TooShort(length) => length,
        }
    }

    /// `standard stroke`, `special stroke` or `longest stroke`.
    fn kind(self) -> &'static str {
        match self {
            Stroke::Standard(_) => "standard stroke",
            Stroke::Special(_) => "no standard stroke reaches, special stroke",
            Stroke::TooShort(_) => "longest stroke",
        }
    }

    /// The check of it: travel and a reserve at each end.
    pub(crate) fn check(self, travel: f64, reserve: f64, quantity: Quantity) -> Check {
        let needed = travel + 2.0 * reserve;
        let (is, wanted) = both(self.length(), needed, quantity);
        let ends = match reserve > 0.0 {
            true => format!(" ({} and {} at each end)", shown(travel, quantity), shown(reserve, quantity)),
            false => String::new(),
        };
        // A rounding error of the travel is not worth a longer stroke.
        let reaches = if matches!(self, Stroke::TooShort(_)) { self.length() } else { self.length().max(needed) };
        let reason = format!("{} {is}, needed {wanted}{ends}", self.kind());
        Check { available: self.length(), ..Check::new(Subject::Stroke, quantity, needed, reaches, reason) }
    }
}
