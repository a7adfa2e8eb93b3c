//! New values for parameters, written into the text of their file; the rest of it stays byte for byte.

#[cfg(test)]
mod tests;

use std::fmt;
use std::ops::Range;

use crate::expression::{Written, parse as parse_expression};
use crate::written::WrittenValue;
use crate::{
    Diagnostics, Override, Parameter, ParameterSet, SourceId, Sources, Table, Text, Value, ValueKind, nearest, parse,
};

/// Why a file was not rewritten.
#[derive(Clone, Debug)]
pub enum RewriteError {
    /// The file is wrong as it is.
    FaultyFile {
        /// Its errors (and warnings).
        diagnostics: Diagnostics,
    },
    /// `[parameters]` of this file has no parameter of the name.
    UnknownParameter {
        /// The name.
        name: String,
        /// The name that was perhaps meant.
        nearest: Option<String>,
    },
    /// Two values for one parameter.
    RepeatedParameter {
        /// Its name.
        name: String,
    },
    /// A value that the parameter cannot have: no expression, of another dimension, in a circle.
    RefusedValue {
        /// What is wrong, at the places of the values in the file that were to be replaced.
        diagnostics: Diagnostics,
    },
    /// The new text does not give this parameter what was asked for (its value, its tolerance, what
    /// it measures: N*m is not N*m/rad). The text is withheld.
    NotAsAsked {
        /// Its name.
        name: String,
    },
}

impl fmt::Display for RewriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let first = |diagnostics: &Diagnostics| diagnostics.iter().next().map_or(String::new(), |d| d.message.clone());
        match self {
            RewriteError::FaultyFile { diagnostics } => write!(f, "the file has errors: {}", first(diagnostics)),
            RewriteError::UnknownParameter { name, nearest: None } => {
                write!(f, "the file defines no parameter `{name}`")
            }
            RewriteError::UnknownParameter { name, nearest: Some(near) } => {
                write!(f, "the file defines no parameter `{name}`; did you mean `{near}`?")
            }
            RewriteError::RepeatedParameter { name } => write!(f, "`{name}` is given two values"),
            RewriteError::RefusedValue { diagnostics } => write!(f, "{}", first(diagnostics)),
            RewriteError::NotAsAsked { name } => {
                write!(f, "the file with the new value would not give `{name}` what was asked for")
            }
        }
    }
}

impl std::error::Error for RewriteError {}

/// The text of `source` with other values (name, value as a file writes it) for parameters of its
/// `[parameters]`: as strings, inline or with a table of their own, with dotted keys, as numbers.
///
/// A tolerance after `±` stays when the new value has none of its own. Comments, layout, line ends,
/// the order of keys and the kind of quotes stay; a string with escapes is written anew, and one
/// in `'` that cannot hold the new value gets `"`. A plain 0 gets a unit where one is needed. The
/// result is read again and compared with what was asked for. [`Sources`] hold texts without a
/// byte order mark: who wants to keep one puts it back.
pub fn rewrite_parameters<N: AsRef<str>, V: AsRef<str>>(
    sources: &Sources,
    source: SourceId,
    changes: &[(N, V)],
) -> Result<String, RewriteError> {
    let (tree, before) = read(sources, source).map_err(|diagnostics| RewriteError::FaultyFile { diagnostics })?;
    let changes = located(&tree, &before, changes)?;
    let overrides: Vec<Override> = changes.iter().map(Change::as_override).collect();
    let (wanted, _) =
        before.with_overrides(&overrides).map_err(|diagnostics| RewriteError::RefusedValue { diagnostics })?;

    let mut splices: Vec<Splice> = changes.iter().filter_map(|change| change.splice(sources)).collect();
    splices.sort_by_key(|splice| splice.bytes.start);
    let text = spliced(sources.text(source), &splices);
    match difference(&text, &wanted) {
        None => Ok(text),
        Some(name) => {
            let changed = changes.first().map_or(String::new(), |change| change.parameter.name.clone());
            Err(RewriteError::NotAsAsked { name: name.unwrap_or(changed) })
        }
    }
}

/// The tree and the parameters of a text without errors.
fn read(sources: &Sources, source: SourceId) -> Result<(Table, ParameterSet), Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    let tree = parse(sources, source, &mut diagnostics);
    let set = match tree.get("parameters").and_then(|entry| entry.value.as_table()) {
        Some(table) => ParameterSet::read(table, &mut diagnostics),
        None => ParameterSet::default(),
    };
    if diagnostics.has_errors() { Err(diagnostics) } else { Ok((tree, set)) }
}

/// One new value and what it replaces.
struct Change<'t> {
    parameter: &'t Parameter,
    old: &'t Value,
    new: String,
}

/// Bytes of a text, and what takes their place.
struct Splice {
    bytes: Range<usize>,
    text: String,
}

fn located<'t, N: AsRef<str>, V: AsRef<str>>(
    tree: &'t Table,
    set: &'t ParameterSet,
    changes: &[(N, V)],
) -> Result<Vec<Change<'t>>, RewriteError> {
    let table = tree.get("parameters").and_then(|entry| entry.value.as_table());
    let mut located: Vec<Change<'t>> = Vec::new();
    for (name, new) in changes {
        let name = name.as_ref();
        let entry = table.and_then(|table| table.get(name));
        let (Some(entry), Some(parameter)) = (entry, set.get(name)) else {
            let nearest = nearest(name, set.all().iter().map(|p| p.name.as_str())).map(str::to_owned);
            return Err(RewriteError::UnknownParameter { name: name.to_owned(), nearest });
        };
        if located.iter().any(|change| change.parameter.name == name) {
            return Err(RewriteError::RepeatedParameter { name: name.to_owned() });
        }
        let inner = entry.value.as_table().and_then(|details| details.get("value"));
        let old = inner.map_or(&entry.value, |entry| &entry.value);
        located.push(Change { parameter, old, new: with_unit(parameter, new.as_ref().trim()) });
    }
    Ok(located)
}

/// A plain 0 fits every parameter, but a file would define a number by it.
fn with_unit(parameter: &Parameter, new: &str) -> String {
    let zero = new.parse() == Ok(0.0) && !parameter.dimension.is_none();
    let written = || parameter.value_as_written(0.0, &parameter.dimension.example_unit());
    zero.then(written).flatten().unwrap_or_else(|| new.to_owned())
}

impl Change<'_> {
    fn written<'n>(&self, new: &'n str) -> Written<'n> {
        Written { text: new, span: self.old.span, origin: None }
    }

    fn as_override(&self) -> Override {
        Override {
            name: self.parameter.name.clone(),
            name_span: self.parameter.span,
            written: WrittenValue::text(self.written(&self.new)).into_owned(),
        }
    }

    /// Where the `±` of a text stands.
    fn sign(&self, text: &str) -> Option<usize> {
        let tree = parse_expression(self.written(text)).ok()?;
        tree.tolerance.map(|tolerance| tolerance.bytes.start)
    }

    fn splice(&self, sources: &Sources) -> Option<Splice> {
        match &self.old.kind {
            ValueKind::String(text) => Some(self.in_string(text, sources.slice(self.old.span))),
            ValueKind::Integer(_) | ValueKind::Float(_) => {
                let text = if is_toml_number(&self.new) { self.new.clone() } else { basic(&self.new) };
                Some(Splice { bytes: self.old.span.start..self.old.span.end, text })
            }
            _ => None,
        }
    }

    /// In the quotes that are there, if they can hold it.
    fn in_string(&self, old: &Text, quoted: &str) -> Splice {
        let sign = if self.sign(&self.new).is_none() { self.sign(&old.value) } else { None };
        let replaced = trimmed(&old.value, sign.unwrap_or(old.value.len()));
        if let (Some(origin), Some(text)) = (old.origin, Quotes::of(quoted).escaped(&self.new)) {
            return Splice { bytes: origin + replaced.start..origin + replaced.end, text };
        }
        let mut whole = old.value.clone();
        whole.replace_range(replaced, &self.new);
        let text = match Quotes::of(quoted) {
            Quotes::Basic3 => format!("\"\"\"{}\"\"\"", Quotes::Basic3.escaped(&whole).unwrap_or_default()),
            _ => basic(whole.trim()),
        };
        Splice { bytes: self.old.span.start..self.old.span.end, text }
    }
}

/// The bytes before `end` without the blanks around them.
fn trimmed(text: &str, end: usize) -> Range<usize> {
    let before = text.get(..end).unwrap_or(text);
    let start = before.len() - before.trim_start().len();
    start..before.trim_end().len().max(start)
}

/// The quotes of a TOML string.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Quotes {
    Basic,
    Basic3,
    Literal,
    Literal3,
}

impl Quotes {
    fn of(quoted: &str) -> Quotes {
        let kinds = [("\"\"\"", Quotes::Basic3), ("'''", Quotes::Literal3), ("'", Quotes::Literal)];
        kinds.iter().find(|(start, _)| quoted.starts_with(start)).map_or(Quotes::Basic, |(_, quotes)| *quotes)
    }

    /// A text as it stands between these quotes; `None` where it cannot.
    fn escaped(self, text: &str) -> Option<String> {
        let lines = matches!(self, Quotes::Basic3 | Quotes::Literal3);
        let raw = |c: char| (!c.is_control() || c == '\t' || (lines && c == '\n')) && c != '\u{7f}';
        match self {
            Quotes::Literal | Quotes::Literal3 => {
                (!text.contains('\'') && text.chars().all(raw)).then(|| text.to_owned())
            }
            Quotes::Basic | Quotes::Basic3 => Some(text.chars().map(|c| escape(c, raw(c))).collect()),
        }
    }
}

fn escape(c: char, raw: bool) -> String {
    match c {
        '"' | '\\' => format!("\\{c}"),
        _ if raw => c.to_string(),
        _ => format!("\\u{:04x}", u32::from(c)),
    }
}

/// A text as a TOML string.
fn basic(text: &str) -> String {
    format!("\"{}\"", Quotes::Basic.escaped(text).unwrap_or_default())
}

/// Whether TOML reads the same number as an expression would.
fn is_toml_number(text: &str) -> bool {
    let mut sources = Sources::new();
    let id = sources.add("", format!("x = {text}"));
    let mut diagnostics = Diagnostics::new();
    let tree = parse(&sources, id, &mut diagnostics);
    let number = match tree.get("x").map(|entry| &entry.value.kind) {
        Some(ValueKind::Integer(number)) => *number as f64,
        Some(ValueKind::Float(number)) => *number,
        _ => return false,
    };
    diagnostics.is_empty() && tree.len() == 1 && text.parse() == Ok(number)
}

/// The text with its splices (in order, apart from each other) in place.
fn spliced(text: &str, splices: &[Splice]) -> String {
    let mut result = String::with_capacity(text.len() + 64);
    let mut at = 0;
    for splice in splices {
        result.push_str(text.get(at..splice.bytes.start).unwrap_or(""));
        result.push_str(&splice.text);
        at = splice.bytes.end;
    }
    result.push_str(text.get(at..).unwrap_or(""));
    result
}

/// Where the parameters of a text are not those wanted: the first one, `Some(None)` where that is
/// none of them. The texts between the splices are the same by construction.
fn difference(text: &str, wanted: &ParameterSet) -> Option<Option<String>> {
    let mut sources = Sources::new();
    let id = sources.add("", text);
    let Ok((_, found)) = read(&sources, id) else { return Some(None) };
    if found.all().len() != wanted.all().len() {
        return Some(None);
    }
    let same = |(i, (a, b)): (usize, (&Parameter, &Parameter))| {
        let data = |p: &Parameter| (p.dimension, p.min, p.max, p.tolerance, p.spread);
        let named = a.name == b.name && a.note == b.note;
        named && data(a) == data(b) && found.values().get(i) == wanted.values().get(i)
    };
    let mut pairs = wanted.all().iter().zip(found.all()).enumerate();
    pairs.find(|pair| !same(*pair)).map(|(_, (parameter, _))| Some(parameter.name.clone()))
}
