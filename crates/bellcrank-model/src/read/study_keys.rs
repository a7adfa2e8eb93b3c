//! The keys of one study, before those of the study it is like are put beneath them.

use bellcrank_doc::{Diagnostic, Dimension, Override, Span, Spanned, Value, nearest};
use bellcrank_multibody::Coordinate;

use super::motions::ReadMotions;
use super::{Machine, PartReader};
use crate::design::{Hold, Quantity, Sweep};
use crate::keyed::Keyed;
use crate::measure::Motion;
use crate::schema::Along;
use crate::signals::{AllSignals, Catalogue};

/// What the keys of a study say; `None` where a key is absent (or wrong, and reported).
#[derive(Clone, Debug, Default)]
pub(crate) struct StudyKeys {
    pub(crate) sweep: Option<(Sweep, Motion)>,
    pub(crate) drive: Option<Drive>,
    pub(crate) holds: Option<Vec<Hold>>,
    pub(crate) duration: Option<Quantity>,
    pub(crate) step: Option<Quantity>,
    pub(crate) motions: Option<Vec<usize>>,
    pub(crate) drives: Option<Vec<Coordinate>>,
    pub(crate) set: Vec<Override>,
    /// Parameters that the study varies.
    pub(crate) named: Vec<usize>,
}

/// The key `drive`.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    pub(crate) coordinate: Option<Coordinate>,
    pub(crate) velocity: Option<Quantity>,
    pub(crate) acceleration: Option<Quantity>,
}

/// What studies refer to.
#[derive(Clone, Copy)]
pub(crate) struct Referred<'a> {
    pub(crate) part: PartReader<'a>,
    pub(crate) machine: &'a Machine,
    pub(crate) motions: &'a ReadMotions,
    pub(crate) catalogue: &'a Catalogue,
    /// Names of all studies.
    pub(crate) studies: &'a [&'a str],
}

impl StudyKeys {
    /// Reads the keys of a study of known kind; `beneath` are those of the study it is like.
    pub(crate) fn read(keyed: &Keyed<'_>, of: Referred<'_>, beneath: &StudyKeys) -> StudyKeys {
        let sweep = keyed.table("sweep").and_then(|sweep| read_sweep(sweep, of));
        let swept = sweep.as_ref().or(beneath.sweep.as_ref()).map(|(_, motion)| *motion);
        StudyKeys {
            drive: keyed.table("drive").and_then(|drive| read_drive(drive, of, swept)),
            sweep,
            holds: keyed.value("hold").and_then(|value| read_holds(value, keyed, of)),
            duration: keyed.quantity("duration").map(|duration| of.part.quantity(duration)),
            step: keyed.quantity("step").map(|step| of.part.quantity(step)),
            motions: read_motions(keyed, of),
            drives: read_drives(keyed, of),
            set: read_set(keyed),
            named: check_later(keyed, of),
        }
    }

    /// These keys, and those of `beneath` where there are none. Positions and time exclude each other, so one of
    /// them given here hides what lies beneath of the other.
    pub(crate) fn over(self, beneath: StudyKeys) -> StudyKeys {
        let hide_positions = self.duration.is_some() || self.step.is_some();
        let hide_time = self.sweep.is_some();
        let mut set: Vec<Override> =
            beneath.set.into_iter().filter(|old| self.set.iter().all(|new| new.name != old.name)).collect();
        set.extend(self.set);
        StudyKeys {
            sweep: self.sweep.or(beneath.sweep.filter(|_| !hide_positions)),
            drive: self.drive.or(beneath.drive.filter(|_| !hide_positions)),
            holds: self.holds.or(beneath.holds),
            duration: self.duration.or(beneath.duration.filter(|_| !hide_time)),
            step: self.step.or(beneath.step.filter(|_| !hide_time)),
            motions: self.motions.or(beneath.motions.filter(|_| !hide_time)),
            drives: self.drives.or(beneath.drives.filter(|_| !hide_time)),
            set,
            named: if self.named.is_empty() { beneath.named } else { self.named },
        }
    }
}

fn read_sweep(keyed: Keyed<'_>, of: Referred<'_>) -> Option<(Sweep, Motion)> {
    let target = keyed.text("joint").and_then(|name| of.part.coordinate(of.machine, name));
    let ends = target.map(|(_, motion)| (keyed.along("from", motion), keyed.along("to", motion)));
    let points = keyed.whole("points");
    keyed.finish();
    let ((coordinate, motion), (from, to)) = (target?, ends?);
    let points = usize::try_from(points?.value).ok()?;
    let sweep = Sweep { coordinate, from: of.part.quantity(from?), to: of.part.quantity(to?), points };
    Some((sweep, motion))
}

fn read_drive(keyed: Keyed<'_>, of: Referred<'_>, swept: Option<Motion>) -> Option<Drive> {
    let own = keyed.text("joint").map(|name| of.part.coordinate(of.machine, name));
    let motion = match &own {
        Some(found) => found.map(|(_, motion)| motion),
        None => swept,
    };
    let read = |name| motion.and_then(|motion| keyed.along(name, motion)).map(|value| of.part.quantity(value));
    let (velocity, acceleration) = (read("velocity"), read("acceleration"));
    keyed.finish();
    motion?;
    Some(Drive { coordinate: own.flatten().map(|(coordinate, _)| coordinate), velocity, acceleration })
}

/// `["a", "b.1"]`, or `{ a = "30 deg" }`; a joint with several coordinates rests in all of them.
fn read_holds(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<Hold>> {
    let what = keyed.named("hold");
    let Some(table) = value.as_table() else {
        let names = of.part.reader.strings(value, &what)?;
        let coordinates = names.into_iter().filter_map(|name| of.part.coordinates(of.machine, name)).flatten();
        return Some(coordinates.map(|(coordinate, _)| Hold { coordinate, at: None }).collect());
    };
    let mut holds = Vec::new();
    for entry in table.iter() {
        let name = Spanned { value: entry.key.as_str(), span: entry.key_span };
        let Some(coordinates) = of.part.coordinates(of.machine, name) else { continue };
        let what = format!("`{}` in {what}", entry.key);
        holds.extend(held_at(&entry.value, &what, &coordinates, of));
    }
    Some(holds)
}

fn held_at(value: &Value, what: &str, coordinates: &[(Coordinate, Motion)], of: Referred<'_>) -> Vec<Hold> {
    let dimensions: Vec<Dimension> = coordinates.iter().map(|(_, motion)| Along::Position.dimension(*motion)).collect();
    let reader = of.part.reader;
    let places = match dimensions.as_slice() {
        [one] if value.as_list().is_none() => reader.quantity(value, what, *one).map(|place| vec![place]),
        all => reader.vector(value, what, all),
    };
    let held = |(place, (coordinate, _)): (_, &(Coordinate, Motion))| Hold {
        coordinate: *coordinate,
        at: Some(of.part.quantity(place)),
    };
    places.into_iter().flatten().zip(coordinates).map(held).collect()
}

fn read_motions(keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<usize>> {
    let names = keyed.texts("motions")?;
    let find = |name: Spanned<&str>| {
        let found = of.motions.names.find(name.value, "", "motion", name.span);
        if found.is_err() && of.motions.faulty.get(name.value).is_some() {
            return None;
        }
        found.map_err(|report| keyed.report(*report)).ok()
    };
    Some(names.into_iter().filter_map(find).collect())
}

fn read_drives(keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<Coordinate>> {
    let names = keyed.texts("drives")?;
    let coordinates = names.into_iter().filter_map(|name| of.part.coordinates(of.machine, name));
    Some(coordinates.flatten().map(|(coordinate, _)| coordinate).collect())
}

fn read_set(keyed: &Keyed<'_>) -> Vec<Override> {
    let Some(value) = keyed.value("set") else { return Vec::new() };
    let Some(fields) = keyed.reader().fields(value, &keyed.named("set")) else { return Vec::new() };
    let mut faults = bellcrank_doc::Diagnostics::new();
    let set = Override::from_table(fields.table(), &mut faults);
    faults.into_iter().for_each(|fault| keyed.report(fault));
    set
}

/// Keys of kinds that are run in another version: their names and expressions are checked now. Answers the
/// parameters they name.
fn check_later(keyed: &Keyed<'_>, of: Referred<'_>) -> Vec<usize> {
    if let Some(name) = keyed.text("of")
        && !of.studies.contains(&name.value)
    {
        let report = Diagnostic::error("unknown-name", name.span, format!("there is no study `{}`", name.value));
        keyed.report(report.did_you_mean(nearest(name.value, of.studies.iter().copied())));
    }
    let mut signals = AllSignals { catalogue: of.catalogue, used: Vec::new() };
    for key in ["response", "minimize", "maximize"] {
        if let Some(value) = keyed.value(key) {
            of.part.reader.response(value, &keyed.named(key), &mut signals);
        }
    }
    if let Some(value) = keyed.value("stop_when") {
        of.part.reader.condition(value, &keyed.named("stop_when"), &mut signals);
    }
    each(keyed, "responses", |value, what| {
        of.part.reader.response(value, what, &mut signals);
    });
    each(keyed, "subject_to", |value, what| {
        of.part.reader.constraint(value, what, &mut signals);
    });
    let named =
        ["parameters", "variables", "tolerances"].into_iter().flat_map(|key| parameters(keyed, key, of)).collect();
    for key in ["starts", "seed", "samples"] {
        keyed.whole(key);
    }
    for key in ["output_step", "tolerance"] {
        keyed.quantity(key);
    }
    keyed.choice("method");
    if let (Some(_), Some(both)) = (keyed.value("minimize"), keyed.value("maximize")) {
        let message = format!("{} has `minimize` and `maximize`; give one", keyed.what());
        keyed.report(Diagnostic::error("conflicting-keys", both.span, message));
    }
    named
}

fn each(keyed: &Keyed<'_>, key: &'static str, mut check: impl FnMut(&Value, &str)) {
    let Some(value) = keyed.value(key) else { return };
    let what = keyed.named(key);
    for value in keyed.reader().list(value, &what).unwrap_or(&[]) {
        check(value, &what);
    }
}

/// A list of parameters, or a table by parameter.
fn parameters(keyed: &Keyed<'_>, key: &'static str, of: Referred<'_>) -> Vec<usize> {
    let Some(value) = keyed.value(key) else { return Vec::new() };
    let names: Vec<(&str, Span)> = match value.as_table() {
        Some(table) => table.iter().map(|entry| (entry.key.as_str(), entry.key_span)).collect(),
        None => {
            let names = of.part.reader.strings(value, &keyed.named(key)).unwrap_or_default();
            names.into_iter().map(|name| (name.value, name.span)).collect()
        }
    };
    let parameters = of.part.reader.parameters();
    let find = |(name, span): (&str, Span)| {
        let found = parameters.index(name);
        if found.is_none() && !parameters.is_faulty(name) {
            let near = nearest(name, parameters.all().iter().map(|p| p.name.as_str()));
            let report = Diagnostic::error("unknown-name", span, format!("there is no parameter `{name}`"));
            keyed.report(report.did_you_mean(near));
        }
        found
    };
    names.into_iter().filter_map(find).collect()
}
