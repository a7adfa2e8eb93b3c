//! The files that a run leaves.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use bellcrank_results::{
    RunResult, StudyResult, event_table, finding_tables, flexible_tables, study_summary, write_csv, write_text_csv,
};

use crate::exports::{Exports, write_exports};
use crate::html::page;
use crate::{FigureFile, PictureFile, ReportError, figures, pictures, study_folders};

/// Writes `report.html`, `STUDY/plots/*.svg` and `STUDY/*.png` into `dir`, which is made where it is missing.
///
/// Gives the paths that were written, the report first.
///
/// # Errors
/// A folder that cannot be made or a file that cannot be written.
pub fn write_report(run: &RunResult, dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    make_folder(dir)?;
    let figures: Vec<_> = run.studies.iter().map(figures).collect();
    let pictures: Vec<_> = run.studies.iter().map(pictures).collect();
    let page = page(run, &figures, &pictures);
    let mut written = vec![write_file(dir.join("report.html"), page.as_bytes())?];
    for (figures, folder) in figures.iter().zip(study_folders(run)) {
        written.extend(write_plots(figures, &dir.join(folder).join("plots"))?);
    }
    for (pictures, folder) in pictures.iter().zip(study_folders(run)) {
        written.extend(write_pictures(pictures, &dir.join(folder))?);
    }
    Ok(written)
}

/// Writes everything a run leaves: for each study `series.csv`, `summary.json`, tables of what it
/// found, plots and what `exports` asks for, and one `report.html`.
///
/// A study over another study has no `series.csv` where it has no rows of its own; the rows of a
/// sweep (`designs.csv`) are written by whoever computes them.
///
/// Gives the paths that were written, the report first.
///
/// # Errors
/// A folder that cannot be made or a file that cannot be written.
pub fn write_run(run: &RunResult, dir: &Path, exports: Exports) -> Result<Vec<PathBuf>, ReportError> {
    let mut written = write_report(run, dir)?;
    for (study, folder) in run.studies.iter().zip(study_folders(run)) {
        let folder = dir.join(folder);
        make_folder(&folder)?;
        if study.findings.is_none() || study.table.rows() > 0 {
            written.push(write_series(study, folder.join("series.csv"))?);
        }
        written.extend(write_tables(study, &folder)?);
        written.extend(write_exports(run, study, &folder, exports)?);
        let summary = format!("{:#}\n", study_summary(study));
        written.push(write_file(folder.join("summary.json"), summary.as_bytes())?);
    }
    Ok(written)
}

fn write_plots(figures: &[FigureFile], dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    if !figures.is_empty() {
        make_folder(dir)?;
    }
    let write = |file: &FigureFile| write_file(dir.join(format!("{}.svg", file.stem)), file.svg.as_bytes());
    figures.iter().map(write).collect()
}

fn write_pictures(pictures: &[Option<PictureFile>], dir: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let all: Vec<&PictureFile> = pictures.iter().flatten().collect();
    if !all.is_empty() {
        make_folder(dir)?;
    }
    let write = |file: &PictureFile| write_file(dir.join(format!("{}.png", file.stem)), &file.png);
    all.into_iter().map(write).collect()
}

fn write_series(study: &StudyResult, path: PathBuf) -> Result<PathBuf, ReportError> {
    let write = |path: &Path| write_csv(&study.table, File::create(path)?);
    match write(&path) {
        Ok(()) => Ok(path),
        Err(source) => Err(ReportError::File { path, source }),
    }
}

/// One file a table of the findings: `sensitivity.csv`, `iterations.csv`, `candidates.csv`, ...; and `events.csv`.
fn write_tables(study: &StudyResult, folder: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let happened = study.events.as_ref().and_then(event_table).map(|table| ("events".to_owned(), table));
    let tables = study.findings.iter().flat_map(finding_tables).chain(happened);
    let tables = tables.chain(study.flexible.iter().flat_map(flexible_tables));
    let write = |(stem, table)| {
        let path = folder.join(format!("{stem}.csv"));
        match File::create(&path).and_then(|file| write_text_csv(&table, file)) {
            Ok(()) => Ok(path),
            Err(source) => Err(ReportError::File { path, source }),
        }
    };
    tables.map(write).collect()
}

pub(crate) fn make_folder(path: &Path) -> Result<(), ReportError> {
    fs::create_dir_all(path).map_err(|source| ReportError::Folder { path: path.to_owned(), source })
}

fn write_file(path: PathBuf, bytes: &[u8]) -> Result<PathBuf, ReportError> {
    match fs::write(&path, bytes) {
        Ok(()) => Ok(path),
        Err(source) => Err(ReportError::File { path, source }),
    }
}
