//! An electric drive of the catalogue.

use crate::error::Demands;
use crate::{Duty, Quantity, Row, SizingError};

/// What the output does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// It slides: N, m, m/s, kg.
    Linear,
    /// It turns: N·m, rad, rad/s, kg·m².
    Rotary,
}

impl Kind {
    /// What an effort measures.
    pub fn effort(self) -> Quantity {
        if self == Kind::Linear { Quantity::Force } else { Quantity::Torque }
    }
    /// What a position measures.
    pub fn travel(self) -> Quantity {
        if self == Kind::Linear { Quantity::Length } else { Quantity::Angle }
    }
    /// What a speed measures.
    pub fn speed(self) -> Quantity {
        if self == Kind::Linear { Quantity::Speed } else { Quantity::AngularSpeed }
    }
}

/// A gear between motor and output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gear {
    /// Motor turns for one of the output, above 0.
    pub ratio: f64,
    /// Share of the power that gets through, either way.
    pub efficiency: f64,
}

/// A drive, SI. Efforts, speeds and inertia are those of the motor shaft where it has a gear, of the output
/// otherwise. What the catalogue does not say is `None`, and the check that would need it says so.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Name in the catalogue.
    pub name: String,
    /// What its output does.
    pub kind: Kind,
    /// Effort it can give without end, N or N·m.
    pub rated_effort: f64,
    /// Effort it can give for a short time, N or N·m.
    pub peak_effort: f64,
    /// Largest speed, m/s or rad/s.
    pub max_speed: f64,
    /// Speed up to which it can give the peak effort; from there it falls on a straight line to the rated
    /// effort at the largest speed. `None`: it can at every speed.
    pub knee_speed: Option<f64>,
    /// Mechanical power it can give without end, W.
    pub rated_power: Option<f64>,
    /// Mechanical power it can give for a short time, W.
    pub peak_power: Option<f64>,
    /// Travels it is stocked with, m or rad, in any order.
    pub strokes: Vec<f64>,
    /// Longest travel that can be ordered, m or rad. A rotary drive without any travel turns on and on.
    pub max_stroke: Option<f64>,
    /// Own inertia that is accelerated with the shaft, kg or kg·m².
    pub inertia: Option<f64>,
    /// Gear, where it has one.
    pub gear: Option<Gear>,
}

impl Drive {
    /// A drive of which only the ratings are known.
    pub fn bare(kind: Kind, rated_effort: f64, peak_effort: f64, max_speed: f64) -> Drive {
        Drive {
            name: String::new(),
            kind,
            rated_effort,
            peak_effort,
            max_speed,
            knee_speed: None,
            rated_power: None,
            peak_power: None,
            strokes: Vec::new(),
            max_stroke: None,
            inertia: None,
            gear: None,
        }
    }

    /// Effort it can give for a short time at a speed, N or N·m.
    pub fn effort_at(&self, speed: f64) -> f64 {
        let knee = self.knee_speed.unwrap_or(self.max_speed).min(self.max_speed);
        let beyond = (speed.abs() - knee) / (self.max_speed - knee);
        if speed.abs() <= knee || beyond.is_nan() {
            return self.peak_effort;
        }
        self.peak_effort + (self.rated_effort - self.peak_effort) * beyond.min(1.0)
    }

    /// Ratio of motor to output; 1 without a gear.
    pub fn ratio(&self) -> f64 {
        self.gear.map_or(1.0, |gear| gear.ratio)
    }

    /// The duty at the motor shaft: position, speed and acceleration × i; effort / i, then / η where it drives or
    /// holds and × η where it brakes; then the own inertia × acceleration.
    pub fn shaft_duty(&self, duty: &Duty) -> Result<Duty, SizingError> {
        let Gear { ratio, efficiency } = self.gear.unwrap_or(Gear { ratio: 1.0, efficiency: 1.0 });
        let own = self.inertia.unwrap_or(0.0);
        duty.map(|row| {
            let loss = if row.effort * row.velocity >= 0.0 { 1.0 / efficiency } else { efficiency };
            let acceleration = row.acceleration * ratio;
            Row {
                position: row.position * ratio,
                effort: row.effort / ratio * loss + own * acceleration,
                velocity: row.velocity * ratio,
                acceleration,
                time: row.time,
            }
        })
    }

    /// Fails at numbers that are no drive: no effort, a peak below the rated effort, NaN.
    pub fn validate(&self) -> Result<(), SizingError> {
        let demands = Demands(&self.name);
        demands.positive("rated_effort", self.rated_effort)?;
        demands.at_least("peak_effort", self.peak_effort, self.rated_effort)?;
        demands.positive("max_speed", self.max_speed)?;
        demands.not_negative_if_any("knee_speed", self.knee_speed)?;
        demands.positive_if_any("rated_power", self.rated_power)?;
        demands.positive_if_any("peak_power", self.peak_power)?;
        self.strokes.iter().try_for_each(|stroke| demands.positive("strokes", *stroke))?;
        demands.positive_if_any("max_stroke", self.max_stroke)?;
        demands.not_negative_if_any("inertia", self.inertia)?;
        self.gear.map_or(Ok(()), |gear| {
            demands.positive("gear_ratio", gear.ratio)?;
            demands.share("gear_efficiency", gear.efficiency)
        })
    }
}
