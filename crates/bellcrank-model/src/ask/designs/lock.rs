//! One run at a time writes the rows of a sweep.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use crate::trial::Undefined;

/// A file that is held while rows are written. The system lets go of it when the process ends, however it ends, so that
/// none is ever stale; the number of the process in it is for people.
#[derive(Debug)]
pub(super) struct Lock {
    path: PathBuf,
    /// `None` where the file system knows no locks.
    file: Option<File>,
}

impl Lock {
    /// Waits for nobody.
    pub(super) fn take(path: &Path) -> Result<Lock, Undefined> {
        loop {
            let opened = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path);
            let mut file = opened.map_err(|error| Undefined {
                message: format!("cannot write `{}`: {error}", path.display()),
                hints: vec!["choose another directory with `--out DIR`".to_owned()],
            })?;
            match file.try_lock() {
                Ok(()) if is_at(&file, path) => {
                    // For people only: a run goes on without.
                    let _ = file.set_len(0).and_then(|()| writeln!(file, "{}", std::process::id()));
                    return Ok(Lock { path: path.to_owned(), file: Some(file) });
                }
                // Whoever held it removed it in between.
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(taken(path, &mut file)),
                Err(TryLockError::Error(_)) => return Ok(Lock { path: path.to_owned(), file: None }),
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Removed while it is held, so that nobody else's is. What stays behind hinders nobody.
        let _ = fs::remove_file(&self.path);
        drop(self.file.take());
    }
}

fn taken(path: &Path, file: &mut File) -> Undefined {
    let mut text = String::new();
    let known = file.read_to_string(&mut text).is_ok() && !text.trim().is_empty();
    let who = if known { format!("another run (process {})", text.trim()) } else { "another run".to_owned() };
    let folder = path.parent().unwrap_or(path).display();
    Undefined {
        message: format!("{who} is writing the designs in `{folder}`"),
        hints: vec!["wait until it is done, or write elsewhere with `--out DIR`".to_owned()],
    }
}

/// Whether the file that was opened is still the one at its path.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |a: fs::Metadata, b: fs::Metadata| a.dev() == b.dev() && a.ino() == b.ino();
    file.metadata().ok().zip(fs::metadata(path).ok()).is_some_and(|(a, b)| same(a, b))
}

/// A file that is open cannot be replaced by another there.
#[cfg(not(unix))]
fn is_at(_file: &File, _path: &Path) -> bool {
    true
}
