//! An electric drive.

use bellcrank_results::{Property, Unit};
use bellcrank_sizing::electric::{self, Conditions, DriveCandidate, Kind};
use bellcrank_sizing::{Basis, Quantity, SizingError, Stroke};

use super::told::{Units, finding, percent, power, property};
use super::{Found, Loads};
use crate::ask::Asking;
use crate::design::{Electric, Sizing};

pub(super) fn run(asking: &Asking<'_>, question: &Sizing, of: &Electric, loads: &Loads) -> Result<Found, SizingError> {
    let values = asking.study.parameters.values();
    let at = |expression: &bellcrank_doc::Expression| expression.eval(values, &[]);
    let conditions = Conditions {
        stroke_reserve: question.stroke_reserve.as_ref().map_or(0.0, at),
        cycle_time: of.cycle_time.as_ref().map(at),
        ..Conditions::new(of.safety.as_ref().map_or(1.0, at))
    };
    let selection = electric::select(&loads.duty, of.kind, &of.drives, &conditions)?;
    let units = Units::new(asking);
    let name = if of.kind == Kind::Linear { "electric-linear" } else { "electric-rotary" };
    let mut sizing = finding(asking, question, name, &selection, |one| {
        units.candidate(one, ordered(one, &units), properties(one, &units))
    });
    sizing.requirements = requirements(&units, of.kind, loads);
    sizing.conditions = assumed(&units, of.kind, &conditions);
    Ok(Found { warnings: warnings(&conditions, loads), columns: Vec::new(), sizing })
}

fn ordered(of: &DriveCandidate, units: &Units<'_>) -> String {
    let shown = |length| Units::shown(length, &units.of(of.drive.kind.travel()));
    match of.stroke {
        Some(Stroke::Standard(length)) => format!("{}, stroke {}", of.drive.name, shown(length)),
        Some(Stroke::Special(length)) => format!("{}, special stroke {}", of.drive.name, shown(length)),
        Some(Stroke::TooShort(_)) | None => of.drive.name.clone(),
    }
}

fn properties(of: &DriveCandidate, units: &Units<'_>) -> Vec<Property> {
    let drive = &of.drive;
    let (effort, speed) = (drive.kind.effort(), drive.kind.speed());
    let word = word(drive.kind);
    let mut told = vec![
        units.property(&format!("rated_{word}"), &format!("rated {word}"), drive.rated_effort, effort),
        units.property(&format!("peak_{word}"), &format!("peak {word}"), drive.peak_effort, effort),
        units.property("max_speed", "largest speed", drive.max_speed, speed),
    ];
    told.extend(drive.rated_power.map(|power| units.property("rated_power", "rated power", power, Quantity::Power)));
    if let Some(gear) = drive.gear {
        told.push(property("gear_ratio", "gear", gear.ratio, Unit::one()));
        told.push(property("gear_efficiency", "gear efficiency", gear.efficiency, percent()));
    }
    let place = if drive.gear.is_some() { " at the motor" } else { "" };
    let shaft = &of.at_shaft;
    told.push(units.property(
        &format!("shaft_peak_{word}"),
        &format!("needed peak{place}"),
        shaft.effort.value,
        effort,
    ));
    told.push(units.property(&format!("shaft_rms_{word}"), &format!("needed rms{place}"), of.rms_effort, effort));
    told.push(units.property("shaft_speed", &format!("needed speed{place}"), shaft.speed.value, speed));
    told
}

fn word(kind: Kind) -> &'static str {
    if kind == Kind::Linear { "force" } else { "torque" }
}

fn requirements(units: &Units<'_>, kind: Kind, loads: &Loads) -> Vec<Property> {
    let of = &loads.requirement;
    let word = word(kind);
    let travel = if kind == Kind::Linear { "stroke" } else { "travel" };
    let mut told = vec![
        units.property(travel, travel, of.stroke, kind.travel()),
        units.property(&format!("peak_{word}"), &format!("peak {word}"), of.effort.value, kind.effort()),
        units.property(&format!("rms_{word}"), &format!("rms {word}"), of.rms_effort, kind.effort()),
    ];
    if of.speed.value > 0.0 {
        told.push(units.property("speed", "speed", of.speed.value, kind.speed()));
    }
    told.extend(power(units, loads));
    told
}

fn assumed(units: &Units<'_>, kind: Kind, conditions: &Conditions) -> Vec<Property> {
    let mut told = vec![property("safety", "safety of the efforts", conditions.safety, Unit::one())];
    told.extend(conditions.cycle_time.map(|time| property("cycle_time", "time of a cycle", time, units.time())));
    if conditions.stroke_reserve > 0.0 {
        let value = conditions.stroke_reserve;
        told.push(units.property("stroke_reserve", "travel kept free at each end", value, kind.travel()));
    }
    told
}

fn warnings(conditions: &Conditions, loads: &Loads) -> Vec<String> {
    let mut told = Vec::new();
    let over = match loads.duty.basis() {
        Basis::Time | Basis::Speed => None,
        Basis::Travel => Some("equal travel"),
        Basis::Rows => Some("the rows"),
    };
    if let Some(over) = over {
        told.push(format!("these rows tell no time, so the root mean square is taken over {over}, and no mean power"));
    }
    match (conditions.cycle_time, loads.duty.duration()) {
        (Some(cycle), Some(duration)) if cycle < duration => {
            let message = format!("the cycle of {cycle} s is shorter than the study, which takes {duration:.4} s: ");
            told.push(message + "the study follows itself");
        }
        (Some(_), None) => told.push("`cycle_time` counts for nothing where rows tell no time".to_owned()),
        _ => {}
    }
    told
}
