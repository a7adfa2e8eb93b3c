//! `[ground]` of all parts, each on the point that carries it.

use bellcrank_doc::{Diagnostic, Entry, Value};

use super::files::Mount;
use super::points::{self, Owner};
use super::{Machine, PartReader};
use crate::design::PointRef;
use crate::keyed::Keyed;
use crate::schema::GROUND;

/// Reads the grounds of all parts; those that sit on the ground of another one come after it.
pub(super) fn read(parts: &[PartReader<'_>], machine: &mut Machine) {
    machine.mounts = vec![None; parts.len()];
    let mut waiting: Vec<usize> = (0..parts.len()).collect();
    loop {
        let before = waiting.len();
        let mut left = waiting.clone();
        for part in waiting {
            if let Some(mount) = mount(parts, part, machine, &left) {
                machine.mounts[part] = mount;
                put(parts[part], mount, machine);
                left.retain(|&other| other != part);
            }
        }
        waiting = left;
        if waiting.is_empty() || waiting.len() == before {
            break;
        }
    }
    waiting.iter().for_each(|&part| report(parts, part, machine, &waiting));
    // Their points are there all the same: what refers to them is not to blame.
    waiting.into_iter().for_each(|part| put(parts[part], None, machine));
}

/// The point that carries a part, `Some(None)` for the world; `None` while what carries it is itself waiting.
fn mount(parts: &[PartReader<'_>], part: usize, machine: &Machine, waiting: &[usize]) -> Option<Option<PointRef>> {
    match &parts[part].part.mount {
        Mount::Point { written, prefix, span } => machine.point(written, prefix, *span).ok().map(Some),
        Mount::Ground => match parts[part].part.parent {
            None => Some(None),
            Some(parent) if waiting.contains(&parent) => None,
            Some(parent) => Some(machine.mounts[parent]),
        },
    }
}

/// Why a part could not be placed. One that only waits for another one with a fault is not to blame.
fn report(parts: &[PartReader<'_>], part: usize, machine: &Machine, waiting: &[usize]) {
    let Mount::Point { written, prefix, span } = &parts[part].part.mount else { return };
    let Some(carrier) = carrier(parts, part, waiting) else {
        if let Err(report) = machine.point(written, prefix, *span) {
            parts[part].reader.report(*report);
        }
        return;
    };
    let mut circle = vec![part];
    let mut next = Some(carrier);
    while let Some(at) = next.filter(|at| !circle.contains(at)) {
        circle.push(at);
        next = self::carrier(parts, at, waiting);
    }
    // Each circle once, at its first part.
    if next == Some(part) && circle.iter().all(|&other| part <= other) {
        let name = |&part: &usize| format!("`{}`", parts[part].prefix().trim_end_matches('.'));
        let names: Vec<String> = circle.iter().chain(circle.first()).map(name).collect();
        let message = format!("subsystems carry each other: the ground of {}", names.join(" is on that of "));
        parts[part].reader.report(Diagnostic::error("mount-cycle", *span, message));
    }
}

/// The waiting part on whose ground a part sits.
fn carrier(parts: &[PartReader<'_>], part: usize, waiting: &[usize]) -> Option<usize> {
    match &parts[part].part.mount {
        Mount::Point { written, prefix, .. } => {
            let body = format!("{prefix}{}", written.rsplit_once('.')?.0);
            waiting
                .iter()
                .copied()
                .find(|&other| !parts[other].prefix().is_empty() && parts[other].full("ground") == body)
        }
        Mount::Ground => parts[part].part.parent.filter(|parent| waiting.contains(parent)),
    }
}

/// Adds the points of a part's ground to the ground, or to the body that carries the part.
fn put(part: PartReader<'_>, mount: Option<PointRef>, machine: &mut Machine) {
    let (body, base) = mount.map_or((0, None), |point| (point.body, Some(point.point)));
    let prefix = if part.prefix().is_empty() { String::new() } else { part.full("ground.") };
    if !part.prefix().is_empty() {
        machine.mount(part.full("ground"), body, prefix.clone());
    }
    let Some(entry) = part.part.table.get("ground") else { return };
    let Some(fields) = part.reader.fields(&entry.value, "the ground") else { return };
    let keyed = Keyed::new(fields, &GROUND, part.space());
    let owner = Owner { what: "the ground".to_owned(), prefix, base };
    let mut read = keyed.value("points").map_or_else(Vec::new, |value| points::read(part, value, &owner));
    let strays = strays(&entry.value);
    if strays.is_empty() {
        keyed.finish();
    } else {
        report_strays(part, &strays);
        read.extend(strays.into_iter().filter_map(|entry| points::read_point(part, entry, &owner)));
    }
    for point in read {
        machine.point_names[body].insert(&point.name, machine.bodies[body].points.len());
        machine.bodies[body].points.push(point);
    }
}

/// Entries of `[ground]` that look like points: the commonest slip there.
fn strays(value: &Value) -> Vec<&Entry> {
    let is_point = |entry: &&Entry| entry.value.as_list().is_some() && entry.key != "points";
    let all: Vec<&Entry> = value.as_table().into_iter().flat_map(|table| table.iter()).collect();
    let others = all.iter().filter(|entry| entry.key != "points").count();
    let strays: Vec<&Entry> = all.into_iter().filter(is_point).collect();
    // Anything else is an unknown key like any other.
    if strays.len() == others { strays } else { Vec::new() }
}

fn report_strays(part: PartReader<'_>, strays: &[&Entry]) {
    let names: Vec<String> = strays.iter().map(|entry| format!("`{}`", entry.key)).collect();
    let message = format!("points of the ground stand in `[ground.points]`, found {} in `[ground]`", names.join(", "));
    let report = Diagnostic::error("unknown-key", strays[0].key_span, message);
    part.reader.report(report.hint("write `[ground.points]` for `[ground]`"));
}
