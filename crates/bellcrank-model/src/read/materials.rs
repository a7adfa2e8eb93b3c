//! `[materials]`.

mod fatigue;

use bellcrank_doc::{Diagnostic, Entry, Expression};

use super::bodies::entries;
use super::{Machine, PartReader};
use crate::design::{Elastic, Material, Quantity};
use crate::keyed::Keyed;
use crate::names;
use crate::schema::MATERIAL;

/// Reads the materials of all parts.
pub(super) fn read(parts: &[PartReader<'_>], machine: &mut Machine) {
    for part in parts {
        for entry in entries(part, "materials") {
            if let Some(fault) = names::fault(entry, "material") {
                part.reader.report(fault);
            }
            let material = one(*part, entry);
            machine.material_names.insert(&material.name, machine.materials.len());
            machine.materials.push(material);
        }
    }
}

/// What cannot be read of it is left out: it has been reported.
fn one(part: PartReader<'_>, entry: &Entry) -> Material {
    let mut material = Material {
        name: part.full(&entry.key),
        span: entry.key_span,
        density: None,
        elastic: None,
        strength: None,
        tensile: None,
        expansion: Vec::new(),
        fatigue: None,
        faulty: true,
    };
    if let Some(fields) = part.reader.fields(&entry.value, &format!("material `{}`", entry.key)) {
        let keyed = Keyed::new(fields, &MATERIAL, part.space());
        let quantity = |name| keyed.quantity(name).map(|one| part.quantity(one));
        material.density = quantity("density");
        material.faulty = keyed.has("density") && material.density.is_none();
        material.elastic = elastic(part, &keyed);
        material.strength = quantity("yield");
        material.tensile = quantity("tensile");
        material.expansion = keyed.one_or_list("expansion").map(|all| part.quantities(all)).unwrap_or_default();
        material.fatigue = fatigue::read(part, &keyed);
        keyed.finish();
    }
    material
}

fn elastic(part: PartReader<'_>, keyed: &Keyed<'_>) -> Option<Elastic> {
    let given = |name| keyed.has(name);
    if !["young", "poisson", "shear"].into_iter().any(given) {
        return None;
    }
    let [young, poisson, shear] = ["young", "poisson", "shear"].map(|name| keyed.one_or_list(name));
    let orthotropic = [&young, &poisson, &shear].into_iter().flatten().any(|values| values.len() == 3);
    // Those that are absent are reported.
    ["young", "poisson"].into_iter().chain(orthotropic.then_some("shear")).for_each(|name| {
        keyed.needed(name);
    });
    if !orthotropic {
        let (young, poisson) = (single(part, young?)?, single(part, poisson?)?);
        return Some(Elastic::Isotropic { young, poisson });
    }
    let mixed: Vec<&str> = [("young", &young), ("poisson", &poisson)]
        .into_iter()
        .filter(|(_, values)| values.as_ref().is_some_and(|values| values.len() == 1))
        .map(|(name, _)| name)
        .collect();
    if let Some(name) = mixed.first() {
        report_mixed(keyed, name);
        return None;
    }
    let three = |values: Option<Vec<Expression>>| part.quantities(values?).try_into().ok();
    Some(Elastic::Orthotropic { young: three(young)?, poisson: three(poisson)?, shear: three(shear)? })
}

fn single(part: PartReader<'_>, values: Vec<Expression>) -> Option<Quantity> {
    values.into_iter().next().map(|value| part.quantity(value))
}

fn report_mixed(keyed: &Keyed<'_>, name: &'static str) {
    let message = format!("`{name}` of {} has one value, where the others are for each axis", keyed.what());
    let span = keyed.value(name).map_or(keyed.span(), |value| value.span);
    let hint =
        "isotropic: one `young` and one `poisson`; orthotropic: `young`, `poisson` and `shear` as lists of three";
    keyed.report(Diagnostic::error("wrong-length", span, message).hint(hint));
}
