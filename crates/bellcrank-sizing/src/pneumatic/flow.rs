//! The flow law of ISO 6358: flow through a valve from sonic conductance and critical pressure ratio.
//!
//! q = C p1 ρ0 √(T0/T1) up to the critical ratio p2/p1 = b (choked), above it times
//! (1 − ((p2/p1 − b)/(1 − b))²)^m. The edition of 1989 has m = 0.5; that of 2013 lets m be measured. Pressures are
//! absolute; ρ0 and T0 are those of free air (ISO 8778).

use std::f64::consts::FRAC_PI_2;

use crate::pneumatic::air::{FREE_AIR_DENSITY, FREE_AIR_TEMPERATURE};

/// Gas constant of dry air, J/(kg K).
pub const GAS_CONSTANT: f64 = 287.05;
/// Exponent of the subsonic law where a data sheet gives none.
pub const SUBSONIC_INDEX: f64 = 0.5;

/// A valve, throttle or tube as its data sheet describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductance {
    /// Sonic conductance C, m³/(s Pa) of free air; 1e-8 is 1 dm³/(s bar).
    pub sonic: f64,
    /// Critical pressure ratio b, from 0 to below 1.
    pub critical_ratio: f64,
    /// Subsonic index m.
    pub index: f64,
}

impl Conductance {
    /// With the subsonic index of 0.5.
    pub fn new(sonic: f64, critical_ratio: f64) -> Conductance {
        Conductance { sonic, critical_ratio, index: SUBSONIC_INDEX }
    }

    /// Flow as a share of the choked flow, 0 to 1, at a ratio p2/p1. 0 from a ratio of 1 on.
    pub fn share(&self, ratio: f64) -> f64 {
        let b = self.critical_ratio;
        if ratio <= b {
            1.0
        } else if ratio < 1.0 {
            (1.0 - ((ratio - b) / (1.0 - b)).powi(2)).powf(self.index)
        } else {
            0.0
        }
    }

    /// Mass flow, kg/s, from p1 to p2, Pa absolute, at the upstream temperature T1, K.
    pub fn mass_flow(&self, p1: f64, p2: f64, t1: f64) -> f64 {
        FREE_AIR_DENSITY * self.volume_flow(p1, p2, t1)
    }

    /// Flow of free air, m³/s, from p1 to p2, Pa absolute, at the upstream temperature T1, K.
    pub fn volume_flow(&self, p1: f64, p2: f64, t1: f64) -> f64 {
        self.sonic * p1 * (FREE_AIR_TEMPERATURE / t1).sqrt() * self.share(p2 / p1)
    }

    /// The sonic conductance, m³/(s Pa), that a flow of free air, m³/s, needs at this critical ratio and index.
    /// Infinite where p2 is not below p1.
    pub fn needed(&self, flow: f64, p1: f64, p2: f64, t1: f64) -> f64 {
        flow / Conductance { sonic: 1.0, ..*self }.volume_flow(p1, p2, t1)
    }
}

/// A volume filled through a restriction with a subsonic index of 0.5, at constant temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Charging {
    /// What it is filled through; its index is taken as 0.5.
    pub through: Conductance,
    /// Volume, m³.
    pub volume: f64,
    /// Pressure of the supply, Pa absolute.
    pub supply: f64,
    /// Pressure at time 0, Pa absolute.
    pub start: f64,
    /// Temperature, K.
    pub temperature: f64,
}

impl Charging {
    /// Rise of pressure while choked, Pa/s: q R T / V.
    pub fn choked_rate(&self) -> f64 {
        self.through.mass_flow(self.supply, 0.0, self.temperature) * GAS_CONSTANT * self.temperature / self.volume
    }
    /// How long the flow stays choked, s; 0 where it begins above the critical ratio.
    pub fn choked_time(&self) -> f64 {
        ((self.critical_pressure() - self.start) / self.choked_rate()).max(0.0)
    }
    /// When the supply's pressure is reached, s.
    pub fn full_time(&self) -> f64 {
        self.choked_time() + self.subsonic_time(FRAC_PI_2 - self.first_angle())
    }
    /// Pressure at a time, Pa absolute: first a straight line, then b p1 + (1 − b) p1 sin(φ), then the supply's.
    pub fn pressure(&self, time: f64) -> f64 {
        let choked = self.choked_time();
        if self.start >= self.supply {
            self.start
        } else if time < choked {
            self.start + self.choked_rate() * time.max(0.0)
        } else {
            let angle = self.first_angle() + (time - choked).max(0.0) / self.subsonic_time(1.0);
            self.critical_pressure() + (self.supply - self.critical_pressure()) * angle.min(FRAC_PI_2).sin()
        }
    }

    fn critical_pressure(&self) -> f64 {
        self.through.critical_ratio * self.supply
    }
    /// Time of a turn of φ, s.
    fn subsonic_time(&self, angle: f64) -> f64 {
        angle * (self.supply - self.critical_pressure()) / self.choked_rate()
    }
    /// φ where the subsonic part begins.
    fn first_angle(&self) -> f64 {
        let above = self.start.max(self.critical_pressure()) - self.critical_pressure();
        (above / (self.supply - self.critical_pressure())).clamp(0.0, 1.0).asin()
    }
}

/// Time constant, s, of a volume, m³, that empties through a sonic conductance, m³/(s Pa), at constant temperature, K.
pub fn discharge_time_constant(volume: f64, sonic: f64, temperature: f64) -> f64 {
    let flow = sonic * FREE_AIR_DENSITY * (FREE_AIR_TEMPERATURE / temperature).sqrt();
    volume / (flow * GAS_CONSTANT * temperature)
}

/// Pressure, Pa absolute, of such a volume after a time, s: p0 exp(−t/τ). Holds while choked, p above p_atm / b.
pub fn discharge_pressure(start: f64, time: f64, time_constant: f64) -> f64 {
    start * (-time / time_constant).exp()
}
