//! The page around the sections.

use bellcrank_results::{RunResult, StudyResult};

use super::{Escaped, contours, data, flexible, model, provenance, sentence, study};
use crate::{FigureFile, PictureFile, findings, study_folders, told};

/// The browser part, built from `web/` (see its README) and committed: building needs no npm.
const SCRIPT: &str = include_str!("../../web/dist/report.js");
const SHEET: &str = include_str!("../../web/dist/report.css");
/// The solid drawing with what it uses of three.js, as gzip in base64.
const SOLID: &str = include_str!("../../web/dist/solid.gz.txt");

/// About what a page of a few studies takes: saves copying it while it grows.
const PAGE_BYTES: usize = 1 << 21;

/// Forbids the page every connection, so that it shows the same thing on and off the network.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; \
                      img-src data:";

/// The whole document; `figures` and `pictures` are those of each study.
pub(crate) fn page(run: &RunResult, figures: &[Vec<FigureFile>], pictures: &[Vec<Option<PictureFile>>]) -> String {
    let with_parts = contours::any(pictures);
    let mut page = head(run, if with_parts { contours::SHEET } else { "" });
    page.reserve(PAGE_BYTES);
    let ids = study_folders(run);
    page.push_str(&header(run));
    page.push_str(&contents(run, &ids));
    page.push_str("<main>\n");
    page.push_str(&notes(run, &ids));
    page.push_str(&model::section(run));
    for (index, of) in run.studies.iter().enumerate() {
        let place = study::Place { index, id: &ids[index] };
        study::push_section(
            &mut page,
            run,
            of,
            &place,
            &study::Drawn { figures: &figures[index], pictures: &pictures[index] },
        );
    }
    page.push_str(&provenance::section(run));
    page.push_str("</main>\n");
    data::push(&mut page, run);
    if with_parts {
        contours::push_data(&mut page, run, pictures);
    }
    flexible::push_data(&mut page, run);
    if with_parts || run.studies.iter().any(|study| study::moves(run, study)) {
        page.push_str(&format!(
            "<!-- three.js, (c) three.js authors, MIT licence -->\n\
             <script type=\"text/plain\" id=\"bellcrank-solid\">{SOLID}</script>\n"
        ));
    }
    if with_parts {
        page.push_str(&format!("<script>{}</script>\n", contours::SCRIPT));
    }
    page.push_str(&format!("<script>{SCRIPT}</script>\n</body>\n</html>\n"));
    page
}

/// `more` is sheet beyond what every page has.
fn head(run: &RunResult, more: &str) -> String {
    let title = Escaped(title(run));
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <title>{title}</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>{SHEET}{more}</style>\n\
         <noscript><style>.figures{{display:grid}}.needs-script{{display:none}}</style></noscript>\n\
         </head>\n<body>\n"
    )
}

fn title(run: &RunResult) -> &str {
    if run.title.is_empty() { &run.model } else { &run.title }
}

fn header(run: &RunResult) -> String {
    let from = &run.provenance;
    format!(
        "<header>\n<p class=\"kicker\">Mechanism analysis report</p>\n<h1>{}</h1>\n\
         <p class=\"byline\">Model <b>{}</b>, from <code>{}</code> · {} · bellcrank {}</p>\n\
         {}</header>\n",
        Escaped(title(run)),
        Escaped(&run.model),
        Escaped(&from.file),
        Escaped(&from.date),
        Escaped(&from.version),
        verdict(run)
    )
}

/// One word on the whole run, with its reason: the first thing a reader looks for.
fn verdict(run: &RunResult) -> String {
    let count = |bad: fn(&StudyResult) -> bool| run.studies.iter().filter(|s| bad(s)).count();
    let stopped = count(|study| study.failure.is_some());
    let doubtful = count(findings::is_doubtful);
    let unmet = count(|study| told::unmet(study).is_some());
    let warned = run.warnings.len() + run.studies.iter().map(|s| s.warnings.len()).sum::<usize>();
    let (class, text) = if stopped > 0 {
        ("bad", format!("{} did not reach the end", counted(stopped, "study", "studies")))
    } else if doubtful > 0 {
        ("bad", format!("residuals too large in {}", counted(doubtful, "study", "studies")))
    } else if unmet > 0 {
        ("caution", format!("complete, but {} did not reach the goal", counted(unmet, "study", "studies")))
    } else if warned > 0 {
        ("caution", format!("complete, with {}", counted(warned, "warning", "warnings")))
    } else {
        ("good", "complete, without warnings".to_owned())
    };
    format!("<p class=\"verdict {class}\">{text}</p>\n")
}

pub(crate) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

fn contents(run: &RunResult, ids: &[String]) -> String {
    let entry = |(study, id): (&StudyResult, &String)| {
        format!("<li><a href=\"#study-{id}\">{}</a></li>\n", Escaped(&study.name))
    };
    let studies: String = run.studies.iter().zip(ids).map(entry).collect();
    format!(
        "<nav aria-label=\"Contents\">\n<ul>\n<li><a href=\"#model\">Model</a></li>\n{studies}\
         <li><a href=\"#provenance\">Provenance</a></li>\n\
         <li><a href=\"#signature\">Signature</a></li>\n</ul>\n</nav>\n"
    )
}

/// Failures of all studies and warnings of the model, before anything else.
fn notes(run: &RunResult, ids: &[String]) -> String {
    let failure = |(study, id): (&StudyResult, &String)| {
        let why = findings::why_stopped(study)?;
        Some(format!(
            "<div class=\"note bad\" role=\"alert\"><b>Study <a href=\"#study-{id}\">{}</a> \
             stopped early.</b> {}</div>\n",
            Escaped(&study.name),
            sentence(why)
        ))
    };
    let failures: String = run.studies.iter().zip(ids).filter_map(failure).collect();
    failures + &warnings(&run.warnings)
}

/// A box for each sentence.
pub(crate) fn warnings(sentences: &[String]) -> String {
    let note = |text: &String| format!("<div class=\"note caution\"><b>Warning.</b> {}</div>\n", sentence(text));
    sentences.iter().map(note).collect()
}
