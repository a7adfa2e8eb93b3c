//! A checked model: what it is made of, and what can be asked of it.

use std::fmt;
use std::path::PathBuf;

use bellcrank_doc::{ParameterSet, nearest};
use bellcrank_multibody::{Blueprint, Engine};
use bellcrank_results::{Drawing, ParameterRow, RunResult, SpaceKind, StudyResult, file_stems};

use crate::build::{self, Built};
use crate::design::{Design, Missing, Study, Task, Values};
use crate::{Check, Progress, RunError, RunOptions, ask, check, drawing, elastic, provenance, run};

/// A study as the file names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudyInfo {
    /// Name.
    pub name: String,
    /// Kind, as in the file.
    pub kind: String,
    /// Whether this version runs it, and the study that it asks, if any.
    pub available: bool,
}

/// A checked model: every value has been evaluated and is sound.
pub struct Model {
    parts: Parts,
    built: Built,
}

/// What a model is made from.
pub(crate) struct Parts {
    pub(crate) name: String,
    pub(crate) title: String,
    pub(crate) main: Main,
    pub(crate) hash: String,
    pub(crate) design: Design,
    pub(crate) studies: Vec<Study>,
}

/// The main file of a model.
pub(crate) struct Main {
    pub(crate) path: PathBuf,
    /// Byte for byte.
    pub(crate) text: String,
    /// Names and values of the command line.
    pub(crate) settings: Vec<(String, String)>,
}

impl fmt::Debug for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Model").field("name", &self.parts.name).finish_non_exhaustive()
    }
}

impl Model {
    /// `None` when the numbers make no mechanism, which has been reported then.
    pub(crate) fn new(parts: Parts) -> Option<Model> {
        let scopes = &parts.design.scopes;
        let values = Values::new(scopes, &scopes.first()?.parameters);
        let built = build::build(&parts.design, &values, &mut Vec::new())?;
        build::engine(&parts.design, &built).ok()?;
        Some(Model { parts, built })
    }

    pub(crate) fn with_settings(mut self, settings: &[(String, String)]) -> Model {
        self.parts.main.settings = settings.to_vec();
        self
    }

    pub(crate) fn main(&self) -> &Main {
        &self.parts.main
    }

    /// Name: the stem of the file's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.parts.name
    }

    /// Title from the file; the name without one.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.parts.title
    }

    /// Plane or space.
    #[must_use]
    pub fn space(&self) -> SpaceKind {
        if self.design().planar { SpaceKind::Planar } else { SpaceKind::Spatial }
    }

    /// Parameters as used, those of subsystems with their prefix.
    #[must_use]
    pub fn parameters(&self) -> Vec<ParameterRow> {
        let design = self.design();
        let values: Values = Values::new(&design.scopes, &design.scopes[0].parameters);
        let mut rows = Vec::new();
        for (index, scope) in design.scopes.iter().enumerate() {
            let values = values.of(crate::design::ScopeId(index));
            for i in 0..scope.parameters.all().len() {
                let row = parameter_row(design, &scope.parameters, i, &scope.prefix);
                rows.extend(row.map(|row| ParameterRow { value: values.get(i).copied().unwrap_or(row.value), ..row }));
            }
        }
        rows
    }

    /// Names of the bodies, without the ground.
    #[must_use]
    pub fn bodies(&self) -> Vec<&str> {
        self.design().bodies.iter().skip(1).map(|body| body.name.as_str()).collect()
    }

    /// Names of the joints.
    #[must_use]
    pub fn joints(&self) -> Vec<&str> {
        self.design().joints.iter().map(|joint| joint.name.as_str()).collect()
    }

    /// Names of the forces.
    #[must_use]
    pub fn forces(&self) -> Vec<&str> {
        self.design().forces.iter().map(|force| force.name.as_str()).collect()
    }

    /// Names of the motions.
    #[must_use]
    pub fn motions(&self) -> Vec<&str> {
        self.design().motions.iter().map(|motion| motion.name.as_str()).collect()
    }

    /// The studies in the order of the file.
    #[must_use]
    pub fn studies(&self) -> Vec<StudyInfo> {
        let info = |study: &Study| StudyInfo {
            name: study.name.clone(),
            kind: study.kind.to_owned(),
            available: study.missing().is_none(),
        };
        self.parts.studies.iter().map(info).collect()
    }

    /// What the mechanism is made of, in SI numbers.
    #[must_use]
    pub fn blueprint(&self) -> &Blueprint<f64> {
        &self.built.blueprint
    }

    /// A mechanism ready to be assembled.
    ///
    /// # Errors
    /// A fault of the program: the same blueprint made a mechanism when the model was loaded.
    pub fn engine(&self) -> Result<Box<dyn Engine>, bellcrank_multibody::BuildError> {
        bellcrank_multibody::engine_for(self.design().planar, &self.built.blueprint)
    }

    /// The stick drawing.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        drawing::drawing(self.design(), &self.built, &self.parts.studies)
    }

    /// Facts about the mechanism: what `bellcrank check` shows.
    #[must_use]
    pub fn check(&self) -> Check {
        check::check(self)
    }

    /// Whether a study can be run.
    ///
    /// # Errors
    /// When there is no such study, or this version does not run it.
    pub fn runs(&self, study: &str) -> Result<(), RunError> {
        self.runnable(study).map(|_| ())
    }

    /// Runs one study. What goes wrong on the way is in [`StudyResult::failure`], with the rows up to there.
    ///
    /// # Errors
    /// When there is no such study, or this version does not run its kind.
    pub fn run(&self, study: &str, progress: &mut dyn Progress) -> Result<StudyResult, RunError> {
        Ok(self.execute(self.runnable(study)?, &RunOptions::default(), progress))
    }

    fn execute(&self, study: &Study, options: &RunOptions, progress: &mut dyn Progress) -> StudyResult {
        self.design().reductions.set(options);
        match &study.task {
            Task::Ask(ask) => ask::run(self.design(), &self.parts.studies, study, ask, options, progress),
            Task::Parts(of) => elastic::run(self.design(), &self.parts.studies, study, of, options, progress),
            _ => run::run(self.design(), study, progress),
        }
    }

    /// Runs some studies, or all when none is named; studies of a kind that this version does not run are then
    /// left out with a warning.
    ///
    /// # Errors
    /// When a named study does not exist or is not available; nothing is run then.
    pub fn run_all(
        &self,
        studies: &[String],
        options: &RunOptions,
        progress: &mut dyn Progress,
    ) -> Result<RunResult, RunError> {
        let mut warnings = Vec::new();
        let chosen: Vec<&Study> = if studies.is_empty() {
            let (available, later): (Vec<&Study>, Vec<&Study>) =
                self.parts.studies.iter().partition(|study| study.missing().is_none());
            warnings.extend(later.into_iter().map(left_out));
            available
        } else {
            studies.iter().map(|name| self.runnable(name)).collect::<Result<_, _>>()?
        };
        if self.parts.studies.is_empty() {
            warnings.push("the model has no studies".to_owned());
        }
        let count = chosen.len();
        let mut results = Vec::with_capacity(count);
        let folders = file_stems(chosen.iter().map(|study| study.name.as_str()));
        for (index, (study, folder)) in chosen.into_iter().zip(folders).enumerate() {
            if progress.cancelled() {
                break;
            }
            let mut share = Share { whole: progress, study: &study.name, index, count };
            let own = RunOptions { folder: options.folder.as_ref().map(|all| all.join(folder)), ..options.clone() };
            results.push(self.execute(study, &own, &mut share));
        }
        Ok(self.result(results, warnings))
    }

    fn result(&self, studies: Vec<StudyResult>, mut warnings: Vec<String>) -> RunResult {
        let facts = check::counted(self);
        warnings.extend(facts.notes.iter().cloned());
        RunResult {
            model: self.parts.name.clone(),
            title: self.parts.title.clone(),
            provenance: provenance::provenance(&self.parts.main.path.display().to_string(), &self.parts.hash),
            parameters: self.parameters(),
            facts: facts.facts(),
            drawing: self.drawing(),
            studies,
            warnings,
        }
    }

    fn runnable(&self, name: &str) -> Result<&Study, RunError> {
        let known = || self.parts.studies.iter().map(|study| study.name.as_str());
        let Some(study) = self.parts.studies.iter().find(|study| study.name == name) else {
            return Err(RunError::UnknownStudy {
                name: name.to_owned(),
                nearest: nearest(name, known()).map(str::to_owned),
                known: known().map(str::to_owned).collect(),
            });
        };
        let (named, kind) = (name.to_owned(), study.kind.to_owned());
        match study.missing() {
            Some(Missing::Kind) => Err(RunError::NotAvailable { study: named, kind }),
            Some(Missing::Question) => Err(RunError::NotAsked { study: named, kind }),
            None => Ok(study),
        }
    }

    pub(crate) fn design(&self) -> &Design {
        &self.parts.design
    }

    /// The design, to be changed for a while, and the studies.
    pub(crate) fn design_and_studies(&mut self) -> (&mut Design, &[Study]) {
        (&mut self.parts.design, &self.parts.studies)
    }

    pub(crate) fn built(&self) -> &Built {
        &self.built
    }

    pub(crate) fn study_list(&self) -> &[Study] {
        &self.parts.studies
    }
}

fn left_out(study: &Study) -> String {
    let (name, kind) = (&study.name, study.kind);
    match study.missing() {
        Some(Missing::Question) => {
            format!("study `{name}` was left out: this version has no `{kind}` of a study of kind `dynamics`")
        }
        _ => format!("study `{name}` was left out: studies of kind `{kind}` are not in this version"),
    }
}

/// One parameter of a set, as results tell it.
pub(crate) fn parameter_row(design: &Design, set: &ParameterSet, index: usize, prefix: &str) -> Option<ParameterRow> {
    let parameter = set.all().get(index)?;
    Some(ParameterRow {
        name: format!("{prefix}{}", parameter.name),
        written: parameter.written.clone(),
        value: set.values().get(index).copied()?,
        unit: design.units.of_dimension(parameter.dimension),
        bounds: (parameter.min, parameter.max),
        note: parameter.note.clone(),
    })
}

/// The part of a run that one study is.
pub(crate) struct Share<'p> {
    pub(crate) whole: &'p mut dyn Progress,
    pub(crate) study: &'p str,
    pub(crate) index: usize,
    pub(crate) count: usize,
}

impl Progress for Share<'_> {
    fn at(&mut self, fraction: f64, message: &str) {
        let done = (self.index as f64 + fraction) / self.count as f64;
        self.whole.at(done, &format!("{}: {message}", self.study));
    }

    fn line(&mut self, text: &str) {
        self.whole.line(text);
    }

    fn cancelled(&self) -> bool {
        self.whole.cancelled()
    }
}
