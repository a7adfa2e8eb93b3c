//! Reading files, never more of one than a model may have.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use bellcrank_doc::{Diagnostic, Diagnostics, MAX_BYTES, SourceId, Sources, check_size, load};

/// Reads a text file into the sources; what is wrong with it is reported.
pub(crate) fn read_source(sources: &mut Sources, path: &Path, diagnostics: &mut Diagnostics) -> Option<SourceId> {
    let name = path.display().to_string();
    match bytes(path, &name) {
        Ok(bytes) => load(sources, &name, &bytes, diagnostics),
        Err(report) => {
            let meant = Some(format!("{name}.toml")).filter(|meant| Path::new(meant).is_file());
            diagnostics.push(match meant {
                Some(meant) => Diagnostic { hints: Vec::new(), ..*report }.did_you_mean(Some(&meant)),
                None => *report,
            });
            None
        }
    }
}

fn bytes(path: &Path, name: &str) -> Result<Vec<u8>, Box<Diagnostic>> {
    let fault = |error: std::io::Error| Box::new(unreadable(name, &error));
    let about = std::fs::metadata(path).map_err(fault)?;
    if about.is_dir() {
        let message = format!("`{name}` is a folder, not a model file");
        let report = Diagnostic::placeless("cannot-read", message);
        return Err(Box::new(match models_in(path) {
            Some(models) => report.hint(format!("files in it: {models}")),
            None => report,
        }));
    }
    check_size(name, about.len())?;
    let mut bytes = Vec::new();
    // A pipe or device tells no size beforehand: one byte more than allowed shows that it is too large.
    let limit = MAX_BYTES as u64 + 1;
    File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes)).map_err(fault)?;
    Ok(bytes)
}

fn unreadable(name: &str, error: &std::io::Error) -> Diagnostic {
    let report = Diagnostic::placeless("cannot-read", format!("cannot read `{name}`: {error}"));
    match error.kind() {
        std::io::ErrorKind::NotFound => report.hint("`bellcrank new NAME` writes a model to start from"),
        _ => report,
    }
}

/// The first few model files of a folder.
fn models_in(folder: &Path) -> Option<String> {
    const SHOWN: usize = 5;
    let entries = std::fs::read_dir(folder).ok()?;
    let mut names: Vec<String> = entries.flatten().map(|entry| entry.path().display().to_string()).collect();
    names.retain(|name| name.ends_with(".toml"));
    names.sort();
    names.truncate(SHOWN);
    (!names.is_empty()).then(|| names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "))
}
