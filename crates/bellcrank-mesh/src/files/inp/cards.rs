//! Lines of an input file: cards with parameters, and rows of entries.

use super::super::FileFault;
use super::super::error::Errors;
use super::{Entry, Place};

/// A line that begins with one asterisk, with the lines that it continues on.
pub(super) struct Card {
    /// In capitals, single spaces.
    pub(super) name: String,
    parameters: Vec<(String, Option<String>)>,
    pub(super) at: Place,
}

impl Card {
    /// Value of a parameter that is given as `KEY=value`.
    pub(super) fn value(&self, key: &str) -> Option<&str> {
        self.parameters.iter().find(|(name, _)| name == key).and_then(|(_, value)| value.as_deref())
    }

    pub(super) fn has(&self, key: &str) -> bool {
        self.parameters.iter().any(|(name, _)| name == key)
    }
}

/// A line of data.
pub(super) struct Row<'a> {
    text: &'a str,
    pub(super) line: usize,
}

impl Row<'_> {
    /// Entries between commas; one that only a last comma would open is none.
    pub(super) fn entries(&self) -> Vec<Entry> {
        let mut entries = Vec::new();
        let mut start = 0;
        for part in self.text.split(',') {
            let column = start + part.len() - part.trim_start().len() + 1;
            entries.push(Entry { text: part.trim().to_owned(), at: (self.line, column) });
            start += part.len() + 1;
        }
        if entries.last().is_some_and(|entry| entry.text.is_empty()) {
            entries.pop();
        }
        entries
    }

    /// Whether it ends with a comma.
    pub(super) fn open(&self) -> bool {
        self.text.trim_end().ends_with(',')
    }

    /// Place after its last character.
    pub(super) fn end(&self) -> Place {
        (self.line, self.text.trim_end().len() + 1)
    }
}

pub(super) struct Lines<'a> {
    lines: Vec<&'a str>,
    next: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn of(text: &'a str) -> Lines<'a> {
        Lines { lines: text.lines().collect(), next: 0 }
    }

    /// The next card; rows before it are told as errors.
    pub(super) fn next_card(&mut self, errors: &mut Errors) -> Option<Card> {
        while let Some(row) = self.next_row() {
            let found: String = row.text.trim().chars().take(40).collect();
            errors.push((row.line, 1), FileFault::Expected { expected: "a card that begins with `*`", found });
            self.skip_rows();
        }
        let at = (self.next + 1, 1);
        let mut text = (*self.lines.get(self.next)?).trim().to_owned();
        self.next += 1;
        while text.ends_with(',') {
            let Some(more) = self.lines.get(self.next).filter(|line| !line.trim_start().starts_with('*')) else {
                break;
            };
            text.push_str(more.trim());
            self.next += 1;
        }
        Some(card(&text, at))
    }

    /// The next line of data before the next card.
    pub(super) fn next_row(&mut self) -> Option<Row<'a>> {
        while let Some(&text) = self.lines.get(self.next) {
            let start = text.trim_start();
            if start.is_empty() || start.starts_with("**") {
                self.next += 1;
            } else if start.starts_with('*') {
                return None;
            } else {
                self.next += 1;
                return Some(Row { text, line: self.next });
            }
        }
        None
    }

    pub(super) fn skip_rows(&mut self) {
        while self.next_row().is_some() {}
    }

    /// Whether nothing follows.
    pub(super) fn at_end(&self) -> bool {
        self.next >= self.lines.len()
    }

    /// Place after the last character.
    pub(super) fn end(&self) -> Place {
        (self.lines.len().max(1), self.lines.last().map_or(1, |line| line.len() + 1))
    }
}

fn card(text: &str, at: Place) -> Card {
    let mut parts = text.trim_start_matches('*').split(',');
    let tidy = |part: &str| part.split_whitespace().collect::<Vec<_>>().join(" ");
    let name = tidy(parts.next().unwrap_or_default()).to_uppercase();
    let parameters = parts.filter(|part| !part.trim().is_empty()).map(|part| match part.split_once('=') {
        Some((key, value)) => (tidy(key).to_uppercase(), Some(value.trim().trim_matches('"').to_owned())),
        None => (tidy(part).to_uppercase(), None),
    });
    Card { name, parameters: parameters.collect(), at }
}
