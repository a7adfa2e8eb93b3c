//! From events to tables.

use toml_parser::decoder::ScalarKind;
use toml_parser::parser::{Event, EventKind};

use super::syntax::Errors;
use crate::tree::MadeBy;
use crate::{Diagnostic, Diagnostics, Entry, SourceId, Span, Spanned, Table, Text, Value, ValueKind};

/// Longest dotted key; a deeper tree would only be there to break its readers.
const MAX_KEYS: usize = 16;

type Key = Spanned<String>;

pub(super) struct Builder<'t> {
    id: SourceId,
    source: toml_parser::Source<'t>,
    errors: Errors<'t>,
    diagnostics: Diagnostics,
    root: Table,
    /// Keys of the table that entries go to; `None` after a header that is in error.
    current: Option<Vec<Key>>,
    /// Takes the entries that have nowhere to go.
    lost: Table,
}

/// The events not read yet.
struct Cursor<'e> {
    events: &'e [Event],
}

impl<'e> Cursor<'e> {
    fn peek(&self) -> Option<EventKind> {
        self.events.first().map(Event::kind)
    }

    fn next(&mut self) -> Option<&'e Event> {
        let (first, rest) = self.events.split_first()?;
        self.events = rest;
        Some(first)
    }

    fn skip_blank(&mut self) {
        use EventKind::{Comment, Newline, Whitespace};
        while matches!(self.peek(), Some(Whitespace | Comment | Newline)) {
            self.next();
        }
    }

    fn skip_spaces(&mut self) {
        while self.peek() == Some(EventKind::Whitespace) {
            self.next();
        }
    }
}

impl<'t> Builder<'t> {
    pub(super) fn new(id: SourceId, source: toml_parser::Source<'t>, errors: Errors<'t>) -> Builder<'t> {
        let whole = Span::new(id, 0, source.input().len());
        let (root, lost) = (Table::new(whole), Table::new(whole));
        Builder { id, source, errors, diagnostics: Diagnostics::new(), root, current: Some(Vec::new()), lost }
    }

    pub(super) fn finish(self) -> (Table, Errors<'t>, Diagnostics) {
        (self.root, self.errors, self.diagnostics)
    }

    pub(super) fn document(&mut self, events: &[Event]) {
        let mut cursor = Cursor { events };
        while let Some(kind) = cursor.peek() {
            match kind {
                EventKind::StdTableOpen | EventKind::ArrayTableOpen => self.header(&mut cursor),
                EventKind::SimpleKey => self.assignment(&mut cursor),
                _ => {
                    cursor.next();
                }
            }
        }
    }

    /// `[a.b]` or `[[a.b]]`.
    fn header(&mut self, cursor: &mut Cursor<'_>) {
        let Some(open) = cursor.next() else { return };
        let mut span = self.span(open);
        let mut keys = Vec::new();
        while let Some(kind) = cursor.peek() {
            match kind {
                EventKind::SimpleKey => keys = self.keys(cursor),
                EventKind::StdTableClose | EventKind::ArrayTableClose => {
                    span = cursor.next().map_or(span, |close| span.to(self.span(close)));
                    break;
                }
                EventKind::Newline => break,
                _ => {
                    cursor.next();
                }
            }
        }
        self.lost = Table::new(span);
        let is_list = open.kind() == EventKind::ArrayTableOpen;
        self.current = self.open_table(&keys, span, is_list).then_some(keys);
    }

    /// Makes the table of a header; whether entries may go into it.
    fn open_table(&mut self, keys: &[Key], span: Span, is_list: bool) -> bool {
        let Some((last, path)) = keys.split_last() else { return false };
        let Some(parent) = descend(&mut self.root, path, MadeBy::Passing) else {
            self.report_not_table(path, last);
            return false;
        };
        let parent_name = path.last().map(|k| k.value.as_str());
        let outcome = if is_list { open_list(parent, last, span) } else { open_single(parent, last, span) };
        match outcome {
            Ok(()) => true,
            Err(first) => {
                self.diagnostics.push(repeated(parent_name, last, first));
                false
            }
        }
    }

    /// `a.b = value` at the level of lines.
    fn assignment(&mut self, cursor: &mut Cursor<'_>) {
        let keys = self.keys(cursor);
        let Some(value) = self.assigned(cursor) else { return };
        let mut root = std::mem::replace(&mut self.root, Table::new(value.span));
        let mut lost = std::mem::replace(&mut self.lost, Table::new(value.span));
        let current = self.current.clone().unwrap_or_default();
        let known = self.current.is_some();
        let table = if known { descend(&mut root, &current, MadeBy::Passing) } else { Some(&mut lost) };
        if let Some(table) = table {
            self.insert(table, current.last().map(|k| k.value.as_str()), keys, value);
        }
        self.root = root;
        self.lost = lost;
    }

    /// `= value` after a key; `None` when either is missing (which has been reported).
    fn assigned(&mut self, cursor: &mut Cursor<'_>) -> Option<Value> {
        cursor.skip_spaces();
        if cursor.peek() != Some(EventKind::KeyValSep) {
            return None;
        }
        cursor.next();
        cursor.skip_spaces();
        self.value(cursor)
    }

    /// Puts a value where its keys say.
    fn insert(&mut self, table: &mut Table, name: Option<&str>, keys: Vec<Key>, value: Value) {
        let Some((last, path)) = keys.split_last() else { return };
        let Some(parent) = descend(table, path, MadeBy::DottedKey) else {
            self.report_not_table(path, last);
            return;
        };
        let name = path.last().map(|k| k.value.as_str()).or(name);
        match parent.get(&last.value) {
            Some(first) => self.diagnostics.push(repeated(name, last, first.key_span)),
            None => parent.insert(entry(last, value)),
        }
    }

    fn report_not_table(&mut self, path: &[Key], last: &Key) {
        let dotted: Vec<&str> = path.iter().map(|k| k.value.as_str()).collect();
        let message = format!("`{}` is complete elsewhere and cannot take `{}` here", dotted.join("."), last.value);
        let span = path.last().map_or(last.span, |k| k.span);
        self.diagnostics.push(Diagnostic::error("not-a-table", span, message).hint("put all its keys in one place"));
    }

    /// The parts of a dotted key.
    fn keys(&mut self, cursor: &mut Cursor<'_>) -> Vec<Key> {
        let mut keys = Vec::new();
        while let Some(kind) = cursor.peek() {
            match kind {
                EventKind::SimpleKey | EventKind::KeySep | EventKind::Whitespace => {
                    if let Some(event) = cursor.next().filter(|e| e.kind() == EventKind::SimpleKey) {
                        keys.push(self.key(event));
                    }
                }
                _ => break,
            }
        }
        if keys.len() > MAX_KEYS {
            let span = keys.first().map_or(Span::new(self.id, 0, 0), |k| k.span);
            let message = format!("a key of {} parts; at most {MAX_KEYS} are read", keys.len());
            self.diagnostics.push(Diagnostic::error("key-too-deep", span, message));
            keys.clear();
        }
        keys
    }

    fn key(&mut self, event: &Event) -> Key {
        let mut value = std::borrow::Cow::Borrowed("");
        if let Some(raw) = self.source.get(event) {
            raw.decode_key(&mut value, &mut self.errors);
        }
        Spanned { value: value.into_owned(), span: self.span(event) }
    }

    /// Any value. Recursion is bounded by `MAX_DEPTH` of the event parser.
    fn value(&mut self, cursor: &mut Cursor<'_>) -> Option<Value> {
        match cursor.peek()? {
            EventKind::Scalar => cursor.next().map(|event| self.scalar(event)),
            EventKind::ArrayOpen => cursor.next().map(|open| self.list(open, cursor)),
            EventKind::InlineTableOpen => cursor.next().map(|open| self.inline_table(open, cursor)),
            _ => None,
        }
    }

    fn list(&mut self, open: &Event, cursor: &mut Cursor<'_>) -> Value {
        let mut span = self.span(open);
        let mut values = Vec::new();
        while let Some(kind) = cursor.peek() {
            match kind {
                EventKind::ArrayClose => {
                    span = cursor.next().map_or(span, |close| span.to(self.span(close)));
                    break;
                }
                EventKind::Scalar | EventKind::ArrayOpen | EventKind::InlineTableOpen => {
                    values.extend(self.value(cursor));
                }
                // The bracket was never closed.
                EventKind::StdTableOpen | EventKind::ArrayTableOpen => break,
                _ => {
                    cursor.next();
                }
            }
        }
        Value { kind: ValueKind::List(values), span }
    }

    fn inline_table(&mut self, open: &Event, cursor: &mut Cursor<'_>) -> Value {
        let mut span = self.span(open);
        let mut table = Table::made(MadeBy::Braces, span);
        while let Some(kind) = cursor.peek() {
            match kind {
                EventKind::InlineTableClose => {
                    span = cursor.next().map_or(span, |close| span.to(self.span(close)));
                    break;
                }
                EventKind::SimpleKey => {
                    let keys = self.keys(cursor);
                    cursor.skip_blank();
                    if let Some(value) = self.assigned(cursor) {
                        self.insert(&mut table, None, keys, value);
                    }
                }
                EventKind::StdTableOpen | EventKind::ArrayTableOpen => break,
                _ => {
                    cursor.next();
                }
            }
        }
        table.span = span;
        seal(&mut table);
        Value { kind: ValueKind::Table(table), span }
    }

    fn scalar(&mut self, event: &Event) -> Value {
        let span = self.span(event);
        let Some(raw) = self.source.get(event) else {
            return Value { kind: ValueKind::Faulty, span };
        };
        let before = self.errors.len();
        let mut decoded = std::borrow::Cow::Borrowed("");
        let kind = raw.decode_scalar(&mut decoded, &mut self.errors);
        if self.errors.len() > before || self.errors.touch(span.start, span.end) {
            return Value { kind: ValueKind::Faulty, span };
        }
        let kind = match kind {
            ScalarKind::String => ValueKind::String(text(decoded.into_owned(), raw.as_str(), span)),
            ScalarKind::Boolean(value) => ValueKind::Boolean(value),
            ScalarKind::DateTime => ValueKind::Datetime(decoded.into_owned()),
            ScalarKind::Float => decoded.parse().map_or(ValueKind::Faulty, ValueKind::Float),
            ScalarKind::Integer(radix) => integer(&decoded, radix.value()),
        };
        Value { kind, span }
    }

    fn span(&self, event: &Event) -> Span {
        Span::new(self.id, event.span().start(), event.span().end())
    }
}

/// A whole number; one beyond 64 bits becomes a float, for the reader to judge its size.
fn integer(digits: &str, radix: u32) -> ValueKind {
    match i64::from_str_radix(digits, radix) {
        Ok(value) => ValueKind::Integer(value),
        Err(_) => digits.parse().map_or(ValueKind::Float(f64::INFINITY), ValueKind::Float),
    }
}

/// The text of a string with its place, if it stands in the file as it is.
fn text(value: String, raw: &str, span: Span) -> Text {
    let quotes = if raw.starts_with("\"\"\"") || raw.starts_with("'''") { 3 } else { 1 };
    let inner = raw.get(quotes..raw.len().saturating_sub(quotes)).unwrap_or("");
    // A newline right after the opening quotes of a multi-line string is not part of it.
    let skipped = inner.len().saturating_sub(value.len());
    let exact =
        inner.get(skipped..) == Some(value.as_str()) && inner.get(..skipped).is_some_and(|s| s.trim().is_empty());
    Text { value, origin: exact.then_some(span.start + quotes + skipped) }
}

fn entry(key: &Key, value: Value) -> Entry {
    Entry { key: key.value.clone(), key_span: key.span, value }
}

/// The table at `path` below `table`; missing ones are made. `None` when a value or a closed table
/// is in the way.
fn descend<'a>(mut table: &'a mut Table, path: &[Key], made_by: MadeBy) -> Option<&'a mut Table> {
    for key in path {
        if table.get(&key.value).is_none() {
            let value = ValueKind::Table(Table::made(made_by, key.span));
            table.insert(entry(key, Value { kind: value, span: key.span }));
        }
        table = match &mut table.get_mut(&key.value)?.value.kind {
            ValueKind::Table(inner) if may_add(inner, made_by) => inner,
            ValueKind::List(elements) => match elements.last_mut().map(|v| &mut v.kind) {
                Some(ValueKind::Table(last)) if last.made_by == MadeBy::Header => last,
                _ => return None,
            },
            _ => return None,
        };
    }
    Some(table)
}

/// Headers reach through everything but braces; dotted keys only into what dotted keys made.
fn may_add(table: &Table, made_by: MadeBy) -> bool {
    match made_by {
        MadeBy::DottedKey => matches!(table.made_by, MadeBy::DottedKey | MadeBy::Passing),
        _ => table.made_by != MadeBy::Braces,
    }
}

/// Opens `[parent.key]`; `Err` is the place that has the name already.
fn open_single(parent: &mut Table, key: &Key, span: Span) -> Result<(), Span> {
    let Some(existing) = parent.get_mut(&key.value) else {
        let table = Table::made(MadeBy::Header, span);
        parent.insert(entry(key, Value { kind: ValueKind::Table(table), span }));
        return Ok(());
    };
    match &mut existing.value.kind {
        ValueKind::Table(table) if table.made_by == MadeBy::Passing => {
            table.made_by = MadeBy::Header;
            table.span = span;
            existing.value.span = span;
            existing.key_span = key.span;
            Ok(())
        }
        _ => Err(existing.key_span),
    }
}

/// Adds an element to `[[parent.key]]`; `Err` is the place that has the name for something else.
fn open_list(parent: &mut Table, key: &Key, span: Span) -> Result<(), Span> {
    let element = Value { kind: ValueKind::Table(Table::made(MadeBy::Header, span)), span };
    let Some(existing) = parent.get_mut(&key.value) else {
        parent.insert(entry(key, Value { kind: ValueKind::List(vec![element]), span }));
        return Ok(());
    };
    match &mut existing.value.kind {
        ValueKind::List(elements)
            if elements.last().and_then(Value::as_table).is_some_and(|t| t.made_by == MadeBy::Header) =>
        {
            elements.push(element);
            Ok(())
        }
        _ => Err(existing.key_span),
    }
}

/// Closes an inline table and all that its dotted keys made.
fn seal(table: &mut Table) {
    table.made_by = MadeBy::Braces;
    for entry in &mut table.entries {
        if let ValueKind::Table(inner) = &mut entry.value.kind
            && inner.made_by != MadeBy::Braces
        {
            seal(inner);
        }
    }
}

/// `two bodies are named ...` where the table holds named things, else `... is given twice`.
fn repeated(parent: Option<&str>, key: &Key, first: Span) -> Diagnostic {
    let plural = match parent {
        Some(
            name @ ("bodies" | "joints" | "forces" | "motions" | "studies" | "parameters" | "points" | "subsystems"
            | "materials" | "solids"),
        ) => Some(name),
        _ => None,
    };
    let message = match plural {
        Some(things) => format!("two {things} are named `{}`", key.value),
        None => format!("`{}` is given twice", key.value),
    };
    Diagnostic::error("duplicate-name", key.span, message).label("again here").also(first, "first here")
}
