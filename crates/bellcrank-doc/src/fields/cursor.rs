//! One table, key by key.

use std::cell::RefCell;
use std::ops::RangeInclusive;

use super::Reader;
use super::reader::quoted;
use crate::{Diagnostic, Dimension, Entry, Expression, Signals, Span, Spanned, Table, Value, ValueKind, nearest};

/// What to write where a key is absent.
type Hints = Box<dyn Fn(&str) -> Option<String>>;

/// A cursor over one table. Every getter marks its key as known; [`Fields::finish`] reports the
/// keys that nobody asked for.
///
/// All getters return `None` both when the key is absent and when its value is wrong; a wrong
/// value is always reported, an absent one by the getters that do not start with `optional_`.
/// Absent keys are reported when the cursor is finished or dropped, for only then is it known
/// whether a misspelt key stands for them.
pub struct Fields<'a> {
    reader: &'a Reader<'a>,
    table: &'a Table,
    what: String,
    known: RefCell<Vec<&'static str>>,
    missing: RefCell<Vec<&'static str>>,
    hints: Hints,
    other_words: &'static [(&'static str, &'static str)],
}

impl<'a> Fields<'a> {
    /// A cursor; `what` names the table in messages, as "joint `B`".
    #[must_use]
    pub fn new(reader: &'a Reader<'a>, table: &'a Table, what: impl Into<String>) -> Fields<'a> {
        Fields {
            reader,
            table,
            what: what.into(),
            known: RefCell::default(),
            missing: RefCell::default(),
            hints: Box::new(|_| None),
            other_words: &[],
        }
    }

    /// Other words for keys, each with the key that is meant where this table has it.
    #[must_use]
    pub fn with_other_words(mut self, words: &'static [(&'static str, &'static str)]) -> Fields<'a> {
        self.other_words = words;
        self
    }

    /// What to write where a required key is absent, by key.
    #[must_use]
    pub fn with_hints(mut self, hints: impl Fn(&str) -> Option<String> + 'static) -> Fields<'a> {
        self.hints = Box::new(hints);
        self
    }

    /// The shared reader.
    #[must_use]
    pub fn reader(&self) -> &'a Reader<'a> {
        self.reader
    }

    /// The table.
    #[must_use]
    pub fn table(&self) -> &'a Table {
        self.table
    }

    /// The name of the table in messages.
    #[must_use]
    pub fn what(&self) -> &str {
        &self.what
    }

    /// Place of the table: header, braces or key.
    #[must_use]
    pub fn span(&self) -> Span {
        self.table.span
    }

    /// Whether the key is there (marks it as known).
    pub fn has(&self, key: &'static str) -> bool {
        self.optional_entry(key).is_some()
    }

    /// The raw entry, marked as known; no report when absent.
    pub fn optional_entry(&self, key: &'static str) -> Option<&'a Entry> {
        let mut known = self.known.borrow_mut();
        if !known.contains(&key) {
            known.push(key);
        }
        self.table.get(key)
    }

    /// The raw value, marked as known; no report when absent.
    pub fn optional_value(&self, key: &'static str) -> Option<&'a Value> {
        self.optional_entry(key).map(|entry| &entry.value)
    }

    /// The raw value; an absent one is reported.
    pub fn value(&self, key: &'static str) -> Option<&'a Value> {
        let value = self.optional_value(key);
        let mut missing = self.missing.borrow_mut();
        if value.is_none() && !missing.contains(&key) {
            missing.push(key);
        }
        value
    }

    /// The name of a value in messages: "`length` of joint `B`".
    fn name(&self, key: &str) -> String {
        format!("`{key}` of {}", self.what)
    }

    /// A value of the given dimension over the parameters.
    pub fn quantity(&self, key: &'static str, dimension: Dimension) -> Option<Expression> {
        self.reader.quantity(self.value(key)?, &self.name(key), dimension)
    }

    /// The same, which may be absent.
    pub fn optional_quantity(&self, key: &'static str, dimension: Dimension) -> Option<Expression> {
        self.reader.quantity(self.optional_value(key)?, &self.name(key), dimension)
    }

    /// A value over the parameters and signals.
    pub fn signal_quantity(
        &self,
        key: &'static str,
        dimension: Dimension,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        self.reader.signal_quantity(self.value(key)?, &self.name(key), dimension, signals)
    }

    /// The same, which may be absent.
    pub fn optional_signal_quantity(
        &self,
        key: &'static str,
        dimension: Dimension,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        self.reader.signal_quantity(self.optional_value(key)?, &self.name(key), dimension, signals)
    }

    /// A list of values, one for each of `dimensions`.
    pub fn vector(&self, key: &'static str, dimensions: &[Dimension]) -> Option<Vec<Expression>> {
        self.reader.vector(self.value(key)?, &self.name(key), dimensions)
    }

    /// The same, which may be absent.
    pub fn optional_vector(&self, key: &'static str, dimensions: &[Dimension]) -> Option<Vec<Expression>> {
        self.reader.vector(self.optional_value(key)?, &self.name(key), dimensions)
    }

    /// A list of values of one dimension, as many as one of `lengths` (inertia: 3 or 6).
    pub fn uniform_vector(
        &self,
        key: &'static str,
        dimension: Dimension,
        lengths: &[usize],
    ) -> Option<Vec<Expression>> {
        self.reader.uniform_vector(self.value(key)?, &self.name(key), dimension, lengths)
    }

    /// The same, which may be absent.
    pub fn optional_uniform_vector(
        &self,
        key: &'static str,
        dimension: Dimension,
        lengths: &[usize],
    ) -> Option<Vec<Expression>> {
        self.reader.uniform_vector(self.optional_value(key)?, &self.name(key), dimension, lengths)
    }

    /// A vector over the parameters and signals.
    pub fn signal_vector(
        &self,
        key: &'static str,
        dimensions: &[Dimension],
        signals: &mut dyn Signals,
    ) -> Option<Vec<Expression>> {
        self.reader.signal_vector(self.value(key)?, &self.name(key), dimensions, signals)
    }

    /// Text.
    pub fn string(&self, key: &'static str) -> Option<Spanned<&'a str>> {
        self.reader.string(self.value(key)?, &self.name(key))
    }

    /// The same, which may be absent.
    pub fn optional_string(&self, key: &'static str) -> Option<Spanned<&'a str>> {
        self.reader.string(self.optional_value(key)?, &self.name(key))
    }

    /// A list of texts.
    pub fn strings(&self, key: &'static str) -> Option<Vec<Spanned<&'a str>>> {
        self.reader.strings(self.value(key)?, &self.name(key))
    }

    /// The same, which may be absent.
    pub fn optional_strings(&self, key: &'static str) -> Option<Vec<Spanned<&'a str>>> {
        self.reader.strings(self.optional_value(key)?, &self.name(key))
    }

    /// One of some names.
    pub fn one_of<'n>(&self, key: &'static str, names: &[&'n str]) -> Option<Spanned<&'n str>> {
        self.reader.one_of(self.value(key)?, &self.name(key), names)
    }

    /// The same, which may be absent.
    pub fn optional_one_of<'n>(&self, key: &'static str, names: &[&'n str]) -> Option<Spanned<&'n str>> {
        self.reader.one_of(self.optional_value(key)?, &self.name(key), names)
    }

    /// `true` or `false`, which may be absent.
    pub fn optional_boolean(&self, key: &'static str) -> Option<Spanned<bool>> {
        self.reader.boolean(self.optional_value(key)?, &self.name(key))
    }

    /// A whole number within a range.
    pub fn integer(&self, key: &'static str, range: RangeInclusive<i64>) -> Option<Spanned<i64>> {
        self.reader.integer(self.value(key)?, &self.name(key), range)
    }

    /// The same, which may be absent.
    pub fn optional_integer(&self, key: &'static str, range: RangeInclusive<i64>) -> Option<Spanned<i64>> {
        self.reader.integer(self.optional_value(key)?, &self.name(key), range)
    }

    /// A list.
    pub fn list(&self, key: &'static str) -> Option<&'a [Value]> {
        self.reader.list(self.value(key)?, &self.name(key))
    }

    /// The same, which may be absent.
    pub fn optional_list(&self, key: &'static str) -> Option<&'a [Value]> {
        self.reader.list(self.optional_value(key)?, &self.name(key))
    }

    /// A table, named `what` in messages.
    pub fn fields(&self, key: &'static str, what: &str) -> Option<Fields<'a>> {
        self.reader.fields(self.value(key)?, what)
    }

    /// The same, which may be absent.
    pub fn optional_fields(&self, key: &'static str, what: &str) -> Option<Fields<'a>> {
        self.reader.fields(self.optional_value(key)?, what)
    }

    /// The entries of a table of named things (`[joints]`), which may be absent (then none).
    pub fn entries(&self, key: &'static str) -> &'a [Entry] {
        let Some(value) = self.optional_value(key) else { return &[] };
        match &value.kind {
            ValueKind::Table(table) => &table.entries,
            _ => {
                // Reports that it is no table.
                let _ = self.reader.fields(value, &self.name(key));
                &[]
            }
        }
    }

    /// Reports an error about this table as a whole.
    pub fn fault(&self, code: &'static str, message: impl Into<String>) {
        self.reader.report(Diagnostic::error(code, self.table.span, message));
    }

    /// Reports every key that was not asked for, with the nearest and all known keys.
    pub fn finish(self) {
        let known = self.known.take();
        let mut names = known.clone();
        names.sort_unstable();
        for entry in self.table.iter().filter(|e| !known.contains(&e.key.as_str())) {
            let absent = || known.iter().copied().filter(|k| self.table.get(k).is_none());
            let word = |k: &&str| self.other_words.iter().any(|(word, key)| *word == entry.key && key == k);
            let meant = absent()
                .find(word)
                .or_else(|| nearest(&entry.key, absent()))
                .or_else(|| nearest(&entry.key, known.iter().copied()));
            // The misspelt key is reported; that the right one is missing would say it twice.
            self.missing.borrow_mut().retain(|k| Some(*k) != meant);
            let message = format!("unknown key `{}` in {}", entry.key, self.what);
            let error = Diagnostic::error("unknown-key", entry.key_span, message).did_you_mean(meant);
            self.reader.report(if names.is_empty() {
                error
            } else {
                error.hint(format!("known keys: {}", quoted(&names)))
            });
        }
    }
}

impl Drop for Fields<'_> {
    fn drop(&mut self) {
        for key in self.missing.take() {
            self.reader.missing(key, &self.what, self.table.span, (self.hints)(key));
        }
    }
}
