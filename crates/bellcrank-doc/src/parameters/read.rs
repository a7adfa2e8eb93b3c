//! From the `[parameters]` table to the set.

use std::collections::HashMap;

use super::{Limits, Parameter, ParameterSet, Spread, order, spread};
use crate::expression::{Known, Parsed, Purpose, Resolve, nominal, reserved};
use crate::fields::quoted;
use crate::written::WrittenValue;
use crate::{
    Diagnostic, Diagnostics, Dimension, Entry, Expression, NoSignals, Scope, Table, Value, ValueKind, nearest,
};

/// Names that are looked through for a hint.
const HINTED: usize = 2000;

const KEYS: [&str; 7] = ["value", "min", "max", "note", "tolerance", "distribution", "sigma"];

/// A definition before names are looked up.
struct Draft<'t> {
    entry: &'t Entry,
    written: WrittenValue<'t>,
    tree: Parsed,
}

pub(super) fn read(table: &Table, diagnostics: &mut Diagnostics) -> ParameterSet {
    let mut set = ParameterSet::default();
    let mut drafts = Vec::new();
    for entry in table.iter() {
        match draft(entry, diagnostics) {
            Some(draft) => drafts.push(draft),
            None => {
                set.faulty.insert(entry.key.clone());
            }
        }
    }
    let definitions = define(&drafts, &mut set, diagnostics);
    collect(&drafts, definitions, &mut set);
    read_details(table, &mut set, diagnostics);
    read_tolerances(&drafts, &mut set, diagnostics);
    set.settle(diagnostics);
    set
}

fn draft<'t>(entry: &'t Entry, diagnostics: &mut Diagnostics) -> Option<Draft<'t>> {
    let named = well_named(entry, diagnostics);
    let value = definition(entry, diagnostics)?;
    let what = format!("parameter `{}`", entry.key);
    let written = WrittenValue::of(value, &what, diagnostics)?;
    let tree = written.parse(diagnostics)?;
    named.then_some(Draft { entry, written, tree })
}

/// The value that defines a parameter: the entry itself, or the `value` of its table.
fn definition<'t>(entry: &'t Entry, diagnostics: &mut Diagnostics) -> Option<&'t Value> {
    let ValueKind::Table(table) = &entry.value.kind else { return Some(&entry.value) };
    let value = table.get("value").map(|e| &e.value);
    if value.is_none() {
        let message = format!("`value` is missing in parameter `{}`", entry.key);
        diagnostics.push(Diagnostic::error("missing-key", table.span, message));
    }
    value
}

fn well_named(entry: &Entry, diagnostics: &mut Diagnostics) -> bool {
    let name = &entry.key;
    if let Some(kind) = reserved(name) {
        let message = format!("a parameter cannot be named `{name}`: that is {kind}");
        diagnostics
            .push(Diagnostic::error("reserved-name", entry.key_span, message).hint(format!("as `{name}_1`, say")));
        return false;
    }
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let starts_well = name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
    if starts_well && name.chars().all(plain) {
        return true;
    }
    let message = format!("a parameter cannot be named `{name}`");
    let hint = "letters, digits and `_`, a letter first; in an expression `-` is a minus and `.` belongs to signals";
    diagnostics.push(Diagnostic::error("bad-name", entry.key_span, message).hint(hint));
    false
}

/// Names while definitions are being checked: those checked already, those in error, the rest.
struct Stage<'s, 't> {
    names: &'s HashMap<&'t str, usize>,
    drafts: &'s [Draft<'t>],
    done: &'s [Option<(Expression, f64)>],
    faulty: &'s std::collections::HashSet<String>,
}

impl Resolve for Stage<'_, '_> {
    fn resolve(&mut self, name: &str) -> Known {
        let Some(&index) = self.names.get(name) else {
            return if self.faulty.contains(name) { Known::Faulty } else { Known::Unknown };
        };
        match (self.done.get(index), self.drafts.get(index)) {
            (Some(Some((expression, value))), Some(draft)) => Known::Parameter {
                index,
                dimension: expression.dimension(),
                value: *value,
                defined: draft.entry.key_span,
            },
            // Its own error, or the cycle it stands in, has been reported.
            _ => Known::Faulty,
        }
    }

    fn names(&self) -> Vec<String> {
        self.drafts.iter().take(HINTED).map(|d| d.entry.key.clone()).collect()
    }

    fn has_signals(&self) -> bool {
        false
    }
}

type Definitions = Vec<Option<(Expression, f64)>>;

/// Checks the definitions in the order of their dependence.
fn define(drafts: &[Draft<'_>], set: &mut ParameterSet, diagnostics: &mut Diagnostics) -> Definitions {
    let names: HashMap<&str, usize> = drafts.iter().enumerate().map(|(i, d)| (d.entry.key.as_str(), i)).collect();
    let uses: Vec<Vec<usize>> = drafts.iter().map(|d| used(d, &names)).collect();
    let order::Order { order, cycles } = order::order(&uses);
    for cycle in cycles {
        let links: Vec<_> = cycle.iter().map(|&i| link(&drafts[i])).collect();
        diagnostics.push(order::cycle_report(&links));
    }
    let mut done: Definitions = drafts.iter().map(|_| None).collect();
    let mut values = vec![f64::NAN; drafts.len()];
    for i in order {
        let draft = &drafts[i];
        let what = format!("`{}`", draft.entry.key);
        let purpose = Purpose { what: &what, dimension: None };
        let mut stage = Stage { names: &names, drafts, done: &done, faulty: &set.faulty };
        let expression = nominal(&draft.tree, &draft.written.text, purpose, &mut stage, diagnostics);
        done[i] = expression.map(|expression| {
            let value: f64 = expression.eval(&values, &[]);
            values[i] = value;
            (expression, value)
        });
    }
    done
}

fn used(draft: &Draft<'_>, names: &HashMap<&str, usize>) -> Vec<usize> {
    let mut used = Vec::new();
    draft.tree.left.names(&mut |name| used.extend(names.get(name).copied()));
    used.sort_unstable();
    used.dedup();
    used
}

fn link<'a>(draft: &'a Draft<'_>) -> order::Link<'a> {
    order::Link { name: &draft.entry.key, span: draft.tree.left.span }
}

/// Moves the good definitions into the set, their indices closed up over the faulty ones.
fn collect(drafts: &[Draft<'_>], definitions: Definitions, set: &mut ParameterSet) {
    let mut new_index = vec![0; drafts.len()];
    let mut count = 0;
    for (i, definition) in definitions.iter().enumerate() {
        new_index[i] = count;
        count += usize::from(definition.is_some());
    }
    for (draft, definition) in drafts.iter().zip(definitions) {
        let name = draft.entry.key.clone();
        let Some((mut expression, value)) = definition else {
            set.faulty.insert(name);
            continue;
        };
        expression.renumber(&new_index);
        set.index.insert(name, set.all.len());
        set.values.push(value);
        set.all.push(parameter(draft, expression));
    }
}

fn parameter(draft: &Draft<'_>, expression: Expression) -> Parameter {
    Parameter {
        name: draft.entry.key.clone(),
        span: draft.entry.key_span,
        dimension: expression.dimension(),
        written: draft.written.text.clone().into_owned(),
        expression,
        min: None,
        max: None,
        tolerance: None,
        spread: Spread::default(),
        note: String::new(),
        limits: Limits::default(),
    }
}

/// Bounds and notes; bounds may use any parameter.
fn read_details(table: &Table, set: &mut ParameterSet, diagnostics: &mut Diagnostics) {
    for entry in table.iter() {
        let ValueKind::Table(details) = &entry.value.kind else { continue };
        report_unknown_keys(entry, details, diagnostics);
        let Some(index) = set.index(&entry.key) else { continue };
        let dimension = set.all[index].dimension;
        let limit = |key: &str, diagnostics: &mut Diagnostics| limit(entry, details, key, dimension, set, diagnostics);
        let limits = Limits {
            min: limit("min", diagnostics),
            max: limit("max", diagnostics),
            tolerance: limit("tolerance", diagnostics),
            sigma: limit("sigma", diagnostics),
        };
        let note = note(details, diagnostics);
        set.all[index].spread.distribution = spread::distribution(entry, details, diagnostics);
        set.all[index].limits = limits;
        set.all[index].note = note;
    }
}

fn limit(
    entry: &Entry,
    details: &Table,
    key: &str,
    dimension: Dimension,
    set: &ParameterSet,
    diagnostics: &mut Diagnostics,
) -> Option<Expression> {
    let what = format!("`{key}` of parameter `{}`", entry.key);
    let written = WrittenValue::of(&details.get(key)?.value, &what, diagnostics)?;
    let purpose = Purpose { what: &what, dimension: Some(dimension) };
    let mut scope = Scope { parameters: set, signals: &mut NoSignals };
    match key {
        "tolerance" | "sigma" => written.difference(purpose, &mut scope, diagnostics),
        _ => written.value(purpose, &mut scope, diagnostics),
    }
}

/// The tolerances that stand in the values, after `±`.
fn read_tolerances(drafts: &[Draft<'_>], set: &mut ParameterSet, diagnostics: &mut Diagnostics) {
    for draft in drafts {
        let Some(tolerance) = &draft.tree.tolerance else { continue };
        let name = &draft.entry.key;
        let Some(index) = set.index(name) else { continue };
        if let Some(key) = draft.entry.value.as_table().and_then(|details| details.get("tolerance")) {
            let message = format!("the tolerance of `{name}` is given twice");
            let error = Diagnostic::error("duplicate-name", key.key_span, message).label("as a key");
            diagnostics.push(error.also(tolerance.span, format!("in the value, after `{}`", tolerance.sign)));
        }
        let mut own = diagnostics.branch();
        let half_width = set.half_width(index, tolerance, &draft.written.text, &mut own);
        set.all[index].limits.tolerance = half_width;
        let (nominal, phrase) = (draft.tree.left.span, set.all[index].dimension.phrase());
        let with_value = |d: Diagnostic| if d.code == "dimension" { d.also(nominal, phrase.clone()) } else { d };
        diagnostics.append(own.into_iter().map(with_value).collect());
    }
}

fn note(details: &Table, diagnostics: &mut Diagnostics) -> String {
    let Some(entry) = details.get("note") else { return String::new() };
    match &entry.value.kind {
        ValueKind::String(text) => text.value.clone(),
        ValueKind::Faulty => String::new(),
        _ => {
            let message = format!("`note` needs a string, found {}", entry.value.describe());
            diagnostics.push(Diagnostic::error("wrong-type", entry.value.span, message));
            String::new()
        }
    }
}

fn report_unknown_keys(entry: &Entry, details: &Table, diagnostics: &mut Diagnostics) {
    for unknown in details.iter().filter(|e| !KEYS.contains(&e.key.as_str())) {
        let message = format!("unknown key `{}` in parameter `{}`", unknown.key, entry.key);
        let error = Diagnostic::error("unknown-key", unknown.key_span, message);
        let error = error.did_you_mean(nearest(&unknown.key, KEYS));
        diagnostics.push(error.hint(format!("known keys: {}", quoted(&KEYS))));
    }
}
