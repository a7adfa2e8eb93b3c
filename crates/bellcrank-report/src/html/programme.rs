//! What moves when: the cycle chart and its moves in a table.

use bellcrank_results::{Move, Programme, StudyResult};

use super::rows::{Rows, code, number, symbol};
use super::study::inline;
use crate::FigureFile;
use crate::figures::PROGRAMME;

/// Moves of the table; the summary has all.
const MOST: usize = 200;

/// Nothing for a study without a programme.
pub(crate) fn section(study: &StudyResult, index: usize, figures: &[FigureFile]) -> String {
    let Some(of) = &study.programme else { return String::new() };
    let chart = figures.iter().find(|figure| figure.finding == Some(PROGRAMME)).map_or_else(String::new, |figure| {
        format!("<figure class=\"cycle\" data-cycle=\"{index}\">{}</figure>\n", inline(&figure.svg))
    });
    format!("<h3>Programme</h3>\n{chart}{}", table(of))
}

fn table(of: &Programme) -> String {
    let unit = &of.time.symbol;
    let heads = [
        format!(" Start in {unit}"),
        format!(" End in {unit}"),
        "Joint".to_owned(),
        " From".to_owned(),
        " To".to_owned(),
    ];
    let rest = ["", "Motion", "Segment", "How"].map(str::to_owned);
    let mut rows = Rows::new(&heads.into_iter().chain(rest).collect::<Vec<_>>());
    of.moves.iter().take(MOST).for_each(|one| rows.push(&cells(of, one)));
    let more = match of.moves.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!("<p class=\"hint\">and {more} more in <code>summary.json</code>.</p>\n"),
    };
    format!("<details>\n<summary>Moves in the order of time</summary>\n{}{more}</details>\n", rows.html())
}

fn cells(of: &Programme, one: &Move) -> [String; 9] {
    let none = || "–".to_owned();
    [
        number(one.start, &of.time),
        one.end.map_or_else(none, |end| number(end, &of.time)),
        code(&one.joint),
        number(one.from, &one.unit),
        one.to.map_or_else(none, |to| number(to, &one.unit)),
        symbol(&one.unit),
        code(&one.motion),
        one.segment.as_deref().map_or_else(String::new, code),
        one.profile.to_owned(),
    ]
}
