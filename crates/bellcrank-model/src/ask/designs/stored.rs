//! Rows read back from their file, up to the first that is not whole.

use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::Path;

use bellcrank_results::CsvRows;

use super::columns::{Columns, REASON};
use super::worker::Row;

/// A file of rows.
pub(super) struct Stored {
    file: BufReader<File>,
    numbers: usize,
    inputs: usize,
    header: bool,
    line: Vec<u8>,
    good: u64,
}

/// The first line of a file of rows.
pub(super) fn header(columns: &Columns) -> Vec<u8> {
    let mut line = Vec::new();
    // Writing into memory does not fail.
    let _ = CsvRows::new(&mut line, columns.of_file(), REASON).flush();
    line
}

impl Stored {
    pub(super) fn open(path: &Path, columns: &Columns) -> io::Result<Stored> {
        let mut file = BufReader::with_capacity(1 << 16, File::open(path)?);
        let mut line = Vec::new();
        file.read_until(b'\n', &mut line)?;
        let header = line == header(columns);
        let good = line.len() as u64;
        Ok(Stored { file, numbers: columns.all.len(), inputs: columns.inputs, header, line, good })
    }

    /// Whether the first line is as it should be.
    pub(super) fn has_header(&self) -> bool {
        self.header
    }

    /// Bytes up to the end of the last whole row.
    pub(super) fn good_bytes(&self) -> u64 {
        self.good
    }

    /// Gives out whole rows, at most so many. A row that is not whole ends the file: a run was killed while it wrote.
    pub(super) fn each(&mut self, most: u64, row: &mut dyn FnMut(u64, &Row)) -> io::Result<()> {
        let mut read = Row { numbers: Vec::new(), reason: String::new() };
        for design in 0..most {
            self.line.clear();
            self.file.read_until(b'\n', &mut self.line)?;
            if self.parse(design, &mut read).is_none() {
                break;
            }
            self.good += self.line.len() as u64;
            row(design, &read);
        }
        Ok(())
    }

    fn parse(&self, design: u64, row: &mut Row) -> Option<()> {
        let text = std::str::from_utf8(self.line.strip_suffix(b"\n")?).ok()?;
        let (number, mut rest) = text.split_once(',')?;
        if number.parse() != Ok(design) {
            return None;
        }
        row.numbers.clear();
        for _ in 0..self.numbers {
            let (field, behind) = rest.split_once(',')?;
            row.numbers.push(if field.is_empty() { f64::NAN } else { field.parse().ok()? });
            rest = behind;
        }
        row.reason.clear();
        match rest.strip_prefix('"') {
            Some(quoted) => row.reason.push_str(&quoted.strip_suffix('"')?.replace("\"\"", "\"")),
            None => row.reason.push_str(rest),
        }
        // A row has all responses, or a reason why it has none.
        let responses = &row.numbers[self.inputs..];
        let whole = if row.reason.is_empty() {
            responses.iter().all(|x| x.is_finite())
        } else {
            responses.iter().all(|x| x.is_nan())
        };
        whole.then_some(())
    }
}
