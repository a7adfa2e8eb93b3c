//! `[solids]`, and which body uses which.

mod files;
mod fit;
mod form;
mod link;
mod others;

pub(super) use fit::fit;

use bellcrank_doc::{Diagnostic, Entry};

use super::bodies::entries;
use super::{Machine, PartReader};
use crate::design::{Solid, SolidForm};
use crate::keyed::Keyed;
use crate::names;
use crate::schema::SOLID;
use form::FormReader;

/// Reads the solids of all parts. Materials are there already.
pub(super) fn read(parts: &[PartReader<'_>], machine: &mut Machine) {
    for part in parts {
        for entry in entries(part, "solids") {
            if let Some(fault) = names::fault(entry, "solid") {
                part.reader.report(fault);
            }
            let solid = one(*part, machine, entry);
            machine.solid_names.insert(&solid.name, machine.solids.len());
            machine.solids.push(solid);
        }
    }
}

fn one(part: PartReader<'_>, machine: &Machine, entry: &Entry) -> Solid {
    let mut solid = Solid {
        name: part.full(&entry.key),
        span: entry.key_span,
        material: None,
        form: SolidForm::Faulty,
        points: Vec::new(),
    };
    let what = format!("solid `{}`", entry.key);
    let Some(fields) = part.reader.fields(&entry.value, &what) else { return solid };
    let keyed = Keyed::new(fields, &SOLID, part.space());
    solid.material = material(part, machine, &keyed);
    let thickness = keyed.quantity("thickness").map(|one| part.quantity(one));
    let mut reader = FormReader { part, solid: what, thickness, points: Vec::new() };
    solid.form = form(&mut reader, &keyed).unwrap_or(SolidForm::Faulty);
    solid.points = reader.points;
    keyed.finish();
    solid
}

fn material(part: PartReader<'_>, machine: &Machine, keyed: &Keyed<'_>) -> Option<usize> {
    let name = keyed.text("material")?;
    match machine.material_names.find(name.value, part.prefix(), "material", name.span) {
        Ok(material) => Some(material),
        Err(report) => {
            part.reader.report(*report);
            None
        }
    }
}

/// What a link is made of.
const OF_LINK: [&str; 4] = ["eyes", "webs", "plates", "cuts"];

fn form(reader: &mut FormReader<'_>, keyed: &Keyed<'_>) -> Option<SolidForm> {
    let link: Vec<&str> = OF_LINK.into_iter().filter(|name| keyed.has(name)).collect();
    let others: Vec<&str> = ["revolved", "file"].into_iter().filter(|name| keyed.has(name)).collect();
    let given: Vec<&str> = link.first().into_iter().chain(&others).copied().collect();
    match given.as_slice() {
        [] => {
            let message = format!("{} has no form", keyed.what());
            let hint = "a link has `eyes` and `webs` or `plates`; a pin is `revolved`; others come from a `file`";
            keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
            None
        }
        ["revolved"] => others::revolved(reader, keyed),
        ["file"] => others::file(reader, keyed),
        [_] => link::read(reader, keyed),
        several => {
            let names: Vec<String> = several.iter().map(|name| format!("`{name}`")).collect();
            let message = format!("{} is made in more than one way: {}", keyed.what(), names.join(", "));
            let hint = "make a solid of each; a body has one, bodies that a `weld` joins have several";
            keyed.report(Diagnostic::error("conflicting-keys", keyed.span(), message).hint(hint));
            None
        }
    }
}
