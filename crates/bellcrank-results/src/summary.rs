//! The JSON summary of a study and of a run: the contract of `summary.json` and `--json`.

use serde_json::{Map, Value, json};

use crate::{Column, Extreme, Failure, ParameterRow, Provenance, Reaction, Reductions, RunResult, StudyResult, Unit};

/// The summary of one study, as `summary.json` holds it: numbers in display units, each unit named.
///
/// Later kinds of study add keys of their own; the ones written here keep their meaning.
pub fn study_summary(study: &StudyResult) -> Value {
    let mut object = Map::new();
    object.insert("kind".to_owned(), json!(study.kind));
    object.insert("rows".to_owned(), json!(study.table.rows()));
    object.insert("seconds".to_owned(), json!(study.seconds));
    object.insert("warnings".to_owned(), json!(study.warnings));
    object.insert("effort".to_owned(), effort(&study.effort));
    if !study.changed.is_empty() {
        object.insert("set".to_owned(), parameters(&study.changed));
    }
    object.insert("axis".to_owned(), study.axis.iter().map(|name| axis(study, name)).collect());
    object.insert("signals".to_owned(), signals(study));
    object.insert("scalars".to_owned(), scalars(&study.scalars));
    object.insert("reactions".to_owned(), reactions(&study.reactions));
    if let Some(failure) = &study.failure {
        object.insert("failure".to_owned(), failed(failure));
    }
    Value::Object(object)
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
    let bound = |si: Option<f64>| si.map_or(Value::Null, |si| shown(si, &row.unit));
    let value = json!({
        "value": shown(row.value, &row.unit),
        "unit": row.unit.symbol,
        "written": row.written,
        "min": bound(row.bounds.0),
        "max": bound(row.bounds.1),
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
    let scalar = |(name, si, unit): &(String, f64, Unit)| {
        (name.clone(), json!({ "value": shown(*si, unit), "unit": unit.symbol }))
    };
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

fn named<T>(pairs: &[(String, T)], value: impl Fn(&T) -> Value) -> Value {
    Value::Object(pairs.iter().map(|(name, of)| (name.clone(), value(of))).collect())
}

/// A count without a decimal point, any other number as it is.
fn whole(value: f64) -> Value {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    if value.fract() == 0.0 && value.abs() < EXACT { json!(value as i64) } else { json!(value) }
}

/// An SI value in `unit`; `null` where it is not finite.
///
/// Converted numbers are rounded to 15 digits: that is all a conversion leaves, and it makes
/// −30 degrees read `-30.0`, not `-29.999999999999996`.
fn shown(si: f64, unit: &Unit) -> Value {
    let value = unit.show(si);
    if unit.factor == 1.0 || !value.is_finite() {
        return json!(value);
    }
    let rounded = format!("{value:.14e}");
    json!(rounded.parse().unwrap_or(value))
}

#[cfg(test)]
mod tests;
