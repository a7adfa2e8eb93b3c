//! Diagnostics as text for people.

use std::fmt::Write;

use crate::{Diagnostic, Diagnostics, Label, Location, Severity, Sources};

/// Diagnostics shown in full; the rest is counted.
pub const RENDER_LIMIT: usize = 50;
/// Characters of a source line that are shown.
const WINDOW: usize = 100;
/// Characters kept before the label of a line that is cut.
const LEAD: usize = 40;
/// Characters of a message or label that are shown; names come from files and may be of any length.
const MESSAGE_LIMIT: usize = 500;

impl Diagnostics {
    /// All of them (at most [`RENDER_LIMIT`]) with source lines, carets and hints; ANSI colours
    /// only when asked.
    #[must_use]
    pub fn render(&self, sources: &Sources, color: bool) -> String {
        let paint = Paint { color };
        let mut out = String::new();
        for diagnostic in self.iter().take(RENDER_LIMIT) {
            if !out.is_empty() {
                out.push('\n');
            }
            render_one(&mut out, diagnostic, sources, paint);
        }
        if self.len() > RENDER_LIMIT {
            let _ = writeln!(out, "\n... and {} more", self.len() - RENDER_LIMIT);
        }
        out
    }
}

fn render_one(out: &mut String, diagnostic: &Diagnostic, sources: &Sources, paint: Paint) {
    let severity = paint.severity(diagnostic.severity);
    let _ = writeln!(out, "{severity}{}", paint.bold(&format!(": {}", visible(&diagnostic.message))));
    let gutter = gutter_width(diagnostic, sources);
    for snippet in snippets(diagnostic, sources) {
        render_snippet(out, &snippet, sources, gutter, paint);
    }
    for hint in &diagnostic.hints {
        let _ = writeln!(out, "{}: {}", paint.hint("hint"), visible(hint));
    }
}

/// A label with its place resolved.
struct Mark<'a> {
    label: &'a Label,
    place: Location,
    primary: bool,
}

/// The marks on one line of one source.
struct Snippet<'a> {
    marks: Vec<Mark<'a>>,
}

/// Marks by line, the primary line first, the rest in their order.
fn snippets<'a>(diagnostic: &'a Diagnostic, sources: &Sources) -> Vec<Snippet<'a>> {
    let mut snippets: Vec<Snippet<'a>> = Vec::new();
    for (label, primary) in labels(diagnostic) {
        let mark = Mark { label, place: sources.start(label.span), primary };
        let same = |s: &&mut Snippet<'_>| {
            s.marks.first().is_some_and(|m| m.label.span.source == label.span.source && m.place.line == mark.place.line)
        };
        match snippets.iter_mut().find(same) {
            Some(snippet) => snippet.marks.push(mark),
            None => snippets.push(Snippet { marks: vec![mark] }),
        }
    }
    snippets
}

fn labels(diagnostic: &Diagnostic) -> impl Iterator<Item = (&Label, bool)> {
    let primary = diagnostic.primary.iter().map(|l| (&**l, true));
    primary.chain(diagnostic.secondary.iter().map(|l| (l, false)))
}

fn gutter_width(diagnostic: &Diagnostic, sources: &Sources) -> usize {
    let lines = labels(diagnostic).map(|(l, _)| sources.start(l.span).line);
    lines.max().map_or(1, |line| line.to_string().len()).max(2)
}

fn render_snippet(out: &mut String, snippet: &Snippet<'_>, sources: &Sources, gutter: usize, paint: Paint) {
    let Some(first) = snippet.marks.first() else { return };
    let source = first.label.span.source;
    let Location { line, column } = first.place;
    let name = visible(sources.name(source));
    let _ = writeln!(out, "{:gutter$} {} {name}:{line}:{column}", "", paint.frame("┌─"));
    if sources.text(source).is_empty() {
        return;
    }
    let shown = ShownLine::new(sources.line(source, line - 1), column - 1);
    let number = format!("{line:>gutter$}");
    let _ = writeln!(out, "{} {} {}", paint.frame(&number), paint.frame("│"), shown.text);
    for mark in &snippet.marks {
        let length = sources.slice(mark.label.span).chars().take_while(|&c| c != '\n').count();
        let (indent, width) = shown.extent(mark.place.column - 1, length);
        let carets = if mark.primary { "^" } else { "-" }.repeat(width);
        let words = visible(&mark.label.message);
        let text = format!("{carets} {words}");
        let text = paint.mark(text.trim_end(), mark.primary);
        let _ = writeln!(out, "{:gutter$} {} {:indent$}{text}", "", paint.frame("│"), "");
    }
}

/// The part of a source line that is shown, with the screen column of each of its characters.
struct ShownLine {
    text: String,
    /// First character of the line that is shown.
    from: usize,
    /// Screen column at which each shown character starts, and the end.
    columns: Vec<usize>,
}

impl ShownLine {
    /// Cuts the line around the character number `focus` when it is too long.
    fn new(line: &str, focus: usize) -> ShownLine {
        let length = line.chars().count();
        let from = if length <= WINDOW { 0 } else { focus.saturating_sub(LEAD).min(length - WINDOW) };
        let mut text = if from > 0 { "…".to_owned() } else { String::new() };
        let mut column = usize::from(from > 0);
        let mut columns = vec![column];
        for c in line.chars().skip(from).take(WINDOW) {
            let shown = visible_char(c);
            column += shown.chars().map(width).sum::<usize>();
            columns.push(column);
            text.push_str(&shown);
        }
        if from + WINDOW < length {
            text.push('…');
        }
        ShownLine { text: text.trim_end().to_owned(), from, columns }
    }

    /// Screen column and width of `length` characters from number `start`.
    fn extent(&self, start: usize, length: usize) -> (usize, usize) {
        let at = |i: usize| {
            let i = i.saturating_sub(self.from).min(self.columns.len() - 1);
            self.columns.get(i).copied().unwrap_or(0)
        };
        let from = at(start);
        (from, at(start + length).saturating_sub(from).max(1))
    }
}

/// Text in which nothing can steer the terminal, cut to a readable length.
fn visible(text: &str) -> String {
    let mut shown: String = text.chars().take(MESSAGE_LIMIT).map(visible_char).collect();
    if text.chars().nth(MESSAGE_LIMIT).is_some() {
        shown.push('…');
    }
    shown
}

fn visible_char(c: char) -> String {
    match c {
        '\t' => "    ".to_owned(),
        '\u{7f}' => "␡".to_owned(),
        '\0'..='\u{1f}' => char::from_u32(0x2400 + u32::from(c)).unwrap_or('?').to_string(),
        _ if c.is_control() || is_invisible(c) => format!("\\u{{{:x}}}", u32::from(c)),
        _ => c.to_string(),
    }
}

/// Zero-width and direction-changing characters: they would make the shown line lie.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// Screen columns of a character: 2 for East Asian wide ones and pictographs.
fn width(c: char) -> usize {
    let wide = matches!(u32::from(c),
        0x1100..=0x115f | 0x2e80..=0xa4cf | 0xac00..=0xd7a3 | 0xf900..=0xfaff | 0xfe30..=0xfe6f
        | 0xff00..=0xff60 | 0xffe0..=0xffe6 | 0x1f300..=0x1faff | 0x20000..=0x3fffd);
    if wide { 2 } else { 1 }
}

/// ANSI colours, or none.
#[derive(Clone, Copy)]
struct Paint {
    color: bool,
}

impl Paint {
    fn with(self, code: &str, text: &str) -> String {
        if self.color { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_owned() }
    }

    fn severity(self, severity: Severity) -> String {
        let code = match severity {
            Severity::Error => "1;31",
            Severity::Warning => "1;33",
        };
        self.with(code, severity.name())
    }

    fn bold(self, text: &str) -> String {
        self.with("1", text)
    }

    fn frame(self, text: &str) -> String {
        self.with("34", text)
    }

    fn hint(self, text: &str) -> String {
        self.with("1;36", text)
    }

    fn mark(self, text: &str, primary: bool) -> String {
        self.with(if primary { "31" } else { "34" }, text)
    }
}

#[cfg(test)]
mod tests;
