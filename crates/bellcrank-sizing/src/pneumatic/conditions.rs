//! What the cylinder works with and how carefully it is chosen.

use crate::SizingError;
use crate::error::Demands;
use crate::pneumatic::{Conductance, Mounting};

/// Compressed air at the cylinder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Supply {
    /// Gauge pressure, Pa, at the valve, the lowest that occurs.
    pub pressure: f64,
    /// Absolute pressure of the air around, Pa.
    pub atmosphere: f64,
}

impl Supply {
    /// Gauge pressure, Pa, at sea level (101.3 kPa).
    pub fn gauge(pressure: f64) -> Supply {
        Supply { pressure, atmosphere: 1.013e5 }
    }
    /// Absolute pressure, Pa.
    pub fn absolute(&self) -> f64 {
        self.pressure + self.atmosphere
    }
}

/// Load factor for fast, dynamic motion: half the theoretical force moves the load, the rest accelerates it, pushes
/// out the exhaust air and overcomes the seals (usual practice, as in makers' selection guides).
pub const LOAD_FACTOR_FAST: f64 = 0.5;
/// Load factor for general use (usual practice).
pub const LOAD_FACTOR_GENERAL: f64 = 0.7;
/// Load factor for slow or holding work on a stable supply (usual practice: 0.8 to 1).
pub const LOAD_FACTOR_SLOW: f64 = 0.8;
/// Safety against buckling that charts of pneumatic makers are commonly drawn for; Hänchen gives 3 to 5 for hydraulic
/// cylinders.
pub const BUCKLING_SAFETY: f64 = 5.0;

/// The force that must not buckle the rod.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BucklingLoad {
    /// The largest push of the duty.
    Duty,
    /// The full push at supply pressure: a cylinder that can be stopped by something on its way.
    Supply,
}

/// What the cylinder works with and how carefully it is chosen, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Conditions {
    /// Compressed air.
    pub supply: Supply,
    /// Share of the theoretical force that may be used, above 0, 1 at most. It covers seals, exhaust pressure and
    /// acceleration of what the duty does not count.
    pub load_factor: f64,
    /// Share of p A that reaches the rod, for those who count the seals apart; 1 where the load factor covers them.
    /// It enters the usable force and the working pressure.
    pub efficiency: f64,
    /// How the cylinder is held.
    pub mounting: Mounting,
    /// Safety against buckling.
    pub buckling_safety: f64,
    /// The force that must not buckle the rod.
    pub buckling_load: BucklingLoad,
    /// Stroke kept free at each end, m.
    pub stroke_reserve: f64,
    /// Mass that arrives at the ends, reduced to the rod, kg; piston and rod come on top.
    pub moved_mass: Option<f64>,
    /// Speed at which it arrives, m/s; `None`: the largest of the duty.
    pub arrival_speed: Option<f64>,
    /// Double strokes a second, Hz.
    pub cycle_rate: Option<f64>,
    /// Volume of tubes and ports that is filled and emptied with the cylinder, both sides, m³.
    pub dead_volume: f64,
    /// The valve (with its tubes) that feeds the cylinder.
    pub valve: Option<Conductance>,
}

impl Conditions {
    /// The choices nobody can make for the user, the rest plain: efficiency 1 (the load factor covers the seals),
    /// buckling safety 5 for the push of the duty, no reserve, no mass, no rate, no dead volume, no valve.
    pub fn new(supply: Supply, load_factor: f64, mounting: Mounting) -> Conditions {
        Conditions {
            supply,
            load_factor,
            efficiency: 1.0,
            mounting,
            buckling_safety: BUCKLING_SAFETY,
            buckling_load: BucklingLoad::Duty,
            stroke_reserve: 0.0,
            moved_mass: None,
            arrival_speed: None,
            cycle_rate: None,
            dead_volume: 0.0,
            valve: None,
        }
    }

    /// Fails at numbers that make no sense: no pressure, a load factor above 1, NaN.
    pub fn validate(&self) -> Result<(), SizingError> {
        let demands = Demands("conditions");
        demands.positive("pressure", self.supply.pressure)?;
        demands.not_negative("atmosphere", self.supply.atmosphere)?;
        demands.share("load_factor", self.load_factor)?;
        demands.share("efficiency", self.efficiency)?;
        demands.not_negative("offset", self.mounting.offset)?;
        demands.positive("buckling_safety", self.buckling_safety)?;
        demands.not_negative("stroke_reserve", self.stroke_reserve)?;
        demands.not_negative_if_any("moved_mass", self.moved_mass)?;
        demands.not_negative_if_any("arrival_speed", self.arrival_speed)?;
        demands.not_negative_if_any("cycle_rate", self.cycle_rate)?;
        demands.not_negative("dead_volume", self.dead_volume)?;
        self.valve.map_or(Ok(()), |valve| conductance(&demands, &valve))
    }
}

fn conductance(demands: &Demands<'_>, valve: &Conductance) -> Result<(), SizingError> {
    demands.positive("sonic conductance", valve.sonic)?;
    demands.positive("subsonic index", valve.index)?;
    demands.below_one("critical ratio", valve.critical_ratio)
}
