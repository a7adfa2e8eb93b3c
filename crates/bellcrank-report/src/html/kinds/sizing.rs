//! What is needed, what there is, and why most of it does not do.

use bellcrank_results::{Candidate, Check, Property, Sizing};

use super::super::Escaped;
use super::super::rows::{Rows, code, number, symbol, words};
use super::pictures;
use crate::FigureFile;
use crate::told::{about, word};

/// Candidates with all of their checks; the file has all.
const MOST_CANDIDATES: usize = 24;
/// What a candidate is needs no more.
const DIGITS: usize = 4;

pub(super) fn section(found: &Sizing, figures: &[FigureFile]) -> String {
    let lists = [("Needed", &found.requirements), ("Assumed", &found.conditions)];
    let lists: String = lists.iter().map(|(title, of)| properties(title, of)).collect();
    format!(
        "<div class=\"pair\">\n{lists}</div>\n{}<h3>Candidates</h3>\n<div class=\"candidates\">{}</div>\n",
        pictures(figures, "stroke", "pair"),
        candidates(found)
    )
}

fn properties(title: &str, of: &[Property]) -> String {
    let mut rows = Rows::new(&[title, " Value", "Unit"]);
    for one in of {
        rows.push(&[Escaped(&one.label).to_string(), number(one.value, &one.unit), symbol(&one.unit)]);
    }
    format!("<div>{}</div>\n", rows.html())
}

fn candidates(found: &Sizing) -> String {
    let mut rows = Rows::new(&["Candidate", "Verdict", "What it is", "Checks"]);
    for (index, candidate) in found.candidates.iter().take(MOST_CANDIDATES).enumerate() {
        let chosen = found.chosen == Some(index);
        rows.push_marked(if chosen { "chosen" } else { "" }, &cells(candidate, chosen));
    }
    let rest = found.candidates.len().saturating_sub(MOST_CANDIDATES);
    let rest = if rest > 0 {
        format!("<p class=\"hint\">and {rest} more in <code>candidates.csv</code>.</p>\n")
    } else {
        String::new()
    };
    rows.html() + &rest
}

fn cells(candidate: &Candidate, chosen: bool) -> [String; 4] {
    let verdict = match (chosen, candidate.passes) {
        (true, _) => "<span class=\"pass\">proposed</span>",
        (false, true) => "<span class=\"pass\">passes</span>",
        (false, false) => "<span class=\"fail\">FAILS</span>",
    };
    let properties: Vec<String> = candidate
        .properties
        .iter()
        .map(|one| format!("{} {}", one.label, about(one.value, &one.unit, DIGITS)))
        .collect();
    let checks: String = candidate.checks.iter().map(check).collect();
    [
        code(&candidate.name),
        verdict.to_owned(),
        words(&properties.join(", ")),
        format!("<ul class=\"checks\">{checks}</ul>"),
    ]
}

fn check(check: &Check) -> String {
    let class = match check.passes {
        Some(true) => "pass",
        Some(false) => "fail",
        None => "unique",
    };
    let key = check.key.replace('_', " ");
    // A reason that begins with what it is about says it itself.
    let about = if check.reason.starts_with(&key) { String::new() } else { format!("{}: ", Escaped(&key)) };
    format!("<li><span class=\"{class}\">{}</span> {about}{}</li>", word(check), words(&check.reason))
}
