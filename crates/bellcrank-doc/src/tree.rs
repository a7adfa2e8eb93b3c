//! The TOML tree: tables in written order, every key and value with its place.

use std::collections::HashMap;

use crate::Span;

/// A value of the tree.
#[derive(Clone, Debug)]
pub struct Value {
    /// What it is.
    pub kind: ValueKind,
    /// Its place: from quote to quote, bracket to bracket; the header (`[bodies.link1]`) of a
    /// table that has one.
    pub span: Span,
}

/// The kinds of values.
#[derive(Clone, Debug)]
pub enum ValueKind {
    /// Text.
    String(Text),
    /// A whole number.
    Integer(i64),
    /// Any other number; may be NaN or infinite, since TOML has them.
    Float(f64),
    /// `true` or `false`.
    Boolean(bool),
    /// A date or time, as written. Model files have no use for one.
    Datetime(String),
    /// A list.
    List(Vec<Value>),
    /// A table, from a header, dotted keys or braces.
    Table(Table),
    /// Stands where something unreadable was; it has been reported, so stay silent about it.
    Faulty,
}

/// Text of a string, and how it lies in the file.
#[derive(Clone, Debug)]
pub struct Text {
    /// The text, escapes resolved.
    pub value: String,
    /// Byte of the file where `value` starts, when `value` stands there character by character
    /// (no escapes).
    pub(crate) origin: Option<usize>,
}

/// Entries in written order, names unique.
#[derive(Clone, Debug)]
pub struct Table {
    pub(crate) entries: Vec<Entry>,
    /// Places of the keys in `entries`, once there are enough of them to need it.
    index: HashMap<String, usize>,
    pub(crate) made_by: MadeBy,
    /// The header, the braces, or the key that made it.
    pub span: Span,
}

/// How a table came about; decides which later parts of the file may add to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MadeBy {
    /// On the way to another: `a` in `[a.b]`.
    Passing,
    /// `[a]`.
    Header,
    /// `a` in `a.b = 1`.
    DottedKey,
    /// `{ ... }`; closed.
    Braces,
}

/// `key = value`.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The key, quotes and escapes resolved.
    pub key: String,
    /// Its place.
    pub key_span: Span,
    /// The value.
    pub value: Value,
}

impl Table {
    /// A table without entries.
    #[must_use]
    pub fn new(span: Span) -> Table {
        Table::made(MadeBy::Header, span)
    }

    pub(crate) fn made(made_by: MadeBy, span: Span) -> Table {
        Table { entries: Vec::new(), index: HashMap::new(), made_by, span }
    }

    /// The entry of a key.
    #[must_use]
    pub fn get(&self, key: &str) -> Option<&Entry> {
        self.position(key).and_then(|i| self.entries.get(i))
    }

    /// Entries in written order.
    pub fn iter(&self) -> std::slice::Iter<'_, Entry> {
        self.entries.iter()
    }

    /// Number of entries.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    pub(crate) fn get_mut(&mut self, key: &str) -> Option<&mut Entry> {
        self.position(key).and_then(|i| self.entries.get_mut(i))
    }

    /// Adds an entry; the key must be new.
    pub(crate) fn insert(&mut self, entry: Entry) {
        if self.entries.is_empty() {
            // Most tables of a hostile file hold one entry; four places for each would be gigabytes.
            self.entries.reserve_exact(1);
        }
        self.entries.push(entry);
        let first = match self.entries.len() {
            0..INDEXED => return,
            INDEXED => 0,
            more => more - 1,
        };
        for (i, entry) in self.entries.iter().enumerate().skip(first) {
            self.index.insert(entry.key.clone(), i);
        }
    }

    fn position(&self, key: &str) -> Option<usize> {
        if self.entries.len() < INDEXED {
            return self.entries.iter().position(|e| e.key == key);
        }
        self.index.get(key).copied()
    }
}

/// Tables of this many entries are found by hash; most are smaller, and searched.
const INDEXED: usize = 16;

impl Value {
    /// What it is, as `a string`.
    #[must_use]
    pub fn describe(&self) -> &'static str {
        match &self.kind {
            ValueKind::String(_) => "a string",
            ValueKind::Integer(_) | ValueKind::Float(_) => "a number",
            ValueKind::Boolean(_) => "true or false",
            ValueKind::Datetime(_) => "a date or time",
            ValueKind::List(_) => "a list",
            ValueKind::Table(_) => "a table",
            ValueKind::Faulty => "something unreadable",
        }
    }

    /// The text of a string.
    #[must_use]
    pub fn as_str(&self) -> Option<&str> {
        match &self.kind {
            ValueKind::String(text) => Some(&text.value),
            _ => None,
        }
    }

    /// The table.
    #[must_use]
    pub fn as_table(&self) -> Option<&Table> {
        match &self.kind {
            ValueKind::Table(table) => Some(table),
            _ => None,
        }
    }

    /// The values of a list.
    #[must_use]
    pub fn as_list(&self) -> Option<&[Value]> {
        match &self.kind {
            ValueKind::List(values) => Some(values),
            _ => None,
        }
    }
}
