//! `[studies]`.

use bellcrank_doc::{Diagnostic, Entry, Fields, ParameterSet, Span, nearest};
use bellcrank_multibody::Coordinate;

use super::bodies::entries;
use super::motions::ReadMotions;
use super::study_keys::{Referred, StudyKeys};
use super::{Machine, PartReader};
use crate::design::{Over, Scope, Study, Task, Values};
use crate::keyed::Keyed;
use crate::names;
use crate::schema::{AVAILABLE, STUDY};
use crate::signals::Catalogue;

/// Studies that lie on each other by `like`; more is a slip.
const DEEPEST: usize = 100;

/// A study as far as it has been read.
#[derive(Clone)]
enum State {
    Unread,
    Open,
    Faulty,
    Read(&'static str, Box<StudyKeys>),
}

struct Reading<'a> {
    of: Referred<'a>,
    entries: &'a [&'a Entry],
    states: Vec<State>,
}

/// Reads the studies of the main file; those of subsystems are run there.
pub(crate) fn read(
    part: PartReader<'_>,
    machine: &Machine,
    motions: &ReadMotions,
    catalogue: &Catalogue,
    scopes: &[Scope],
) -> Vec<Study> {
    let entries = entries(&part, "studies");
    let names: Vec<&str> = entries.iter().map(|entry| entry.key.as_str()).collect();
    let of = Referred { part, machine, motions, catalogue, studies: &names };
    let mut reading = Reading { of, entries: &entries, states: vec![State::Unread; entries.len()] };
    for (index, entry) in entries.iter().enumerate() {
        if let Some(fault) = names::fault(entry, "study") {
            part.reader.report(fault);
        }
        reading.study(index, 0);
    }
    let finished = |(entry, state): (&&Entry, State)| match state {
        State::Read(kind, keys) => finish(entry, kind, *keys, of, scopes),
        _ => None,
    };
    entries.iter().zip(reading.states).filter_map(finished).collect()
}

impl<'a> Reading<'a> {
    fn study(&mut self, index: usize, depth: usize) {
        if matches!(self.states[index], State::Unread) {
            self.states[index] = State::Open;
            self.states[index] = self.read(index, depth).unwrap_or(State::Faulty);
        }
    }

    fn read(&mut self, index: usize, depth: usize) -> Option<State> {
        let entry = self.entries[index];
        let reader = self.of.part.reader;
        let what = format!("study `{}`", entry.key);
        let fields = reader.fields(&entry.value, &what)?;
        let beneath = match fields.optional_string("like") {
            Some(like) => Some(self.beneath(like.value, like.span, depth)?),
            None => None,
        };
        let keyed = self.open(fields, beneath.as_ref().map(|(kind, _)| *kind))?;
        let kind = keyed.kind()?;
        let beneath = beneath.map(|(_, keys)| keys).unwrap_or_default();
        let keys = StudyKeys::read(&keyed, self.of, &beneath);
        keyed.finish();
        Some(State::Read(kind, Box::new(keys.over(beneath))))
    }

    /// A study without a kind has that of the study it is like.
    fn open(&self, fields: Fields<'a>, inherited: Option<&'static str>) -> Option<Keyed<'a>> {
        let space = self.of.part.space();
        if let (Some(kind), false) = (inherited, fields.has("kind")) {
            return Some(Keyed::of_kind(fields, &STUDY, kind, space));
        }
        let keyed = Keyed::new(fields, &STUDY, space);
        if keyed.kind().is_none() {
            keyed.finish();
            return None;
        }
        Some(keyed)
    }

    /// The kind and keys of the study that another one is like.
    fn beneath(&mut self, name: &str, span: Span, depth: usize) -> Option<(&'static str, StudyKeys)> {
        let reader = self.of.part.reader;
        let Some(index) = self.entries.iter().position(|entry| entry.key == name) else {
            let report = Diagnostic::error("unknown-name", span, format!("there is no study `{name}`"));
            reader.report(report.did_you_mean(nearest(name, self.of.studies.iter().copied())));
            return None;
        };
        if depth >= DEEPEST {
            let message = format!("more than {DEEPEST} studies are like each other in a row");
            reader.report(Diagnostic::error("too-deep", span, message));
            return None;
        }
        if matches!(self.states[index], State::Open) {
            let message = format!("study `{name}` is like itself");
            let report = Diagnostic::error("study-cycle", span, message);
            reader.report(report.also(self.entries[index].key_span, "back to here"));
            return None;
        }
        self.study(index, depth + 1);
        match &self.states[index] {
            State::Read(kind, keys) => Some((kind, StudyKeys::clone(keys))),
            _ => None,
        }
    }
}

/// The study that its own and inherited keys make.
fn finish(entry: &Entry, kind: &'static str, keys: StudyKeys, of: Referred<'_>, scopes: &[Scope]) -> Option<Study> {
    let base = of.part.reader.parameters();
    let (parameters, changed) = parameters(base, &keys, of)?;
    let values = Values::new(scopes, &parameters);
    let named = keys.named.clone();
    let task = task(entry, kind, keys, of)?;
    Some(Study { name: entry.key.clone(), span: entry.key_span, kind, task, parameters, changed, named, values })
}

/// The main file's parameters with what the study sets, and which ones it sets.
fn parameters(base: &ParameterSet, keys: &StudyKeys, of: Referred<'_>) -> Option<(ParameterSet, Vec<usize>)> {
    let changed = keys.set.iter().filter_map(|one| base.index(&one.name)).collect();
    match base.with_overrides(&keys.set) {
        Ok((parameters, warnings)) => {
            warnings.into_iter().for_each(|warning| of.part.reader.report(warning));
            Some((parameters, changed))
        }
        Err(faults) => {
            faults.into_iter().for_each(|fault| of.part.reader.report(fault));
            None
        }
    }
}

fn task(entry: &Entry, kind: &'static str, keys: StudyKeys, of: Referred<'_>) -> Option<Task> {
    if !AVAILABLE.contains(&kind) {
        return Some(Task::Later);
    }
    let holds = keys.holds.clone().unwrap_or_default();
    if kind == "statics" {
        let sweep = keys.sweep.map(|(sweep, _)| sweep);
        return Some(Task::Statics { sweep, holds, motions: keys.motions.unwrap_or_default() });
    }
    let forces = kind == "inverse-dynamics";
    Some(Task::Motion { forces, over: over(entry, keys, of)?, holds })
}

/// Positions or time; what is missing or too much is reported.
fn over(entry: &Entry, keys: StudyKeys, of: Referred<'_>) -> Option<Over> {
    let table = entry.value.as_table()?;
    let own = |key: &str| table.get(key).is_some();
    let report = |code, message: String| of.part.reader.report(Diagnostic::error(code, entry.key_span, message));
    let name = &entry.key;
    match (keys.sweep, keys.duration, keys.step) {
        (Some(_), Some(_), _) | (Some(_), _, Some(_)) => {
            report("conflicting-keys", format!("study `{name}` goes over positions (`sweep`) and over time; give one"));
            None
        }
        (Some((sweep, _)), None, None) => {
            let swept = sweep.coordinate;
            let drive = keys.drive;
            let coordinate: Coordinate = drive.as_ref().and_then(|drive| drive.coordinate).unwrap_or(swept);
            let (velocity, acceleration) = drive.map_or((None, None), |drive| (drive.velocity, drive.acceleration));
            Some(Over::Positions { sweep, drive: coordinate, velocity, acceleration })
        }
        (None, Some(duration), Some(step)) => {
            let motions = keys.motions.unwrap_or_else(|| (0..of.motions.list.len()).collect());
            Some(Over::Time { duration, step, motions, drives: keys.drives })
        }
        (None, duration, step) => {
            let wrong = own("sweep") || duration.is_none() && own("duration") || step.is_none() && own("step");
            match (duration, step) {
                // The key is there, and what is wrong with it has been told.
                _ if wrong => {}
                (Some(_), _) => report("missing-key", format!("`step` is missing in study `{name}`")),
                (_, Some(_)) => report("missing-key", format!("`duration` is missing in study `{name}`")),
                _ => report(
                    "missing-key",
                    format!("study `{name}` needs `sweep` (over positions), or `duration` and `step` (over time)"),
                ),
            }
            None
        }
    }
}
