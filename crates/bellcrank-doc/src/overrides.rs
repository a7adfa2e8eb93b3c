//! Other values for parameters: `set = { m1 = "0 kg" }` and `--set m1=0kg`.

use crate::expression::Written;
use crate::written::WrittenValue;
use crate::{Diagnostic, Diagnostics, Sources, Span, Table};

/// A new definition of one parameter.
#[derive(Clone, Debug)]
pub struct Override {
    /// The parameter.
    pub name: String,
    /// Where the override names it.
    pub name_span: Span,
    /// The new definition.
    pub(crate) written: WrittenValue<'static>,
}

impl Override {
    /// The overrides of a `set` table; entries that are no values are reported.
    pub fn from_table(table: &Table, diagnostics: &mut Diagnostics) -> Vec<Override> {
        let mut overrides = Vec::new();
        for entry in table.iter() {
            let written = WrittenValue::of(&entry.value, &format!("`{}`", entry.key), diagnostics);
            overrides.extend(written.map(|written| Override {
                name: entry.key.clone(),
                name_span: entry.key_span,
                written: written.into_owned(),
            }));
        }
        overrides
    }

    /// The override of one `--set` argument `NAME=VALUE`. The argument becomes a source named
    /// `--set`, so that faults in it are shown like faults in a file.
    pub fn from_argument(sources: &mut Sources, argument: &str) -> Result<Override, Diagnostic> {
        let id = sources.add("--set", argument);
        let fault = |message: &str| {
            let error = Diagnostic::error("bad-override", sources.whole(id), message);
            Err(error.hint("as `--set m1=0kg`, with quotes where the shell needs them: `--set 'l1=l2/2 + 5 mm'`"))
        };
        let Some((name, value)) = argument.split_once('=') else {
            return fault("expected `NAME=VALUE`");
        };
        if name.trim().is_empty() || value.trim().is_empty() {
            return fault("expected `NAME=VALUE`, found one side empty");
        }
        // In a file the value stands in quotes, so it may here as well.
        let (value, skipped) = unquoted(value);
        let at = name.len() + 1 + skipped;
        let span = Span::new(id, at, at + value.len());
        let name_start = name.len() - name.trim_start().len();
        let written = WrittenValue::text(Written { text: value, span, origin: Some(at) }).into_owned();
        let name_span = Span::new(id, name_start, name_start + name.trim().len());
        Ok(Override { name: name.trim().to_owned(), name_span, written })
    }
}

/// A value without the quotes around it, and how much stands before it.
fn unquoted(value: &str) -> (&str, usize) {
    let trimmed = value.trim();
    let inside = ['"', '\''].iter().find_map(|&quote| trimmed.strip_prefix(quote)?.strip_suffix(quote));
    match inside {
        Some(inside) if !inside.trim().is_empty() => (inside, value.len() - value.trim_start().len() + 1),
        _ => (value, 0),
    }
}
