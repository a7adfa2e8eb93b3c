//! One study, top to bottom.

use bellcrank_results::{Findings, RunResult, StudyResult};

use super::page::{counted, warnings};
use super::{Escaped, contours, data, events, flexible, glance, kinds, model, programme, reactions, sentence};
use crate::findings::{self, Check};
use crate::{FigureFile, PictureFile, number, told};

/// Where a study stands in the page.
pub(crate) struct Place<'a> {
    /// Its index in the run.
    pub(crate) index: usize,
    /// Its name as a link target.
    pub(crate) id: &'a str,
}

/// What was drawn of it before.
pub(crate) struct Drawn<'a> {
    pub(crate) figures: &'a [FigureFile],
    /// One a contour; none where there was nothing to draw.
    pub(crate) pictures: &'a [Option<PictureFile>],
}

pub(crate) fn push_section(
    page: &mut String,
    run: &RunResult,
    study: &StudyResult,
    place: &Place<'_>,
    drawn: &Drawn<'_>,
) {
    let figures = drawn.figures;
    let (id, name, kind) = (place.id, Escaped(&study.name), Escaped(&study.kind));
    page.push_str(&format!("<section class=\"study\" id=\"study-{id}\">\n<h2>{name} <small>{kind}</small></h2>\n"));
    page.push_str(&lead(run, study));
    page.push_str(&failure(study));
    page.push_str(&warnings(&study.warnings));
    page.push_str(&unmet(study));
    page.push_str(&model::changed(&study.changed, &run.parameters));
    page.push_str(&kinds::findings(study, place.index, figures));
    page.push_str(&flexible::section(study));
    page.push_str(&contours::section(study, drawn.pictures, place.index));
    page.push_str(&glance::glance(study));
    page.push_str(&programme::section(study, place.index, figures));
    page.push_str(&mounts(run, study, place.index));
    push_figures(page, figures);
    page.push_str(&events::section(study));
    page.push_str(&reactions::table(study));
    page.push_str(&reactions::hodographs(figures, place.index));
    page.push_str(&trust(study));
    page.push_str("</section>\n");
}

/// It ran to its end, but not to what it was for.
fn unmet(study: &StudyResult) -> String {
    told::unmet(study).map_or_else(String::new, |why| {
        format!("<div class=\"note caution\"><b>Goal not reached:</b> {}.</div>\n", sentence(&why))
    })
}

/// What was computed, over what, and from what, in a sentence or two.
fn lead(run: &RunResult, study: &StudyResult) -> String {
    let ranges: Vec<String> = findings::axis_ranges(study)
        .into_iter()
        .map(|(name, range)| format!("<code>{}</code> from {}", Escaped(&name), Escaped(&range_in_words(&range))))
        .collect();
    let over = if ranges.is_empty() { String::new() } else { format!(", {}", ranges.join(", ")) };
    format!(
        "<p class=\"lead\">{}{}{over}. Computed in {} from <code>{}</code>{}.</p>\n",
        what(study),
        positions(study),
        number::duration(study.seconds),
        Escaped(&run.provenance.file),
        if study.changed.is_empty() { "" } else { ", with the parameters below changed" }
    )
}

fn positions(study: &StudyResult) -> String {
    if (study.findings.is_some() || !study.contours.is_empty()) && study.table.rows() == 0 {
        return String::new();
    }
    let in_time = study.axis.first().is_some_and(|axis| axis == "time");
    let (one, many) = if in_time { ("instant", "instants") } else { ("position", "positions") };
    format!(" at {}", counted(study.table.rows(), one, many))
}

fn range_in_words(range: &str) -> String {
    number::typeset_places(range).replace(" … ", " to ")
}

fn what(study: &StudyResult) -> String {
    match study.kind.as_str() {
        "kinematics" => "Positions, velocities and accelerations".to_owned(),
        "inverse-dynamics" => "Positions, velocities, accelerations, drive forces and joint reactions \
             (d’Alembert’s principle)"
            .to_owned(),
        "statics" => "Equilibrium of weights, springs and applied forces".to_owned(),
        "dynamics" => "Motion in time under drives and forces".to_owned(),
        "modes" if matches!(study.findings, Some(Findings::BodyModes(_))) => {
            "Natural frequencies and mode shapes of an elastic body".to_owned()
        }
        "stress" => "Stress in elastic bodies, with its error".to_owned(),
        "modes" => "Natural frequencies, damping and mode shapes of the machine linearized".to_owned(),
        "sensitivity" => "Exact derivatives of a response with respect to parameters".to_owned(),
        "optimize" => "Search for parameters that make a response best within bounds and constraints".to_owned(),
        "sweep" => "Responses over many designs".to_owned(),
        "tolerance" => "Scatter of a response from the tolerances of its parameters".to_owned(),
        "sizing" => "Standard drives against what the motion needs".to_owned(),
        other => format!("A study of kind {}", Escaped(other)),
    }
}

fn failure(study: &StudyResult) -> String {
    let Some(failure) = &study.failure else { return String::new() };
    let hint = |hint: &String| format!("<li>{}</li>\n", sentence(hint));
    let hints: String = failure.hints.iter().map(hint).collect();
    let hints = if hints.is_empty() { hints } else { format!("<p>What to try:</p>\n<ul>\n{hints}</ul>\n") };
    let kept = match study.table.columns.len() {
        0 if study.findings.is_none() => String::new(),
        0 => "<p>What follows is what was found until then.</p>".to_owned(),
        _ => format!("<p>What follows shows the {} before that.</p>", counted(study.table.rows(), "row", "rows")),
    };
    format!(
        "<div class=\"note bad\" role=\"alert\"><b>This study stopped before its end:</b> {}\n{hints}\
         {kept}</div>\n",
        sentence(findings::why_stopped(study).unwrap_or(&failure.message))
    )
}

/// Where the browser part puts the moving drawing and the curves.
fn mounts(run: &RunResult, study: &StudyResult, index: usize) -> String {
    if study.table.rows() == 0 && (study.findings.is_some() || !study.contours.is_empty()) {
        return String::new();
    }
    if study.table.rows() == 0 {
        return "<p class=\"hint\">There are no rows to draw.</p>\n".to_owned();
    }
    let single = findings::is_single(study);
    let stage = if moves(run, study) {
        format!(
            "<h3 class=\"needs-script\">{}</h3>\n\
             <div class=\"stage needs-script\" data-stage=\"{index}\"></div>\n",
            if single { "Position" } else { "Motion" }
        )
    } else {
        String::new()
    };
    if single {
        return stage;
    }
    let thinned = thinned(study);
    format!(
        "{stage}<h3 class=\"needs-script no-print\">Curves</h3>\n\
         <div class=\"curves needs-script no-print\" data-curves=\"{index}\"></div>\n{thinned}"
    )
}

/// Whether there is a drawing of it.
pub(crate) fn moves(run: &RunResult, study: &StudyResult) -> bool {
    let has_frames = study.animation.as_ref().is_some_and(|animation| !animation.frames.is_empty());
    has_frames && study.table.rows() > 0 && !run.drawing.bodies.is_empty()
}

/// Says so where the page holds fewer rows than the study.
fn thinned(study: &StudyResult) -> String {
    let (kept, all) = (data::kept_rows(study).len(), study.table.rows());
    if kept == all {
        return String::new();
    }
    format!(
        "<p class=\"hint\">Drawing and interactive curves show {kept} of the {all} rows; tables, pictures \
         and the series file are of all.</p>\n"
    )
}

/// The charts as pictures: for print, and where scripts do not run.
fn push_figures(page: &mut String, figures: &[FigureFile]) {
    page.push_str("<div class=\"figures\">\n");
    for figure in figures.iter().filter(|figure| figure.joint.is_none() && figure.finding.is_none()) {
        page.push_str("<figure>");
        page.push_str(&inline(&figure.svg));
        page.push_str("</figure>\n");
    }
    page.push_str("</div>\n");
}

/// An SVG document as part of the page, where the name space is understood.
pub(crate) fn inline(svg: &str) -> String {
    svg.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1)
}

/// The trust signals against their limits.
fn trust(study: &StudyResult) -> String {
    let rows: String = findings::checks(study).iter().map(|check| check_row(study, check)).collect();
    let effort: Vec<String> = study
        .effort
        .iter()
        .map(|(name, count)| format!("{} {}", Escaped(&name.replace('_', " ")), number::alone(*count)))
        .collect();
    if rows.is_empty() && effort.is_empty() {
        return String::new();
    }
    let effort = if effort.is_empty() {
        String::new()
    } else {
        format!("<p class=\"hint\">Solver effort: {}.</p>\n", effort.join(", "))
    };
    // Questions asked of another study have their own measures of trust above.
    if rows.is_empty() {
        return effort;
    }
    format!(
        "<div class=\"trust\">\n<h3>Can this be trusted?</h3>\n<div class=\"scroll\">\
         <table>\n{rows}</table></div>\n{effort}</div>\n"
    )
}

fn check_row(study: &StudyResult, check: &Check<'_>) -> String {
    let (class, word) = if check.passed() { ("pass", "pass") } else { ("fail", "FAIL") };
    let unit = &check.finding.column.unit;
    let show = |si: f64| {
        let text = number::typeset(&number::significant(unit.show(si), 3));
        number::with_unit(&text, &Escaped(&unit.symbol).to_string())
    };
    let place = findings::whereabouts(study, check.finding.reductions.peak());
    format!(
        "<tr><th scope=\"row\">{}<span class=\"kind\">{}</span></th><td class=\"n\">{}</td>\
         <td class=\"at\">{}</td><td>limit {}</td><td class=\"{class}\">{word}</td></tr>\n",
        check.title,
        check.meaning,
        show(check.finding.peak()),
        Escaped(&number::typeset_places(&if place.is_empty() { place } else { format!("at {place}") })),
        show(check.limit)
    )
}
