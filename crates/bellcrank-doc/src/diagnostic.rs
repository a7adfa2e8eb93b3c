//! What is wrong, where, and what to do about it.

use crate::{Location, Sources, Span};

/// How bad a diagnostic is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The model cannot be used.
    Error,
    /// The model can be used; the author should look.
    Warning,
}

impl Severity {
    /// `error` or `warning`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Severity::Error => "error",
            Severity::Warning => "warning",
        }
    }
}

/// A place with a few words under its carets (may be empty).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// The words.
    pub message: String,
}

/// One finding about a text: says expected and found, points at every place involved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad.
    pub severity: Severity,
    /// Stable name of the kind of finding, as `unknown-key`.
    pub code: &'static str,
    /// One sentence, lowercase, names in backticks.
    pub message: String,
    /// Where; `None` for what concerns no place (a file that cannot be opened).
    pub primary: Option<Box<Label>>,
    /// Other places that explain it.
    pub secondary: Vec<Label>,
    /// What to try.
    pub hints: Vec<String>,
}

impl Diagnostic {
    /// An error at `span`.
    pub fn error(code: &'static str, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(Severity::Error, code, Some(span), message.into())
    }

    /// A warning at `span`.
    pub fn warning(code: &'static str, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(Severity::Warning, code, Some(span), message.into())
    }

    /// An error that has no place in any text.
    pub fn placeless(code: &'static str, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(Severity::Error, code, None, message.into())
    }

    fn new(severity: Severity, code: &'static str, span: Option<Span>, message: String) -> Diagnostic {
        let primary = span.map(|span| Box::new(Label { span, message: String::new() }));
        Diagnostic { severity, code, message, primary, secondary: Vec::new(), hints: Vec::new() }
    }

    /// Words under the primary carets.
    #[must_use]
    pub fn label(mut self, message: impl Into<String>) -> Diagnostic {
        if let Some(primary) = &mut self.primary {
            primary.message = message.into();
        }
        self
    }

    /// One more place.
    #[must_use]
    pub fn also(mut self, span: Span, message: impl Into<String>) -> Diagnostic {
        self.secondary.push(Label { span, message: message.into() });
        self
    }

    /// One more hint.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Diagnostic {
        self.hints.push(hint.into());
        self
    }

    /// A hint `did you mean ...?` where there is a near name, else nothing.
    #[must_use]
    pub fn did_you_mean(self, nearest: Option<&str>) -> Diagnostic {
        match nearest {
            Some(name) => self.hint(format!("did you mean `{name}`?")),
            None => self,
        }
    }
}

/// A diagnostic with its place resolved: plain data for JSON.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Name of the file; empty without a place.
    pub file: String,
    /// Line and column from 1; `None` without a place.
    pub location: Option<Location>,
    /// `error` or `warning`.
    pub severity: &'static str,
    /// Kind of finding.
    pub code: &'static str,
    /// The sentence.
    pub message: String,
    /// What to try.
    pub hints: Vec<String>,
}

/// Diagnostics that are kept; beyond, they are only counted. Nobody reads a thousand.
const KEPT: usize = 1000;

/// Diagnostics collected on the way.
#[derive(Clone, Debug)]
pub struct Diagnostics {
    all: Vec<Diagnostic>,
    /// Free places in `all`.
    room: usize,
    /// Those that were not kept.
    more_errors: usize,
    more_warnings: usize,
}

impl Default for Diagnostics {
    fn default() -> Diagnostics {
        Diagnostics { all: Vec::new(), room: KEPT, more_errors: 0, more_warnings: 0 }
    }
}

impl Diagnostics {
    /// None yet.
    #[must_use]
    pub fn new() -> Diagnostics {
        Diagnostics::default()
    }

    /// None yet, with as much room as is left in `self`, to be appended to it.
    pub(crate) fn branch(&self) -> Diagnostics {
        Diagnostics { room: self.room, ..Diagnostics::default() }
    }

    /// Whether further ones are only counted: no work should be put into them.
    pub(crate) fn is_full(&self) -> bool {
        self.room == 0
    }

    /// Adds one.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if let Some(room) = self.room.checked_sub(1) {
            self.room = room;
            self.all.push(diagnostic);
            return;
        }
        match diagnostic.severity {
            Severity::Error => self.more_errors += 1,
            Severity::Warning => self.more_warnings += 1,
        }
    }

    /// Takes over all of `other`.
    pub fn append(&mut self, other: Diagnostics) {
        other.all.into_iter().for_each(|d| self.push(d));
        self.more_errors += other.more_errors;
        self.more_warnings += other.more_warnings;
    }

    /// Whether one of them is an error.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.errors() > 0
    }

    /// Number of errors.
    #[must_use]
    pub fn errors(&self) -> usize {
        self.all.iter().filter(|d| d.severity == Severity::Error).count() + self.more_errors
    }

    /// All that were kept (1000), in the order they stand in.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.all.iter()
    }

    /// How many, those that were only counted among them.
    #[must_use]
    pub fn len(&self) -> usize {
        self.all.len() + self.more_errors + self.more_warnings
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Orders by source and place (placeless first) and drops exact repeats.
    pub fn sort(&mut self) {
        self.all.sort_by_key(|d| d.primary.as_ref().map(|p| p.span));
        self.all.dedup();
    }

    /// Lets `revise` work on those that were kept.
    pub fn revise(&mut self, revise: impl FnOnce(&mut Vec<Diagnostic>)) {
        revise(&mut self.all);
    }

    /// The same as plain data, for JSON.
    #[must_use]
    pub fn findings(&self, sources: &Sources) -> Vec<Finding> {
        self.all.iter().map(|d| finding(d, sources)).collect()
    }
}

impl IntoIterator for Diagnostics {
    type Item = Diagnostic;
    type IntoIter = std::vec::IntoIter<Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.all.into_iter()
    }
}

impl FromIterator<Diagnostic> for Diagnostics {
    fn from_iter<I: IntoIterator<Item = Diagnostic>>(all: I) -> Diagnostics {
        let mut diagnostics = Diagnostics::new();
        all.into_iter().for_each(|d| diagnostics.push(d));
        diagnostics
    }
}

fn finding(diagnostic: &Diagnostic, sources: &Sources) -> Finding {
    let span = diagnostic.primary.as_ref().map(|p| p.span);
    Finding {
        file: span.map_or(String::new(), |s| sources.name(s.source).to_owned()),
        location: span.map(|s| sources.start(s)),
        severity: diagnostic.severity.name(),
        code: diagnostic.code,
        message: diagnostic.message.clone(),
        hints: diagnostic.hints.clone(),
    }
}
