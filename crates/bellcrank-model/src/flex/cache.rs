//! A folder of reductions. Files are written whole or not at all, and read as if anybody could have written them.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use super::recipe::Key;
use super::{Reduced, file};

fn path(folder: &Path, key: Key) -> PathBuf {
    folder.join(format!("{}.reduction", key.hex()))
}

/// What the folder has under a key; nothing is no fault.
pub(super) fn load(folder: &Path, key: Key) -> Result<Option<Reduced>, String> {
    let path = path(folder, key);
    let bytes = match fs::read(&path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(format!("`{}` cannot be read: {error}", path.display())),
    };
    match file::read(&bytes, key) {
        Ok(reduced) => Ok(Some(reduced)),
        Err(fault) => Err(format!("`{}` {fault}", path.display())),
    }
}

/// Writes beside, then renames: who reads meanwhile finds all of the old file, or all of the new one.
pub(super) fn save(folder: &Path, key: Key, reduced: &Reduced) -> Result<(), String> {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let told = |what: &Path, error: std::io::Error| format!("`{}` cannot be written: {error}", what.display());
    fs::create_dir_all(folder).map_err(|error| told(folder, error))?;
    let own = format!("{}.{}.{}", key.hex(), std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
    let (beside, path) = (folder.join(own), path(folder, key));
    let written = fs::File::create(&beside).and_then(|mut of| {
        of.write_all(&file::written(reduced, key))?;
        of.sync_all()?;
        fs::rename(&beside, &path)
    });
    if written.is_err() {
        // What is left of it is of no use, and is in nobody's way if it stays.
        drop(fs::remove_file(&beside));
    }
    written.map_err(|error| told(&path, error))
}
