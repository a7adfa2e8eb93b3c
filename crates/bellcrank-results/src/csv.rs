//! Tables as comma-separated text: one header line, one line a row.

use std::io::{self, Write};

use crate::{Column, Table, Unit};

/// Bytes gathered before they go to the writer: large enough that a file write costs nothing.
const CHUNK: usize = 1 << 16;

/// Writes `table` as CSV in display units.
///
/// Header fields are `signal [unit]`, without the bracket for pure numbers. Numbers are the
/// shortest text that reads back to the same `f64`; a number that is not finite (a signal not
/// defined at that row) leaves an empty cell. A table without columns writes nothing.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_csv(table: &Table, mut out: impl Write) -> io::Result<()> {
    if table.columns.is_empty() {
        return Ok(());
    }
    let mut text = header(table).into_bytes();
    for row in 0..table.rows() {
        push_row(&mut text, &table.columns, row);
        if text.len() >= CHUNK {
            out.write_all(&text)?;
            text.clear();
        }
    }
    out.write_all(&text)?;
    out.flush()
}

/// A signal's name as it stands over its column: `joint.B.position [deg]`.
pub fn heading(name: &str, unit: &Unit) -> String {
    if unit.symbol.is_empty() { name.to_owned() } else { format!("{name} [{}]", unit.symbol) }
}

fn header(table: &Table) -> String {
    let fields: Vec<String> = table.columns.iter().map(|column| quoted(heading(&column.name, &column.unit))).collect();
    fields.join(",") + "\n"
}

/// RFC 4180: a field with a comma, quote or line break stands in quotes, quotes doubled.
pub(crate) fn quoted(field: String) -> String {
    if field.contains([',', '"', '\n', '\r']) { format!("\"{}\"", field.replace('"', "\"\"")) } else { field }
}

fn push_row(text: &mut Vec<u8>, columns: &[Column], row: usize) {
    for (index, column) in columns.iter().enumerate() {
        if index > 0 {
            text.push(b',');
        }
        // A short column leaves empty cells rather than shifting its neighbours.
        if let Some(&si) = column.values.get(row) {
            push_number(text, column.unit.show(si));
        }
    }
    text.push(b'\n');
}

pub(crate) fn push_number(text: &mut Vec<u8>, value: f64) {
    if !value.is_finite() {
        return;
    }
    let mut buffer = zmij::Buffer::new();
    let shown = buffer.format_finite(value);
    text.extend_from_slice(shown.strip_suffix(".0").unwrap_or(shown).as_bytes());
}

#[cfg(test)]
mod tests;
