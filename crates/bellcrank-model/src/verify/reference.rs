//! Reading `reference.toml` and `expected.toml`.

use std::path::{Path, PathBuf};

use bellcrank_doc::{Diagnostics, ParameterSet, Reader, Sources, Table, parse};

use crate::disk::read_source;

/// A reference file: values are kept as written, since they may use parameters of the model.
pub(super) struct Reference {
    pub(super) model: PathBuf,
    pub(super) kind: String,
    pub(super) source: String,
    pub(super) checks: Vec<Table>,
    pub(super) sources: Sources,
}

/// Reads the reference of a folder, or the file itself.
pub(super) fn read(case: &Path) -> Result<Reference, Vec<String>> {
    let Some(path) = file(case) else {
        return Err(vec![format!("no reference.toml or expected.toml in {}", case.display())]);
    };
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut sources = Sources::new();
    let mut diagnostics = Diagnostics::new();
    let table = read_source(&mut sources, &path, &mut diagnostics).map(|id| parse(&sources, id, &mut diagnostics));
    let none = ParameterSet::default();
    let reader = Reader::new(&none);
    let head = table.as_ref().and_then(|table| head(&reader, table, folder));
    diagnostics.append(reader.finish());
    if diagnostics.has_errors() {
        return Err(faults(&diagnostics, &sources));
    }
    let Some((model, kind, source, checks)) = head else { return Err(vec!["nothing to compare".to_owned()]) };
    Ok(Reference { model, kind, source, checks, sources })
}

fn file(case: &Path) -> Option<PathBuf> {
    if case.is_file() {
        return Some(case.to_owned());
    }
    ["reference.toml", "expected.toml"].map(|name| case.join(name)).into_iter().find(|path| path.exists())
}

type Head = (PathBuf, String, String, Vec<Table>);

fn head(reader: &Reader<'_>, table: &Table, folder: &Path) -> Option<Head> {
    let fields = bellcrank_doc::Fields::new(reader, table, "the reference");
    let kind = fields.one_of("kind", &["analytic", "literature", "other-code", "regression"]);
    let source = fields.string("source");
    let model = fields.optional_string("model").map_or("model.toml", |model| model.value);
    let checks = fields.list("check").unwrap_or(&[]);
    let checks = checks.iter().filter_map(|value| value.as_table().cloned()).collect();
    let head = Some((folder.join(model), kind?.value.to_owned(), source?.value.to_owned(), checks));
    fields.finish();
    head
}

/// Diagnostics as lines.
pub(super) fn faults(diagnostics: &Diagnostics, sources: &Sources) -> Vec<String> {
    let line = |finding: bellcrank_doc::Finding| match finding.location {
        Some(at) => format!("{}:{}:{}: {}", finding.file, at.line, at.column, finding.message),
        None => finding.message,
    };
    diagnostics.findings(sources).into_iter().filter(|finding| finding.severity == "error").map(line).collect()
}
