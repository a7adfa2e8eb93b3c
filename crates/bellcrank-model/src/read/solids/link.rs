//! Eyes, webs, plates and cuts.

use bellcrank_doc::{Diagnostic, Entry, Spanned};

use super::form::{FormReader, named};
use crate::design::{
    BarForm, CutForm, CutKind, EyeForm, LinkForm, Plane, PlateForm, ProfileForm, Quantity, SolidForm, WebForm, WebKind,
};
use crate::keyed::Keyed;
use crate::names::{self, Index};
use crate::schema::{CUT, EYE, PLATE, WEB};

/// Reads all of it, and then gives up where something was wrong.
pub(super) fn read(reader: &mut FormReader<'_>, keyed: &Keyed<'_>) -> Option<SolidForm> {
    let plane = plane(reader, keyed);
    let given = keyed.has("fillet");
    let fillet = reader.quantity(keyed, "fillet");
    let (eyes, webs) = (named(keyed, "eyes"), named(keyed, "webs"));
    let mut eye_names = Index::default();
    eyes.iter().enumerate().for_each(|(place, entry)| eye_names.insert(&entry.key, place));
    if eyes.is_empty() && !webs.is_empty() {
        let message = format!("{} has webs, but no eyes for them to join", keyed.what());
        let hint = "`[solids.NAME.eyes.B]` with `bore` and `outer`; a bar without eyes is a plate";
        keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
    } else if keyed.has("cuts") && eyes.is_empty() && named(keyed, "plates").is_empty() {
        let message = format!("{} has cuts, but nothing to cut", keyed.what());
        keyed
            .report(Diagnostic::error("missing-key", keyed.span(), message).hint("give it `eyes`, `webs` or `plates`"));
    }
    let eyes = all(eyes, |entry| eye(reader, entry));
    let webs = all(webs, |entry| web(reader, &eye_names, entry));
    let plates = all(named(keyed, "plates"), |entry| plate(reader, entry));
    let cuts = all(named(keyed, "cuts"), |entry| cut(reader, entry));
    if given && fillet.is_none() || eye_names.listed("").is_none() && plates.as_ref().is_none_or(Vec::is_empty) {
        return None;
    }
    let (eyes, webs, plates, cuts) = (eyes?, webs?, plates?, cuts?);
    Some(SolidForm::Link(Box::new(LinkForm { plane: plane?, fillet, eyes, webs, plates, cuts })))
}

/// Every one, or nothing where one is wrong.
fn all<T>(entries: Vec<&Entry>, read: impl FnMut(&Entry) -> Option<T>) -> Option<Vec<T>> {
    // All are read before giving up, for the errors of each.
    let read: Vec<Option<T>> = entries.into_iter().map(read).collect();
    read.into_iter().collect()
}

fn plane(reader: &FormReader<'_>, keyed: &Keyed<'_>) -> Option<Plane> {
    let given = keyed.has("plane");
    let Some(name) = keyed.choice("plane") else { return (!given).then_some(Plane::Xy) };
    let plane = Plane::of(name.value);
    if reader.part.planar && plane != Plane::Xy {
        let message = format!("{} lies in the x-y plane, as everything in a planar file", keyed.what());
        keyed.report(Diagnostic::error("not-in-plane", name.span, message).hint("leave `plane` out"));
        return None;
    }
    Some(plane)
}

/// A part of the solid with a name, as "eye `B`".
fn open<'a>(
    reader: &FormReader<'a>,
    entry: &'a Entry,
    kind: &str,
    schema: &'static crate::schema::Schema,
) -> Option<Keyed<'a>> {
    if let Some(fault) = names::fault(entry, kind) {
        reader.part.reader.report(fault);
    }
    let fields = reader.part.reader.fields(&entry.value, &reader.what(kind, &entry.key))?;
    Some(Keyed::new(fields, schema, 2))
}

fn eye(reader: &mut FormReader<'_>, entry: &Entry) -> Option<EyeForm> {
    let keyed = open(reader, entry, "eye", &EYE)?;
    let what = reader.what("eye", &entry.key);
    let at = match keyed.value("at") {
        Some(value) => reader.spot(value, &keyed.named("at"), 2),
        None => Some(reader.point(&entry.key, entry.key_span, &what)),
    };
    let [bore, outer] = ["bore", "outer"].map(|name| reader.quantity(&keyed, name));
    let height = reader.height(&keyed, &["width"]);
    let with_clearance = keyed.has("clearance");
    let clearance = reader.quantity(&keyed, "clearance");
    keyed.finish();
    if with_clearance && clearance.is_none() {
        return None;
    }
    let name = entry.key.clone();
    Some(EyeForm { name, span: entry.key_span, at: at?, bore: bore?, outer: outer?, height: height?, clearance })
}

fn web(reader: &FormReader<'_>, names: &Index, entry: &Entry) -> Option<WebForm> {
    let keyed = open(reader, entry, "web", &WEB)?;
    let eyes = between(&keyed, names);
    let height = reader.height(&keyed, &["thickness", "height"]);
    let kind = keyed.kind().and_then(|kind| web_kind(reader, &keyed, kind));
    keyed.finish();
    Some(WebForm { name: entry.key.clone(), span: entry.key_span, eyes: eyes?, height: height?, kind: kind? })
}

fn web_kind(reader: &FormReader<'_>, keyed: &Keyed<'_>, kind: &str) -> Option<WebKind> {
    if kind == "hull" {
        return Some(WebKind::Hull);
    }
    let widths = widths(reader, keyed);
    let both = |a, b| Some((reader.quantity(keyed, a), reader.quantity(keyed, b)));
    let profile = match kind {
        "box" => both("wall", "skin").and_then(|(wall, skin)| Some(ProfileForm::Box { wall: wall?, skin: skin? })),
        "i" => both("flange", "web").and_then(|(flange, web)| Some(ProfileForm::I { flange: flange?, web: web? })),
        _ => Some(ProfileForm::Flat),
    };
    Some(WebKind::Bar(Box::new(BarForm { widths: widths?, profile: profile? })))
}

/// One for all of it, or one at each eye.
fn widths(reader: &FormReader<'_>, keyed: &Keyed<'_>) -> Option<[Quantity; 2]> {
    let values = reader.part.quantities(keyed.one_or_list("width")?);
    match values.as_slice() {
        [one] => Some([one.clone(), one.clone()]),
        [first, second] => Some([first.clone(), second.clone()]),
        _ => None,
    }
}

/// The eyes that a web joins.
fn between(keyed: &Keyed<'_>, names: &Index) -> Option<Vec<usize>> {
    let written = keyed.texts("between")?;
    let span = keyed.value("between").map_or(keyed.span(), |value| value.span);
    let eyes = find(keyed, &written, names)?;
    let hull = keyed.kind() == Some("hull");
    if eyes.len() < 2 || eyes.len() > 2 && !hull {
        let wanted = if hull { "two eyes or more" } else { "two eyes" };
        let report = Diagnostic::error(
            "wrong-length",
            span,
            format!("{} needs {wanted}, found {}", keyed.named("between"), eyes.len()),
        );
        keyed.report(if eyes.len() > 2 { report.hint("`kind = \"hull\"` joins any number") } else { report });
        return None;
    }
    let twice = written.iter().enumerate().find(|(place, one)| written[..*place].iter().any(|o| o.value == one.value));
    if let Some((_, name)) = twice {
        let message = format!("{} joins eye `{}` with itself", keyed.what(), name.value);
        keyed.report(Diagnostic::error("wrong-length", name.span, message));
        return None;
    }
    Some(eyes)
}

fn find(keyed: &Keyed<'_>, written: &[Spanned<&str>], names: &Index) -> Option<Vec<usize>> {
    let one = |name: &Spanned<&str>| match names.find(name.value, "", "eye", name.span) {
        Ok(eye) => Some(eye),
        // That there are none at all has been reported.
        Err(_) if names.listed("").is_none() => None,
        Err(report) => {
            keyed.report(*report);
            None
        }
    };
    let found: Vec<Option<usize>> = written.iter().map(one).collect();
    found.into_iter().collect()
}

fn plate(reader: &mut FormReader<'_>, entry: &Entry) -> Option<PlateForm> {
    let keyed = open(reader, entry, "plate", &PLATE)?;
    let outline = reader.outline(&keyed);
    let height = reader.height(&keyed, &["thickness"]);
    keyed.finish();
    Some(PlateForm { name: entry.key.clone(), span: entry.key_span, outline: outline?, height: height? })
}

fn cut(reader: &mut FormReader<'_>, entry: &Entry) -> Option<CutForm> {
    let keyed = open(reader, entry, "cut", &CUT)?;
    let height = reader.own_height(&keyed, &["thickness"]);
    if matches!(height, Some(None)) && keyed.has("offset") {
        let message = format!("{} has an `offset`, but goes through everything", keyed.what());
        let hint = "give its `thickness`, or leave `offset` out";
        keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
    }
    let kind = match keyed.kind() {
        Some("hole") => {
            let (at, diameter) = (reader.spot_of(&keyed, "at", 2), reader.quantity(&keyed, "diameter"));
            at.zip(diameter).map(|(at, diameter)| CutKind::Hole { at, diameter })
        }
        Some("slot") => slot(reader, &keyed),
        Some("outline") => reader.outline(&keyed).map(CutKind::Outline),
        _ => None,
    };
    keyed.finish();
    Some(CutForm { name: entry.key.clone(), span: entry.key_span, kind: kind?, height: height? })
}

fn slot(reader: &mut FormReader<'_>, keyed: &Keyed<'_>) -> Option<CutKind> {
    let (from, to) = (reader.spot_of(keyed, "from", 2), reader.spot_of(keyed, "to", 2));
    let width = reader.quantity(keyed, "width");
    Some(CutKind::Slot { from: from?, to: to?, width: width? })
}
