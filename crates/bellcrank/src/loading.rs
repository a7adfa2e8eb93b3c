//! Reading a model for a command: diagnostics are shown here, in both languages.

use std::path::Path;

use bellcrank_doc::Finding;
use bellcrank_model::{Loaded, Model, load};
use serde_json::{Value, json};

use crate::config::Setting;
use crate::console::Console;
use crate::exit::{Exit, Refusal};

/// How diagnostics are shown beside their text on standard error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shown {
    /// Errors and warnings.
    All,
    /// Errors only.
    Errors,
    /// Errors and warnings, and errors also as one JSON object on standard output.
    Json,
}

/// The model, or a refusal after every error of the file has been shown.
pub(crate) fn open(path: &Path, settings: &[Setting], shown: Shown, console: &Console) -> Result<Model, Refusal> {
    let Loaded { sources, diagnostics, model } = load(path, settings);
    if diagnostics.has_errors() || shown != Shown::Errors {
        console.say(&diagnostics.render(&sources, console.color_err()));
    }
    match model {
        Some(model) if !diagnostics.has_errors() => Ok(model),
        _ => Err(refuse(path, &diagnostics.findings(&sources), shown, console)),
    }
}

fn refuse(path: &Path, findings: &[Finding], shown: Shown, console: &Console) -> Refusal {
    if shown == Shown::Json
        && let Err(refusal) = console.print(&format!("{:#}\n", as_json(path, findings)))
    {
        return refusal;
    }
    Refusal::said(blame(findings))
}

/// A file is not to blame for what stands on the command line.
fn blame(findings: &[Finding]) -> Exit {
    let mut errors = findings.iter().filter(|finding| finding.severity == "error").peekable();
    let on_command_line = errors.peek().is_some() && errors.all(|finding| finding.file.starts_with("--set"));
    if on_command_line { Exit::CommandLine } else { Exit::Model }
}

fn as_json(path: &Path, findings: &[Finding]) -> Value {
    json!({
        "bellcrank": env!("CARGO_PKG_VERSION"),
        "model": path.file_stem().map(|stem| stem.to_string_lossy()),
        "diagnostics": findings.iter().map(finding).collect::<Vec<_>>(),
    })
}

fn finding(of: &Finding) -> Value {
    json!({
        "severity": of.severity,
        "code": of.code,
        "message": of.message,
        "file": of.file,
        "line": of.location.map(|location| location.line),
        "column": of.location.map(|location| location.column),
        "hints": of.hints,
    })
}
