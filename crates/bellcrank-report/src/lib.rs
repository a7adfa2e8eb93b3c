//! Plots, tables and the self-contained HTML report.
//!
//! Three readers of one [`RunResult`](bellcrank_results::RunResult): [`terminal_summary`] for a
//! glance, [`render_html`] for a report to sign, [`figures`] for a paper. Nothing in here knows
//! mechanics; what is shown was computed elsewhere, in SI, with the unit to show it in.

mod error;
mod exports;
mod figures;
mod findings;
mod html;
mod number;
mod picture;
mod plot;
mod terminal;
mod told;
mod write;

pub use bellcrank_results::study_folders;
pub use error::ReportError;
pub use exports::Exports;
pub use figures::{FigureFile, figures};
pub use html::render_html;
pub use picture::{PictureFile, pictures};
pub use terminal::{Style, terminal_convergence, terminal_summary};
pub use write::{write_report, write_run};
