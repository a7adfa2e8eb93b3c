//! Rows as comma-separated text, each whole on its line as soon as it is flushed.

use std::io::{self, Write};

use super::{RowColumn, RowKind, RowWriter};
use crate::csv::{heading, push_number, quoted};

/// Bytes gathered before they go to the file.
const CHUNK: usize = 1 << 16;

/// Rows as CSV with the head line of [`write_csv`](crate::write_csv).
///
/// Whole lines go to the file, and [`flush`](Self::flush) sends those held back: what was computed
/// before an interruption can be read and continued.
pub struct CsvRows<W: Write> {
    out: W,
    columns: Vec<RowColumn>,
    text: Vec<u8>,
}

impl<W: Write> CsvRows<W> {
    /// A file that begins with its head line.
    pub fn new(out: W, columns: Vec<RowColumn>, words: &str) -> Self {
        let mut writer = Self::continued(out, columns);
        let name = |column: &RowColumn| match &column.kind {
            RowKind::Count => column.name.clone(),
            RowKind::Number(unit) => heading(&column.name, unit),
        };
        let heads = writer.columns.iter().map(name).chain([words.to_owned()]);
        writer.text = (heads.map(quoted).collect::<Vec<_>>().join(",") + "\n").into_bytes();
        writer
    }

    /// A file that has its head line and maybe rows already.
    pub fn continued(out: W, columns: Vec<RowColumn>) -> Self {
        Self { out, columns, text: Vec::new() }
    }

    /// Sends the rows held back to the file.
    ///
    /// # Errors
    /// Whatever the file reports.
    pub fn flush(&mut self) -> io::Result<()> {
        self.out.write_all(&self.text)?;
        self.text.clear();
        self.out.flush()
    }
}

impl<W: Write> RowWriter for CsvRows<W> {
    fn push(&mut self, si: &[f64], words: &str) -> io::Result<()> {
        for (index, column) in self.columns.iter().enumerate() {
            push_number(&mut self.text, column.shown(si.get(index).copied().unwrap_or(f64::NAN)));
            self.text.push(b',');
        }
        self.text.extend_from_slice(quoted(words.to_owned()).as_bytes());
        self.text.push(b'\n');
        if self.text.len() >= CHUNK { self.flush() } else { Ok(()) }
    }

    fn finish(&mut self) -> io::Result<()> {
        self.flush()
    }
}
