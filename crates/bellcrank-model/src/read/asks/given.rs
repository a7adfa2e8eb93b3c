//! Keys that may be absent, wrong or read; parameters by name.

use bellcrank_doc::{Diagnostic, Entry, ParameterSet, Span, Spanned, Value, ValueKind, nearest};

use crate::keyed::Keyed;
use crate::read::PartReader;

/// A key of a study. A wrong one has been reported, so that nobody says it is missing.
#[derive(Clone, Debug, Default)]
pub(crate) enum Given<T> {
    #[default]
    No,
    Wrong,
    Is(T),
}

impl<T> Given<T> {
    /// The key as `read` finds it.
    pub(super) fn key<'a>(keyed: &Keyed<'a>, key: &'static str, read: impl FnOnce(&'a Value) -> Option<T>) -> Given<T> {
        match keyed.value(key) {
            None => Given::No,
            Some(value) => read(value).map_or(Given::Wrong, Given::Is),
        }
    }

    /// The same of a key that must be there unless it lies `beneath`.
    pub(super) fn needed<'a>(
        keyed: &Keyed<'a>,
        key: &'static str,
        beneath: &Given<T>,
        read: impl FnOnce(&'a Value) -> Option<T>,
    ) -> Given<T> {
        if beneath.is_no() {
            keyed.needed(key);
        }
        Given::key(keyed, key, read)
    }

    /// This key, or the one of the study that this one is like.
    pub(super) fn or(self, beneath: Given<T>) -> Given<T> {
        if self.is_no() { beneath } else { self }
    }

    pub(super) fn is_no(&self) -> bool {
        matches!(self, Given::No)
    }

    pub(super) fn is(&self) -> Option<&T> {
        match self {
            Given::Is(value) => Some(value),
            _ => None,
        }
    }

    /// The value, that of `otherwise` without the key, nothing after an error.
    pub(super) fn or_else(self, otherwise: impl FnOnce() -> T) -> Option<T> {
        match self {
            Given::Is(value) => Some(value),
            Given::No => Some(otherwise()),
            Given::Wrong => None,
        }
    }

    /// The value if there is one; the outer `None` after an error.
    pub(super) fn optional(self) -> Option<Option<T>> {
        match self {
            Given::Is(value) => Some(Some(value)),
            Given::No => Some(None),
            Given::Wrong => None,
        }
    }
}

/// A whole number that is not negative, by the schema.
pub(super) fn whole(keyed: &Keyed<'_>, key: &'static str) -> Given<Spanned<u64>> {
    Given::key(keyed, key, |_| {
        let read = keyed.whole(key)?;
        Some(Spanned { value: u64::try_from(read.value).ok()?, span: read.span })
    })
}

/// A parameter, and what is said of it.
pub(super) struct Told<'v> {
    pub(super) name: &'v str,
    pub(super) parameter: usize,
    pub(super) span: Span,
    /// With a table of parameters.
    pub(super) value: Option<&'v Value>,
}

/// A list of names of parameters, or a table by name; no name twice, one at least. Wrong ones are reported and left
/// out, so that the others are checked all the same: the model is refused anyway.
pub(super) fn told<'v>(part: PartReader<'_>, value: &'v Value, what: &str) -> Option<Vec<Told<'v>>> {
    match value.as_table() {
        Some(table) => some(part, value, what, table.iter().map(|entry| said(part, entry)).collect()),
        None => names(part, value, what),
    }
}

/// The value, unless it is a text where a list of texts is needed; that is reported.
pub(super) fn one_in_brackets<'v>(part: PartReader<'_>, value: &'v Value, what: &str) -> Option<&'v Value> {
    let Some(text) = value.as_str() else { return Some(value) };
    let report = Diagnostic::error("wrong-type", value.span, format!("{what} needs a list, found a string"));
    part.reader.report(report.hint(format!("one stands in brackets, too: `[\"{text}\"]`")));
    None
}

/// A list of names of parameters.
pub(super) fn names<'v>(part: PartReader<'_>, value: &'v Value, what: &str) -> Option<Vec<Told<'v>>> {
    if let Some(table) = value.as_table() {
        let names: Vec<String> = table.iter().map(|entry| format!("\"{}\"", entry.key)).collect();
        let report = Diagnostic::error("wrong-type", value.span, format!("{what} needs a list, found a table"));
        part.reader.report(report.hint(format!("names in brackets: `[{}]`", names.join(", "))));
        return None;
    }
    let list = part.reader.list(one_in_brackets(part, value, what)?, what)?;
    let one = |value: &'v Value| {
        let name = part.reader.string(value, what)?;
        let parameter = parameter(part, name.value, name.span)?;
        Some(Told { name: name.value, parameter, span: name.span, value: None })
    };
    some(part, value, what, list.iter().map(one).collect())
}

fn some<'v>(part: PartReader<'_>, value: &Value, what: &str, told: Vec<Option<Told<'v>>>) -> Option<Vec<Told<'v>>> {
    if told.is_empty() {
        let message = format!("{what} names no parameter");
        let report = Diagnostic::error("wrong-length", value.span, message);
        part.reader.report(report.hint(parameters_of_the_file(part.reader.parameters())));
        return None;
    }
    let told: Vec<Told<'v>> = told.into_iter().flatten().collect();
    report_repeats(part, &told);
    Some(told)
}

fn said<'v>(part: PartReader<'_>, entry: &'v Entry) -> Option<Told<'v>> {
    let parameter = parameter(part, &entry.key, entry.key_span)?;
    Some(Told { name: &entry.key, parameter, span: entry.key_span, value: Some(&entry.value) })
}

fn report_repeats(part: PartReader<'_>, told: &[Told<'_>]) {
    for (i, one) in told.iter().enumerate() {
        if let Some(first) = told[..i].iter().find(|before| before.parameter == one.parameter) {
            let message = format!("`{}` is named twice", one.name);
            part.reader.report(Diagnostic::error("duplicate-name", one.span, message).also(first.span, "first here"));
        }
    }
}

/// The parameter of a name; one whose definition is wrong has been reported there.
pub(super) fn parameter(part: PartReader<'_>, name: &str, span: Span) -> Option<usize> {
    let parameters = part.reader.parameters();
    let found = parameters.index(name);
    if found.is_none() && !parameters.is_faulty(name) {
        part.reader.report(unknown_parameter(parameters, name, span));
    }
    found
}

pub(super) fn unknown_parameter(parameters: &ParameterSet, name: &str, span: Span) -> Diagnostic {
    let report = Diagnostic::error("unknown-name", span, format!("there is no parameter `{name}`"));
    match nearest(name, parameters.all().iter().map(|p| p.name.as_str())) {
        Some(near) => report.did_you_mean(Some(near)),
        None => report.hint(parameters_of_the_file(parameters)),
    }
}

fn parameters_of_the_file(parameters: &ParameterSet) -> String {
    const SHOWN: usize = 12;
    let mut names: Vec<String> = parameters.all().iter().take(SHOWN).map(|p| format!("`{}`", p.name)).collect();
    if parameters.all().len() > SHOWN {
        names.push("...".to_owned());
    }
    match names.as_slice() {
        [] => "the file has no parameters: give it some in `[parameters]`, as `l1 = \"300 mm\"`".to_owned(),
        names => format!("parameters of this file: {}", names.join(", ")),
    }
}

/// Whether a value is there, but unreadable, which has been reported.
pub(super) fn unreadable(value: &Value) -> bool {
    matches!(value.kind, ValueKind::Faulty)
}
