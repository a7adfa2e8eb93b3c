//! Flexible bodies row by row for ParaView.

use std::path::{Path, PathBuf};

use bellcrank_results::{FlexibleMotion, PvdEntry, StudyResult, file_stems, write_pvd, write_vtu_row};

use crate::ReportError;
use crate::write::make_folder;

/// Rows that are written, evenly spread; the last one and the one of the largest stress are among them.
const MOST_ROWS: usize = 240;

/// `motion.pvd` and a folder a body; nothing without flexible bodies.
pub(super) fn write(study: &StudyResult, folder: &Path) -> Result<Vec<PathBuf>, ReportError> {
    let whole: Vec<&FlexibleMotion> = study.motions.iter().filter(|motion| motion.is_whole()).collect();
    if whole.is_empty() {
        return Ok(Vec::new());
    }
    let stems = file_stems(whole.iter().map(|motion| motion.body.as_str()));
    let (mut written, mut entries) = (Vec::new(), Vec::new());
    for (part, (motion, stem)) in whole.iter().zip(&stems).enumerate() {
        make_folder(&folder.join(stem))?;
        for (step, at) in kept(motion).into_iter().enumerate() {
            let file = format!("{stem}/{stem}_{step:04}.vtu");
            written.push(super::write(folder.join(&file), |out| write_vtu_row(motion, at, out))?);
            entries.push(PvdEntry { at: count(study, motion.rows[at]), part, name: motion.body.clone(), file });
        }
    }
    // Readers want rising times.
    entries.sort_by(|a, b| a.at.total_cmp(&b.at).then(a.part.cmp(&b.part)));
    written.insert(0, super::write(folder.join("motion.pvd"), |out| write_pvd(&entries, out))?);
    Ok(written)
}

/// Rows of the motion that are written, rising.
fn kept(motion: &FlexibleMotion) -> Vec<usize> {
    let count = motion.rows.len();
    let mut kept: Vec<usize> = (0..count).step_by(count.div_ceil(MOST_ROWS).max(1)).collect();
    kept.extend([count - 1, motion.worst.min(count - 1)]);
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// What a row is counted by: the only axis of the study as it is shown, where it rises, else the number of the row.
fn count(study: &StudyResult, row: usize) -> f64 {
    let axis = match study.axis.as_slice() {
        [one] => study.table.column(one),
        _ => None,
    };
    let rises = |values: &[f64]| values.windows(2).all(|pair| pair[0] < pair[1]);
    let axis = axis.filter(|column| rises(&column.values));
    let value = axis.and_then(|column| column.values.get(row).map(|si| column.unit.show(*si)));
    value.unwrap_or(row as f64)
}
