//! Syntax errors: collecting them, and saying them in the words of a model's author.

use toml_parser::{ErrorSink, Expected, ParseError};

use crate::{Diagnostic, Diagnostics, SourceId, Span, units};

/// Errors kept; a file with more is no model file, and memory stays bounded.
const MAX_ERRORS: usize = 200;

/// Bytes after a value in which an error casts doubt on it; bounded, for the sake of a file that
/// is one long line.
const LINE_LIMIT: usize = 4096;

/// The syntax errors of one text.
pub(super) struct Errors<'t> {
    text: &'t str,
    all: Vec<ParseError>,
}

impl ErrorSink for Errors<'_> {
    fn report_error(&mut self, error: ParseError) {
        if self.all.len() < MAX_ERRORS {
            self.all.push(error);
        }
    }
}

impl<'t> Errors<'t> {
    pub(super) fn new(text: &'t str) -> Errors<'t> {
        Errors { text, all: Vec::new() }
    }

    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether one of them lies between a byte and the end of its line: what was read there may
    /// not be what was meant.
    pub(super) fn touch(&self, start: usize, end: usize) -> bool {
        let near = |at: &usize| (start..end + LINE_LIMIT).contains(at);
        let mut starts = self.all.iter().filter_map(ParseError::unexpected).map(|s| s.start()).filter(near);
        starts.any(|at| at < end || !self.text.as_bytes().get(end..at).unwrap_or_default().contains(&b'\n'))
    }

    /// One diagnostic a line: the first error of a line is the one that explains it.
    pub(super) fn report(mut self, id: SourceId, diagnostics: &mut Diagnostics) {
        self.all.sort_by_key(|e| e.unexpected().map_or(0, |s| s.start()));
        let mut last_end = None;
        for error in &self.all {
            let span = self.span(id, error);
            if last_end.is_none_or(|end| span.start > end) {
                diagnostics.push(self.diagnostic(error, span, id));
                last_end = Some(self.line_end(span.start));
            }
        }
    }

    fn line_end(&self, at: usize) -> usize {
        self.text.get(at..).and_then(|t| t.find('\n')).map_or(self.text.len(), |i| at + i)
    }

    fn diagnostic(&self, error: &ParseError, span: Span, id: SourceId) -> Diagnostic {
        let said = error.description();
        let message = match (plain_words(said), expected(error)) {
            (Some(plain), _) => plain.to_owned(),
            (None, Some(expected)) => format!("{said}; expected {expected}"),
            (None, None) => said.to_owned(),
        };
        let mut diagnostic = Diagnostic::error("syntax", span, message);
        let explains =
            |opening: &toml_parser::Span| said.starts_with("unclosed") || self.line_end(opening.start()) < span.start;
        if let Some(opening) = error.context().filter(explains) {
            diagnostic = diagnostic.also(self.fit(id, opening.start(), opening.end()), "it starts here");
        }
        if said == UNQUOTED { diagnostic.hint(self.quoting_hint(span)) } else { diagnostic }
    }

    /// The place of an error, moved onto character boundaries and off an end of line.
    fn span(&self, id: SourceId, error: &ParseError) -> Span {
        let place = error.unexpected().or(error.context());
        place.map_or(Span::new(id, 0, 0), |s| self.fit(id, s.start(), s.end()))
    }

    fn fit(&self, id: SourceId, start: usize, end: usize) -> Span {
        let floor = |i: usize| (0..=i.min(self.text.len())).rev().find(|&i| self.text.is_char_boundary(i));
        let (start, end) = (floor(start).unwrap_or(0), floor(end).unwrap_or(0));
        Span::new(id, start, end)
    }

    /// The commonest slip: a value with a unit, or an expression, without its quotes.
    fn quoting_hint(&self, span: Span) -> String {
        let value = self.text.get(span.start..span.end).unwrap_or("").trim();
        if value.starts_with(['\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}', '\u{ab}']) {
            return "these are the quotation marks of a text editor; write straight ones: `\"`".to_owned();
        }
        let starts_number = value.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        let word = value.find(|c: char| c.is_alphabetic()).and_then(|i| value.get(i..)).unwrap_or("");
        let unit = word.split(|c: char| !c.is_alphabetic()).next().unwrap_or("");
        let has_unit = starts_number && units::single(unit).is_some();
        let kind = if has_unit { "a value with a unit stands" } else { "texts and expressions stand" };
        format!("{kind} in quotes: `\"{value}\"`")
    }
}

/// What `toml_parser` says of text where a value should be.
const UNQUOTED: &str = "string values must be quoted";

/// Its sentences that a model's author would not understand, in better words.
fn plain_words(description: &str) -> Option<&'static str> {
    Some(match description {
        UNQUOTED => "this is no value",
        "invalid basic string" | "invalid literal string" => {
            "this string is not closed on its line, or holds what it may not"
        }
        "missing comma between key-value pairs" => "a comma is missing, or a `}` before this",
        "missing comma between array elements" => "a comma is missing, or a `]` before this",
        "unclosed inline table" => "this `{` is never closed",
        "unclosed array" => "this `[` is never closed",
        "unquoted keys cannot be empty" => "a name is missing",
        "cannot recurse further; max recursion depth met" => "brackets are nested too deep",
        _ => return None,
    })
}

fn expected(error: &ParseError) -> Option<String> {
    let words: Vec<String> = error.expected()?.iter().filter_map(word).collect();
    match words.as_slice() {
        [] => None,
        [one] => Some(one.clone()),
        [most @ .., last] => Some(format!("{} or {last}", most.join(", "))),
    }
}

fn word(expected: &Expected) -> Option<String> {
    match expected {
        Expected::Literal("\n") => Some("the end of the line".to_owned()),
        Expected::Literal(literal) => Some(format!("`{literal}`")),
        Expected::Description(words) => Some((*words).to_owned()),
        _ => None,
    }
}
