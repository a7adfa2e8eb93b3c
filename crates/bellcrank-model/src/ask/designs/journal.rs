//! The rows of a sweep on disk: `designs.csv` grows while they are computed, and an interrupted sweep goes on behind its
//! last whole row.
//!
//! Beside it `designs.state.json` says what the rows were made from and whether all are there. The order of writing makes
//! any moment a good one to be killed: old rows are removed before a new state is written, the state is there before the
//! first row, and says that all is done only after the last file is whole.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufRead, BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use bellcrank_results::{CsvRows, ParquetRows, RowWriter};
use serde_json::{Map, Value, json};

use super::columns::{Columns, REASON};
use super::inputs::Inputs;
use super::lock::Lock;
use super::stored::Stored;
use super::worker::Row;
use crate::trial::Undefined;

pub(super) const CSV: &str = "designs.csv";
pub(super) const PARQUET: &str = "designs.parquet";
const STATE: &str = "designs.state.json";
const LOCK: &str = "designs.lock";
/// Rows are on disk at most so long after they were computed.
const PATIENCE: Duration = Duration::from_secs(1);

/// The files of a sweep while it runs.
pub(super) struct Journal {
    folder: PathBuf,
    columns: Columns,
    inputs: Inputs,
    csv: CsvRows<File>,
    line: Vec<f64>,
    flushed: Instant,
    /// The last thing to go.
    _lock: Lock,
}

impl Journal {
    /// Takes up the rows that an interrupted run left, each of which `taken` sees, or begins anew.
    pub(super) fn open(
        folder: &Path,
        columns: &Columns,
        inputs: Inputs,
        fresh: bool,
        total: u64,
        taken: &mut dyn FnMut(&Row),
    ) -> Result<Journal, Undefined> {
        fs::create_dir_all(folder).map_err(|error| unwritable(folder, &error))?;
        let lock = Lock::take(&folder.join(LOCK))?;
        let path = folder.join(CSV);
        let interrupted = if fresh { None } else { interrupted(folder) };
        let changes = interrupted.as_ref().and_then(|before| inputs.changes(before));
        let file = match (interrupted, changes) {
            (Some(_), None) => go_on(&path, columns, total, taken),
            (Some(_), Some(changes)) => refuse(&path, &changes)?,
            (None, _) => Ok(None),
        };
        let csv = match file.map_err(|error| unwritable(&path, &error))? {
            Some(file) => CsvRows::continued(file, columns.of_file()),
            None => begin(folder, &inputs, columns)?,
        };
        let (folder, columns) = (folder.to_owned(), columns.clone());
        Ok(Journal { folder, columns, inputs, csv, line: Vec::new(), flushed: Instant::now(), _lock: lock })
    }

    /// The next row.
    pub(super) fn push(&mut self, design: u64, row: &Row) -> Result<(), Undefined> {
        self.line.clear();
        self.line.push(design as f64);
        self.line.extend_from_slice(&row.numbers);
        let mut written = self.csv.push(&self.line, &row.reason);
        if self.flushed.elapsed() > PATIENCE {
            written = written.and_then(|()| self.csv.flush());
            self.flushed = Instant::now();
        }
        written.map_err(|error| unwritable(&self.folder.join(CSV), &error))
    }

    /// Everything computed so far is on disk.
    pub(super) fn pause(&mut self) -> Result<(), Undefined> {
        self.csv.finish().map_err(|error| unwritable(&self.folder.join(CSV), &error))
    }

    /// All rows are there.
    pub(super) fn finish(&mut self) -> Result<(), Undefined> {
        self.pause()?;
        let parquet = self.folder.join(PARQUET);
        self.write_parquet(&parquet).map_err(|error| unwritable(&parquet, &error))?;
        write_state(&self.folder, &self.inputs, true)
    }

    fn write_parquet(&self, path: &Path) -> io::Result<()> {
        whole(path, |file| {
            let mut rows = ParquetRows::new(BufWriter::new(file), self.columns.of_file(), Some(REASON))?;
            let mut line = Vec::new();
            let mut stored = Stored::open(&self.folder.join(CSV), &self.columns)?;
            let mut failed = Ok(());
            stored.each(u64::MAX, &mut |design, row| {
                line.clear();
                line.push(design as f64);
                line.extend_from_slice(&row.numbers);
                if failed.is_ok() {
                    failed = rows.push(&line, &row.reason);
                }
            })?;
            failed?;
            rows.finish()
        })
    }
}

/// What the rows of an interrupted run were made from.
fn interrupted(folder: &Path) -> Option<Map<String, Value>> {
    let text = fs::read_to_string(folder.join(STATE)).ok()?;
    let state: Value = serde_json::from_str(&text).ok()?;
    let unfinished = state.get("finished")?.as_bool() == Some(false) && folder.join(CSV).is_file();
    unfinished.then_some(state.get("inputs")?.as_object()?.clone())
}

/// The file behind its last whole row; `None` where it does not hold even its first line.
fn go_on(path: &Path, columns: &Columns, total: u64, taken: &mut dyn FnMut(&Row)) -> io::Result<Option<File>> {
    let mut stored = Stored::open(path, columns)?;
    if !stored.has_header() {
        return Ok(None);
    }
    stored.each(total, &mut |_, row| taken(row))?;
    let good = stored.good_bytes();
    drop(stored);
    let file = OpenOptions::new().append(true).open(path)?;
    file.set_len(good)?;
    Ok(Some(file))
}

fn begin(folder: &Path, inputs: &Inputs, columns: &Columns) -> Result<CsvRows<File>, Undefined> {
    for name in [CSV, PARQUET] {
        let path = folder.join(name);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(unwritable(&path, &error)),
            _ => {}
        }
    }
    write_state(folder, inputs, false)?;
    let path = folder.join(CSV);
    let file = File::create(&path).map_err(|error| unwritable(&path, &error))?;
    let mut csv = CsvRows::new(file, columns.of_file(), REASON);
    csv.flush().map_err(|error| unwritable(&path, &error))?;
    Ok(csv)
}

fn write_state(folder: &Path, inputs: &Inputs, finished: bool) -> Result<(), Undefined> {
    let state = json!({ "finished": finished, "inputs": inputs.to_json() });
    let path = folder.join(STATE);
    let written = whole(&path, |mut file| file.write_all(format!("{state:#}\n").as_bytes()));
    written.map_err(|error| unwritable(&path, &error))
}

/// A file that appears whole: it is written beside its place and renamed.
fn whole(path: &Path, write: impl FnOnce(&File) -> io::Result<()>) -> io::Result<()> {
    let mut beside = path.as_os_str().to_owned();
    beside.push(".part");
    let file = File::create(&beside)?;
    write(&file)?;
    drop(file);
    fs::rename(&beside, path)
}

/// Rows of another machine are neither mixed with others nor thrown away; where there are none, nothing is lost.
fn refuse(path: &Path, changes: &str) -> Result<io::Result<Option<File>>, Undefined> {
    let rows = match lines(path) {
        Ok(lines) => lines.saturating_sub(1),
        Err(error) => return Ok(Err(error)),
    };
    if rows == 0 {
        return Ok(Ok(None));
    }
    Err(Undefined {
        message: format!(
            "an interrupted run left {rows} designs in `{}`, and those to come would be of another machine: {changes}",
            path.display()
        ),
        hints: vec![
            "undo the change, and the run goes on behind the last of them".to_owned(),
            "`--fresh` begins anew and drops them; `--out DIR` writes elsewhere".to_owned(),
        ],
    })
}

fn lines(path: &Path) -> io::Result<usize> {
    let mut file = BufReader::new(File::open(path)?);
    let mut count = 0;
    loop {
        let bytes = file.fill_buf()?;
        if bytes.is_empty() {
            return Ok(count);
        }
        count += bytes.iter().filter(|byte| **byte == b'\n').count();
        let length = bytes.len();
        file.consume(length);
    }
}

fn unwritable(path: &Path, error: &io::Error) -> Undefined {
    Undefined {
        message: format!("cannot write `{}`: {error}", path.display()),
        hints: vec!["choose another directory with `--out DIR`; rows that are there already are kept".to_owned()],
    }
}
