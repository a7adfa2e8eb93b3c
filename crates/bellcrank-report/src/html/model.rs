//! The model: parameters and facts about the mechanism.

use bellcrank_results::{ParameterRow, RunResult, Unit};

use super::{Escaped, sentence};
use crate::number;

pub(crate) fn section(run: &RunResult) -> String {
    format!(
        "<section id=\"model\">\n<h2>Model</h2>\n<div class=\"columns\">\n{}{}</div>\n</section>\n",
        facts(&run.facts),
        parameters(&run.parameters)
    )
}

fn facts(facts: &[(String, String)]) -> String {
    if facts.is_empty() {
        return String::new();
    }
    let row = |(label, text): &(String, String)| {
        format!("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", Escaped(label), sentence(text))
    };
    let rows: String = facts.iter().map(row).collect();
    format!("<div class=\"scroll\"><h3>Mechanism</h3>\n<table class=\"facts\">\n{rows}</table></div>\n")
}

/// A table of parameters as used, with what the file says and the bounds.
fn parameters(rows: &[ParameterRow]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let rows: String = rows.iter().map(parameter).collect();
    format!(
        "<div class=\"scroll tall\"><h3>Parameters</h3>\n<table class=\"parameters\">\n<thead><tr>\
         <th scope=\"col\">Name</th><th scope=\"col\" class=\"n\">Value</th>\
         <th scope=\"col\">Unit</th><th scope=\"col\" class=\"n\">Min</th>\
         <th scope=\"col\" class=\"n\">Max</th><th scope=\"col\">As written</th>\
         <th scope=\"col\">Note</th></tr></thead>\n<tbody>\n{rows}</tbody></table></div>\n"
    )
}

fn parameter(row: &ParameterRow) -> String {
    let bound = |si: Option<f64>| si.map_or_else(String::new, |si| shown(si, &row.unit));
    format!(
        "<tr><th scope=\"row\">{}</th><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td>\
         <td class=\"n\">{}</td><td><code>{}</code></td><td>{}</td></tr>\n",
        Escaped(&row.name),
        shown(row.value, &row.unit),
        Escaped(&number::unit(&row.unit.symbol)),
        bound(row.bounds.0),
        bound(row.bounds.1),
        Escaped(&row.written),
        Escaped(&row.note)
    )
}

/// The parameters that a study overrides, beside the values of the model.
pub(crate) fn changed(rows: &[ParameterRow], model: &[ParameterRow]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let row = |row: &ParameterRow| {
        let before = model.iter().find(|other| other.name == row.name);
        let before = before.map_or_else(String::new, |other| shown(other.value, &row.unit));
        format!(
            "<tr><th scope=\"row\">{}</th><td class=\"n\">{}</td><td class=\"n\">{before}</td><td>{}</td></tr>\n",
            Escaped(&row.name),
            shown(row.value, &row.unit),
            Escaped(&number::unit(&row.unit.symbol))
        )
    };
    let rows: String = rows.iter().map(row).collect();
    format!(
        "<div class=\"scroll\"><h3>Parameters changed in this study</h3>\n<table class=\"changed\">\n<thead><tr>\
         <th scope=\"col\">Name</th><th scope=\"col\" class=\"n\">Here</th>\
         <th scope=\"col\" class=\"n\">Instead of</th><th scope=\"col\">Unit</th></tr></thead>\n\
         <tbody>\n{rows}</tbody></table></div>\n"
    )
}

fn shown(si: f64, unit: &Unit) -> String {
    number::typeset(&number::alone(unit.show(si)))
}
