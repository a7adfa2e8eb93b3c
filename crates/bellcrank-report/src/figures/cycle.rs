//! The cycle chart of a study over time.

use bellcrank_results::StudyResult;

use super::FigureFile;
use crate::plot::Cycle;

/// The finding that the chart draws.
pub(crate) const PROGRAMME: &str = "programme";

/// Nothing for a study without motions or without rows; it lasts as long as the rows do.
pub(super) fn figure(study: &StudyResult) -> Option<FigureFile> {
    let of = study.programme.as_ref()?;
    let until = study.table.column("time")?.values.last().copied().filter(|until| *until > 0.0)?;
    let title = "Cycle chart".to_owned();
    let svg = Cycle { title: title.clone(), of, until }.svg();
    Some(FigureFile::of_finding(PROGRAMME, "cycle-chart".to_owned(), title, svg))
}
