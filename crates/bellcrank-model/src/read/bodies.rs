//! `[ground]` and `[bodies]`.

use bellcrank_doc::{Diagnostic, Span, Spanned, Value};

use super::flexible;
use super::points::{self, Owner};
use super::{Machine, PartReader, grounds};
use crate::design::{Body, Quantity, Rod, Worn};
use crate::keyed::Keyed;
use crate::names::{self, Index};
use crate::schema::BODY;

/// Reads the bodies of all parts, then the grounds: these may sit on a body of another part.
pub(crate) fn read(parts: &[PartReader<'_>], machine: &mut Machine) {
    let span = parts[0].part.table.span;
    add(machine, massless("ground".to_owned(), span));
    for part in parts {
        for entry in entries(part, "bodies") {
            if let Some(fault) = names::fault(entry, "body") {
                part.reader.report(fault);
            }
            read_body(*part, machine, &entry.key, entry.key_span, &entry.value);
        }
    }
    grounds::read(parts, machine);
}

/// The entries of a table of named things in a part; what is no table has been reported with the head.
pub(crate) fn entries<'a>(part: &PartReader<'a>, key: &str) -> Vec<&'a bellcrank_doc::Entry> {
    match part.part.table.get(key) {
        None => Vec::new(),
        Some(entry) => match part.reader.fields(&entry.value, &format!("`{key}` of the model")) {
            Some(fields) => fields.table().iter().collect(),
            None => Vec::new(),
        },
    }
}

fn massless(name: String, span: Span) -> Body {
    Body {
        name,
        span,
        mass: None,
        center: None,
        inertia: None,
        solid: None,
        rod: None,
        flexible: None,
        points: Vec::new(),
        planar: false,
    }
}

fn add(machine: &mut Machine, body: Body) -> usize {
    let index = machine.bodies.len();
    machine.body_names.insert(&body.name, index);
    let mut points = Index::default();
    for (place, point) in body.points.iter().enumerate() {
        points.insert(&point.name, place);
    }
    machine.point_names.push(points);
    machine.bodies.push(body);
    index
}

fn read_body(part: PartReader<'_>, machine: &mut Machine, key: &str, span: Span, value: &Value) {
    let mut body = Body { planar: part.planar, ..massless(part.full(key), span) };
    let mut flexible = None;
    if let Some(fields) = part.reader.fields(value, &format!("body `{key}`")) {
        let keyed = Keyed::new(fields, &BODY, part.space());
        let owner = Owner { what: format!("body `{key}`"), prefix: String::new(), base: None };
        if let Some(value) = keyed.value("points") {
            body.points = points::read(part, value, &owner);
        }
        body.mass = keyed.quantity("mass").map(|mass| part.quantity(mass));
        body.center = keyed.vector("center").map(|center| part.quantities(center));
        body.inertia = inertia(part, &keyed);
        body.solid = solid(part, machine, &keyed);
        body.rod = rod(part, machine, &keyed);
        flexible = flexible::read(part, &keyed, &body);
        if key != "ground" {
            check_inertia(&keyed, &body);
        }
        keyed.finish();
    }
    if machine.body(&body.name).is_none() {
        let body = add(machine, body);
        machine.deforming.extend(flexible.map(|form| form.of(body)));
    }
}

/// One value in the plane; a list of three or six in space, and in the plane for a part of a spatial machine: alone it
/// uses the third.
fn inertia(part: PartReader<'_>, keyed: &Keyed<'_>) -> Option<Vec<Quantity>> {
    let value = keyed.value("inertia")?;
    let what = keyed.named("inertia");
    let dimension = bellcrank_doc::Dimension::INERTIA;
    let read = match (value.as_list(), part.planar) {
        (None, true) => part.reader.quantity(value, &what, dimension).map(|one| vec![one]),
        (Some(list), true) if matches!(list.len(), 1 | 3 | 6) => {
            part.reader.uniform_vector(value, &what, dimension, &[1, 3, 6])
        }
        (Some(list), true) => {
            let message = format!("{what} needs one value in the plane, found {}", list.len());
            let report = Diagnostic::error("wrong-length", value.span, message);
            part.reader.report(report.hint("about the centre of mass, round z: `inertia = \"0.1 kg*m^2\"`"));
            None
        }
        (Some(_), false) => part.reader.uniform_vector(value, &what, dimension, &[3, 6]),
        (None, false) => {
            let message = format!("{what} needs a list in space: [Ixx, Iyy, Izz], or with Ixy, Ixz, Iyz");
            part.reader.report(Diagnostic::error("wrong-type", value.span, message));
            None
        }
    };
    read.map(|values| part.quantities(values))
}

/// A massive body needs an inertia, even where a study sets its mass to zero.
fn check_inertia(keyed: &Keyed<'_>, body: &Body) {
    let Some(mass) = &body.mass else { return };
    let always_massless = mass.expression.as_constant() == Some(0.0);
    if ["inertia", "solid", "beam"].into_iter().any(|key| keyed.has(key)) || always_massless {
        return;
    }
    let message = format!("`inertia` is missing in {}, which has a mass", keyed.what());
    let report = Diagnostic::error("missing-inertia", keyed.span(), message).also(mass.span(), "mass given here");
    keyed.report(report.hint("about the centre of mass; a point mass has `inertia = 0` (in space `[0, 0, 0]`)"));
}

/// The solid of a body; its points are found when all bodies are there.
fn solid(part: PartReader<'_>, machine: &Machine, keyed: &Keyed<'_>) -> Option<Worn> {
    let name = keyed.text("solid")?;
    check_numbers(keyed, name, "a solid");
    match machine.solid_names.find(name.value, part.prefix(), "solid", name.span) {
        Ok(solid) => Some(Worn { solid, span: name.span, points: Vec::new() }),
        Err(report) => {
            part.reader.report(*report);
            None
        }
    }
}

/// The beam of a body; its ends are found when all bodies are there.
fn rod(part: PartReader<'_>, machine: &Machine, keyed: &Keyed<'_>) -> Option<Rod> {
    let name = keyed.text("beam")?;
    check_numbers(keyed, name, "a beam");
    if let Some(solid) = keyed.value("solid") {
        let message = format!("{} has a solid and a beam", keyed.what());
        let report = Diagnostic::error("conflicting-keys", name.span, message).also(solid.span, "the solid");
        keyed.report(report.hint("leave out one; two parts that are one body in the machine are two bodies, welded"));
    }
    match machine.beam_names.find(name.value, part.prefix(), "beam", name.span) {
        Ok(beam) => Some(Rod { beam, span: name.span, ends: [0, 0] }),
        Err(report) => {
            part.reader.report(*report);
            None
        }
    }
}

/// Mass properties come from a solid, a beam or from numbers.
fn check_numbers(keyed: &Keyed<'_>, name: Spanned<&str>, from: &str) {
    let given: Vec<&'static str> = ["mass", "center", "inertia"].into_iter().filter(|key| keyed.has(key)).collect();
    let Some(first) = given.first().and_then(|key| keyed.value(key)) else { return };
    let names: Vec<String> = given.iter().map(|key| format!("`{key}`")).collect();
    let message = format!("{} has its mass properties from {from} and from {}", keyed.what(), names.join(", "));
    let report = Diagnostic::error("conflicting-keys", first.span, message).also(name.span, &from["a ".len()..]);
    keyed.report(
        report.hint("leave out one or the other; what the solid leaves out can be a body of its own, welded on"),
    );
}
