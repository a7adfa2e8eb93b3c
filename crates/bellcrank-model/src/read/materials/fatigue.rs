//! What a material stands when loaded again and again.

use bellcrank_doc::{Diagnostic, Span};
use bellcrank_fem::fatigue::{Beyond, MetalGroup};

use super::PartReader;
use crate::design::{FatigueForm, MeanForm};
use crate::keyed::Keyed;

/// Reads the key `fatigue` of a material; `None` without it, or where it is wrong, which is reported.
pub(super) fn read(part: PartReader<'_>, material: &Keyed<'_>) -> Option<FatigueForm> {
    let keyed = material.table("fatigue")?;
    let [amplitude, cycles, slope] =
        ["amplitude", "cycles", "slope"].map(|name| keyed.quantity(name).map(|value| part.quantity(value)));
    let beyond = match keyed.choice("beyond").map(|word| word.value) {
        Some("none") => Beyond::Infinite,
        Some("haibach") => Beyond::Haibach,
        _ => Beyond::Elementary,
    };
    let mean = mean(part, material, &keyed);
    keyed.finish();
    Some(FatigueForm { amplitude: amplitude?, cycles: cycles?, slope: slope?, beyond, mean: mean? })
}

fn mean(part: PartReader<'_>, material: &Keyed<'_>, keyed: &Keyed<'_>) -> Option<MeanForm> {
    let sensitivity = keyed.quantity("sensitivity").map(|value| part.quantity(value));
    let group = keyed.choice("group");
    let word = keyed.choice("mean")?;
    if word.value != "fkm" {
        strangers(keyed, word.value);
    }
    match word.value {
        "goodman" => tensile(material, "`mean = \"goodman\"`", word.span).map(|()| MeanForm::Goodman),
        "fkm" if keyed.has("sensitivity") && keyed.has("group") => {
            let span = keyed.value("group").map_or(word.span, |value| value.span);
            let message = format!("{} has both `sensitivity` and `group`", keyed.what());
            let hint = "the group gives a sensitivity: leave one of them out";
            keyed.report(Diagnostic::error("conflicting-keys", span, message).hint(hint));
            None
        }
        "fkm" if keyed.has("sensitivity") => sensitivity.map(MeanForm::Sensitivity),
        "fkm" if keyed.has("group") => {
            let group = group?;
            tensile(material, "`group`", group.span).map(|()| MeanForm::Group(metal(group.value)))
        }
        "fkm" => {
            let message = format!("`mean = \"fkm\"` of {} needs `sensitivity` or `group`", keyed.what());
            let hint = "`group = \"steel\"` with `tensile` of the material, or a number as `sensitivity = 0.1`";
            keyed.report(Diagnostic::error("missing-key", word.span, message).hint(hint));
            None
        }
        _ => Some(MeanForm::None),
    }
}

/// Keys that are for `fkm` alone.
fn strangers(keyed: &Keyed<'_>, word: &str) {
    for (key, value) in ["sensitivity", "group"].into_iter().filter_map(|key| Some((key, keyed.value(key)?))) {
        let message = format!("`{key}` of {} is for `mean = \"fkm\"`, found `mean = \"{word}\"`", keyed.what());
        keyed.report(Diagnostic::error("conflicting-keys", value.span, message).hint("leave it out, or choose `fkm`"));
    }
}

/// The tensile strength has to be there; a wrong one has been told.
fn tensile(material: &Keyed<'_>, what: &str, span: Span) -> Option<()> {
    if material.has("tensile") {
        return Some(());
    }
    let message = format!("{what} needs `tensile` of {}", material.what());
    let hint = "its tensile strength, as `tensile = \"490 MPa\"`; for structural steel S355 470 to 630 MPa";
    material.report(Diagnostic::error("missing-key", span, message).hint(hint));
    None
}

fn metal(group: &str) -> MetalGroup {
    match group {
        "cast-steel" => MetalGroup::CastSteel,
        "nodular-iron" => MetalGroup::NodularIron,
        "malleable-iron" => MetalGroup::MalleableIron,
        "grey-iron" => MetalGroup::GreyIron,
        "wrought-aluminium" => MetalGroup::WroughtAluminium,
        "cast-aluminium" => MetalGroup::CastAluminium,
        _ => MetalGroup::Steel,
    }
}
