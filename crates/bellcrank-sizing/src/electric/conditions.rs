//! How carefully an electric drive is chosen.

use crate::SizingError;
use crate::error::Demands;

/// How carefully an electric drive is chosen, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conditions {
    /// Factor on the efforts the duty asks, 1 or above: what is not modelled (friction, tolerances of the load).
    pub safety: f64,
    /// Travel kept free at each end, m or rad.
    pub stroke_reserve: f64,
    /// Time of a cycle, s: the duty, then rest without effort (a brake holds). `None`: the duty follows itself.
    pub cycle_time: Option<f64>,
}

impl Conditions {
    /// This safety, no reserve, no rest.
    pub fn new(safety: f64) -> Conditions {
        Conditions { safety, stroke_reserve: 0.0, cycle_time: None }
    }
    /// Share of the cycle in which the duty runs; 1 where the cycle is not longer or the duty has no time.
    pub fn share(&self, duration: Option<f64>) -> f64 {
        match (duration, self.cycle_time) {
            (Some(duration), Some(cycle)) if cycle > duration => duration / cycle,
            _ => 1.0,
        }
    }
    /// Fails at numbers that make no sense.
    pub fn validate(&self) -> Result<(), SizingError> {
        let demands = Demands("conditions");
        demands.positive("safety", self.safety)?;
        demands.not_negative("stroke_reserve", self.stroke_reserve)?;
        demands.positive_if_any("cycle_time", self.cycle_time)
    }
}
