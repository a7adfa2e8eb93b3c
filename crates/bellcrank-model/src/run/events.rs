//! What happened while a machine moved, in names and units of the file.

use bellcrank_multibody::{Event, EventKind, ForceId};
use bellcrank_results::{Event as Told, EventKind as Kind};

use super::explain::Namer;
use crate::design::{Design, ForceShape, StopWhen};
use crate::measure::{Measure, Motion};

/// An event as results tell it.
pub(super) fn told(design: &Design, conditions: &[StopWhen], event: &Event) -> Told {
    let one = |kind, force: ForceId, side: &'static str| Told {
        time: event.time,
        kind,
        name: design.forces.get(force.0).map_or_else(String::new, |force| force.name.clone()),
        joint: joint(design, force),
        side,
        numbers: Vec::new(),
    };
    let limit = |upper: bool| if upper { "upper" } else { "lower" };
    match event.kind {
        EventKind::Switch { index, .. } => Told {
            time: event.time,
            kind: Kind::Condition,
            name: conditions.get(index).map_or_else(String::new, |stop| stop.written.clone()),
            joint: String::new(),
            side: "",
            numbers: Vec::new(),
        },
        EventKind::Impact { force, upper, speed, impulse } => {
            let motion = motion(design, force);
            let units = &design.units;
            let (rate, effort) = (units.of(Measure::velocity(motion)), units.of(Measure::effort(motion)));
            let time = units.of(Measure::Time);
            let effort_time = format!("{}*{}", effort.symbol, time.symbol);
            let push = bellcrank_results::Unit::new(effort_time, effort.factor * time.factor);
            let numbers = vec![("speed", speed, rate), ("impulse", impulse, push)];
            Told { numbers, ..one(Kind::Impact, force, limit(upper)) }
        }
        EventKind::Contact { force, upper } => one(Kind::Contact, force, limit(upper)),
        EventKind::Release { force, upper } => one(Kind::Release, force, limit(upper)),
        EventKind::Stick { force } => one(Kind::Stick, force, ""),
        EventKind::Slip { force, rising } => one(Kind::Slip, force, if rising { "up" } else { "down" }),
    }
}

fn coordinate(design: &Design, force: ForceId) -> Option<bellcrank_multibody::Coordinate> {
    match design.forces.get(force.0)?.shape {
        ForceShape::Stop { coordinate, .. } | ForceShape::Friction { coordinate, .. } => Some(coordinate),
        _ => None,
    }
}

fn joint(design: &Design, force: ForceId) -> String {
    coordinate(design, force).map_or_else(String::new, |c| Namer::new(design).coordinate(c))
}

fn motion(design: &Design, force: ForceId) -> Motion {
    let of = |c: bellcrank_multibody::Coordinate| {
        let joint = design.joints.get(c.joint.0)?;
        joint.coordinates(design.planar).get(c.index).copied()
    };
    coordinate(design, force).and_then(of).unwrap_or(Motion::Slide)
}
