//! From bytes to text: what is refused before parsing.

use crate::{Diagnostic, Diagnostics, SourceId, Sources, Span};

/// Largest file that is read, 16 MiB; a model is some kilobytes.
pub const MAX_BYTES: usize = 16 * 1024 * 1024;

const BYTE_ORDER_MARK: char = '\u{feff}';

/// Refuses what is larger than [`MAX_BYTES`]; to be asked before the file is read into memory.
pub fn check_size(name: &str, bytes: u64) -> Result<(), Diagnostic> {
    if bytes <= MAX_BYTES as u64 {
        return Ok(());
    }
    let message = format!(
        "`{name}` has {} MiB; a model file may have {} MiB",
        bytes.div_ceil(1024 * 1024),
        MAX_BYTES / (1024 * 1024)
    );
    Err(Diagnostic::placeless("file-too-large", message)
        .hint("is this the right file? tables of numbers go into CSV files"))
}

/// Why bytes are no text.
enum Fault {
    Utf16,
    Binary,
    NotUtf8 { valid_up_to: usize, byte: u8 },
}

/// UTF-8 text without a byte order mark, or why it is none. The diagnostic has no place.
pub fn decode(bytes: &[u8]) -> Result<String, Diagnostic> {
    match inspect(bytes) {
        Ok(text) => Ok(text.to_owned()),
        Err(fault) => Err(fault.report(None)),
    }
}

/// Adds the text of a file under `name`, whatever is in it, and reports what is wrong with it
/// (too large, binary, not UTF-8, empty). `None` when there is nothing to parse.
pub fn load(sources: &mut Sources, name: &str, bytes: &[u8], diagnostics: &mut Diagnostics) -> Option<SourceId> {
    if let Err(refusal) = check_size(name, bytes.len() as u64) {
        diagnostics.push(refusal);
        return None;
    }
    match inspect(bytes) {
        Ok(text) => {
            let id = sources.add(name, text);
            if text.len() < bytes.len() {
                sources.mark(id);
            }
            report_empty(sources, id, diagnostics).then_some(id)
        }
        Err(fault) => {
            let place = fault.place(sources, name, bytes);
            diagnostics.push(fault.report(Some(place)));
            None
        }
    }
}

fn inspect(bytes: &[u8]) -> Result<&str, Fault> {
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(Fault::Utf16);
    }
    if bytes.contains(&0) {
        return Err(Fault::Binary);
    }
    let text = std::str::from_utf8(bytes).map_err(|e| {
        let valid_up_to = e.valid_up_to();
        Fault::NotUtf8 { valid_up_to, byte: bytes.get(valid_up_to).copied().unwrap_or(0) }
    })?;
    Ok(text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text))
}

impl Fault {
    /// Keeps as much of the file as can be shown, and says where the fault is in it.
    fn place(&self, sources: &mut Sources, name: &str, bytes: &[u8]) -> Span {
        match self {
            Fault::Utf16 | Fault::Binary => Span::new(sources.add(name, ""), 0, 0),
            Fault::NotUtf8 { valid_up_to, .. } => {
                let id = sources.add(name, String::from_utf8_lossy(bytes));
                Span::new(id, *valid_up_to, valid_up_to + '\u{fffd}'.len_utf8())
            }
        }
    }

    fn report(&self, place: Option<Span>) -> Diagnostic {
        let error = |code, message: String| match place {
            Some(span) => Diagnostic::error(code, span, message),
            None => Diagnostic::placeless(code, message),
        };
        match self {
            Fault::Utf16 => error("not-utf8", "the file is UTF-16 text, not UTF-8".to_owned()).hint("save it as UTF-8"),
            Fault::Binary => error("binary-file", "this is not a text file: it holds NUL bytes".to_owned())
                .hint("give the model file (`.toml`), not a result or a drawing"),
            Fault::NotUtf8 { byte, .. } => {
                error("not-utf8", format!("byte 0x{byte:02x} is not UTF-8 text")).hint("save the file as UTF-8")
            }
        }
    }
}

/// Whether there is something to parse.
fn report_empty(sources: &Sources, id: SourceId, diagnostics: &mut Diagnostics) -> bool {
    let blank = sources.text(id).trim().is_empty();
    if blank {
        let error = Diagnostic::error("empty-file", Span::new(id, 0, 0), "the file is empty");
        diagnostics.push(error.hint("`bellcrank new NAME` writes a model to start from"));
    }
    !blank
}

#[cfg(test)]
mod tests;
