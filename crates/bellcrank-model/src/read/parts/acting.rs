//! Supports and loads.

use bellcrank_doc::{Diagnostic, Entry, Expression, Spanned};

use super::keys::owned;
use crate::design::{HoldForm, LoadForm, Quantity, SupportForm};
use crate::keyed::Keyed;
use crate::read::study_keys::Referred;
use crate::schema::{LOAD, SUPPORT};

/// Directions of a frame: displacements, then rotations.
const DIRECTIONS: [&str; 6] = ["x", "y", "z", "rx", "ry", "rz"];

/// Vectors of a part have three components in the plane as well.
const SPACE: usize = 3;

pub(super) fn support(entry: &Entry, of_study: &Keyed<'_>, of: Referred<'_>) -> Option<SupportForm> {
    let what = format!("support `{}` of {}", entry.key, of_study.what());
    let keyed = Keyed::new(of.part.reader.fields(&entry.value, &what)?, &SUPPORT, SPACE);
    let set = keyed.text("set").map(owned);
    let fixed = keyed.texts("fixed");
    let value = keyed.list("value").and_then(|value| three(value, of));
    let spring = keyed.list("spring").and_then(|spring| three(spring, of));
    let coupling = keyed.choice("coupling");
    let errors = of.part.reader.errors();
    let hold = hold(&keyed, fixed.as_deref(), value, spring, coupling.map(|word| word.value == "rigid"));
    let sound = of.part.reader.errors() == errors;
    keyed.finish();
    let form = SupportForm { name: entry.key.clone(), set: set?, hold: hold? };
    sound.then_some(form)
}

/// What the keys come to; keys that exclude each other and a support that holds nothing are reported.
fn hold(
    keyed: &Keyed<'_>,
    fixed: Option<&[Spanned<&str>]>,
    value: Option<[Quantity; 3]>,
    spring: Option<[Quantity; 3]>,
    coupling: Option<bool>,
) -> Option<HoldForm> {
    let others = ["fixed", "value", "coupling"].into_iter().find(|key| keyed.has(key));
    if keyed.has("spring") {
        if let Some(other) = others.and_then(|key| keyed.value(key)) {
            let message = format!("{} has a `spring`, so nothing of it is held", keyed.what());
            keyed.report(Diagnostic::error("conflicting-keys", other.span, message));
        }
        return spring.map(|spring| HoldForm::Spring(Box::new(spring)));
    }
    if others.is_none() {
        let message = format!("{} holds nothing", keyed.what());
        let hint = "give it `fixed = [\"x\", \"y\", \"z\"]`, a `value`, a `spring` or a `coupling`";
        keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
        return None;
    }
    let known = if coupling.is_some() { 6 } else { 3 };
    let held = directions(keyed, fixed, known, keyed.has("value"));
    let displacement = |k: usize| value.as_ref().and_then(|value| value.get(k).cloned());
    match coupling {
        Some(rigid) => {
            let held = std::array::from_fn(|k| held[k].then(|| displacement(k)));
            Some(HoldForm::Frame { rigid, held: Box::new(held) })
        }
        None => Some(HoldForm::Nodes(Box::new(std::array::from_fn(|k| held[k].then(|| displacement(k)))))),
    }
}

/// Which of the directions are named; all where none is.
fn directions(keyed: &Keyed<'_>, fixed: Option<&[Spanned<&str>]>, known: usize, valued: bool) -> [bool; 6] {
    let Some(fixed) = fixed else {
        // A prescribed displacement says nothing of rotations.
        let count = if valued { 3 } else { known };
        return std::array::from_fn(|k| k < count);
    };
    let mut held = [false; 6];
    for name in fixed {
        match DIRECTIONS[..known].iter().position(|direction| direction == &name.value) {
            Some(k) => held[k] = true,
            None => {
                let message = format!("`{}` is no direction that {} can hold", name.value, keyed.what());
                let report = Diagnostic::error("unknown-choice", name.span, message);
                keyed.report(report.hint(match DIRECTIONS.contains(&name.value) {
                    true => "nodes do not turn: a `coupling` holds the rotations of the set as a whole".to_owned(),
                    false => format!("one of {}", DIRECTIONS[..known].join(", ")),
                }));
            }
        }
    }
    held
}

fn three(values: Vec<Expression>, of: Referred<'_>) -> Option<[Quantity; 3]> {
    of.part.quantities(values).try_into().ok()
}

pub(super) fn load(entry: &Entry, of_study: &Keyed<'_>, of: Referred<'_>) -> Option<LoadForm> {
    let what = format!("load `{}` of {}", entry.key, of_study.what());
    let keyed = Keyed::new(of.part.reader.fields(&entry.value, &what)?, &LOAD, SPACE);
    let before = of.part.reader.errors();
    let list = |name| keyed.list(name).map_or_else(Vec::new, |values| of.part.quantities(values));
    let one = |name| keyed.quantity(name).map(|value| of.part.quantity(value));
    let form = LoadForm {
        name: entry.key.clone(),
        set: keyed.text("set").map(owned),
        force: list("force"),
        moment: list("moment"),
        rigid: keyed.choice("coupling").is_some_and(|word| word.value == "rigid"),
        bearing: keyed.boolean("bearing").is_some_and(|flag| flag.value),
        pressure: one("pressure"),
        traction: list("traction"),
        gravity: list("gravity"),
        temperature: one("temperature"),
    };
    check(&keyed, &form);
    keyed.finish();
    (of.part.reader.errors() == before).then_some(form)
}

/// Reports a load that is none, one without a place, and words that do not go together.
fn check(keyed: &Keyed<'_>, form: &LoadForm) {
    let has = |names: &[&'static str]| names.iter().copied().find(|name| keyed.has(name));
    let on_set = has(&["force", "moment", "pressure", "traction"]);
    if on_set.is_none() && has(&["gravity", "temperature"]).is_none() {
        let message = format!("{} has no load in it", keyed.what());
        let hint = "give it `force`, `moment`, `pressure`, `traction`, `gravity` or `temperature`";
        keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
    }
    match (on_set, &form.set) {
        (Some(name), None) if !keyed.has("set") => {
            let message = format!("`set` is missing in {}: where its `{name}` acts", keyed.what());
            let hint = "a bore: `set = \"bore.B\"`; the whole surface: `set = \"surface\"`";
            keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
        }
        (None, Some(set)) => {
            let message = format!("{} has a `set`, but nothing in it acts on one", keyed.what());
            keyed.report(Diagnostic::error("conflicting-keys", set.span, message));
        }
        _ => {}
    }
    if form.bearing && (keyed.has("moment") || keyed.has("coupling") || !keyed.has("force")) {
        let message = format!("{} is that of a pin in a bore: it has a `force` and nothing else", keyed.what());
        keyed.report(Diagnostic::error("conflicting-keys", keyed.span(), message));
    }
}
