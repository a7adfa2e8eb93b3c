//! The report: one HTML file that needs nothing else.

mod data;
mod escape;
mod glance;
mod model;
mod page;
mod provenance;
mod reactions;
mod study;

pub(crate) use escape::Escaped;
pub(crate) use page::page;

use bellcrank_results::RunResult;

/// The run as one self-contained HTML document: no network, no other file.
pub fn render_html(run: &RunResult) -> String {
    let figures: Vec<_> = run.studies.iter().map(crate::figures).collect();
    page(run, &figures)
}
