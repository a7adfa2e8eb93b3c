//! Key results of a study at a glance.

use bellcrank_results::{Extreme, StudyResult, Unit};

use super::Escaped;
use crate::findings::{self, Finding};
use crate::number;

/// Cards with the numbers that matter most, then a table of all drives and strokes.
pub(crate) fn glance(study: &StudyResult) -> String {
    let cards = cards(study);
    if cards.is_empty() && study.scalars.is_empty() {
        return String::new();
    }
    let cards: String = cards.iter().map(Card::html).collect();
    format!(
        "<h3>Key results</h3>\n<div class=\"cards\">\n{cards}</div>\n{}{}",
        extremes_table(study),
        scalars(&study.scalars)
    )
}

struct Card {
    label: String,
    value: String,
    place: String,
}

impl Card {
    /// The largest magnitude of a finding and where it occurs.
    fn peak(study: &StudyResult, label: String, finding: &Finding<'_>) -> Self {
        let peak = finding.reductions.peak();
        let value = finding.shown(peak.value);
        let place = axis_and_place(study, peak);
        Self { label, value, place: if place.is_empty() { place } else { format!("at {place}") } }
    }

    fn html(&self) -> String {
        format!(
            "<div class=\"card\"><div class=\"label\">{}</div><div class=\"value\">{}</div>\
             <div class=\"place\">{}</div></div>\n",
            Escaped(&self.label),
            Escaped(&number::typeset(&self.value)),
            Escaped(&number::typeset_places(&self.place))
        )
    }
}

fn cards(study: &StudyResult) -> Vec<Card> {
    let drive = findings::drives(study)
        .into_iter()
        .max_by(|a, b| a.1.peak().total_cmp(&b.1.peak()))
        .map(|(joint, found)| Card::peak(study, format!("Peak drive effort, {joint}"), &found));
    let strokes = if findings::is_single(study) { Vec::new() } else { findings::strokes(study) };
    let stroke = strokes.into_iter().max_by(|a, b| strokes_first(study, a, b));
    let strongest = findings::strongest(study)
        .into_iter()
        .next()
        .map(|(joint, found)| Card::peak(study, format!("Strongest reaction, {joint}"), &found));
    drive.into_iter().chain(stroke.map(|found| stroke_card(&found))).chain(strongest).collect()
}

/// The swept coordinate is known beforehand; the stroke of another driven joint is news.
fn strokes_first(study: &StudyResult, a: &Finding<'_>, b: &Finding<'_>) -> std::cmp::Ordering {
    let swept = |finding: &Finding<'_>| study.axis.contains(&finding.column.name);
    let range = |finding: &Finding<'_>| finding.reductions.range;
    swept(b).cmp(&swept(a)).then(range(a).total_cmp(&range(b)))
}

fn stroke_card(finding: &Finding<'_>) -> Card {
    let found = &finding.reductions;
    let show = |si: f64| number::alone(finding.column.unit.show(si));
    let (low, high) = (show(found.min.value), finding.shown(found.max.value));
    Card {
        label: format!("Stroke, {}", finding.column.name),
        value: finding.shown(found.range),
        place: format!("{low} … {high}"),
    }
}

/// `joint.B.position = -30 deg`.
fn axis_and_place(study: &StudyResult, extreme: Extreme) -> String {
    let place = findings::whereabouts(study, extreme);
    match study.axis.as_slice() {
        [axis] if study.table.column(axis).is_some() => format!("{axis} = {place}"),
        _ => place,
    }
}

fn extremes_table(study: &StudyResult) -> String {
    if findings::is_single(study) {
        return value_table(study);
    }
    let drives = findings::drives(study).into_iter().map(|(_, finding)| finding);
    let rows: String = drives.chain(findings::strokes(study)).map(|finding| extremes_row(study, &finding)).collect();
    if rows.is_empty() {
        return String::new();
    }
    format!(
        "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">Drive or stroke</th>\
         <th scope=\"col\" class=\"n\">Min</th><th scope=\"col\" class=\"n\">at</th>\
         <th scope=\"col\" class=\"n\">Max</th><th scope=\"col\" class=\"n\">at</th>\
         <th scope=\"col\" class=\"n\">Range</th><th scope=\"col\" class=\"n\">RMS</th>\
         <th scope=\"col\">Unit</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
    )
}

fn value_table(study: &StudyResult) -> String {
    let row = |finding: Finding<'_>| {
        let value = Escaped(&number::typeset(&finding.shown(finding.reductions.first))).to_string();
        format!(
            "<tr><th scope=\"row\"><code>{}</code></th><td class=\"n\">{value}</td></tr>\n",
            Escaped(&finding.column.name)
        )
    };
    let rows: String = findings::values(study).into_iter().map(row).collect();
    if rows.is_empty() {
        return rows;
    }
    format!(
        "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">Drive or position</th>\
         <th scope=\"col\" class=\"n\">Value</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
    )
}

fn extremes_row(study: &StudyResult, finding: &Finding<'_>) -> String {
    let (found, unit) = (&finding.reductions, &finding.column.unit);
    let decimals = finding.decimals();
    let show = |si: f64| number::typeset(&number::aligned(unit.show(si), decimals));
    let at = |extreme| number::typeset_places(&findings::whereabouts(study, extreme));
    format!(
        "<tr><th scope=\"row\"><code>{}</code></th><td class=\"n\">{}</td><td class=\"n at\">{}</td>\
         <td class=\"n\">{}</td><td class=\"n at\">{}</td><td class=\"n\">{}</td>\
         <td class=\"n\">{}</td><td>{}</td></tr>\n",
        Escaped(&finding.column.name),
        show(found.min.value),
        Escaped(&at(found.min)),
        show(found.max.value),
        Escaped(&at(found.max)),
        show(found.range),
        show(found.rms),
        Escaped(&number::unit(&unit.symbol))
    )
}

fn scalars(of: &[(String, f64, Unit)]) -> String {
    if of.is_empty() {
        return String::new();
    }
    let row = |(name, si, unit): &(String, f64, Unit)| {
        let value = number::typeset(&number::alone(unit.show(*si)));
        let symbol = number::unit(&unit.symbol);
        let (name, symbol) = (Escaped(name), Escaped(&symbol));
        format!("<tr><th scope=\"row\">{name}</th><td class=\"n\">{value}</td><td>{symbol}</td></tr>\n")
    };
    let rows: String = of.iter().map(row).collect();
    format!("<div class=\"scroll\"><table class=\"facts\">\n{rows}</table></div>\n")
}
