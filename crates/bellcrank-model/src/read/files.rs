//! A model file and the files of its subsystems, read and put in order.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use bellcrank_doc::{
    Diagnostic, Diagnostics, Dimension, Entry, Expression, NoSignals, Override, ParameterSet, Reader, SourceId,
    Sources, Span, Spanned, Table, ValueKind, nearest, parse,
};

use crate::design::{Scope, ScopeId};
use crate::disk::read_source;
use crate::keyed::Keyed;
use crate::motion::{Columns, Spline, read_table};
use crate::mounts::Mounted;
use crate::names;
use crate::schema::SUBSYSTEM;

/// Files of one model; a tree that doubles at every level would never end.
const MOST_FILES: usize = 1000;

/// One file of a model.
#[derive(Debug)]
pub(crate) struct Part {
    pub(crate) table: Table,
    pub(crate) scope: ScopeId,
    /// `lift.` for the subsystem `lift`; empty for the main file.
    pub(crate) prefix: String,
    /// The part that includes this one.
    pub(crate) parent: Option<usize>,
    pub(crate) mount: Mount,
    /// Where the file is: what it names is relative to it.
    pub(crate) folder: PathBuf,
}

/// What carries the ground of a part.
#[derive(Debug)]
pub(crate) enum Mount {
    /// The ground of the file that includes it; the world at last.
    Ground,
    Point {
        written: String,
        prefix: String,
        span: Span,
    },
}

/// All files of a model, each after the one that includes it.
pub(crate) struct Files {
    pub(crate) parts: Vec<Part>,
    pub(crate) scopes: Vec<Scope>,
    /// Texts of all but the main file, those that could not be read among them.
    pub(crate) mounted: Vec<Mounted>,
}

/// The main file, which is `source`, and all that it includes. `None` when there is nothing to work on.
pub(crate) fn read_files(
    sources: &mut Sources,
    source: SourceId,
    path: &Path,
    overrides: Vec<Override>,
    diagnostics: &mut Diagnostics,
) -> Option<Files> {
    let mut expander = Expander {
        sources,
        diagnostics,
        overrides,
        parts: Vec::new(),
        scopes: Vec::new(),
        open: Vec::new(),
        chain: Vec::new(),
        mounted: Vec::new(),
    };
    expander.file(source, path, String::new(), Mount::Ground, None)?;
    expander.report_unused_overrides();
    let Expander { parts, scopes, mounted, .. } = expander;
    Some(Files { parts, scopes, mounted })
}

/// What a subsystem is given by the file that includes it.
struct Given<'a> {
    parent: ScopeId,
    set: Option<&'a Entry>,
}

struct Expander<'s> {
    sources: &'s mut Sources,
    diagnostics: &'s mut Diagnostics,
    /// From the command line; names carry the prefix of a subsystem.
    overrides: Vec<Override>,
    parts: Vec<Part>,
    scopes: Vec<Scope>,
    /// Files that are being read, outermost first: as found on disk, and as named.
    open: Vec<(PathBuf, String)>,
    /// Subsystems that are being read, outermost first: full names, and where the files mount them.
    chain: Vec<(String, Span)>,
    mounted: Vec<Mounted>,
}

impl Expander<'_> {
    fn file(
        &mut self,
        source: SourceId,
        path: &Path,
        prefix: String,
        mount: Mount,
        given: Option<Given<'_>>,
    ) -> Option<()> {
        let errors = self.diagnostics.errors();
        let table = parse(self.sources, source, self.diagnostics);
        // Nothing of it could be read: what is missing in it is no news.
        if table.is_empty() && self.diagnostics.errors() > errors {
            return None;
        }
        let (parameters, settled) = self.parameters(&table, &prefix);
        let scope = ScopeId(self.scopes.len());
        let including = given.as_ref().map(|given| given.parent.0);
        let mut parent = given.map(|given| (given.parent, self.set(given, &parameters, &prefix)));
        // The command line has the last word.
        if let Some((_, set)) = &mut parent {
            set.retain(|(index, _)| !settled.contains(index));
        }
        self.scopes.push(Scope { prefix: prefix.clone(), parameters, parent });
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let subsystems = table.get("subsystems").cloned();
        self.open.push((identity(path), path.display().to_string()));
        self.parts.push(Part {
            table,
            scope,
            prefix: prefix.clone(),
            parent: including,
            mount,
            folder: folder.clone(),
        });
        if let Some(entry) = subsystems {
            self.subsystems(&entry, scope, &prefix, &folder);
        }
        self.open.pop();
        Some(())
    }

    /// The parameters of a file, with what the command line says about them, and which these are.
    fn parameters(&mut self, table: &Table, prefix: &str) -> (ParameterSet, Vec<usize>) {
        let read = match table.get("parameters").map(|entry| &entry.value) {
            None => ParameterSet::default(),
            Some(value) => match value.as_table() {
                Some(table) => ParameterSet::read(table, self.diagnostics),
                None => {
                    let message = format!("`parameters` needs a table, found {}", value.describe());
                    if !matches!(value.kind, ValueKind::Faulty) {
                        self.diagnostics.push(Diagnostic::error("wrong-type", value.span, message));
                    }
                    ParameterSet::default()
                }
            },
        };
        let own = self.own_overrides(prefix);
        if own.is_empty() {
            return (read, Vec::new());
        }
        let settled = own.iter().filter_map(|one| read.index(&one.name)).collect();
        match read.with_overrides(&own) {
            Ok((changed, warnings)) => {
                self.diagnostics.append(warnings);
                (changed, settled)
            }
            Err(faults) => {
                self.diagnostics.append(faults);
                (read, settled)
            }
        }
    }

    /// Overrides for the file of this prefix: `lift.l5` belongs to `lift.`, not to the main file.
    fn own_overrides(&mut self, prefix: &str) -> Vec<Override> {
        let mine = |one: &Override| one.name.strip_prefix(prefix).is_some_and(|rest| !rest.contains('.'));
        let (own, rest): (Vec<_>, Vec<_>) = std::mem::take(&mut self.overrides).into_iter().partition(mine);
        self.overrides = rest;
        let local = |mut one: Override| {
            one.name.drain(..prefix.len());
            one
        };
        own.into_iter().map(local).collect()
    }

    /// Overrides with the prefix of no subsystem.
    fn report_unused_overrides(&mut self) {
        for one in std::mem::take(&mut self.overrides) {
            let message = format!("there is no parameter `{}`", one.name);
            let prefixes = self.scopes.iter().map(|scope| scope.prefix.as_str());
            let report = Diagnostic::error("unknown-name", one.name_span, message);
            self.diagnostics.push(report.did_you_mean(nearest(&one.name, prefixes)));
        }
    }

    fn subsystems(&mut self, entry: &Entry, parent: ScopeId, prefix: &str, folder: &Path) {
        let Some(table) = entry.value.as_table() else { return };
        for entry in table.iter() {
            if let Some(fault) = names::fault(entry, "subsystem") {
                self.diagnostics.push(fault);
            }
            if self.parts.len() >= MOST_FILES {
                let message = format!("this model includes more than {MOST_FILES} files");
                self.diagnostics.push(Diagnostic::error("too-many-files", entry.key_span, message));
                return;
            }
            self.subsystem(entry, parent, prefix, folder);
        }
    }

    fn subsystem(&mut self, entry: &Entry, parent: ScopeId, prefix: &str, folder: &Path) {
        let Some((file, ground)) = self.subsystem_keys(entry) else { return };
        let set = entry.value.as_table().and_then(|table| table.get("set"));
        let path = folder.join(&file.value);
        if let Some(report) = self.cycle(&path, file.span) {
            self.diagnostics.push(report);
            return;
        }
        if !path.exists() {
            let message = format!("there is no file `{}`", path.display());
            self.diagnostics.push(Diagnostic::error("cannot-read", file.span, message));
            return;
        }
        let mount = match ground {
            Some(written) => Mount::Point { written: written.value, prefix: prefix.to_owned(), span: written.span },
            None => Mount::Ground,
        };
        let mut reports = Diagnostics::new();
        let source = read_source(self.sources, &path, &mut reports);
        // What is said of a main file does not help here: the name stands in this one.
        reports.into_iter().for_each(|report| self.diagnostics.push(placed(report, file.span)));
        let Some(source) = source else { return };
        self.chain.push((format!("{prefix}{}", entry.key), entry.key_span));
        self.mounted.push(Mounted { source, chain: self.chain.clone() });
        self.file(source, &path, format!("{prefix}{}.", entry.key), mount, Some(Given { parent, set }));
        self.chain.pop();
    }

    /// `file` and `ground` of a subsystem; `set` is read with the parameters of both files.
    fn subsystem_keys(&mut self, entry: &Entry) -> Option<(Spanned<String>, Option<Spanned<String>>)> {
        let none = ParameterSet::default();
        let reader = Reader::new(&none);
        let keys = reader.fields(&entry.value, &format!("subsystem `{}`", entry.key)).map(|fields| {
            let keyed = Keyed::new(fields, &SUBSYSTEM, 3);
            let owned = |text: Spanned<&str>| Spanned { value: text.value.to_owned(), span: text.span };
            let keys = (keyed.text("file").map(owned), keyed.text("ground").map(owned));
            keyed.finish();
            keys
        });
        self.diagnostics.append(reader.finish());
        let (file, ground) = keys?;
        Some((file?, ground))
    }

    /// The report of a file that includes itself, with the chain that leads back to it.
    fn cycle(&self, path: &Path, span: Span) -> Option<Diagnostic> {
        let identity = identity(path);
        let first = self.open.iter().position(|(open, _)| *open == identity)?;
        let mut chain: Vec<String> = self.open[first..].iter().map(|(_, name)| format!("`{name}`")).collect();
        chain.push(format!("`{}`", path.display()));
        let message = format!("this file includes itself: {}", chain.join(" includes "));
        Some(Diagnostic::error("file-cycle", span, message))
    }

    /// What a file sets in its subsystem: values over its own parameters, of the dimensions wanted there.
    fn set(&mut self, given: Given<'_>, inner: &ParameterSet, prefix: &str) -> Vec<(usize, Expression)> {
        let Some(entry) = given.set else { return Vec::new() };
        let outer = &self.scopes[given.parent.0].parameters;
        let reader = Reader::new(outer);
        let mut set = Vec::new();
        if let Some(fields) =
            reader.fields(&entry.value, &format!("`set` of subsystem `{}`", prefix.trim_end_matches('.')))
        {
            for entry in fields.table().iter() {
                set.extend(one_set(&reader, inner, entry));
            }
        }
        self.diagnostics.append(reader.finish());
        set
    }
}

fn one_set(reader: &Reader<'_>, inner: &ParameterSet, entry: &Entry) -> Option<(usize, Expression)> {
    let Some(index) = inner.index(&entry.key) else {
        if inner.is_faulty(&entry.key) {
            return None;
        }
        let message = format!("the subsystem has no parameter `{}`", entry.key);
        let near = nearest(&entry.key, inner.all().iter().map(|p| p.name.as_str()));
        reader.report(Diagnostic::error("unknown-name", entry.key_span, message).did_you_mean(near));
        return None;
    };
    let parameter = &inner.all()[index];
    let what = format!("`{}`", entry.key);
    let value = reader.any_quantity(&entry.value, &what, &mut NoSignals)?;
    // A plain 0 is a value of any dimension.
    let zero = value.as_constant() == Some(0.0) && value.dimension() == Dimension::NONE;
    if !zero && !value.dimension().agrees(parameter.dimension) {
        let (wanted, found) = (parameter.dimension.phrase(), value.dimension().phrase());
        let message = format!("{what} needs {wanted}, found {found}");
        reader.report(Diagnostic::error("wrong-dimension", value.span(), message).also(parameter.span, "defined here"));
        return None;
    }
    Some((index, value))
}

/// The same for two names of one file.
fn identity(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

/// Reads the tables of motions while the model is read.
pub(crate) struct Tables<'s> {
    sources: RefCell<&'s mut Sources>,
}

impl<'s> Tables<'s> {
    pub(crate) fn new(sources: &'s mut Sources) -> Tables<'s> {
        Tables { sources: RefCell::new(sources) }
    }

    /// The spline through the table of a file; what is wrong with the file is said at `span` or in the file.
    pub(crate) fn read(&self, path: &Path, position: Dimension, span: Span) -> Result<Spline, Vec<Diagnostic>> {
        self.with(path, span, |sources, id, diagnostics| read_table(sources, id, Columns { position }, diagnostics))
    }

    /// What `read` makes of the text of a file; what is wrong with the file is said at `span` or in the file.
    pub(crate) fn with<T>(
        &self,
        path: &Path,
        span: Span,
        read: impl FnOnce(&Sources, SourceId, &mut Diagnostics) -> Option<T>,
    ) -> Result<T, Vec<Diagnostic>> {
        let mut diagnostics = Diagnostics::new();
        let mut sources = self.sources.borrow_mut();
        let found =
            read_source(&mut sources, path, &mut diagnostics).and_then(|id| read(&sources, id, &mut diagnostics));
        found.ok_or_else(|| diagnostics.into_iter().map(|report| placed(report, span)).collect())
    }
}

/// A report without a place gets that of the name of the file.
fn placed(report: Diagnostic, span: Span) -> Diagnostic {
    match report.primary {
        Some(_) => report,
        // What is said of model files does not help with a table.
        None => Diagnostic { primary: Diagnostic::error(report.code, span, "").primary, hints: Vec::new(), ..report },
    }
}
