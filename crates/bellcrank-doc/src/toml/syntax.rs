//! Syntax errors: collecting them, and saying them in the words of a model's author.

use toml_parser::{ErrorSink, Expected, ParseError};

use crate::{Diagnostic, Diagnostics, SourceId, Span, units};

/// Errors kept; a file with more is no model file, and memory stays bounded.
const MAX_ERRORS: usize = 200;

/// Bytes of a line that are looked at.
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
        if self.all.is_empty() {
            return false;
        }
        // Bounded, for the sake of a file that is one long line.
        let ahead = self.text.as_bytes().iter().skip(end).take(LINE_LIMIT);
        let line_end = end + ahead.take_while(|&&b| b != b'\n').count();
        self.all.iter().filter_map(ParseError::unexpected).any(|s| start <= s.start() && s.start() <= line_end)
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
        let mut message = error.description().to_owned();
        if let Some(expected) = expected(error) {
            message = format!("{message}; expected {expected}");
        }
        let mut diagnostic = Diagnostic::error("syntax", span, message);
        if let Some(opening) = error.context().filter(|c| self.line_end(c.start()) < span.start) {
            diagnostic = diagnostic.also(self.fit(id, opening.start(), opening.end()), "it starts here");
        }
        match self.hint(span) {
            Some(hint) => diagnostic.hint(hint),
            None => diagnostic,
        }
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
    fn hint(&self, span: Span) -> Option<String> {
        let line_start = self.text.get(..span.start)?.rfind('\n').map_or(0, |i| i + 1);
        let line = self.text.get(line_start..self.line_end(span.start))?;
        let (_, value) = line.split_once('=')?;
        let value = value.split('#').next()?.trim();
        let bare = !value.is_empty() && !value.contains(['"', '\'', '[', '{', '=']);
        if !bare || value.len() > 60 {
            return None;
        }
        let starts_number = value.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        let word = value.rsplit(|c: char| c.is_whitespace() || c.is_ascii_digit()).next().unwrap_or("");
        let kind =
            if starts_number && units::single(word).is_some() { "a value with a unit" } else { "a text or expression" };
        Some(format!("{kind} stands in quotes: `\"{value}\"`"))
    }
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
        Expected::Literal(literal) => Some(format!("`{}`", literal.escape_debug())),
        Expected::Description(words) => Some((*words).to_owned()),
        _ => None,
    }
}
