//! The JSON summary of a study and of a run: the contract of `summary.json` and `--json`.

mod events;
mod findings;
mod flexible;
mod programme;
mod values;

use serde_json::{Map, Value, json};

use crate::{
    Column, Extreme, Failure, Findings, ParameterRow, Provenance, Reaction, Reductions, RunResult, StudyResult, Unit,
};
pub use programme::moves;
pub(crate) use values::{change, quantity, rounded};
use values::{maybe, named, shown, whole};

/// The summary of one study, as `summary.json` holds it: numbers in display units, each unit named.
///
/// A study over another study adds the keys of its findings; `axis`, `signals` and
/// `reactions` are there where it has rows of its own, `scalars` where it has any.
pub fn study_summary(study: &StudyResult) -> Value {
    let mut object = common(study);
    if let Some(findings) = &study.findings {
        object.extend(findings::keys(findings));
    }
    if study.findings.is_none() || study.table.rows() > 0 {
        object.extend(series(study));
    } else if !study.scalars.is_empty() {
        object.insert("scalars".to_owned(), scalars(&study.scalars));
    }
    if let Some(of) = &study.programme {
        object.insert("programme".to_owned(), programme::moves(of));
    }
    if let Some(found) = &study.flexible {
        object.insert("flexible".to_owned(), flexible::described(found));
    }
    if let Some(events) = &study.events {
        object.extend(events::keys(events));
    }
    if let Some(failure) = &study.failure {
        object.insert("failure".to_owned(), failed(failure));
    }
    Value::Object(object)
}

fn common(study: &StudyResult) -> Map<String, Value> {
    let mut object = values::object([
        ("kind", json!(study.kind)),
        ("rows", json!(rows(study))),
        ("seconds", json!(study.seconds)),
        ("warnings", json!(study.warnings)),
        ("effort", effort(&study.effort)),
    ]);
    if !study.changed.is_empty() {
        object.insert("set".to_owned(), parameters(&study.changed));
    }
    object
}

/// Rows of the study's files: the designs of a sweep, the positions or times of any other.
fn rows(study: &StudyResult) -> u64 {
    match &study.findings {
        Some(Findings::Designs(found)) => found.done,
        _ => study.table.rows() as u64,
    }
}

/// What the rows of the study come to.
fn series(study: &StudyResult) -> Map<String, Value> {
    values::object([
        ("axis", study.axis.iter().map(|name| axis(study, name)).collect()),
        ("signals", signals(study)),
        ("scalars", scalars(&study.scalars)),
        ("reactions", reactions(&study.reactions)),
    ])
}

/// The summary of a whole run: what `--json` prints.
pub fn run_summary(run: &RunResult) -> Value {
    json!({
        "bellcrank": run.provenance.version,
        "model": run.model,
        "title": run.title,
        "provenance": provenance(&run.provenance),
        "warnings": run.warnings,
        "facts": named(&run.facts, |text| json!(text)),
        "parameters": parameters(&run.parameters),
        "studies": run.studies.iter()
            .map(|study| (study.name.clone(), study_summary(study)))
            .collect::<Map<_, _>>(),
    })
}

fn provenance(of: &Provenance) -> Value {
    json!({ "file": of.file, "hash": of.hash, "date": of.date })
}

fn parameters(rows: &[ParameterRow]) -> Value {
    Value::Object(rows.iter().map(parameter).collect())
}

fn parameter(row: &ParameterRow) -> (String, Value) {
    let value = json!({
        "value": shown(row.value, &row.unit),
        "unit": row.unit.symbol,
        "written": row.written,
        "min": maybe(row.bounds.0, &row.unit),
        "max": maybe(row.bounds.1, &row.unit),
        "note": row.note,
    });
    (row.name.clone(), value)
}

fn axis(study: &StudyResult, name: &str) -> Value {
    let unit = study.table.column(name).map(|column| column.unit.symbol.as_str());
    json!({ "name": name, "unit": unit })
}

fn signals(study: &StudyResult) -> Value {
    let axes: Vec<&Column> = study.axis.iter().filter_map(|name| study.table.column(name)).collect();
    let signal = |column: &Column| (column.name.clone(), signal(column, &axes));
    Value::Object(study.table.columns.iter().map(signal).collect())
}

/// A column's reductions; a signal that is nowhere defined has a unit and nothing else.
fn signal(column: &Column, axes: &[&Column]) -> Value {
    let unit = &column.unit;
    let mut object = Map::new();
    object.insert("unit".to_owned(), json!(unit.symbol));
    if let Some(found) = Reductions::of(&column.values) {
        object.insert("min".to_owned(), extreme(found.min, unit, axes));
        object.insert("max".to_owned(), extreme(found.max, unit, axes));
        for (name, si) in [
            ("range", found.range),
            ("rms", found.rms),
            ("mean", found.mean),
            ("first", found.first),
            ("last", found.last),
        ] {
            object.insert(name.to_owned(), shown(si, unit));
        }
    }
    Value::Object(object)
}

fn extreme(found: Extreme, unit: &Unit, axes: &[&Column]) -> Value {
    let place = |axis: &&Column| {
        let si = axis.values.get(found.row).copied().unwrap_or(f64::NAN);
        (axis.name.clone(), shown(si, &axis.unit))
    };
    let at: Map<String, Value> = axes.iter().map(place).collect();
    json!({ "value": shown(found.value, unit), "at": at })
}

fn scalars(of: &[(String, f64, Unit)]) -> Value {
    let scalar = |(name, si, unit): &(String, f64, Unit)| (name.clone(), quantity(*si, unit));
    Value::Object(of.iter().map(scalar).collect())
}

fn reactions(of: &[Reaction]) -> Value {
    let reaction = |reaction: &Reaction| {
        let unique = named(&reaction.unique, |unique| json!(unique));
        (reaction.joint.clone(), json!({ "kind": reaction.kind, "unique": unique }))
    };
    Value::Object(of.iter().map(reaction).collect())
}

fn effort(of: &[(String, f64)]) -> Value {
    named(of, |&count| whole(count))
}

fn failed(failure: &Failure) -> Value {
    json!({ "message": failure.message, "hints": failure.hints })
}

#[cfg(test)]
mod tests;
