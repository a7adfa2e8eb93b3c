//! What a study found beside its rows: one file a kind.

mod designs;
mod modes;
mod optimization;
mod sensitivity;
mod sizing;
mod stress;
mod tolerance;

use bellcrank_results::{Findings, StudyResult};

use super::rows::words;
use super::study::inline;
use crate::{FigureFile, told};

/// Sentences first, then pictures and tables; nothing for a study without findings.
pub(crate) fn findings(study: &StudyResult, index: usize, figures: &[FigureFile]) -> String {
    let Some(findings) = &study.findings else { return String::new() };
    let body = match findings {
        Findings::Sensitivity(found) => sensitivity::section(found, figures),
        Findings::Optimization(found) => optimization::section(found, figures),
        Findings::Designs(found) => designs::section(found, index, figures),
        Findings::Tolerance(found) => tolerance::section(found, figures),
        Findings::Modes(found) => modes::section(found),
        Findings::Sizing(found) => sizing::section(found, figures),
        Findings::Stress(found) => stress::section(found),
        Findings::BodyModes(found) => stress::modes(found),
    };
    format!("<h3>Result</h3>\n{}{body}", told(findings))
}

/// The first sentence is what was asked for.
fn told(findings: &Findings) -> String {
    let sentences = told::sentences(findings);
    let line = |(index, text): (usize, &String)| {
        let class = if index == 0 { "answer" } else { "lead" };
        format!("<p class=\"{class}\">{}</p>\n", words(text))
    };
    sentences.iter().enumerate().map(line).collect()
}

/// The pictures of that finding, each as wide as there is room.
fn pictures(figures: &[FigureFile], finding: &str, class: &str) -> String {
    let wanted = figures.iter().filter(|figure| figure.finding == Some(finding));
    let pictures: String = wanted.map(|figure| format!("<figure>{}</figure>\n", inline(&figure.svg))).collect();
    if pictures.is_empty() { pictures } else { format!("<div class=\"{class}\">\n{pictures}</div>\n") }
}
