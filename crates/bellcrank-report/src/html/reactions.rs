//! The reaction table and the force hodographs.

use bellcrank_results::{Reaction, StudyResult};

use super::Escaped;
use crate::findings::{self, Finding};
use crate::{FigureFile, number};

const COMPONENTS: [&str; 8] = ["fx", "fy", "fz", "force", "mx", "my", "mz", "moment"];

/// A component this much smaller than the largest force of the study (moments over a metre) is a rounding error.
const ROUNDING: f64 = 1e-12;

/// Each component of each joint: extremes, where they occur, and whether they are unique.
pub(crate) fn table(study: &StudyResult) -> String {
    let rounding = ROUNDING * findings::strongest_peak(study);
    let bodies: String = joints(study).iter().map(|joint| joint_rows(study, joint, rounding)).collect();
    if bodies.is_empty() {
        return String::new();
    }
    let places = match study.axis.join(", ") {
        names if names.is_empty() => String::new(),
        names => format!(" Places are values of <code>{}</code>.", Escaped(&names)),
    };
    format!(
        "<h3>Joint reactions</h3>\n<p class=\"hint\">What the first body of a joint puts on the \
         second, at the joint's point, along the world axes; <em>force</em> and <em>moment</em> \
         are magnitudes.{places} Components that are zero \
         throughout, but for rounding, are left out.{}{}</p>\n<div class=\"scroll\"><table class=\"reactions\">\n\
         <thead><tr><th scope=\"col\">Joint</th><th scope=\"col\"></th>\
         <th scope=\"col\" class=\"n\">Min</th><th scope=\"col\" class=\"n\">at</th>\
         <th scope=\"col\" class=\"n\">Max</th><th scope=\"col\" class=\"n\">at</th>\
         <th scope=\"col\">Unit</th><th scope=\"col\">Determined</th></tr></thead>\n\
         {bodies}</table></div>\n",
        uniqueness_hint(study),
        omitted(study)
    )
}

fn uniqueness_hint(study: &StudyResult) -> &'static str {
    let loose = |reaction: &Reaction| reaction.unique.iter().any(|(_, unique)| !unique);
    if study.reactions.iter().any(loose) {
        " Equilibrium alone does not fix the ones marked <b>not unique</b> (the mechanism is \
         over-constrained there): shown is the smallest set of forces that keeps balance; the \
         real ones depend on clearances and stiffness."
    } else {
        ""
    }
}

/// Joints of the table: a page of more is read by nobody, and the series file has them all.
const MOST_JOINTS: usize = 150;

/// Joints that have reactions, in the order of the study; of very many, the strongest.
fn joints(study: &StudyResult) -> Vec<&str> {
    let mut found = findings::strongest(study);
    found.truncate(MOST_JOINTS);
    let place = |joint: &str| study.reactions.iter().position(|reaction| reaction.joint == joint);
    found.sort_by_cached_key(|(joint, _)| place(joint).unwrap_or(usize::MAX));
    found.into_iter().map(|(joint, _)| joint).collect()
}

/// Says so where the table does not hold all joints.
fn omitted(study: &StudyResult) -> String {
    match findings::strongest(study).len() {
        all if all > MOST_JOINTS => format!(" Shown are the {MOST_JOINTS} most loaded of {all} joints."),
        _ => String::new(),
    }
}

fn joint_rows(study: &StudyResult, joint: &str, rounding: f64) -> String {
    let reaction = study.reactions.iter().find(|reaction| reaction.joint == joint);
    let component = |name: &&'static str| {
        let finding = findings::finding(study, &format!("joint.{joint}.reaction.{name}"))?;
        (finding.peak() > rounding).then_some((*name, finding))
    };
    let found: Vec<(&str, Finding<'_>)> = COMPONENTS.iter().filter_map(component).collect();
    let mut head = joint_head(joint, reaction, found.len());
    let mut rows = String::new();
    for (name, finding) in &found {
        let cells = component_cells(study, name, finding);
        let mark = mark(reaction, name);
        rows.push_str(&format!("<tr>{head}{cells}{mark}</tr>\n"));
        head.clear();
    }
    if rows.is_empty() { rows } else { format!("<tbody>\n{rows}</tbody>\n") }
}

fn joint_head(joint: &str, reaction: Option<&Reaction>, rows: usize) -> String {
    let kind = reaction.map_or("", |reaction| reaction.kind.as_str());
    let (joint, kind) = (Escaped(joint), Escaped(kind));
    format!("<th scope=\"rowgroup\" rowspan=\"{rows}\">{joint}<span class=\"kind\">{kind}</span></th>")
}

fn component_cells(study: &StudyResult, name: &str, finding: &Finding<'_>) -> String {
    let (found, unit) = (&finding.reductions, &finding.column.unit);
    let decimals = number::decimals(unit.show(finding.peak()), 5);
    let show = |si: f64| number::typeset(&number::aligned(unit.show(si), decimals));
    let at = |extreme| number::typeset_places(&findings::whereabouts(study, extreme));
    let strong = if ["force", "moment"].contains(&name) { " class=\"magnitude\"" } else { "" };
    format!(
        "<td{strong}>{name}</td><td class=\"n\">{}</td><td class=\"n at\">{}</td>\
         <td class=\"n\">{}</td><td class=\"n at\">{}</td><td>{}</td>",
        show(found.min.value),
        Escaped(&at(found.min)),
        show(found.max.value),
        Escaped(&at(found.max)),
        Escaped(&number::unit(&unit.symbol))
    )
}

/// Magnitudes are as unique as the components they are made of.
fn mark(reaction: Option<&Reaction>, name: &str) -> &'static str {
    let parts: &[&str] = match name {
        "force" => &["fx", "fy", "fz"],
        "moment" => &["mx", "my", "mz"],
        _ => &[name],
    };
    let listed = reaction.into_iter().flat_map(|reaction| &reaction.unique);
    let mut marks = listed.filter(|(part, _)| parts.contains(&part.as_str())).peekable();
    if marks.peek().is_none() {
        return "<td></td>";
    }
    if marks.all(|(_, unique)| *unique) {
        "<td class=\"unique\">unique</td>"
    } else {
        "<td class=\"loose\">not unique</td>"
    }
}

/// The hodographs among the figures.
pub(crate) fn hodographs(figures: &[FigureFile], study: usize) -> String {
    let plots: String = figures.iter().filter_map(|figure| hodograph(figure, study)).collect();
    if plots.is_empty() {
        return String::new();
    }
    format!(
        "<h3>Force hodographs</h3>\n<p class=\"hint\">The path of each joint's force vector in \
         world axes over the study: hollow dot at the first row, full dot at the last, dashed the \
         largest force. The orange marker follows the drawing above.</p>\n\
         <div class=\"hodographs\">\n{plots}</div>\n"
    )
}

fn hodograph(figure: &FigureFile, study: usize) -> Option<String> {
    let (joint, (x, y)) = (figure.joint.as_ref()?, figure.components.as_ref()?);
    Some(format!(
        "<figure data-hodograph=\"{study}\" data-joint=\"{}\" data-x=\"{x}\" data-y=\"{y}\">\
         {}</figure>\n",
        Escaped(joint),
        super::study::inline(&figure.svg)
    ))
}
