//! Rows written while they are computed: a sweep of a million designs is never in memory.

mod csv;
mod parquet;
mod series;

use std::io;

pub use csv::CsvRows;
pub use parquet::ParquetRows;
pub use series::write_parquet;

use crate::Unit;

/// A column of numbers in a file that is written row by row.
#[derive(Clone, Debug)]
pub struct RowColumn {
    /// Name.
    pub name: String,
    /// What its numbers are.
    pub kind: RowKind,
}

/// What the numbers of a column are.
#[derive(Clone, Debug)]
pub enum RowKind {
    /// A whole number that every row has, e.g. that of the design.
    Count,
    /// SI values shown in a unit; what is not finite is left empty.
    Number(Unit),
}

/// A file that takes one row after the other: numbers by column, then words.
///
/// A file can have one column of words after those of numbers, e.g. the reason of a failure.
pub trait RowWriter {
    /// Adds a row: SI values in the order of the columns, and words, empty where there are none.
    ///
    /// A row that is too short is filled with empty fields, one that is too long is cut.
    ///
    /// # Errors
    /// Whatever the file reports.
    fn push(&mut self, si: &[f64], words: &str) -> io::Result<()>;

    /// Writes what is still held back, and what the format wants at its end.
    ///
    /// # Errors
    /// Whatever the file reports.
    fn finish(&mut self) -> io::Result<()>;
}

impl RowColumn {
    /// The number to write: a count as it is, an SI value in its unit.
    fn shown(&self, si: f64) -> f64 {
        match &self.kind {
            RowKind::Count => si,
            RowKind::Number(unit) => unit.show(si),
        }
    }

    fn unit(&self) -> &str {
        match &self.kind {
            RowKind::Count => "",
            RowKind::Number(unit) => &unit.symbol,
        }
    }
}

#[cfg(test)]
mod tests;
