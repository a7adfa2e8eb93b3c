//! Gmsh as a program of its own.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicU64, Ordering};

use super::run::{End, Outcome, run};
use super::script::{OPEN, script};
use super::{VolumeMesh, VolumeMesher, VolumeMesherError, VolumeWishes};
use crate::read_msh_entities;

/// The program `gmsh` (<https://gmsh.info>, GPL: it stays a process of its own).
#[derive(Clone, Debug)]
pub struct Gmsh {
    /// The program: a path, or a name that is looked for on the path.
    pub program: PathBuf,
    /// Folder for a folder of its own, which is deleted afterwards.
    pub scratch: PathBuf,
}

/// Messages that are carried on.
const MOST_MESSAGES: usize = 12;

impl VolumeMesher for Gmsh {
    fn mesh(&self, file: &Path, wishes: &VolumeWishes) -> Result<VolumeMesh, VolumeMesherError> {
        let file = file.canonicalize().map_err(|error| io(file, &error))?;
        let text = script(&file, wishes)?;
        let folder = Folder::new(&self.scratch)?;
        let (geo, msh) = (folder.0.join("part.geo"), folder.0.join("part.msh"));
        std::fs::write(&geo, text).map_err(|error| io(&geo, &error))?;
        let mut command = Command::new(&self.program);
        command.current_dir(&folder.0).args(["part.geo", "-3", "-v", "4", "-o", "part.msh"]);
        let outcome =
            run(&mut command, wishes.timeout, wishes.interrupted).map_err(|error| self.not_started(&error))?;
        let warnings = self.judge(&outcome, wishes)?;
        let bytes =
            std::fs::read(&msh).map_err(|_| VolumeMesherError::Failed { messages: messages(&outcome.lines) })?;
        let imported = read_msh_entities(&bytes).map_err(|errors| no_answer(errors, &outcome))?;
        let cylinders = imported.mesh.cylinders();
        Ok(VolumeMesh { mesh: imported.mesh, cylinders, warnings, notes: imported.notes })
    }
}

impl Gmsh {
    fn not_started(&self, error: &std::io::Error) -> VolumeMesherError {
        match error.kind() {
            std::io::ErrorKind::NotFound => VolumeMesherError::Absent { program: self.program.clone() },
            _ => io(&self.program, error),
        }
    }

    /// Warnings of a run that went well.
    fn judge(&self, outcome: &Outcome, wishes: &VolumeWishes) -> Result<Vec<String>, VolumeMesherError> {
        let messages = messages(&outcome.lines);
        match &outcome.end {
            End::Interrupted => Err(VolumeMesherError::Interrupted),
            End::TimedOut => Err(VolumeMesherError::TimedOut { after: wishes.timeout }),
            End::Exited(_) if outcome.lines.iter().any(|line| line.contains(OPEN)) => Err(VolumeMesherError::Open {
                messages: messages.into_iter().filter(|line| !line.contains(OPEN)).collect(),
            }),
            End::Exited(status) if !status.success() || outcome.lines.iter().any(|line| line.starts_with("Error")) => {
                Err(VolumeMesherError::Failed { messages })
            }
            End::Exited(_) => Ok(messages),
        }
    }
}

fn io(what: &Path, error: &std::io::Error) -> VolumeMesherError {
    VolumeMesherError::Io { what: what.to_owned(), reason: error.to_string() }
}

/// A mesh without solids means that there was nothing to fill.
fn no_answer(errors: Vec<crate::FileError>, outcome: &Outcome) -> VolumeMesherError {
    let empty = errors
        .iter()
        .any(|error| matches!(error.fault, crate::FileFault::EndsEarly { within } if within.contains("no solid")));
    if empty {
        VolumeMesherError::Open { messages: messages(&outcome.lines) }
    } else {
        VolumeMesherError::Answer { errors }
    }
}

/// Errors and warnings without their prefixes, the last ones.
fn messages(lines: &[String]) -> Vec<String> {
    let said = lines.iter().filter(|line| line.starts_with("Error") || line.starts_with("Warning"));
    let tidy = said.map(|line| line.split_once(':').map_or(line.as_str(), |(_, rest)| rest).trim().to_owned());
    let mut all: Vec<String> = tidy.filter(|line| !line.chars().all(|c| c == '-')).collect();
    all.dedup();
    all.split_off(all.len().saturating_sub(MOST_MESSAGES))
}

/// A folder that goes away with its value.
struct Folder(PathBuf);

static NEXT: AtomicU64 = AtomicU64::new(0);

impl Folder {
    fn new(parent: &Path) -> Result<Folder, VolumeMesherError> {
        let name = format!("bellcrank-gmsh-{}-{}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
        let path = parent.join(name);
        std::fs::create_dir_all(&path).map_err(|error| io(&path, &error))?;
        let path = path.canonicalize().map_err(|error| io(&path, &error))?;
        Ok(Folder(path))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // What cannot be deleted is left: nothing depends on it.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
