//! Typed reading of tables: what a schema asks, with the reports of what it did not get.

use std::ops::RangeInclusive;

use crate::{
    Condition, Constraint, Diagnostic, Diagnostics, Dimension, Entry, Expression, ParameterSet,
    Response, Signals, Span, Spanned, Table, Value,
};

/// What all readings of a file share: its parameters, and the diagnostics so far.
pub struct Reader<'p> {
    parameters: &'p ParameterSet,
    diagnostics: std::cell::RefCell<Diagnostics>,
}

impl<'p> Reader<'p> {
    /// No diagnostics yet.
    #[must_use]
    pub fn new(parameters: &'p ParameterSet) -> Reader<'p> {
        todo!()
    }
    /// The parameters that values may use.
    #[must_use]
    pub fn parameters(&self) -> &'p ParameterSet {
        self.parameters
    }
    /// Adds a diagnostic.
    pub fn report(&self, diagnostic: Diagnostic) {
        todo!()
    }
    /// What was reported.
    #[must_use]
    pub fn finish(self) -> Diagnostics {
        todo!()
    }

    // Single values, `what` as in "`length` of joint `B`": for entries of maps and lists.

    /// A value of the given dimension over the parameters.
    pub fn quantity(&self, value: &Value, what: &str, dimension: Dimension) -> Option<Expression> {
        todo!()
    }
    /// The same, which may also use signals.
    pub fn signal_quantity(
        &self,
        value: &Value,
        what: &str,
        dimension: Dimension,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        todo!()
    }
    /// A value of any dimension, over the parameters and signals.
    pub fn any_quantity(
        &self,
        value: &Value,
        what: &str,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        todo!()
    }
    /// A list of values, one for each of `dimensions`.
    pub fn vector(
        &self,
        value: &Value,
        what: &str,
        dimensions: &[Dimension],
    ) -> Option<Vec<Expression>> {
        todo!()
    }
    /// The same, which may also use signals.
    pub fn signal_vector(
        &self,
        value: &Value,
        what: &str,
        dimensions: &[Dimension],
        signals: &mut dyn Signals,
    ) -> Option<Vec<Expression>> {
        todo!()
    }
    /// A list of values of one dimension, as many as one of `lengths`.
    pub fn uniform_vector(
        &self,
        value: &Value,
        what: &str,
        dimension: Dimension,
        lengths: &[usize],
    ) -> Option<Vec<Expression>> {
        todo!()
    }
    /// Text.
    pub fn string<'a>(&self, value: &'a Value, what: &str) -> Option<Spanned<&'a str>> {
        todo!()
    }
    /// A list of texts.
    pub fn strings<'a>(&self, value: &'a Value, what: &str) -> Option<Vec<Spanned<&'a str>>> {
        todo!()
    }
    /// A list.
    pub fn list<'a>(&self, value: &'a Value, what: &str) -> Option<&'a [Value]> {
        todo!()
    }
    /// A table, to be read field by field; `what` names it, as "joint `B`".
    pub fn fields<'a>(&'a self, value: &'a Value, what: &str) -> Option<Fields<'a>> {
        todo!()
    }
    /// One of some names.
    pub fn one_of<'n>(
        &self,
        value: &Value,
        what: &str,
        names: &[&'n str],
    ) -> Option<Spanned<&'n str>> {
        todo!()
    }
    /// A number of a run (`response`, `minimize`).
    pub fn response(
        &self,
        value: &Value,
        what: &str,
        signals: &mut dyn Signals,
    ) -> Option<Response> {
        todo!()
    }
    /// A comparison of numbers of a run (an entry of `subject_to`).
    pub fn constraint(
        &self,
        value: &Value,
        what: &str,
        signals: &mut dyn Signals,
    ) -> Option<Constraint> {
        todo!()
    }
    /// A comparison at one instant (`stop_when`).
    pub fn condition(
        &self,
        value: &Value,
        what: &str,
        signals: &mut dyn Signals,
    ) -> Option<Condition> {
        todo!()
    }
}

/// A cursor over one table. Every getter marks its key as known; [`Fields::finish`] reports the
/// keys that nobody asked for.
///
/// All getters return `None` both when the key is absent and when its value is wrong; a wrong
/// value is always reported, an absent one by the getters that do not start with `optional_`.
pub struct Fields<'a> {
    reader: &'a Reader<'a>,
    table: &'a Table,
    what: String,
    known: std::cell::RefCell<Vec<&'static str>>,
}

impl<'a> Fields<'a> {
    /// A cursor; `what` names the table in messages, as "joint `B`".
    #[must_use]
    pub fn new(reader: &'a Reader<'a>, table: &'a Table, what: impl Into<String>) -> Fields<'a> {
        todo!()
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
        todo!()
    }
    /// The raw entry, marked as known; no report when absent.
    pub fn optional_entry(&self, key: &'static str) -> Option<&'a Entry> {
        todo!()
    }
    /// The raw value, marked as known; no report when absent.
    pub fn optional_value(&self, key: &'static str) -> Option<&'a Value> {
        todo!()
    }
    /// The raw value; an absent one is reported.
    pub fn value(&self, key: &'static str) -> Option<&'a Value> {
        todo!()
    }
    /// A value of the given dimension over the parameters.
    pub fn quantity(&self, key: &'static str, dimension: Dimension) -> Option<Expression> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_quantity(&self, key: &'static str, dimension: Dimension) -> Option<Expression> {
        todo!()
    }
    /// A value over the parameters and signals.
    pub fn signal_quantity(
        &self,
        key: &'static str,
        dimension: Dimension,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_signal_quantity(
        &self,
        key: &'static str,
        dimension: Dimension,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        todo!()
    }
    /// A list of values, one for each of `dimensions`.
    pub fn vector(&self, key: &'static str, dimensions: &[Dimension]) -> Option<Vec<Expression>> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_vector(
        &self,
        key: &'static str,
        dimensions: &[Dimension],
    ) -> Option<Vec<Expression>> {
        todo!()
    }
    /// A list of values of one dimension, as many as one of `lengths` (inertia: 3 or 6).
    pub fn uniform_vector(
        &self,
        key: &'static str,
        dimension: Dimension,
        lengths: &[usize],
    ) -> Option<Vec<Expression>> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_uniform_vector(
        &self,
        key: &'static str,
        dimension: Dimension,
        lengths: &[usize],
    ) -> Option<Vec<Expression>> {
        todo!()
    }
    /// A vector over the parameters and signals.
    pub fn signal_vector(
        &self,
        key: &'static str,
        dimensions: &[Dimension],
        signals: &mut dyn Signals,
    ) -> Option<Vec<Expression>> {
        todo!()
    }
    /// Text.
    pub fn string(&self, key: &'static str) -> Option<Spanned<&'a str>> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_string(&self, key: &'static str) -> Option<Spanned<&'a str>> {
        todo!()
    }
    /// A list of texts.
    pub fn strings(&self, key: &'static str) -> Option<Vec<Spanned<&'a str>>> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_strings(&self, key: &'static str) -> Option<Vec<Spanned<&'a str>>> {
        todo!()
    }
    /// One of some names.
    pub fn one_of<'n>(&self, key: &'static str, names: &[&'n str]) -> Option<Spanned<&'n str>> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_one_of<'n>(
        &self,
        key: &'static str,
        names: &[&'n str],
    ) -> Option<Spanned<&'n str>> {
        todo!()
    }
    /// `true` or `false`, which may be absent.
    pub fn optional_boolean(&self, key: &'static str) -> Option<Spanned<bool>> {
        todo!()
    }
    /// A whole number within a range.
    pub fn integer(&self, key: &'static str, range: RangeInclusive<i64>) -> Option<Spanned<i64>> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_integer(
        &self,
        key: &'static str,
        range: RangeInclusive<i64>,
    ) -> Option<Spanned<i64>> {
        todo!()
    }
    /// A list.
    pub fn list(&self, key: &'static str) -> Option<&'a [Value]> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_list(&self, key: &'static str) -> Option<&'a [Value]> {
        todo!()
    }
    /// A table, named `what` in messages.
    pub fn fields(&self, key: &'static str, what: &str) -> Option<Fields<'a>> {
        todo!()
    }
    /// The same, which may be absent.
    pub fn optional_fields(&self, key: &'static str, what: &str) -> Option<Fields<'a>> {
        todo!()
    }
    /// The entries of a table of named things (`[joints]`), which may be absent (then none).
    pub fn entries(&self, key: &'static str) -> &'a [Entry] {
        todo!()
    }
    /// Reports an error about this table as a whole.
    pub fn fault(&self, code: &'static str, message: impl Into<String>) {
        todo!()
    }
    /// Reports every key that was not asked for, with the nearest and all known keys.
    pub fn finish(self) {
        todo!()
    }
}
