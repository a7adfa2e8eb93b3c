//! One entry of a catalogue with its series beneath it.

use bellcrank_doc::{Diagnostic, Dimension, Fields, Value};

/// What a number of a catalogue or a study may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Allowed {
    /// Above 0.
    Positive,
    /// 0 or above.
    NotNegative,
    /// Above 0, 1 at most.
    Share,
    /// 0 or above, below 1.
    BelowOne,
}

impl Allowed {
    pub(crate) fn holds(self, value: f64) -> bool {
        match self {
            Allowed::Positive => value > 0.0,
            Allowed::NotNegative => value >= 0.0,
            Allowed::Share => value > 0.0 && value <= 1.0,
            Allowed::BelowOne => (0.0..1.0).contains(&value),
        }
    }

    pub(crate) fn words(self) -> &'static str {
        match self {
            Allowed::Positive => "above 0",
            Allowed::NotNegative => "0 or above",
            Allowed::Share => "above 0, 1 at most",
            Allowed::BelowOne => "0 or above, below 1",
        }
    }
}

/// A cursor over an entry; what the entry does not say, its series does.
pub(super) struct Entry<'a> {
    own: Fields<'a>,
    series: Option<Fields<'a>>,
}

/// `None` after an error, which has been reported; the inner one without the key.
type Read<T> = Option<Option<T>>;

impl<'a> Entry<'a> {
    pub(super) fn new(own: Fields<'a>, series: Option<Fields<'a>>) -> Entry<'a> {
        own.has("series");
        Entry { own, series }
    }

    /// `cylinder `x``.
    pub(super) fn what(&self) -> &str {
        self.own.what()
    }

    pub(super) fn report(&self, report: Diagnostic) {
        self.own.reader().report(report);
    }

    /// An error about the entry as a whole.
    pub(super) fn error(&self, code: &'static str, message: String, hint: &str) {
        self.report(Diagnostic::error(code, self.own.span(), message).hint(hint));
    }

    /// The value of a key and its name in messages.
    pub(super) fn value(&self, key: &'static str) -> Option<(&'a Value, String)> {
        // Both are asked, so that both know the key.
        let beneath = self.series.as_ref().and_then(|series| Some((series.optional_value(key)?, series.what())));
        let own = self.own.optional_value(key).map(|value| (value, self.own.what()));
        own.or(beneath).map(|(value, what)| (value, format!("`{key}` of {what}")))
    }

    pub(super) fn text(&self, key: &'static str) -> Read<String> {
        let Some((value, what)) = self.value(key) else { return Some(None) };
        Some(Some(self.own.reader().string(value, &what)?.value.to_owned()))
    }

    pub(super) fn one_of(&self, key: &'static str, words: &[&'static str]) -> Read<&'static str> {
        let Some((value, what)) = self.value(key) else { return Some(None) };
        Some(Some(self.own.reader().one_of(value, &what, words)?.value))
    }

    pub(super) fn number(&self, key: &'static str, dimension: Dimension, allowed: Allowed) -> Read<f64> {
        let Some((value, what)) = self.value(key) else { return Some(None) };
        self.one(value, &what, dimension, allowed).map(Some)
    }

    /// A number that must be there.
    pub(super) fn needed(&self, key: &'static str, dimension: Dimension, allowed: Allowed) -> Option<f64> {
        let read = self.number(key, dimension, allowed)?;
        if read.is_none() {
            // Told when the entry is done with, unless a misspelt key stands for it.
            self.own.value(key);
        }
        read
    }

    /// A list of numbers, empty without the key.
    pub(super) fn numbers(&self, key: &'static str, dimension: Dimension, allowed: Allowed) -> Option<Vec<f64>> {
        let Some((value, what)) = self.value(key) else { return Some(Vec::new()) };
        let list = self.own.reader().list(value, &what)?;
        let read: Vec<Option<f64>> = list.iter().map(|one| self.one(one, &what, dimension, allowed)).collect();
        read.into_iter().collect()
    }

    fn one(&self, value: &Value, what: &str, dimension: Dimension, allowed: Allowed) -> Option<f64> {
        let number = self.own.reader().quantity(value, what, dimension)?.eval(&[], &[]);
        if allowed.holds(number) {
            return Some(number);
        }
        self.report(Diagnostic::error("out-of-range", value.span, format!("{what} must be {}", allowed.words())));
        None
    }

    /// Reports keys that nobody asked for.
    pub(super) fn finish(self) {
        self.own.finish();
        self.series.into_iter().for_each(Fields::finish);
    }
}
