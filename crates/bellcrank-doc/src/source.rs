//! Texts that were read, and places in them.

/// One text of a [`Sources`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SourceId(u32);

/// A range of bytes in one source; both ends lie on character boundaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The text.
    pub source: SourceId,
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    /// The bytes `start..end` of `source`.
    #[must_use]
    pub fn new(source: SourceId, start: usize, end: usize) -> Span {
        Span { source, start, end: end.max(start) }
    }

    /// The smallest span over both, which must be of one source (else `self`).
    #[must_use]
    pub fn to(self, other: Span) -> Span {
        if self.source != other.source {
            return self;
        }
        Span::new(self.source, self.start.min(other.start), self.end.max(other.end))
    }
}

/// A value and where it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Its place.
    pub span: Span,
}

/// A place as people name it; both numbers count from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Location {
    /// Line.
    pub line: usize,
    /// Column, in characters (not bytes).
    pub column: usize,
}

#[derive(Clone, Debug)]
struct Source {
    name: String,
    text: String,
    /// Byte offset at which each line starts; the first is 0.
    lines: Vec<usize>,
    /// The file began with a byte order mark, which is not part of the text.
    marked: bool,
}

/// All texts of a run: model files, subsystem files, pieces of the command line.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    all: Vec<Source>,
}

impl Sources {
    /// No texts yet.
    #[must_use]
    pub fn new() -> Sources {
        Sources::default()
    }

    /// Keeps `text` under `name` (a path as the user gave it, or `--set`).
    pub fn add(&mut self, name: impl Into<String>, text: impl Into<String>) -> SourceId {
        let text = text.into();
        let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(i, _)| i + 1)).collect();
        self.all.push(Source { name: name.into(), text, lines, marked: false });
        SourceId(u32::try_from(self.all.len() - 1).unwrap_or(u32::MAX))
    }

    /// Name of a text; empty for an id of another collection.
    #[must_use]
    pub fn name(&self, id: SourceId) -> &str {
        self.get(id).map_or("", |s| &s.name)
    }

    /// The whole text; empty for an id of another collection.
    #[must_use]
    pub fn text(&self, id: SourceId) -> &str {
        self.get(id).map_or("", |s| &s.text)
    }

    /// The text of a span; empty when the span does not fit its text.
    #[must_use]
    pub fn slice(&self, span: Span) -> &str {
        self.text(span.source).get(span.start..span.end).unwrap_or("")
    }

    /// Whether the file began with a byte order mark, which its text is without.
    #[must_use]
    pub fn is_marked(&self, id: SourceId) -> bool {
        self.get(id).is_some_and(|s| s.marked)
    }

    pub(crate) fn mark(&mut self, id: SourceId) {
        if let Some(source) = self.all.get_mut(id.0 as usize) {
            source.marked = true;
        }
    }

    /// A span over the whole text.
    #[must_use]
    pub fn whole(&self, id: SourceId) -> Span {
        Span::new(id, 0, self.text(id).len())
    }

    /// Line and column of a byte; O(log lines + line length).
    #[must_use]
    pub fn location(&self, id: SourceId, offset: usize) -> Location {
        let line = self.line_index(id, offset);
        let start = self.line_start(id, line);
        let before = self.text(id).get(start..offset).unwrap_or("");
        Location { line: line + 1, column: before.chars().count() + 1 }
    }

    /// Line and column at which a span starts.
    #[must_use]
    pub fn start(&self, span: Span) -> Location {
        self.location(span.source, span.start)
    }

    /// Number (from 0) of the line that holds the byte.
    pub(crate) fn line_index(&self, id: SourceId, offset: usize) -> usize {
        self.get(id).map_or(0, |s| s.lines.partition_point(|&start| start <= offset).max(1) - 1)
    }

    /// Byte at which a line (from 0) starts.
    pub(crate) fn line_start(&self, id: SourceId, line: usize) -> usize {
        self.get(id).and_then(|s| s.lines.get(line).copied()).unwrap_or(0)
    }

    /// A line (from 0) without its end-of-line characters.
    pub(crate) fn line(&self, id: SourceId, line: usize) -> &str {
        let Some(source) = self.get(id) else {
            return "";
        };
        let start = self.line_start(id, line);
        let end = source.lines.get(line + 1).map_or(source.text.len(), |&next| next - 1);
        let text = source.text.get(start..end).unwrap_or("");
        text.strip_suffix('\r').unwrap_or(text)
    }

    fn get(&self, id: SourceId) -> Option<&Source> {
        self.all.get(id.0 as usize)
    }
}
