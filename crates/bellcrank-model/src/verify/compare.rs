//! Computed numbers beside those of a reference.

use std::collections::HashMap;

use bellcrank_doc::{Fields, NoSignals, Reader, ReductionKind, Response, Table, Value};
use bellcrank_results::{Reductions, StudyResult, Unit, study_summary};

use super::reference::{Reference, faults};
use super::{CaseReport, Comparison, summary};
use crate::design::Study;
use crate::signals::{AllSignals, Signal};
use crate::{Check, Model, Silent, load};

/// Rows are found by their coordinates to this difference (SI).
const SAME_ROW: f64 = 1e-9;

pub(super) fn run(reference: &Reference, report: &mut CaseReport) -> Result<(), Vec<String>> {
    report.kind.clone_from(&reference.kind);
    report.source.clone_from(&reference.source);
    let loaded = load(&reference.model, &[]);
    let Some(model) = loaded.model else { return Err(faults(&loaded.diagnostics, &loaded.sources)) };
    let mut case = Case { model: &model, check: None, results: HashMap::new() };
    for check in &reference.checks {
        let reader = Reader::new(&model.design().scopes[0].parameters);
        let outcome = case.compare(&reader, check);
        let unread = faults(&reader.finish(), &reference.sources);
        match outcome {
            Ok(comparison) if unread.is_empty() => report.comparisons.push(comparison),
            Ok(_) => report.faults.extend(unread),
            Err(fault) => {
                report.faults.extend(unread);
                report.faults.push(fault);
            }
        }
    }
    let failed = case.results.values().filter_map(|result| result.failure.as_ref());
    report.faults.extend(failed.map(|failure| failure.message.clone()));
    Ok(())
}

struct Case<'m> {
    model: &'m Model,
    check: Option<Check>,
    results: HashMap<String, StudyResult>,
}

/// A computed number (SI), what it is called, and the unit it is shown in.
struct Found {
    what: String,
    value: f64,
    unit: Unit,
}

impl Case<'_> {
    fn compare(&mut self, reader: &Reader<'_>, check: &Table) -> Result<Comparison, String> {
        let fields = Fields::new(reader, check, "a check");
        let study = fields.optional_string("study").map_or("", |name| name.value);
        if let Some(path) = fields.optional_string("summary") {
            let found = self.summed_up(reader, &fields, study, path.value);
            fields.finish();
            return found;
        }
        let wanted = fields.value("value").and_then(|value| number(reader, value)).ok_or("a check without a value")?;
        let found = if let Some(component) = fields.optional_string("unique") {
            self.unique(study, component.value)?
        } else if let Some(name) = fields.optional_string("scalar") {
            self.scalar(study, name.value)?
        } else if let Some(value) = fields.optional_value("reduce") {
            self.reduced(reader, study, value)?
        } else {
            let signal =
                fields.string("signal").ok_or("a check without `signal`, `reduce`, `scalar`, `summary` or `unique`")?;
            self.at_row(reader, study, signal.value, fields.optional_value("at"))?
        };
        let tolerance = |key| fields.optional_value(key).and_then(|value| number(reader, value)).unwrap_or(0.0);
        let allowed = tolerance("rtol") * wanted.abs() + tolerance("atol");
        fields.finish();
        Ok(comparison(study, found, wanted, allowed))
    }

    fn result(&mut self, study: &str) -> Result<&StudyResult, String> {
        if !self.results.contains_key(study) {
            let result = self.model.run(study, &mut Silent).map_err(|error| error.to_string())?;
            self.results.insert(study.to_owned(), result);
        }
        self.results.get(study).ok_or_else(|| format!("study `{study}` left no result"))
    }

    fn study(&self, name: &str) -> Result<&Study, String> {
        let found = self.model.study_list().iter().find(|study| study.name == name);
        found.ok_or_else(|| format!("there is no study `{name}`"))
    }

    /// The study that answers questions about reactions when none is named.
    fn with_forces(&self) -> Option<String> {
        let forces = self.model.studies().into_iter().find(|study| study.kind == "inverse-dynamics");
        forces.or_else(|| self.model.studies().into_iter().find(|study| study.available)).map(|study| study.name)
    }

    fn unique(&mut self, study: &str, component: &str) -> Result<Found, String> {
        let study = if study.is_empty() { self.with_forces().unwrap_or_default() } else { study.to_owned() };
        let (joint, part) =
            component.rsplit_once('.').ok_or_else(|| format!("`{component}` is not joint.component"))?;
        let reactions = &self.result(&study)?.reactions;
        let of_joint = reactions.iter().find(|reaction| reaction.joint == joint);
        let unique = of_joint.and_then(|reaction| reaction.unique.iter().find(|(name, _)| name == part));
        let (_, unique) = unique.ok_or_else(|| format!("there is no reaction `{component}`"))?;
        Ok(Found { what: format!("unique {component}"), value: f64::from(u8::from(*unique)), unit: Unit::one() })
    }

    fn scalar(&mut self, study: &str, name: &str) -> Result<Found, String> {
        let what = name.to_owned();
        if study.is_empty() {
            let check = self.check.get_or_insert_with(|| self.model.check());
            let value = fact(check, name).ok_or_else(|| format!("there is no fact `{name}`"))?;
            return Ok(Found { what, value, unit: Unit::one() });
        }
        let scalars = &self.result(study)?.scalars;
        let found = scalars.iter().find(|(known, _, _)| known == name);
        let (_, value, unit) = found.ok_or_else(|| format!("study `{study}` has no scalar `{name}`"))?;
        Ok(Found { what, value: *value, unit: unit.clone() })
    }

    /// A number or a text of the study's summary.
    fn summed_up(
        &mut self,
        reader: &Reader<'_>,
        fields: &Fields<'_>,
        study: &str,
        path: &str,
    ) -> Result<Comparison, String> {
        let all = study_summary(self.result(study)?);
        let place =
            summary::find(&all, path).ok_or_else(|| format!("study `{study}` has no `{path}` in its summary"))?;
        let unit = fields.optional_string("unit").map_or("", |unit| unit.value);
        if !unit.is_empty() && !place.units.contains(&unit) {
            return Err(format!("`{path}` of study `{study}` is not in {unit}, but in one of {:?}", place.units));
        }
        if let Some(text) = fields.optional_string("text") {
            let same = place.value.as_str() == Some(text.value);
            let what = format!("{path} is `{}`", text.value);
            let found = Found { what, value: f64::from(u8::from(same)), unit: Unit::one() };
            return Ok(comparison(study, found, 1.0, 0.0));
        }
        let wanted = plain(reader, fields, "value")?.ok_or("a check without a value")?;
        let allowed = plain(reader, fields, "rtol")?.unwrap_or(0.0) * wanted.abs()
            + plain(reader, fields, "atol")?.unwrap_or(0.0);
        let value = place.number().ok_or_else(|| format!("`{path}` of study `{study}` is not a number"))?;
        let found = Found { what: path.to_owned(), value, unit: Unit::new(unit, 1.0) };
        Ok(comparison(study, found, wanted, allowed))
    }

    fn at_row(&mut self, reader: &Reader<'_>, study: &str, signal: &str, at: Option<&Value>) -> Result<Found, String> {
        let mut places = Vec::new();
        for entry in at.and_then(Value::as_table).into_iter().flat_map(Table::iter) {
            let place = number(reader, &entry.value).ok_or_else(|| format!("`{}` has no place", entry.key))?;
            places.push((entry.key.as_str(), place));
        }
        let result = self.result(study)?;
        let row = row(result, &places)?;
        let column = result.table.column(signal).ok_or_else(|| format!("study `{study}` has no signal `{signal}`"))?;
        let value = column.values.get(row).copied().unwrap_or(f64::NAN);
        Ok(Found { what: located(result, signal, &places), value, unit: column.unit.clone() })
    }

    fn reduced(&mut self, reader: &Reader<'_>, study: &str, value: &Value) -> Result<Found, String> {
        let model = self.model;
        let parameters = self.study(study)?.parameters.values().to_vec();
        let mut signals = AllSignals { catalogue: &model.design().catalogue, used: Vec::new() };
        let response = reader.response(value, "`reduce`", &mut signals).ok_or("`reduce` cannot be read")?;
        let columns: Vec<Vec<f64>> =
            signals.used.iter().map(|&signal| values(model, self.result(study)?, signal)).collect::<Result<_, _>>()?;
        let value_of = |reduction: &bellcrank_doc::Reduction| reduce(reduction, &parameters, &columns);
        let reductions: Vec<f64> = response.reductions.iter().map(value_of).collect();
        let found = response.value.eval(&parameters, &reductions);
        let unit = model.design().units.of_dimension(response.value.dimension());
        Ok(Found { what: written(&response), value: found, unit })
    }
}

fn written(response: &Response) -> String {
    response.value.written().to_owned()
}

/// The column of a signal.
fn values(model: &Model, result: &StudyResult, signal: Signal) -> Result<Vec<f64>, String> {
    let name = model.design().catalogue.column(signal).map(|column| column.name).unwrap_or_default();
    let column = result.table.column(&name).ok_or_else(|| format!("the study has no signal `{name}`"))?;
    Ok(column.values.clone())
}

fn reduce(reduction: &bellcrank_doc::Reduction, parameters: &[f64], columns: &[Vec<f64>]) -> f64 {
    let rows = columns.first().map_or(0, Vec::len);
    let at = |row: usize| {
        let signals: Vec<f64> = columns.iter().map(|column| column.get(row).copied().unwrap_or(f64::NAN)).collect();
        reduction.curve.eval(parameters, &signals)
    };
    let curve: Vec<f64> = (0..rows).map(at).collect();
    let Some(found) = Reductions::of(&curve) else { return f64::NAN };
    match reduction.kind {
        ReductionKind::Min => found.min.value,
        ReductionKind::Max => found.max.value,
        ReductionKind::Mean => found.mean,
        ReductionKind::Rms => found.rms,
        ReductionKind::Range => found.range,
        ReductionKind::First => found.first,
        ReductionKind::Last => found.last,
        // The axis is not known here; NaN fails the check (`at = {...}` beside `signal` does the same).
        ReductionKind::At => f64::NAN,
    }
}

/// A number, a value with a unit, or true and false as 1 and 0.
fn number(reader: &Reader<'_>, value: &Value) -> Option<f64> {
    if let bellcrank_doc::ValueKind::Boolean(truth) = value.kind {
        return Some(f64::from(u8::from(truth)));
    }
    let expression = reader.any_quantity(value, "a number of a check", &mut NoSignals)?;
    Some(expression.eval(reader.parameters().values(), &[]))
}

/// A number without a unit: those of a summary are in the unit shown there.
fn plain(reader: &Reader<'_>, fields: &Fields<'_>, key: &'static str) -> Result<Option<f64>, String> {
    let Some(value) = fields.optional_value(key) else { return Ok(None) };
    if let bellcrank_doc::ValueKind::Boolean(_) = value.kind {
        return Ok(number(reader, value));
    }
    let what = format!("`{key}` of a check of a summary");
    let expression =
        reader.any_quantity(value, &what, &mut NoSignals).ok_or_else(|| format!("{what} cannot be read"))?;
    if !expression.dimension().is_none() {
        return Err(format!("{what} is a plain number; its unit goes to `unit`"));
    }
    Ok(Some(expression.eval(reader.parameters().values(), &[])))
}

fn fact(check: &Check, name: &str) -> Option<f64> {
    match name {
        "bodies" => Some(check.bodies.len() as f64),
        "joints" => Some(check.joints.len() as f64),
        "loops" => Some(check.loops as f64),
        "degrees_of_freedom" => check.degrees.map(|degrees| degrees as f64),
        "redundant" => Some(check.redundancies() as f64),
        "rank" => check.rank.map(|rank| rank as f64),
        _ => None,
    }
}

/// The row where all signals are at their places; the first without any.
fn row(result: &StudyResult, places: &[(&str, f64)]) -> Result<usize, String> {
    let rows = result.table.rows();
    let distance = |row: usize| {
        let off = |(name, place): &(&str, f64)| {
            let column = result.table.column(name)?;
            Some((column.values.get(row)? - place).abs())
        };
        places.iter().map(|place| off(place).unwrap_or(f64::INFINITY)).fold(0.0, f64::max)
    };
    let nearest = (0..rows).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
    match nearest {
        Some(row) if distance(row) <= SAME_ROW => Ok(row),
        _ => Err(format!("no row at {places:?} (SI)")),
    }
}

fn located(result: &StudyResult, signal: &str, places: &[(&str, f64)]) -> String {
    let place = |(name, place): &(&str, f64)| {
        let unit = result.table.column(name).map_or_else(Unit::one, |column| column.unit.clone());
        let shown = format!("{:.6e}", unit.show(*place)).parse().unwrap_or(*place);
        format!("{name} = {shown} {}", unit.symbol).trim_end().to_owned()
    };
    let places: Vec<String> = places.iter().map(place).collect();
    if places.is_empty() { signal.to_owned() } else { format!("{signal} at {}", places.join(", ")) }
}

fn comparison(study: &str, found: Found, wanted: f64, allowed: f64) -> Comparison {
    let error = (found.value - wanted).abs();
    Comparison {
        study: study.to_owned(),
        what: found.what,
        value: found.unit.show(found.value),
        reference: found.unit.show(wanted),
        error: error / found.unit.factor,
        allowed: allowed / found.unit.factor,
        // A difference that is no number passes nothing.
        passed: error <= allowed,
        unit: found.unit.symbol,
    }
}
