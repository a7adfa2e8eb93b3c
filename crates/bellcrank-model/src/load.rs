//! From a path to a checked model, with everything that is wrong in one go.

use std::path::Path;

use bellcrank_doc::{Diagnostic, Diagnostics, Override, SourceId, Sources};

use crate::Model;
use crate::build::{self, check_connected};
use crate::design::{Design, Study, Task, Values};
use crate::disk::read_source;
use crate::model::{Main, Parts};
use crate::mounts;
use crate::provenance;
use crate::read::{Files, ReadModel, Tables, read_files, read_model};

/// What reading a file gave.
#[derive(Debug)]
pub struct Loaded {
    /// All texts that were read: what diagnostics point into.
    pub sources: Sources,
    /// Everything found, in the order of places.
    pub diagnostics: Diagnostics,
    /// The model, when there is no error.
    pub model: Option<Model>,
}

/// Reads a model file with other values for some of its parameters (name and value as written on
/// the command line), and checks all of it.
#[must_use]
pub fn load(path: &Path, overrides: &[(String, String)]) -> Loaded {
    loaded(path, overrides, |sources, diagnostics| read_source(sources, path, diagnostics))
}

/// The same of a text as if it stood in the file `path`: what it names is looked for beside that.
pub(crate) fn load_text(path: &Path, text: &str, overrides: &[(String, String)]) -> Loaded {
    let name = path.display().to_string();
    loaded(path, overrides, |sources, diagnostics| bellcrank_doc::load(sources, &name, text.as_bytes(), diagnostics))
}

fn loaded(
    path: &Path,
    overrides: &[(String, String)],
    main: impl FnOnce(&mut Sources, &mut Diagnostics) -> Option<SourceId>,
) -> Loaded {
    let mut sources = Sources::new();
    let mut diagnostics = Diagnostics::new();
    let arguments = arguments(overrides, &mut sources, &mut diagnostics);
    let model = main(&mut sources, &mut diagnostics)
        .and_then(|main| read(main, path, arguments, &mut sources, &mut diagnostics));
    diagnostics.sort();
    let model = model.filter(|_| !diagnostics.has_errors()).map(|model| model.with_settings(overrides));
    Loaded { sources, diagnostics, model }
}

fn read(
    main: SourceId,
    path: &Path,
    overrides: Vec<Override>,
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Option<Model> {
    let mut files = read_files(sources, main, path, overrides, diagnostics)?;
    let mounted = std::mem::take(&mut files.mounted);
    let model = read_parts(main, path, files, sources, diagnostics);
    mounts::tell(&mounted, sources, diagnostics);
    model
}

fn read_parts(
    main: SourceId,
    path: &Path,
    files: Files,
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Option<Model> {
    let texts: Vec<SourceId> = files.parts.iter().map(|part| part.table.span.source).collect();
    let read = read_model(files, &Tables::new(sources), diagnostics)?;
    evaluate(&read, diagnostics);
    let ReadModel { title, design, studies } = read;
    let name = path.file_stem().map_or_else(|| "model".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let hash = provenance::hash(sources, &texts);
    let main = Main { path: path.to_owned(), text: text_of(sources, main), settings: Vec::new() };
    Model::new(Parts { title: title.unwrap_or_else(|| name.clone()), name, main, hash, design, studies })
}

/// The text as the file has it, with its byte order mark.
fn text_of(sources: &Sources, id: SourceId) -> String {
    let mark = if sources.is_marked(id) { "\u{feff}" } else { "" };
    format!("{mark}{}", sources.text(id))
}

fn arguments(overrides: &[(String, String)], sources: &mut Sources, diagnostics: &mut Diagnostics) -> Vec<Override> {
    let mut read = Vec::new();
    for (name, value) in overrides {
        match Override::from_argument(sources, &format!("{name}={value}")) {
            Ok(one) => read.push(one),
            Err(report) => diagnostics.push(report),
        }
    }
    read
}

/// Checks the numbers of the model and of each study that changes some, as far as they could be read.
fn evaluate(read: &ReadModel, diagnostics: &mut Diagnostics) {
    let main = &read.design.scopes[0].parameters;
    let values = Values::new(&read.design.scopes, main);
    // A mechanism is made only of what was read without an error.
    let whole = !diagnostics.has_errors();
    let mut found = faults(&read.design, &values, whole);
    if whole && found.is_empty() {
        found.extend(build::implausible(&read.design, &values));
    }
    let (asking, plain): (Vec<&Study>, Vec<&Study>) =
        read.studies.iter().partition(|study| matches!(study.task, Task::Ask(_)));
    let mut told = found.clone();
    for study in plain.into_iter().chain(asking) {
        let in_study = if study.changed.is_empty() { Vec::new() } else { faults(&read.design, &study.values, whole) };
        // What is wrong without the study, or in the study that it asks, has been told.
        let known = if matches!(study.task, Task::Ask(_)) { &told } else { &found };
        let new = in_study.into_iter().filter(|fault| !known.contains(fault)).collect::<Vec<_>>();
        told.extend(new.iter().cloned());
        found.extend(new.into_iter().map(|fault| with_study(fault, study)));
        let wrong = study.faults(&read.design);
        if wrong.is_empty() {
            found.extend(build::implausible_study(&read.design, study));
            found.extend(build::idle_velocities(&read.design, study));
        }
        // Of several studies that share a fault one is enough.
        found.extend(
            wrong.into_iter().filter(|fault| !found.iter().any(|known| is_same(known, fault))).collect::<Vec<_>>(),
        );
    }
    if whole {
        found.extend(check_connected(&read.design));
    }
    found.into_iter().for_each(|fault| diagnostics.push(fault));
}

fn faults(design: &Design, values: &Values, whole: bool) -> Vec<Diagnostic> {
    let mut faults = Vec::new();
    build::material_faults(design, values, &mut faults);
    if let Some(built) = build::build(design, values, &mut faults)
        && whole
        && let Err(fault) = build::engine(design, &built)
    {
        faults.push(*fault);
    }
    faults
}

fn is_same(a: &Diagnostic, b: &Diagnostic) -> bool {
    (a.code, &a.message, &a.primary) == (b.code, &b.message, &b.primary)
}

fn with_study(fault: Diagnostic, study: &Study) -> Diagnostic {
    let message = format!("{} (in study `{}`)", fault.message, study.name);
    Diagnostic { message, ..fault }.also(study.span, "with the parameters of this study")
}
