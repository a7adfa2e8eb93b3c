//! The report: one HTML file that needs nothing else.

mod contours;
mod data;
mod escape;
mod events;
mod flexible;
mod glance;
mod kinds;
mod model;
mod page;
mod programme;
mod provenance;
mod reactions;
mod rows;
mod sentence;
mod study;

pub(crate) use escape::Escaped;
pub(crate) use page::page;
pub(crate) use sentence::sentence;

use bellcrank_results::RunResult;

/// The run as one self-contained HTML document: no network, no other file.
pub fn render_html(run: &RunResult) -> String {
    let figures: Vec<_> = run.studies.iter().map(crate::figures).collect();
    let pictures: Vec<_> = run.studies.iter().map(crate::pictures).collect();
    page(run, &figures, &pictures)
}
