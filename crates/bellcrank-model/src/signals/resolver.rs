//! Names of signals in expressions.

use bellcrank_doc::{Dimension, Signals};

use super::{Catalogue, Level, Signal, Source};

/// Names in hints; more are not compared.
const HINTS: usize = 2000;

/// The full name of a signal that a file with this prefix writes.
fn full(name: &str, prefix: &str) -> String {
    match name.split_once('.') {
        Some((family @ ("joint" | "drive" | "point" | "body" | "force"), rest)) if !prefix.is_empty() => {
            format!("{family}.{prefix}{rest}")
        }
        _ => name.to_owned(),
    }
}

/// The name of a signal as a file with this prefix writes it; `None` for what it cannot see.
fn local(name: &str, prefix: &str) -> Option<String> {
    match name.split_once('.') {
        Some((family @ ("joint" | "drive" | "point" | "body" | "force"), rest)) => {
            rest.strip_prefix(prefix).map(|rest| format!("{family}.{rest}"))
        }
        _ => Some(name.to_owned()),
    }
}

/// Signals that force expressions may use: those known before forces are solved.
pub(crate) struct InstantSignals<'a> {
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) prefix: &'a str,
    /// Those in use; an expression's signal `i` is `used[i]`.
    pub(crate) used: &'a mut Vec<Signal>,
    /// A name that exists but is known too late: of the expression read last.
    pub(crate) too_late: Option<String>,
    /// They are read by a planar file in a spatial machine.
    pub(crate) embedded: bool,
    /// A name of a component along the axes of the world, which such a file does not know.
    pub(crate) out_of_plane: Option<String>,
}

impl Signals for InstantSignals<'_> {
    fn lookup(&mut self, name: &str) -> Option<(usize, Dimension)> {
        let signal = self.catalogue.find(&full(name, self.prefix))?;
        let column = self.catalogue.column(signal)?;
        if self.embedded && matches!(signal.source, Source::Point { .. } | Source::Body(_)) {
            self.out_of_plane.get_or_insert_with(|| name.to_owned());
        }
        if column.level > Level::Velocity {
            self.too_late.get_or_insert_with(|| name.to_owned());
        }
        let index = self.used.iter().position(|&used| used == signal).unwrap_or_else(|| {
            self.used.push(signal);
            self.used.len() - 1
        });
        Some((index, column.measure.dimension()))
    }

    fn names(&self) -> Vec<String> {
        let early = |column: &super::Column| column.level <= Level::Velocity;
        let known = |source: &&Source| !(self.embedded && matches!(source, Source::Point { .. } | Source::Body(_)));
        let sources = self.catalogue.sources().iter().filter(known);
        let columns = sources.flat_map(|&source| self.catalogue.columns(source)).filter(early);
        columns.filter_map(|column| local(&column.name, self.prefix)).take(HINTS).collect()
    }
}

/// All signals, for responses and conditions.
pub(crate) struct AllSignals<'a> {
    pub(crate) catalogue: &'a Catalogue,
    /// Those in use; an expression's signal `i` is `used[i]`.
    pub(crate) used: Vec<Signal>,
}

impl Signals for AllSignals<'_> {
    fn lookup(&mut self, name: &str) -> Option<(usize, Dimension)> {
        let signal = self.catalogue.find(name)?;
        let column = self.catalogue.column(signal)?;
        let index = self.used.iter().position(|&used| used == signal).unwrap_or_else(|| {
            self.used.push(signal);
            self.used.len() - 1
        });
        Some((index, column.measure.dimension()))
    }

    fn names(&self) -> Vec<String> {
        self.catalogue.names().take(HINTS).collect()
    }
}

/// Motions know `time` only.
pub(crate) struct TimeOnly;

impl Signals for TimeOnly {
    fn lookup(&mut self, name: &str) -> Option<(usize, Dimension)> {
        (name == "time").then_some((0, Dimension::TIME))
    }

    fn names(&self) -> Vec<String> {
        vec!["time".to_owned()]
    }
}
