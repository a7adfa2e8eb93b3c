//! `[studies]`.

use std::cell::RefCell;
use std::path::Path;
use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Entry, Fields, Override, ParameterSet, Span, Spanned};

use super::asks::{self, Asked, Asking, design_table};
use super::bodies::entries;
use super::motions::ReadMotions;
use super::study_keys::{Referred, StudyKeys, overlaid};
use super::tasks::Tasks;
use super::{Machine, PartReader, Tables};
use crate::catalogue::stock;
use crate::design::{Scope, Study, Task, Values};
use crate::keyed::Keyed;
use crate::names;
use crate::schema::{ASKING, LOADING, STUDY, WITH_ROWS};
use crate::signals::{Catalogue, Signal};

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
    tables: &Tables<'_>,
    catalogue: &Catalogue,
    scopes: &[Scope],
) -> Vec<Study> {
    let entries = entries(&part, "studies");
    let names: Vec<&str> = entries.iter().map(|entry| entry.key.as_str()).collect();
    let signals = RefCell::default();
    let designs = |path: &Path, span, parameters: &ParameterSet| {
        tables.with(path, span, |sources, id, reports| design_table(sources, id, parameters, reports))
    };
    let catalogues = |path: &Path, span| tables.with(path, span, stock);
    let (designs, catalogues) = (&designs, &catalogues);
    let of = Referred { part, machine, motions, catalogue, designs, catalogues, studies: &names, signals: &signals };
    let mut reading = Reading { of, entries: &entries, states: vec![State::Unread; entries.len()] };
    for (index, entry) in entries.iter().enumerate() {
        if let Some(fault) = names::fault(entry, "study") {
            part.reader.report(fault);
        }
        reading.study(index, 0);
    }
    let states = reading.states;
    let signals: Arc<[Signal]> = signals.take().into();
    let finishing = Finishing { of, entries: &entries, states: &states, scopes, signals };
    finishing.studies()
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
        let beneath = beneath.map(|(from, keys)| keys.for_kind(from, kind)).unwrap_or_default();
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
            reader.report(self.of.unknown_study(Spanned { value: name, span }));
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

/// From the keys of all studies to studies.
struct Finishing<'a> {
    of: Referred<'a>,
    entries: &'a [&'a Entry],
    states: &'a [State],
    scopes: &'a [Scope],
    /// Of responses in all studies.
    signals: Arc<[Signal]>,
}

impl Finishing<'_> {
    /// In the order of the file; those that ask need to know which of the others are sound.
    fn studies(&self) -> Vec<Study> {
        let mut finished: Vec<Option<Study>> = (0..self.entries.len()).map(|index| self.plain(index)).collect();
        for index in 0..self.entries.len() {
            if let Some(study) = self.asking(index, &finished).or_else(|| self.loaded(index, &finished)) {
                finished[index] = Some(study);
            }
        }
        finished.into_iter().flatten().collect()
    }

    fn read(&self, index: usize) -> Option<(&'static str, &StudyKeys)> {
        match self.states.get(index)? {
            State::Read(kind, keys) => Some((kind, keys)),
            _ => None,
        }
    }

    /// A study that asks no other one: what its own and inherited keys make.
    fn plain(&self, index: usize) -> Option<Study> {
        let (kind, keys) = self.read(index).filter(|(kind, keys)| !ASKING.contains(kind) && keys.parts.of.is_none())?;
        let entry = self.entries[index];
        let (parameters, changed) = parameters(self.of, &keys.set)?;
        let task = Tasks { entry, kind, of: self.of, signals: &self.signals }.task(keys.clone())?;
        Some(self.study(entry, kind, task, parameters, changed, keys.flexible))
    }

    /// A study that asks another one: its parameters are those of that study, and what it sets itself.
    fn asking(&self, index: usize, finished: &[Option<Study>]) -> Option<Study> {
        let (kind, keys) = self.read(index).filter(|(kind, _)| ASKING.contains(kind))?;
        let entry = self.entries[index];
        let asked_index = self.asked(entry, keys)?;
        let (asked_kind, asked_keys) = self.read(asked_index)?;
        // What is wrong with that study has been told.
        finished[asked_index].as_ref()?;
        let (parameters, changed) = parameters(self.of, &overlaid(asked_keys.set.clone(), keys.set.clone()))?;
        let name = self.entries[asked_index].key.as_str();
        let asked = Asked { name, kind: asked_kind, keys: asked_keys, of: self.of };
        let signals = &self.signals;
        let asking = Asking { entry, kind, part: self.of.part, asked: &asked, parameters: &parameters, signals };
        let ask = asks::ask(&asking, keys.ask.clone())?;
        // Of dynamics only what runs it as it is: derivatives and drawn machines are worked out position by position.
        let answered = asked_kind != "dynamics" || matches!(kind, "sizing" | "sweep");
        let task = if answered { Task::Ask(Box::new(ask)) } else { Task::Later };
        Some(self.study(entry, kind, task, parameters, changed, keys.flexible.or(asked_keys.flexible)))
    }

    /// A study of parts that another study loads: its parameters are those of that study, and what it sets itself.
    fn loaded(&self, index: usize, finished: &[Option<Study>]) -> Option<Study> {
        let (kind, keys) = self.read(index).filter(|(kind, _)| !ASKING.contains(kind))?;
        let name = keys.parts.of.as_ref()?;
        let entry = self.entries[index];
        // Its own keys are checked whatever is wrong with the other study.
        let task = Tasks { entry, kind, of: self.of, signals: &self.signals }.task(keys.clone());
        let other = self.entries.iter().position(|entry| entry.key == name.value);
        let (other_kind, beneath) = self.read(other?)?;
        if !LOADING.contains(&other_kind) {
            let message = format!("study `{}` is of kind `{other_kind}` and finds no forces", name.value);
            let report = Diagnostic::error("no-rows", name.span, message);
            let hint = format!("a study of kind {}", LOADING.join(", "));
            self.of.part.reader.report(report.also(self.entries[other?].key_span, "this study").hint(hint));
            return None;
        }
        finished[other?].as_ref()?;
        let (parameters, changed) = parameters(self.of, &overlaid(beneath.set.clone(), keys.set.clone()))?;
        Some(self.study(entry, kind, task?, parameters, changed, keys.flexible.or(beneath.flexible)))
    }

    /// The study that another one asks: one with rows.
    fn asked(&self, entry: &Entry, keys: &StudyKeys) -> Option<usize> {
        let name = keys.ask.of()?;
        let reader = self.of.part.reader;
        let Some(index) = self.entries.iter().position(|entry| entry.key == name.value) else {
            reader.report(self.of.unknown_study(name));
            return None;
        };
        let (kind, _) = self.read(index)?;
        if WITH_ROWS.contains(&kind) {
            return Some(index);
        }
        let itself = entry.key == name.value;
        let message = match itself {
            true => format!("study `{}` asks itself", name.value),
            false => format!("study `{}` is of kind `{kind}` and has no rows to ask", name.value),
        };
        let report = Diagnostic::error("no-rows", name.span, message).also(self.entries[index].key_span, "this study");
        let further = self.read(index).and_then(|(_, keys)| keys.ask.of()).filter(|_| !itself);
        reader.report(report.hint(match further {
            Some(further) => format!("ask the study that it asks: `of = \"{}\"`", further.value),
            None => format!("ask a study of kind {}", WITH_ROWS.join(", ")),
        }));
        None
    }

    fn study(
        &self,
        entry: &Entry,
        kind: &'static str,
        task: Task,
        parameters: ParameterSet,
        changed: Vec<usize>,
        flexible: Option<bool>,
    ) -> Study {
        let flexible = flexible.unwrap_or(true);
        let named = if let Task::Ask(ask) = &task { ask.parameters() } else { Vec::new() };
        let values = Values::new(self.scopes, &parameters);
        let (name, span) = (entry.key.clone(), entry.key_span);
        Study { name, span, kind, task, flexible, parameters, changed, named, values }
    }
}

/// The main file's parameters with what a study sets, and which ones it sets.
fn parameters(of: Referred<'_>, set: &[Override]) -> Option<(ParameterSet, Vec<usize>)> {
    let base = of.part.reader.parameters();
    let changed = set.iter().filter_map(|one| base.index(&one.name)).collect();
    match base.with_overrides(set) {
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
