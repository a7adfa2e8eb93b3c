//! The keys of one study, before those of the study it is like are put beneath them.

use std::cell::RefCell;
use std::path::Path;

use bellcrank_doc::{
    Condition, Constraint, Diagnostic, Dimension, Override, ParameterSet, Response, Span, Spanned, Value, nearest,
};
use bellcrank_multibody::Coordinate;

use super::asks::{AskKeys, CatalogueFiles, DesignTable};
use super::forward_keys::ForwardKeys;
use super::motions::ReadMotions;
use super::parts::PartKeys;
use super::{Machine, PartReader};
use crate::design::{Hold, Quantity, Sweep};
use crate::keyed::Keyed;
use crate::measure::Motion;
use crate::schema::{ASKING, Along};
use crate::signals::{AllSignals, Catalogue, Signal};

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
    /// `false` for a machine whose bodies are rigid.
    pub(crate) flexible: Option<bool>,
    /// Of studies of dynamics and modes alone.
    pub(crate) forward: ForwardKeys,
    /// Of studies of parts alone.
    pub(crate) parts: PartKeys,
    /// What it asks of another study.
    pub(crate) ask: AskKeys,
}

/// The key `drive`.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    pub(crate) coordinate: Option<Coordinate>,
    pub(crate) velocity: Option<Quantity>,
    pub(crate) acceleration: Option<Quantity>,
}

/// Reads the table of designs of a file that a place names, over some parameters.
pub(crate) type DesignFiles<'a> = dyn Fn(&Path, Span, &ParameterSet) -> Result<DesignTable, Vec<Diagnostic>> + 'a;

/// What studies refer to.
#[derive(Clone, Copy)]
pub(crate) struct Referred<'a> {
    pub(crate) part: PartReader<'a>,
    pub(crate) machine: &'a Machine,
    pub(crate) motions: &'a ReadMotions,
    pub(crate) catalogue: &'a Catalogue,
    /// Reads tables of designs.
    pub(crate) designs: &'a DesignFiles<'a>,
    /// Reads catalogues of drives.
    pub(crate) catalogues: &'a CatalogueFiles<'a>,
    /// Names of all studies.
    pub(crate) studies: &'a [&'a str],
    /// Signals in responses of all studies: one list, for a study inherits keys of others.
    pub(crate) signals: &'a RefCell<Vec<Signal>>,
}

impl Referred<'_> {
    pub(crate) fn unknown_study(&self, name: Spanned<&str>) -> Diagnostic {
        let report = Diagnostic::error("unknown-name", name.span, format!("there is no study `{}`", name.value));
        report.did_you_mean(nearest(name.value, self.studies.iter().copied()))
    }

    /// One number of a study.
    pub(crate) fn response(&self, value: &Value, what: &str) -> Option<Response> {
        self.with_signals(|signals| self.part.reader.response(value, what, signals))
    }

    /// A comparison of two numbers of a study.
    pub(crate) fn constraint(&self, value: &Value, what: &str) -> Option<Constraint> {
        self.with_signals(|signals| self.part.reader.constraint(value, what, signals))
    }

    /// A comparison at one instant.
    pub(crate) fn condition(&self, value: &Value, what: &str) -> Option<Condition> {
        self.with_signals(|signals| self.part.reader.condition(value, what, signals))
    }

    fn with_signals<T>(&self, read: impl FnOnce(&mut AllSignals<'_>) -> T) -> T {
        let mut signals = AllSignals { catalogue: self.catalogue, used: self.signals.take() };
        let read = read(&mut signals);
        self.signals.replace(signals.used);
        read
    }
}

impl StudyKeys {
    /// Reads the keys of a study of known kind; `beneath` are those of the study it is like.
    pub(crate) fn read(keyed: &Keyed<'_>, of: Referred<'_>, beneath: &StudyKeys) -> StudyKeys {
        check_later(keyed, of);
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
            flexible: keyed.boolean("flexible").map(|flag| flag.value),
            forward: ForwardKeys::read(keyed, of, &beneath.forward),
            parts: PartKeys::read(keyed, of),
            ask: AskKeys::read(keyed, of, &beneath.ask),
        }
    }

    /// These keys, and those of `beneath` where there are none. Positions and time exclude each other, so one of
    /// them given here hides what lies beneath of the other.
    pub(crate) fn over(self, beneath: StudyKeys) -> StudyKeys {
        let hide_positions = self.duration.is_some() || self.step.is_some();
        let hide_time = self.sweep.is_some();
        let fixed_step = self.step.is_some();
        // A largest step given here says that the step is not fixed.
        let own_largest = self.forward.largest_step.is_some();
        StudyKeys {
            sweep: self.sweep.or(beneath.sweep.filter(|_| !hide_positions)),
            drive: self.drive.or(beneath.drive.filter(|_| !hide_positions)),
            holds: self.holds.or(beneath.holds),
            duration: self.duration.or(beneath.duration.filter(|_| !hide_time)),
            step: self.step.or(beneath.step.filter(|_| !hide_time && !own_largest)),
            motions: self.motions.or(beneath.motions.filter(|_| !hide_time)),
            drives: self.drives.or(beneath.drives.filter(|_| !hide_time)),
            set: overlaid(beneath.set, self.set),
            flexible: self.flexible.or(beneath.flexible),
            forward: self.forward.over(beneath.forward, fixed_step),
            parts: self.parts.over(beneath.parts),
            ask: self.ask.over(beneath.ask),
        }
    }

    /// The keys of a study of kind `from` for one of kind `to` that is like it: from row to row is `step` over time
    /// and `output_step` in dynamics, where a `step` is one of the integration.
    pub(crate) fn for_kind(mut self, from: &str, to: &str) -> StudyKeys {
        match (from == "dynamics", to == "dynamics") {
            (false, true) => self.forward.output_step = self.step.take(),
            (true, false) => self.step = self.forward.output_step.take(),
            _ => {}
        }
        self
    }
}

/// Overrides of one study, and those beneath that it does not replace.
pub(crate) fn overlaid(beneath: Vec<Override>, own: Vec<Override>) -> Vec<Override> {
    let mut set: Vec<Override> = beneath.into_iter().filter(|old| own.iter().all(|new| new.name != old.name)).collect();
    set.extend(own);
    set
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
        let held = |name: Spanned<&str>| {
            let coordinates = of.part.coordinates(of.machine, name).into_iter().flatten();
            coordinates.map(move |(coordinate, _)| Hold { coordinate, at: None, span: name.span })
        };
        return Some(names.into_iter().flat_map(held).collect());
    };
    let mut holds = Vec::new();
    for entry in table.iter() {
        let name = Spanned { value: entry.key.as_str(), span: entry.key_span };
        let Some(coordinates) = of.part.coordinates(of.machine, name) else { continue };
        let what = format!("`{}` in {what}", entry.key);
        holds.extend(held_at(&entry.value, &what, &coordinates, entry.key_span, of));
    }
    Some(holds)
}

fn held_at(value: &Value, what: &str, coordinates: &[(Coordinate, Motion)], span: Span, of: Referred<'_>) -> Vec<Hold> {
    let dimensions: Vec<Dimension> = coordinates.iter().map(|(_, motion)| Along::Position.dimension(*motion)).collect();
    let reader = of.part.reader;
    let places = match dimensions.as_slice() {
        [one] if value.as_list().is_none() => reader.quantity(value, what, *one).map(|place| vec![place]),
        all => reader.vector(value, what, all),
    };
    let held = |(place, (coordinate, _)): (_, &(Coordinate, Motion))| Hold {
        coordinate: *coordinate,
        at: Some(of.part.quantity(place)),
        span,
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

/// Keys of kinds that are run in another version: their names and expressions are checked now.
fn check_later(keyed: &Keyed<'_>, of: Referred<'_>) {
    if keyed.kind().is_some_and(|kind| ASKING.contains(&kind)) {
        return;
    }
    if let Some(name) = keyed.text("of")
        && !of.studies.contains(&name.value)
    {
        keyed.report(of.unknown_study(name));
    }
}
