//! A whole table as Parquet.

use std::io::{self, Write};

use super::{ParquetRows, RowColumn, RowKind, RowWriter};
use crate::{Column, Table, heading};

/// Writes `table` as Parquet in display units, columns named as over those of
/// [`write_csv`](crate::write_csv); null where a number is not finite.
///
/// A table without columns writes nothing.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_parquet(table: &Table, out: impl Write) -> io::Result<()> {
    if table.columns.is_empty() {
        return Ok(());
    }
    let column = |column: &Column| RowColumn {
        name: heading(&column.name, &column.unit),
        kind: RowKind::Number(column.unit.clone()),
    };
    let mut rows = ParquetRows::new(out, table.columns.iter().map(column).collect(), None)?;
    let mut si = vec![f64::NAN; table.columns.len()];
    for row in 0..table.rows() {
        for (value, column) in si.iter_mut().zip(&table.columns) {
            *value = column.values.get(row).copied().unwrap_or(f64::NAN);
        }
        rows.push(&si, "")?;
    }
    rows.finish()
}
