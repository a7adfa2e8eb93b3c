//! Files appear whole or not at all: they are written beside their place and then renamed into it.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use bellcrank_model::PartFile;
use bellcrank_report::{Exports, write_run};
use bellcrank_results::RunResult;

use crate::exit::Refusal;

/// What the name of a room begins with.
const ROOM: &str = ".bellcrank-";

/// A result directory that can be written, with a room in it for files that are not finished.
#[derive(Debug)]
pub(crate) struct Staging {
    out: PathBuf,
    room: PathBuf,
}

impl Staging {
    /// Makes the directory. Asked before a study is run, so that nothing is computed in vain.
    pub(crate) fn prepare(out: &Path) -> Result<Self, Refusal> {
        sweep_out(out);
        let room = out.join(format!("{ROOM}{}", std::process::id()));
        match fs::create_dir_all(&room) {
            Ok(()) => Ok(Self { out: out.to_owned(), room }),
            Err(error) => Err(unwritable(out, &error)),
        }
    }

    /// Writes all files of a run and moves each into its place; gives back how many there are.
    pub(crate) fn publish(&self, run: &RunResult, exports: Exports) -> Result<usize, Refusal> {
        let written = write_run(run, &self.room, exports).map_err(|error| Refusal::command_line(error.to_string()))?;
        for file in &written {
            self.move_out(file).map_err(|error| unwritable(&self.out, &error))?;
        }
        Ok(written.len())
    }

    /// Writes files that are already made, whole or not at all.
    pub(crate) fn put(&self, files: &[PartFile]) -> Result<usize, Refusal> {
        let put = |file: &PartFile| {
            let path = self.room.join(&file.path);
            if let Some(folder) = path.parent() {
                fs::create_dir_all(folder)?;
            }
            fs::write(&path, &file.bytes)?;
            self.move_out(&path)
        };
        files.iter().try_for_each(put).map_err(|error| unwritable(&self.out, &error))?;
        Ok(files.len())
    }

    fn move_out(&self, file: &Path) -> io::Result<()> {
        let target = self.out.join(file.strip_prefix(&self.room).map_err(io::Error::other)?);
        if let Some(folder) = target.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::rename(file, target)
    }
}

impl Drop for Staging {
    fn drop(&mut self) {
        // What is left here is of no use to anybody, and nobody can be told.
        let _ = fs::remove_dir_all(&self.room);
    }
}

/// Rooms of runs that were killed. Only empty ones go; a run that still needs its room makes it again.
fn sweep_out(out: &Path) {
    for entry in fs::read_dir(out).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(ROOM) {
            let _ = fs::remove_dir(entry.path());
        }
    }
}

fn unwritable(out: &Path, error: &io::Error) -> Refusal {
    let refusal = Refusal::command_line(format!("cannot write into `{}`: {error}", out.display()));
    refusal.hint("choose another directory with `--out DIR`")
}
