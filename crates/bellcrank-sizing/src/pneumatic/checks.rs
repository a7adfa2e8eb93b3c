//! The checks of a cylinder, each with its sentence.

use crate::pneumatic::buckling::critical_load;
use crate::pneumatic::cushion::kinetic_energy;
use crate::pneumatic::force::{annulus_area, piston_area, pull, push, working_pressure};
use crate::pneumatic::{BucklingLoad, Conditions, Conductance, Cylinder, Side, air};
use crate::words::{both, number, shown};
use crate::{Check, Duty, Peak, Quantity, Requirement, Row, Stroke, Subject};

/// A cylinder with its stroke under the conditions, against a duty.
pub(super) struct Trial<'a> {
    pub(super) cylinder: &'a Cylinder,
    pub(super) conditions: &'a Conditions,
    pub(super) duty: &'a Duty,
    pub(super) requirement: &'a Requirement,
    pub(super) stroke: Stroke,
}

impl Trial<'_> {
    /// All of them, the most important first.
    pub(super) fn checks(&self) -> Vec<Check> {
        let mut checks = vec![self.push(), self.pull(), self.stroke(), self.buckling()];
        checks.extend([self.pressure(), self.speed(), self.cushion()]);
        checks.extend(self.conditions.valve.map(|valve| self.valve(&valve)));
        checks
    }

    /// A position of the duty as the machine counts it.
    fn place(&self, position: f64) -> String {
        shown(self.duty.machine_position(position), Quantity::Length)
    }

    fn push(&self) -> Check {
        let theoretical = push(self.cylinder.bore, self.conditions.supply.pressure);
        self.force(Subject::Push, theoretical, &self.requirement.push)
    }
    fn pull(&self) -> Check {
        let theoretical = pull(self.cylinder.bore, self.cylinder.rod, self.conditions.supply.pressure);
        self.force(Subject::Pull, theoretical, &self.requirement.pull)
    }
    /// Theoretical force less load factor and efficiency, against the largest effort of that sign.
    fn force(&self, subject: Subject, theoretical: f64, peak: &Peak) -> Check {
        let Conditions { load_factor, efficiency, .. } = *self.conditions;
        let usable = theoretical * load_factor * efficiency;
        let (is, needed) = both(usable, peak.value, Quantity::Force);
        let seals = if efficiency == 1.0 { String::new() } else { format!(" × {}", number(efficiency)) };
        let product = format!("{} × {}{seals} = {is}", shown(theoretical, Quantity::Force), number(load_factor));
        let key = subject.key();
        let reason = match peak.value > 0.0 {
            true => format!("{key} {product}, needed {needed} at {}", self.place(peak.position)),
            false => format!("{key} {product}, none needed"),
        };
        Check::new(subject, Quantity::Force, peak.value, usable, reason)
    }

    fn stroke(&self) -> Check {
        self.stroke.check(self.requirement.stroke, self.conditions.stroke_reserve, Quantity::Length)
    }

    /// The push against Euler's load with the rod fully out, whatever the position the push is needed at.
    fn buckling(&self) -> Check {
        let length = self.column();
        let critical = self.critical_load();
        let allowed = critical / self.conditions.buckling_safety;
        let force = match self.conditions.buckling_load {
            BucklingLoad::Duty => self.requirement.push.value,
            BucklingLoad::Supply => push(self.cylinder.bore, self.conditions.supply.pressure),
        };
        if self.cylinder.rod == 0.0 {
            return Check::unknown(Subject::Buckling, Quantity::Force, force, f64::NAN, "the cylinder has no rod");
        }
        let (is, needed) = both(allowed, force, Quantity::Force);
        let reason = format!(
            "Euler's load {} at {} ({}) / {} = {is}, needed {needed}",
            shown(critical, Quantity::Force),
            shown(length, Quantity::Length),
            self.held(),
            number(self.conditions.buckling_safety)
        );
        Check::new(Subject::Buckling, Quantity::Force, force, allowed, reason)
    }
    /// How the column is held, and whether a part of its length is missing.
    fn held(&self) -> String {
        let mounting = &self.conditions.mounting;
        let missing = mounting.at.shares().1 > 0.0 && self.cylinder.base_length.is_none() && mounting.offset == 0.0;
        format!("{}{}", mounting.end.key(), if missing { ", without the body's base length" } else { "" })
    }
    pub(super) fn column(&self) -> f64 {
        self.conditions.mounting.column(self.stroke.length(), self.cylinder.base_length)
    }
    pub(super) fn critical_load(&self) -> f64 {
        let Cylinder { rod, youngs_modulus, .. } = *self.cylinder;
        critical_load(rod, self.column(), self.conditions.mounting.end, youngs_modulus)
    }

    fn pressure(&self) -> Check {
        let supply = self.conditions.supply.pressure;
        let Some(limit) = self.cylinder.max_pressure else {
            let why = "the catalogue gives no pressure limit";
            return Check::unknown(Subject::Pressure, Quantity::Pressure, supply, f64::NAN, why);
        };
        let (is, needed) = both(limit, supply, Quantity::Pressure);
        let reason = format!("pressure limit {is}, supply {needed}");
        Check::new(Subject::Pressure, Quantity::Pressure, supply, limit, reason)
    }

    fn speed(&self) -> Check {
        let peak = &self.requirement.speed;
        let Some(limit) = self.cylinder.max_speed else {
            let why = "the catalogue gives no speed limit";
            return Check::unknown(Subject::Speed, Quantity::Speed, peak.value, f64::NAN, why);
        };
        let (is, needed) = both(limit, peak.value, Quantity::Speed);
        let reason = format!("speed limit {is}, needed {needed} at {}", self.place(peak.position));
        Check::new(Subject::Speed, Quantity::Speed, peak.value, limit, reason)
    }

    fn cushion(&self) -> Check {
        let speed = self.conditions.arrival_speed.unwrap_or(self.requirement.speed.value);
        let limit = self.cylinder.cushion_energy;
        let own = self.cylinder.moving_mass_at(self.stroke.length()).unwrap_or(0.0);
        let needed = self.conditions.moved_mass.map(|moved| kinetic_energy(moved + own, speed));
        let unknown = |why| {
            let (needed, limit) = (needed.unwrap_or(f64::NAN), limit.unwrap_or(f64::NAN));
            Check::unknown(Subject::Cushion, Quantity::Energy, needed, limit, why)
        };
        match (needed, limit) {
            (_, None) => unknown("the catalogue gives no cushion energy"),
            (None, _) => unknown("the moved mass is not given"),
            (Some(needed), Some(limit)) => {
                let (is, energy) = both(limit, needed, Quantity::Energy);
                let mass = number(self.conditions.moved_mass.unwrap_or(0.0) + own);
                let reason = format!("cushion {is}, {mass} kg at {} bring {energy}", shown(speed, Quantity::Speed));
                Check::new(Subject::Cushion, Quantity::Energy, needed, limit, reason)
            }
        }
    }

    /// Where the cylinder drives (effort with the motion), the valve must fill the growing chamber at its working
    /// pressure.
    fn valve(&self, valve: &Conductance) -> Check {
        let share = |flow: &(f64, f64, f64)| if flow.0 == 0.0 { 0.0 } else { flow.0 / flow.1 };
        let driving = self.duty.rows().iter().filter(|row| row.effort * row.velocity > 0.0);
        // From the end, so that the first of equals is told.
        let worst = driving.rev().map(|row| self.flow(row, valve)).max_by(|a, b| share(a).total_cmp(&share(b)));
        let Some((needed, available, position)) = worst else {
            let why = "the cylinder drives nothing at a speed";
            return Check::unknown(Subject::Valve, Quantity::Flow, 0.0, f64::NAN, why);
        };
        let (is, wanted) = both(available, needed, Quantity::Flow);
        let reason = format!("valve {is}, needed {wanted} at {}", self.place(position));
        Check::new(Subject::Valve, Quantity::Flow, needed, available, reason)
    }
    /// Flow needed, flow the valve gives against the chamber's pressure, position.
    fn flow(&self, row: &Row, valve: &Conductance) -> (f64, f64, f64) {
        let Cylinder { bore, rod, .. } = *self.cylinder;
        let (side, gauge) = working_pressure(row.effort, bore, rod, self.conditions.efficiency);
        let area = match side {
            Side::Piston => piston_area(bore),
            Side::Rod => annulus_area(bore, rod),
        };
        let supply = self.conditions.supply;
        let chamber = gauge + supply.atmosphere;
        let needed = air::filling_flow(area, row.velocity.abs(), chamber);
        (needed, valve.volume_flow(supply.absolute(), chamber, air::FREE_AIR_TEMPERATURE), row.position)
    }
}
