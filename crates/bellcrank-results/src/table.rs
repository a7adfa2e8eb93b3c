//! Named columns of SI numbers, one row a position or time.

use crate::Unit;

/// One signal over the rows of a study.
#[derive(Clone, Debug)]
pub struct Column {
    /// Signal name, e.g. `joint.B.position`.
    pub name: String,
    /// Unit it is shown in.
    pub unit: Unit,
    /// SI values, one a row.
    pub values: Vec<f64>,
}

/// Columns of equal length.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// In the order they are written.
    pub columns: Vec<Column>,
}

impl Table {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |c| c.values.len())
    }
    /// The column of that name.
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|c| c.name == name)
    }
}
