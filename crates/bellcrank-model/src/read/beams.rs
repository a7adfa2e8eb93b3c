//! `[beams]`, and which body uses which.

use bellcrank_doc::{Diagnostic, Entry, Expression, Spanned};

use super::bodies::entries;
use super::{Machine, PartReader};
use crate::design::{Beam, Quantity, Rod, Section};
use crate::keyed::Keyed;
use crate::names;
use crate::schema::BEAM;

/// Reads the beams of all parts. Materials are there already.
pub(super) fn read(parts: &[PartReader<'_>], machine: &mut Machine) {
    for part in parts {
        for entry in entries(part, "beams") {
            if let Some(fault) = names::fault(entry, "beam") {
                part.reader.report(fault);
            }
            let beam = one(*part, machine, entry);
            machine.beam_names.insert(&beam.name, machine.beams.len());
            machine.beams.push(beam);
        }
    }
}

fn one(part: PartReader<'_>, machine: &Machine, entry: &Entry) -> Beam {
    let mut beam = Beam {
        name: part.full(&entry.key),
        span: entry.key_span,
        material: None,
        between: Vec::new(),
        section: Section::Faulty,
        up: None,
    };
    let Some(fields) = part.reader.fields(&entry.value, &format!("beam `{}`", entry.key)) else { return beam };
    let keyed = Keyed::new(fields, &BEAM, part.space());
    if let Some(name) = keyed.text("material") {
        match machine.material_names.find(name.value, part.prefix(), "material", name.span) {
            Ok(material) => beam.material = Some(material),
            Err(report) => part.reader.report(*report),
        }
    }
    beam.between = between(&keyed);
    beam.section = section(part, &keyed).unwrap_or(Section::Faulty);
    beam.up = keyed.axis("up").map(|axis| part.direction(axis));
    if let (true, Some(up)) = (part.planar, keyed.value("up")) {
        let message = format!("{} has `up`, which beams of a planar model do not", keyed.what());
        let hint = "in the plane `height` lies in the plane, and `width` across it";
        keyed.report(Diagnostic::error("conflicting-keys", up.span, message).hint(hint));
    }
    keyed.finish();
    beam
}

/// The names of the ends; none after an error.
fn between(keyed: &Keyed<'_>) -> Vec<Spanned<String>> {
    let Some(names) = keyed.texts("between") else { return Vec::new() };
    let span = keyed.value("between").map_or(keyed.span(), |value| value.span);
    match names.as_slice() {
        [a, b] if a.value != b.value => {
            names.iter().map(|name| Spanned { value: name.value.to_owned(), span: name.span }).collect()
        }
        [a, _] => {
            let message = format!("{} begins and ends at `{}`", keyed.what(), a.value);
            keyed.report(Diagnostic::error("wrong-length", span, message));
            Vec::new()
        }
        _ => {
            let message = format!("{} needs two points, found {}", keyed.named("between"), names.len());
            keyed.report(Diagnostic::error("wrong-length", span, message).hint("as `between = [\"A\", \"B\"]`"));
            Vec::new()
        }
    }
}

/// Keys that say what the section is; each group by itself.
const SECTIONS: [&[&str]; 4] =
    [&["width", "height"], &["diameter"], &["tube"], &["area", "second_moment", "torsion", "shear_areas"]];

/// `None` after an error.
fn section(part: PartReader<'_>, keyed: &Keyed<'_>) -> Option<Section> {
    let given = SECTIONS.map(|keys| keys.iter().copied().find(|key| keyed.has(key)));
    let several: Vec<String> = given.iter().flatten().map(|key| format!("`{key}`")).collect();
    if several.len() != 1 {
        let (code, message) = match several.len() {
            0 => ("missing-key", format!("{} has no section", keyed.what())),
            _ => ("conflicting-keys", format!("{} has more than one section: {}", keyed.what(), several.join(", "))),
        };
        let hint = "`width` and `height`; `diameter`; `tube = [outer diameter, wall]`; or `area` and `second_moment`";
        keyed.report(Diagnostic::error(code, keyed.span(), message).hint(hint));
        return None;
    }
    let needed = |name| {
        keyed.needed(name);
        keyed.quantity(name).map(|value| part.quantity(value))
    };
    let all = |values: Vec<Expression>| -> Vec<Quantity> { part.quantities(values) };
    match given {
        [Some(_), ..] => {
            let (width, height) = (needed("width"), needed("height"));
            Some(Section::Rectangle { width: width?, height: height? })
        }
        [_, Some(_), ..] => Some(Section::Round(needed("diameter")?)),
        [_, _, Some(_), _] => {
            let [outer, wall] = all(keyed.list("tube")?).try_into().ok()?;
            Some(Section::Tube { outer, wall })
        }
        _ => {
            let area = needed("area");
            keyed.needed("second_moment");
            let second_moment = keyed.one_or_list("second_moment").map(all);
            if !part.planar {
                keyed.needed("torsion");
            }
            let torsion = keyed.quantity("torsion").map(|value| part.quantity(value));
            let shear_areas = keyed.one_or_list("shear_areas").map(all).unwrap_or_default();
            Some(Section::Any { area: area?, second_moment: second_moment?, torsion, shear_areas })
        }
    }
}

/// Finds the ends of beams on each body that uses one; bodies and grounds are there already. A body whose ends are not
/// there has no beam then.
pub(super) fn fit(parts: &[PartReader<'_>], machine: &mut Machine) {
    let reader = parts[0].reader;
    let mut users: Vec<Option<usize>> = vec![None; machine.beams.len()];
    for body in 0..machine.bodies.len() {
        let Some(rod) = machine.bodies[body].rod.take() else { continue };
        users[rod.beam].get_or_insert(body);
        match ends(machine, body, &rod) {
            Ok(ends) => machine.bodies[body].rod = ends.map(|ends| Rod { ends, ..rod }),
            Err(reports) => reports.into_iter().for_each(|report| reader.report(report)),
        }
    }
    for (beam, user) in machine.beams.iter().zip(&users) {
        let Some(material) = beam.material.and_then(|material| machine.materials.get(material)) else { continue };
        if user.is_none() {
            let message = format!("no body uses beam `{}`", beam.name);
            let hint = "a body does by `beam = \"...\"`";
            reader.report(Diagnostic::warning("unused", beam.span, message).hint(hint));
        } else if material.density.is_none() && !material.faulty {
            let message = format!(
                "`density` is missing in material `{}`, which beam `{}` has its mass from",
                material.name, beam.name
            );
            let report = Diagnostic::error("missing-key", material.span, message);
            reader.report(report.hint("as `density = \"7850 kg/m^3\"`"));
        }
    }
}

/// `None` where the beam itself names none, which has been told.
fn ends(machine: &Machine, body: usize, rod: &Rod) -> Result<Option<[usize; 2]>, Vec<Diagnostic>> {
    let names = &machine.point_names[body];
    let beam = &machine.beams[rod.beam];
    let mut faults = Vec::new();
    let mut found = Vec::new();
    for end in &beam.between {
        match names.get(&end.value) {
            Some(point) => found.push(point),
            None => {
                let name = &machine.bodies[body].name;
                let message = format!("body `{name}` has no point `{}` for an end of beam `{}`", end.value, beam.name);
                let report = Diagnostic::error("unknown-name", end.span, message).also(rod.span, "used here");
                faults.push(report.did_you_mean(names.nearest(&end.value)));
            }
        }
    }
    if faults.is_empty() { Ok(found.try_into().ok()) } else { Err(faults) }
}
