//! A pneumatic cylinder.

use bellcrank_doc::Expression;
use bellcrank_results::{Column, Property, Unit};
use bellcrank_sizing::pneumatic::{self, BucklingLoad, Conditions, Conductance, CylinderCandidate, Mounting, Supply};
use bellcrank_sizing::{Quantity, Selection, SizingError, Stroke, Subject};

use super::told::{Units, finding, percent, power, property};
use super::{Found, Loads};
use crate::ask::Asking;
use crate::design::{Pneumatic, Sizing};

pub(super) fn run(asking: &Asking<'_>, question: &Sizing, of: &Pneumatic, loads: &Loads) -> Result<Found, SizingError> {
    let conditions = conditions(asking, question, of);
    let selection = pneumatic::select(&loads.duty, &of.cylinders, &conditions)?;
    let units = Units::new(asking);
    let mut sizing = finding(asking, question, "pneumatic", &selection, |one| {
        units.candidate(one, ordered(one, &units), properties(one, &units))
    });
    sizing.requirements = requirements(&units, loads);
    sizing.conditions = assumed(&units, &conditions, of);
    let columns = pressures(&selection, &conditions, loads, &units);
    Ok(Found { warnings: warnings(&selection, &conditions, of, loads), columns, sizing })
}

fn conditions(asking: &Asking<'_>, question: &Sizing, of: &Pneumatic) -> Conditions {
    let values = asking.study.parameters.values();
    let at = |expression: &Expression| expression.eval(values, &[]);
    let or = |expression: &Option<Expression>, otherwise: f64| expression.as_ref().map_or(otherwise, at);
    let mounting = Mounting { end: of.ends, at: of.mounting, offset: or(&of.offset, 0.0) };
    let supply = Supply::gauge(at(&of.supply));
    let supply = Supply { atmosphere: or(&of.atmosphere, supply.atmosphere), ..supply };
    let usual = Conditions::new(supply, or(&of.load_factor, pneumatic::LOAD_FACTOR_GENERAL), mounting);
    Conditions {
        efficiency: or(&of.efficiency, usual.efficiency),
        buckling_safety: or(&of.buckling_safety, usual.buckling_safety),
        buckling_load: of.buckling_load,
        stroke_reserve: or(&question.stroke_reserve, usual.stroke_reserve),
        moved_mass: of.moved_mass.as_ref().map(at),
        arrival_speed: of.arrival_speed.as_ref().map(at),
        cycle_rate: of.cycles.as_ref().map(at),
        dead_volume: or(&of.dead_volume, usual.dead_volume),
        valve: of.valve.as_ref().map(|valve| {
            let usual = Conductance::new(at(&valve.sonic), at(&valve.critical_ratio));
            Conductance { index: or(&valve.index, usual.index), ..usual }
        }),
        ..usual
    }
}

/// `iso15552-125, stroke 160 mm`.
fn ordered(of: &CylinderCandidate, units: &Units<'_>) -> String {
    let shown = |length| Units::shown(length, &units.of(Quantity::Length));
    match of.stroke {
        Stroke::Standard(length) => format!("{}, stroke {}", of.cylinder.name, shown(length)),
        Stroke::Special(length) => format!("{}, special stroke {}", of.cylinder.name, shown(length)),
        Stroke::TooShort(_) => of.cylinder.name.clone(),
    }
}

fn properties(of: &CylinderCandidate, units: &Units<'_>) -> Vec<Property> {
    let volume = Unit::new("L", 1e-3);
    let mut told = vec![
        units.property("bore", "bore", of.cylinder.bore, Quantity::Length),
        units.property("rod", "rod", of.cylinder.rod, Quantity::Length),
        units.property("stroke", "stroke", of.stroke.length(), Quantity::Length),
        units.property("push", "theoretical push", of.push, Quantity::Force),
        units.property("pull", "theoretical pull", of.pull, Quantity::Force),
        units.property("working_pressure", "largest working pressure", of.working_pressure, Quantity::Pressure),
        units.property("needed_supply", "smallest supply", of.needed_supply, Quantity::Pressure),
        units.property("column", "buckling length", of.column, Quantity::Length),
        units.property("critical_load", "Euler's load", of.critical_load, Quantity::Force),
        property("air_per_double_stroke", "free air a double stroke", of.air.per_double_stroke, volume),
    ];
    told.extend(of.air.mean_flow.map(|flow| units.property("mean_air", "mean free air", flow, Quantity::Flow)));
    if of.air.peak_flow > 0.0 {
        told.push(units.property("peak_air", "peak free air", of.air.peak_flow, Quantity::Flow));
    }
    told
}

fn requirements(units: &Units<'_>, loads: &Loads) -> Vec<Property> {
    let of = &loads.requirement;
    let mut told = vec![
        units.property("stroke", "stroke", of.stroke, Quantity::Length),
        units.property("push", "push", of.push.value, Quantity::Force),
        units.property("pull", "pull", of.pull.value, Quantity::Force),
    ];
    let speeds = [("extending_speed", "speed out", of.extending), ("retracting_speed", "speed in", of.retracting)];
    for (key, label, motion) in speeds {
        if motion.speed.value > 0.0 {
            told.push(units.property(key, label, motion.speed.value, Quantity::Speed));
        }
    }
    told.extend(power(units, loads));
    told
}

fn assumed(units: &Units<'_>, conditions: &Conditions, of: &Pneumatic) -> Vec<Property> {
    let plain = |key: &str, label: &str, value: f64| property(key, label, value, Unit::one());
    let mounting = &conditions.mounting;
    let mut told = vec![
        units.property("supply", "supply pressure (gauge)", conditions.supply.pressure, Quantity::Pressure),
        plain("load_factor", "load factor", conditions.load_factor),
    ];
    if of.atmosphere.is_some() {
        let value = conditions.supply.atmosphere;
        told.push(units.property("atmosphere", "air around (absolute)", value, Quantity::Pressure));
    }
    if conditions.efficiency != 1.0 {
        told.push(property("efficiency", "efficiency", conditions.efficiency, percent()));
    }
    let (ends, held) = (mounting.end.key(), mounting.at.key());
    told.push(plain("end_factor", &format!("Euler's length factor, ends {ends}"), mounting.end.factor()));
    let column = |stroke| mounting.column(stroke, None) - mounting.offset;
    told.push(plain("column_strokes", &format!("strokes in the buckling length, {held} mounting"), column(1.0)));
    if mounting.offset > 0.0 {
        told.push(units.property("offset", "added to the buckling length", mounting.offset, Quantity::Length));
    }
    let load = match conditions.buckling_load {
        BucklingLoad::Duty => "largest push",
        BucklingLoad::Supply => "push of the full supply",
    };
    told.push(plain("buckling_safety", &format!("buckling safety of the {load}"), conditions.buckling_safety));
    if conditions.stroke_reserve > 0.0 {
        let value = conditions.stroke_reserve;
        told.push(units.property("stroke_reserve", "stroke kept free at each end", value, Quantity::Length));
    }
    told.extend(conditions.moved_mass.map(|mass| property("moved_mass", "moved mass", mass, units.mass())));
    told.extend(
        conditions
            .arrival_speed
            .map(|speed| units.property("arrival_speed", "speed of arrival", speed, Quantity::Speed)),
    );
    told.extend(
        conditions.cycle_rate.map(|rate| property("cycles", "double strokes", rate, Unit::new("1/min", 1.0 / 60.0))),
    );
    if conditions.dead_volume > 0.0 {
        told.push(property("dead_volume", "dead volume", conditions.dead_volume, Unit::new("L", 1e-3)));
    }
    if let Some(valve) = conditions.valve {
        let conductance = Unit::new("L/(s*bar)", 1e-8);
        told.push(property("sonic_conductance", "sonic conductance of the valve", valve.sonic, conductance));
        told.push(plain("critical_ratio", "critical pressure ratio of the valve", valve.critical_ratio));
    }
    told
}

/// Working pressure of the proposed cylinder over the rows, else of the nearest; what may be used of the supply, and
/// the supply.
fn pressures(
    selection: &Selection<CylinderCandidate>,
    conditions: &Conditions,
    loads: &Loads,
    units: &Units<'_>,
) -> Vec<Column> {
    let Some(drawn) = selection.chosen().or_else(|| selection.nearest()) else { return Vec::new() };
    let working = drawn.working_pressures(&loads.duty, conditions.efficiency);
    let supply = conditions.supply.pressure;
    let column = |name: &str, values| Column { name: name.to_owned(), unit: units.of(Quantity::Pressure), values };
    vec![
        column("working pressure", working.iter().map(|row| row.pressure).collect()),
        column("usable pressure", vec![supply * conditions.load_factor; loads.rows()]),
        column("supply pressure", vec![supply; loads.rows()]),
    ]
}

fn warnings(
    selection: &Selection<CylinderCandidate>,
    conditions: &Conditions,
    of: &Pneumatic,
    loads: &Loads,
) -> Vec<String> {
    let mut told = Vec::new();
    if of.valve.is_some() && loads.requirement.speed.value == 0.0 {
        told.push("nothing moves in these rows, so the valve is not judged".to_owned());
    }
    told.extend(selection.chosen().and_then(|chosen| body_too_long(chosen, conditions)));
    told
}

/// Bodies are shorter than so many bores: ISO 15552 has 2 to 5, ISO 6432 up to 10.
const LONGEST_BODY: f64 = 10.0;

/// The catalogue does not give the length of the body, and one that may well be would buckle the rod.
fn body_too_long(chosen: &CylinderCandidate, conditions: &Conditions) -> Option<String> {
    let buckling = chosen.checks.iter().find(|check| check.subject == Subject::Buckling)?;
    let mounting = &conditions.mounting;
    let share = mounting.column(0.0, Some(1.0)) - mounting.offset;
    if share == 0.0 || mounting.offset > 0.0 || chosen.cylinder.base_length.is_some() {
        return None;
    }
    // Euler's load falls with the square of the length.
    let longest = chosen.column * (1.0 / buckling.utilization()).sqrt();
    let body = (longest - chosen.column) / share;
    (body < LONGEST_BODY * chosen.cylinder.bore).then(|| {
        format!(
            "the catalogue does not give the length of the body of `{}`: longer than {} the rod would buckle; \
             give it as `offset`",
            chosen.cylinder.name,
            Units::shown(body, &Unit::new("mm", 1e-3))
        )
    })
}
