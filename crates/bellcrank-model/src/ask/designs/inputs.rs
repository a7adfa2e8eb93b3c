//! Everything that the rows of a sweep depend on, as named texts: an interrupted sweep goes on only where none of them
//! changed, and says which one did.

use bellcrank_results::Unit;
use serde_json::{Map, Value};

use super::super::Asking;
use super::columns::{Columns, tidy};
use super::plan::{Plan, Span};
use crate::design::{Designs, Law, Method, Study};
use crate::provenance::Fingerprint;

/// Of the state file and of the rows.
const FORMAT: &str = "1";
/// Changes that are named.
const TOLD: usize = 4;
/// What changes along with other things.
const CONSEQUENCES: [&str; 2] = ["the last digits of the parameters", "the order of the parts of the model"];
/// What stands before a text that says nothing to people.
const HASH: char = '#';

/// Names and texts, in the order in which changes are told.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Inputs(Vec<(String, String)>);

impl Inputs {
    pub(super) fn new(asking: &Asking<'_>, question: &Designs, plan: &Plan, columns: &Columns) -> Inputs {
        let mut all = Inputs(Vec::new());
        all.add("the format of the state", FORMAT.to_owned());
        all.add("bellcrank", env!("CARGO_PKG_VERSION").to_owned());
        all.add("`of`", format!("`{}`", asking.of.name));
        all.plan(question, plan, columns);
        for one in &question.responses {
            all.add(&format!("response `{}`", one.name), format!("`{}`", one.response.written()));
        }
        let head = |named: &super::columns::Named| bellcrank_results::heading(&named.name, &named.unit);
        all.add("the line of columns", columns.all.iter().map(head).collect::<Vec<_>>().join(", "));
        all.parameters(asking);
        all.sections(asking);
        all.tables(asking);
        all
    }

    fn add(&mut self, name: &str, text: String) {
        self.0.push((name.to_owned(), text));
    }

    fn hashed(&mut self, name: &str, fingerprint: u64) {
        self.add(name, format!("{HASH}{fingerprint:016x}"));
    }

    fn plan(&mut self, question: &Designs, plan: &Plan, columns: &Columns) {
        self.add("`method`", format!("`{}`", question.method.name()));
        if matches!(question.method, Method::LatinHypercube | Method::Sobol) {
            self.add("`samples`", question.samples.to_string());
            self.add("`seed`", question.seed.to_string());
        }
        if question.method == Method::Table {
            let mut of = Fingerprint::default();
            question.table.iter().flatten().for_each(|value| of.bytes(value.to_bits().to_le_bytes()));
            self.add("the number of designs in the table", plan.total.to_string());
            self.hashed("the table of designs", of.value());
            return;
        }
        let grid = question.method == Method::Grid;
        for (axis, column) in plan.axes.iter().zip(&columns.all) {
            self.add(&format!("the range of `{}`", column.name), range(&axis.span, &column.unit, grid));
        }
    }

    fn parameters(&mut self, asking: &Asking<'_>) {
        let set = &asking.study.parameters;
        let mut all = Fingerprint::default();
        set.values().iter().for_each(|value| all.bytes(value.to_bits().to_le_bytes()));
        for (index, parameter) in set.all().iter().enumerate() {
            let value = exact(set.values()[index], &asking.parameter_unit(index));
            let plain = parameter.expression.parameters().is_empty();
            let text = if plain { value } else { format!("`{}` ({value})", parameter.written) };
            self.add(&format!("parameter `{}`", parameter.name), text);
        }
        self.hashed(CONSEQUENCES[0], all.value());
    }

    /// Parts of the files. Of the studies only the one that is asked counts, and what it is like.
    fn sections(&mut self, asking: &Asking<'_>) {
        let written = &asking.design.written;
        let mut order = Fingerprint::default();
        let studies = asked(asking.of, written);
        for section in written {
            if section.name.starts_with("studies.") && !studies.contains(&section.name) {
                continue;
            }
            order.words("section", &section.name);
            self.hashed(&format!("`{}`", section.name), section.fingerprint);
        }
        self.hashed(CONSEQUENCES[1], order.value());
    }

    /// Motions that stand in other files.
    fn tables(&mut self, asking: &Asking<'_>) {
        for motion in &asking.design.motions {
            if let Law::Table(spline) = &motion.law {
                let mut of = Fingerprint::default();
                of.words("spline", &format!("{spline:?}"));
                self.hashed(&format!("the table of motion `{}`", motion.name), of.value());
            }
        }
    }

    pub(super) fn to_json(&self) -> Value {
        Value::Object(self.0.iter().map(|(name, text)| (name.clone(), Value::String(text.clone()))).collect())
    }

    /// What is now other than it was then, in words; `None` where nothing is.
    pub(super) fn changes(&self, before: &Map<String, Value>) -> Option<String> {
        let mut changes: Vec<String> = Vec::new();
        for (name, now) in &self.0 {
            match before.get(name).and_then(Value::as_str) {
                Some(then) if then == now => {}
                Some(_) if now.starts_with(HASH) => changes.push(format!("{name} changed")),
                Some(then) => changes.push(format!("{name} was {then} and is {now}")),
                None => changes.push(format!("{name} is new")),
            }
        }
        let known = |name: &String| self.0.iter().any(|(known, _)| known == name);
        changes.extend(before.keys().filter(|name| !known(name)).map(|name| format!("{name} is gone")));
        // Digits change with the numbers, and the order with the parts; alone they are news.
        if changes.len() > 1 {
            let follows = |change: &String| CONSEQUENCES.iter().any(|name| change.starts_with(name));
            let alone = changes.iter().all(follows);
            changes.retain(|change| alone || !follows(change));
        }
        let more = changes.len().saturating_sub(TOLD);
        changes.truncate(TOLD);
        if more > 0 {
            changes.push(format!("and {more} more"));
        }
        (!changes.is_empty()).then(|| changes.join("; "))
    }
}

/// The sections of the study that is asked and of those that it is like.
fn asked(of: &Study, written: &[crate::written::Section]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut next = Some(of.name.clone());
    while let Some(study) = next {
        let name = format!("studies.{study}");
        if names.contains(&name) {
            break;
        }
        next = written.iter().find(|section| section.name == name).and_then(|section| section.like.clone());
        names.push(name);
    }
    names
}

fn range(span: &Span, unit: &Unit, grid: bool) -> String {
    match span {
        Span::Range { from, to, levels } => {
            let ends = format!("{} to {}", exact(*from, unit), exact(*to, unit));
            if grid { format!("{ends} in {levels} levels") } else { ends }
        }
        Span::List(values) => values.iter().map(|value| exact(*value, unit)).collect::<Vec<_>>().join(", "),
    }
}

/// A number in its unit, to 15 digits.
fn exact(si: f64, unit: &Unit) -> String {
    let number = tidy(unit.show(si));
    if unit.symbol.is_empty() { number.to_string() } else { format!("{number} {}", unit.symbol) }
}
