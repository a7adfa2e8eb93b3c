//! Names: what may be one, and how they are looked up.

use bellcrank_doc::{Diagnostic, Entry, Span, Spanned, nearest};
use std::collections::HashMap;

/// Characters that would make `joint.NAME.position [deg]` unreadable or ambiguous.
const FORBIDDEN: &[char] = &['.', ',', '"', '\'', '[', ']', '(', ')', '{', '}', '\\', '`'];
/// Longer names make columns that nobody can read.
const LONGEST: usize = 100;

/// Why a key cannot be the name of a `what`.
pub(crate) fn fault(entry: &Entry, what: &str) -> Option<Diagnostic> {
    fault_in(Spanned { value: entry.key.as_str(), span: entry.key_span }, what)
}

/// Why a text cannot be the name of a `what`.
pub(crate) fn fault_in(name: Spanned<&str>, what: &str) -> Option<Diagnostic> {
    let Spanned { value: name, span } = name;
    let message = if name.is_empty() {
        format!("a {what} needs a name; this one is empty")
    } else if name == "ground" && matches!(what, "body" | "subsystem") {
        format!("a {what} cannot be named `ground`: that is the body that does not move")
    } else if name.contains('.') {
        format!("the name `{name}` has a dot in it; dots separate the parts of a signal")
    } else if name.chars().count() > LONGEST {
        format!("this name has {} characters; {LONGEST} are allowed", name.chars().count())
    } else if name.contains(|c: char| c.is_whitespace() || c.is_control() || FORBIDDEN.contains(&c)) {
        format!("the name `{name}` has a character that names cannot have")
    } else {
        return None;
    };
    let hint = "use letters, digits and `_`";
    Some(Diagnostic::error("bad-name", span, message).hint(hint))
}

/// Names of one sort and their places in the model.
#[derive(Clone, Debug, Default)]
pub(crate) struct Index {
    places: HashMap<String, usize>,
    /// For hints, in the order of the file.
    names: Vec<String>,
}

impl Index {
    pub(crate) fn insert(&mut self, name: &str, place: usize) {
        if self.places.insert(name.to_owned(), place).is_none() {
            self.names.push(name.to_owned());
        }
    }

    pub(crate) fn get(&self, name: &str) -> Option<usize> {
        self.places.get(name).copied()
    }

    pub(crate) fn nearest(&self, name: &str) -> Option<&str> {
        nearest(name, self.names.iter().map(String::as_str))
    }

    /// The place of a name, or a report that there is no such `what`.
    pub(crate) fn find(&self, name: &str, prefix: &str, what: &str, span: Span) -> Result<usize, Box<Diagnostic>> {
        let full = format!("{prefix}{name}");
        self.get(&full).ok_or_else(|| Box::new(self.unknown(&full, prefix, what, span)))
    }

    /// The report that there is no such `what`; names are shown as the file with this prefix writes them.
    pub(crate) fn unknown(&self, full: &str, prefix: &str, what: &str, span: Span) -> Diagnostic {
        let local = |name: &str| name.strip_prefix(prefix).unwrap_or(name).to_owned();
        let report = Diagnostic::error("unknown-name", span, format!("there is no {what} `{}`", local(full)));
        match self.nearest(full) {
            Some(near) => report.hint(format!("did you mean `{}`?", local(near))),
            None => report.hint(match self.listed(prefix) {
                Some(names) => format!("the file has: {names}"),
                None => format!("this file has no {what}"),
            }),
        }
    }

    /// The names that start with a prefix, without it; `None` when there are none.
    pub(crate) fn listed(&self, prefix: &str) -> Option<String> {
        const SHOWN: usize = 12;
        let mut names: Vec<&str> = self.names.iter().filter_map(|n| n.strip_prefix(prefix)).take(SHOWN + 1).collect();
        if names.len() > SHOWN {
            names[SHOWN] = "...";
        }
        (!names.is_empty()).then(|| names.join(", "))
    }
}
