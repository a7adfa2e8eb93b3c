//! Rows as Apache Parquet: columns that pandas, polars, DuckDB and Arrow read without parsing text.
//!
//! An own writer of the part of the format that such rows need: plain encoding, no compression, one
//! page a column and row group, nulls, statistics. The `parquet` crate does all of the format and
//! costs 90 CPU seconds and 25 crates to build; this is 300 lines and takes a million rows of twenty
//! numbers a second. Format: <https://parquet.apache.org/docs/>.
//!
//! A file without its end cannot be read, so what is to survive an interruption belongs into
//! [`CsvRows`](super::CsvRows) as well.

mod chunk;
mod footer;
mod thrift;

use std::io::{self, Write};

use super::{RowColumn, RowKind, RowWriter};
use chunk::{Chunk, Chunks};
use footer::Group;

const MAGIC: &[u8; 4] = b"PAR1";
/// Numbers held back before they are written as a row group: 8 MB.
const NUMBERS_IN_GROUP: usize = 1 << 20;
/// Rows in a group; readers skip whole groups by their statistics.
const ROWS_IN_GROUP: (usize, usize) = (1 << 10, 1 << 16);

/// Rows as a Parquet file: counts are `INT64`, numbers `DOUBLE` in display units with null where
/// they are not finite, words strings with null where there are none.
///
/// The units stand in the file's metadata under `bellcrank.units`, a JSON object by column.
pub struct ParquetRows<W: Write> {
    out: W,
    /// Bytes written so far.
    at: u64,
    columns: Vec<RowColumn>,
    /// Name of the column of words; none without it.
    words: Option<String>,
    numbers: Vec<Vec<f64>>,
    texts: Vec<String>,
    most_rows: usize,
    groups: Vec<Group>,
}

impl<W: Write> ParquetRows<W> {
    /// A file with these columns and, after them, one of words where that has a name.
    ///
    /// # Errors
    /// Whatever the file reports.
    pub fn new(mut out: W, columns: Vec<RowColumn>, words: Option<&str>) -> io::Result<Self> {
        out.write_all(MAGIC)?;
        let most_rows = (NUMBERS_IN_GROUP / columns.len().max(1)).clamp(ROWS_IN_GROUP.0, ROWS_IN_GROUP.1);
        Ok(Self {
            out,
            at: MAGIC.len() as u64,
            numbers: vec![Vec::new(); columns.len()],
            columns,
            words: words.map(str::to_owned),
            texts: Vec::new(),
            most_rows,
            groups: Vec::new(),
        })
    }

    /// Writes the rows held back as a group.
    fn flush_group(&mut self) -> io::Result<()> {
        if self.texts.is_empty() {
            return Ok(());
        }
        let start = self.at;
        let mut chunks: Vec<Chunks> = Vec::new();
        for index in 0..self.columns.len() {
            let values = std::mem::take(&mut self.numbers[index]);
            let chunk = match self.columns[index].kind {
                RowKind::Count => chunk::counts(&values),
                RowKind::Number(_) => chunk::numbers(&values),
            };
            chunks.push(self.write_chunk(&chunk)?);
            self.numbers[index] = values;
            self.numbers[index].clear();
        }
        if self.words.is_some() {
            let chunk = chunk::words(&self.texts);
            chunks.push(self.write_chunk(&chunk)?);
        }
        self.groups.push(Group { rows: self.texts.len() as u64, start, bytes: self.at - start, chunks });
        self.texts.clear();
        Ok(())
    }

    fn write_chunk(&mut self, chunk: &Chunk) -> io::Result<Chunks> {
        let start = self.at;
        let head = chunk.page_header();
        for part in [&head, &chunk.levels, &chunk.values] {
            self.out.write_all(part)?;
            self.at += part.len() as u64;
        }
        Ok(Chunks { start, bytes: self.at - start, rows: chunk.rows, statistics: chunk.statistics.clone() })
    }
}

impl<W: Write> RowWriter for ParquetRows<W> {
    fn push(&mut self, si: &[f64], words: &str) -> io::Result<()> {
        for (index, (column, values)) in self.columns.iter().zip(&mut self.numbers).enumerate() {
            values.push(column.shown(si.get(index).copied().unwrap_or(f64::NAN)));
        }
        self.texts.push(words.to_owned());
        if self.texts.len() >= self.most_rows { self.flush_group() } else { Ok(()) }
    }

    fn finish(&mut self) -> io::Result<()> {
        self.flush_group()?;
        let footer = footer::footer(&self.columns, self.words.as_deref(), &self.groups);
        self.out.write_all(&footer)?;
        self.out.write_all(&(footer.len() as u32).to_le_bytes())?;
        self.out.write_all(MAGIC)?;
        self.out.flush()
    }
}
