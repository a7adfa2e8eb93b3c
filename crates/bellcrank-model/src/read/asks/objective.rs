//! `minimize` and `maximize`.

use bellcrank_doc::{Diagnostic, Expression, Response, Value};

use super::AskKeys;
use super::given::{Given, unreadable};
use crate::keyed::Keyed;
use crate::read::study_keys::Referred;
use crate::schema::OBJECTIVE;

/// What is to be small or large: one response, or several with weights.
#[derive(Clone, Debug)]
pub(crate) struct Objective {
    pub(super) maximize: bool,
    pub(super) terms: Vec<(Response, Option<Expression>)>,
}

pub(super) fn read_objective(keyed: &Keyed<'_>, of: Referred<'_>, beneath: &AskKeys) -> Given<Objective> {
    let read = |key, maximize| {
        Given::key(keyed, key, |value| {
            let terms = read_terms(value, &keyed.named(key), of)?;
            Some(Objective { maximize, terms })
        })
    };
    let (minimize, maximize) = (read("minimize", false), read("maximize", true));
    if let (Some(small), Some(large)) = (keyed.value("minimize"), keyed.value("maximize")) {
        let message = format!("{} has `minimize` and `maximize`; give one", keyed.what());
        let report = Diagnostic::error("conflicting-keys", large.span, message).also(small.span, "and this");
        keyed.report(report.hint("to make one small and another large: `minimize = [\"A\", \"-B\"]`"));
        return Given::Wrong;
    }
    if minimize.is_no() && maximize.is_no() && beneath.objective.is_no() {
        keyed.needed("minimize");
    }
    minimize.or(maximize)
}

fn read_terms(value: &Value, what: &str, of: Referred<'_>) -> Option<Vec<(Response, Option<Expression>)>> {
    let parts = value.as_list().unwrap_or(std::slice::from_ref(value));
    if parts.is_empty() {
        let report = Diagnostic::error("wrong-length", value.span, format!("{what} names no response"));
        of.part.reader.report(report);
        return None;
    }
    // Wrong ones have been reported; the others are checked all the same.
    Some(parts.iter().filter_map(|part| read_term(part, what, of)).collect())
}

fn read_term(value: &Value, what: &str, of: Referred<'_>) -> Option<(Response, Option<Expression>)> {
    if unreadable(value) {
        return None;
    }
    if value.as_table().is_none() {
        return Some((of.response(value, what)?, None));
    }
    let fields = of.part.reader.fields(value, &format!("a part of {what}"))?;
    let keyed = Keyed::new(fields, &OBJECTIVE, of.part.space());
    let response = keyed.value("response").and_then(|value| of.response(value, &keyed.named("response")));
    let weight = Given::key(&keyed, "weight", |_| keyed.quantity("weight")).optional();
    keyed.finish();
    Some((response?, weight?))
}
