//! The checks of an electric drive, each with its sentence.

use crate::electric::{Conditions, Drive, Kind};
use crate::words::{both, number, shown};
use crate::{Check, Duty, Quantity, Requirement, Row, Stroke, Subject};

/// A drive under the conditions against a duty, at the shaft.
pub(super) struct Trial<'a> {
    pub(super) drive: &'a Drive,
    pub(super) conditions: &'a Conditions,
    /// Rows at the shaft.
    pub(super) duty: &'a Duty,
    /// What they ask.
    pub(super) requirement: &'a Requirement,
    /// Travel of the output.
    pub(super) travel: f64,
    pub(super) stroke: Option<Stroke>,
}

impl Trial<'_> {
    /// All of them, the most important first.
    pub(super) fn checks(&self) -> Vec<Check> {
        let mut checks = vec![self.rms(), self.peak(), self.speed(), self.rated_power(), self.peak_power()];
        checks.extend(self.stroke_check());
        checks
    }

    /// Root mean square of the effort over the cycle.
    pub(super) fn rms_effort(&self) -> f64 {
        let share = self.conditions.share(self.requirement.duration);
        self.requirement.rms_effort * share.sqrt() * self.conditions.safety
    }
    fn rms(&self) -> Check {
        let quantity = self.drive.kind.effort();
        let (is, needed) = both(self.drive.rated_effort, self.rms_effort(), quantity);
        let reason = format!("rated {is}, root mean square {needed}{}", self.safety());
        Check::new(Subject::RmsEffort, quantity, self.rms_effort(), self.drive.rated_effort, reason)
    }
    fn safety(&self) -> String {
        let safety = self.conditions.safety;
        if safety == 1.0 { String::new() } else { format!(" with safety {}", number(safety)) }
    }

    /// The row that comes closest to what the drive can give at its speed.
    fn peak(&self) -> Check {
        let quantity = self.drive.kind.effort();
        let share = |row: &&Row| row.effort.abs() / self.drive.effort_at(row.velocity);
        let worst = self.duty.rows().iter().rev().max_by(|a, b| share(a).total_cmp(&share(b)));
        let (effort, speed) = worst.map_or((0.0, 0.0), |row| (row.effort.abs(), row.velocity.abs()));
        let (needed, available) = (effort * self.conditions.safety, self.drive.effort_at(speed));
        let (is, wanted) = both(available, needed, quantity);
        let at = shown(speed, self.drive.kind.speed());
        let reason = format!("peak {is} at {at}, needed {wanted}{}", self.safety());
        Check::new(Subject::PeakEffort, quantity, needed, available, reason)
    }

    fn speed(&self) -> Check {
        let quantity = self.drive.kind.speed();
        let (needed, limit) = (self.requirement.speed.value, self.drive.max_speed);
        let (is, wanted) = both(limit, needed, quantity);
        Check::new(Subject::Speed, quantity, needed, limit, format!("speed limit {is}, needed {wanted}"))
    }

    /// Mean power over the cycle with the safety.
    fn mean_power(&self) -> Option<f64> {
        let factor = self.conditions.share(self.requirement.duration) * self.conditions.safety;
        self.requirement.mean_power.map(|power| power * factor)
    }
    fn rated_power(&self) -> Check {
        let limit = self.drive.rated_power;
        let unknown =
            |needed, why| Check::unknown(Subject::RatedPower, Quantity::Power, needed, limit.unwrap_or(f64::NAN), why);
        match (self.mean_power(), limit) {
            (None, _) => unknown(f64::NAN, "the duty has no time"),
            (Some(needed), None) => unknown(needed, "the catalogue gives no rated power"),
            (Some(needed), Some(limit)) => {
                let (is, wanted) = both(limit, needed, Quantity::Power);
                let reason = format!("rated power {is}, mean {wanted}{}", self.safety());
                Check::new(Subject::RatedPower, Quantity::Power, needed, limit, reason)
            }
        }
    }
    fn peak_power(&self) -> Check {
        let peak = &self.requirement.power;
        let needed = peak.value * self.conditions.safety;
        let Some(limit) = self.drive.peak_power else {
            let why = "the catalogue gives no peak power; peak effort and speed limit it";
            return Check::unknown(Subject::PeakPower, Quantity::Power, needed, f64::NAN, why);
        };
        let (is, wanted) = both(limit, needed, Quantity::Power);
        let reason = format!("peak power {is}, needed {wanted}{}", self.safety());
        Check::new(Subject::PeakPower, Quantity::Power, needed, limit, reason)
    }

    /// None for a drive that turns on and on.
    fn stroke_check(&self) -> Option<Check> {
        let (quantity, reserve) = (self.drive.kind.travel(), self.conditions.stroke_reserve);
        match (self.stroke, self.drive.kind) {
            (Some(stroke), _) => Some(stroke.check(self.travel, reserve, quantity)),
            (None, Kind::Rotary) => None,
            (None, Kind::Linear) => {
                let needed = self.travel + 2.0 * reserve;
                let why = "the catalogue gives no stroke";
                Some(Check::unknown(Subject::Stroke, quantity, needed, f64::NAN, why))
            }
        }
    }
}
