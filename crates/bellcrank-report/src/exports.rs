//! Files that a study leaves only when asked for.

mod series;

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use bellcrank_results::{RunResult, StudyResult, write_glb, write_parquet};

use crate::ReportError;

/// What a run leaves beside CSV, JSON, plots and the report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Exports {
    /// `motion.glb` for each study that moves.
    pub gltf: bool,
    /// `series.parquet` for each study that has rows.
    pub parquet: bool,
    /// `motion.pvd` with `BODY/BODY_0000.vtu` and so on for each study with flexible bodies.
    pub vtu: bool,
}

/// Writes what is asked for and what the study has (its attachments were asked for); gives the paths.
pub(crate) fn write_exports(
    run: &RunResult,
    study: &StudyResult,
    folder: &Path,
    exports: Exports,
) -> Result<Vec<PathBuf>, ReportError> {
    let moves = study.animation.as_ref().is_some_and(|animation| !animation.frames.is_empty());
    let mut written = Vec::new();
    if exports.gltf && moves {
        written.push(write(folder.join("motion.glb"), |file| write_glb(run, study, file))?);
    }
    if exports.parquet && study.table.rows() > 0 {
        written.push(write(folder.join("series.parquet"), |file| write_parquet(&study.table, file))?);
    }
    if exports.vtu {
        written.extend(series::write(study, folder)?);
    }
    for file in &study.attachments {
        written.push(write(folder.join(&file.name), |out| out.write_all(&file.bytes))?);
    }
    Ok(written)
}

fn write(path: PathBuf, fill: impl Fn(&mut dyn Write) -> io::Result<()>) -> Result<PathBuf, ReportError> {
    let into = |path: &Path| fill(&mut BufWriter::new(File::create(path)?));
    match into(&path) {
        Ok(()) => Ok(path),
        Err(source) => Err(ReportError::File { path, source }),
    }
}
