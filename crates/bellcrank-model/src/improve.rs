//! The model file with the values that an optimization found.

mod error;

use std::path::Path;

use bellcrank_doc::{Diagnostics, ParameterSet, SourceId, Sources, parse, rewrite_parameters};
use bellcrank_results::{Findings, Optimization, StudyResult, VariableRow};

pub use error::ImproveError;

use crate::ask::{self, Asking};
use crate::design::{Ask, Question, Study, Task};
use crate::load::load_text;
use crate::{Loaded, Model, RunOptions};

/// Values are rounded where that changes them less than this, relative to their size: optima are not known better.
const DIGITS: f64 = 1e-12;
/// The new file gives the objective that was found, relative to its size.
const SAME: f64 = 1e-6;

/// A model file with better values.
#[derive(Clone, Debug)]
pub struct Improved {
    /// The whole text; the file's, but for the values of the variables.
    pub text: String,
    /// What its reader should know.
    pub warnings: Vec<String>,
}

impl Model {
    /// The model's own text, read as if it stood in another file: whether all that it names is found from there.
    #[must_use]
    pub fn moved(&self, path: &Path) -> Loaded {
        let main = self.main();
        load_text(path, &main.text, &main.settings)
    }

    /// The text of the model file with the values that one of its `optimize` studies found, to stand in the file
    /// `path`. The text is read again as if it stood there, and gives the objective that was found.
    ///
    /// # Errors
    /// When nothing was found, or the new text does not give it.
    pub fn improved(&self, result: &StudyResult, path: &Path) -> Result<Improved, ImproveError> {
        let (study, found) = self.optimized(result)?;
        let text = self.rewritten(study, found)?;
        self.verify(&text, path, study, found)?;
        Ok(Improved { text, warnings: self.strangers(study, found) })
    }

    /// The study of a result, and what it found when that can be used.
    fn optimized<'r>(&self, result: &'r StudyResult) -> Result<(&Study, &'r Optimization), ImproveError> {
        let study = self.study_list().iter().find(|study| study.name == result.name);
        let (Some(study), Some(Findings::Optimization(found))) = (study, &result.findings) else {
            return Err(ImproveError::NoDesign { study: result.name.clone(), status: String::new() });
        };
        let violated = found.constraints.iter().any(|row| row.violation > 0.0) && found.status != "converged";
        let finite = found.variables.iter().all(|row| row.value.is_finite()) && found.objective.value.is_finite();
        if result.failure.is_some() || violated || !finite {
            let status = found.status.clone();
            return Err(ImproveError::NoDesign { study: study.name.clone(), status });
        }
        Ok((study, found))
    }

    fn rewritten(&self, study: &Study, found: &Optimization) -> Result<String, ImproveError> {
        let text = &self.main().text;
        let (mark, bare) = match text.strip_prefix('\u{feff}') {
            Some(bare) => ("\u{feff}", bare),
            None => ("", text.as_str()),
        };
        let mut sources = Sources::new();
        let source = sources.add("", bare);
        // Without what the command line says.
        let file = parameters(&sources, source);
        let change = |row: &VariableRow| {
            let (index, parameter) = (file.index(&row.name)?, study.parameters.get(&row.name)?);
            let written = file.all().get(index)?;
            let size = tolerance(row) / DIGITS;
            let now = file.values().get(index).copied()?;
            if (now - row.value).abs() <= 1e-15 * size {
                return None;
            }
            // A bound is met exactly, and none is passed.
            let room = (row.value - row.bounds.0).min(row.bounds.1 - row.value).max(0.0);
            let tolerance = tolerance(row).min(room);
            let unit = self.design().units.of_dimension(parameter.dimension).symbol;
            Some((row.name.clone(), written.value_as_written_within(row.value, tolerance, &unit)?))
        };
        let changes: Vec<(String, String)> = found.variables.iter().filter_map(change).collect();
        let rewritten = rewrite_parameters(&sources, source, &changes);
        rewritten.map(|text| format!("{mark}{text}")).map_err(|error| ImproveError::Rewrite { error: Box::new(error) })
    }

    /// Reads the text as if it stood in `path`: its parameters and its responses are those that were found.
    fn verify(&self, text: &str, path: &Path, study: &Study, found: &Optimization) -> Result<(), ImproveError> {
        let loaded = load_text(path, text, &self.other_settings(found));
        let Some(model) = &loaded.model else {
            return Err(ImproveError::Unreadable { path: path.to_owned(), loaded: Box::new(loaded) });
        };
        let parameters = &model.design().scopes[0].parameters;
        let mut x = Vec::with_capacity(found.variables.len());
        for row in &found.variables {
            let value = parameters.index(&row.name).and_then(|index| parameters.values().get(index).copied());
            let value = value.unwrap_or(f64::NAN);
            if (value - row.value).abs() > 2.0 * tolerance(row) || value.is_nan() {
                return Err(ImproveError::Differs { what: row.name.clone(), found: row.value, gives: value });
            }
            x.push(value);
        }
        let terms = model.terms(&study.name, &x).map_err(|why| ImproveError::NotSolved { why })?;
        for (row, value) in found.compared.iter().zip(terms) {
            let start = if row.start.is_finite() { row.start.abs() } else { 0.0 };
            if value.is_nan() || (value - row.value).abs() > SAME * row.value.abs().max(start) {
                return Err(ImproveError::Differs { what: row.name.clone(), found: row.value, gives: value });
            }
        }
        Ok(())
    }

    /// The responses that an `optimize` study makes small or large, at values of its variables.
    fn terms(&self, study: &str, x: &[f64]) -> Result<Vec<f64>, String> {
        let missing = || format!("there is no study `{study}`");
        let study = self.study_list().iter().find(|other| other.name == study).ok_or_else(missing)?;
        let Some((ask, question)) = question(study) else { return Err(missing()) };
        let of = self.study_list().iter().find(|other| other.name == ask.of).ok_or_else(missing)?;
        let options = RunOptions::default();
        let asking = Asking { design: self.design(), study, of, ask, options: &options };
        ask::terms(&asking, question, x).map_err(|why| why.message)
    }

    /// What the command line sets beside the variables: they begin there, and end elsewhere.
    fn other_settings(&self, found: &Optimization) -> Vec<(String, String)> {
        let variable = |name: &str| found.variables.iter().any(|row| row.name == name);
        self.main().settings.iter().filter(|(name, _)| !variable(name.trim())).cloned().collect()
    }

    /// Values that the optimum rests on and that `[parameters]` of the new file does not have.
    fn strangers(&self, study: &Study, found: &Optimization) -> Vec<String> {
        let mut warnings = Vec::new();
        let settings: Vec<String> = self.other_settings(found).iter().map(|(name, _)| format!("`{name}`")).collect();
        if !settings.is_empty() {
            let names = settings.join(", ");
            warnings.push(format!("{names}: from the command line, not in the new file; the optimum holds with it"));
        }
        let (variables, others): (Vec<&str>, Vec<&str>) = study
            .changed
            .iter()
            .filter_map(|&index| study.parameters.all().get(index).map(|parameter| parameter.name.as_str()))
            .partition(|name| found.variables.iter().any(|row| row.name == *name));
        if !variables.is_empty() {
            warnings.push(format!(
                "{}: new in `[parameters]`, but a `set` still gives it another value in study `{}` of the new file",
                listed(&variables),
                study.name
            ));
        }
        if !others.is_empty() {
            warnings.push(format!(
                "{}: the optimum holds with the `set` of study `{}`; `[parameters]` of the new file keeps the old value",
                listed(&others),
                study.name
            ));
        }
        warnings
    }
}

fn question(study: &Study) -> Option<(&Ask, &crate::design::Optimize)> {
    match &study.task {
        Task::Ask(ask) => match &ask.question {
            Question::Optimize(question) => Some((ask, question)),
            _ => None,
        },
        _ => None,
    }
}

/// The parameters of a text that is known to be right.
fn parameters(sources: &Sources, source: SourceId) -> ParameterSet {
    let mut diagnostics = Diagnostics::new();
    let tree = parse(sources, source, &mut diagnostics);
    let table = tree.get("parameters").and_then(|entry| entry.value.as_table());
    table.map_or_else(ParameterSet::default, |table| ParameterSet::read(table, &mut diagnostics))
}

/// How far a written value may be from the one that was found, SI.
fn tolerance(row: &VariableRow) -> f64 {
    DIGITS * row.value.abs().max(row.start.abs())
}

fn listed(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}
