//! How far a study moves when its flexible bodies keep more modes, and when their meshes are finer.
//!
//! The design is changed for a run and changed back: what a file may say of modes and meshes stays one place.

mod settings;
mod watched;

use bellcrank_results::{Convergence, Failure, Ladder, Over, Rung};

use crate::design::{Design, Study, Task};
use crate::elastic::End;
use crate::flex::{self, Found};
use crate::model::Share;
use crate::{Model, Progress, RunError, RunOptions, run};
use settings::{Own, counts};

/// Multiples of the sizes of elements.
const SCALES: [f64; 3] = [1.0, 0.7, 0.5];

/// How convergence is looked at.
#[derive(Clone, Debug)]
pub struct Converge {
    /// Largest change against the finest that counts as none, e.g. 0.01.
    pub tolerance: f64,
    /// As of any run.
    pub options: RunOptions,
}

impl Model {
    /// Runs a study with more and more modes of all its flexible bodies, then with finer and finer meshes. What goes
    /// wrong on the way is in the answer.
    ///
    /// # Errors
    /// When there is no such study, it has no rows of its own, or no body is flexible in it.
    pub fn converge(
        &mut self,
        study: &str,
        how: &Converge,
        progress: &mut dyn Progress,
    ) -> Result<Convergence, RunError> {
        let place = self.convergent(study)?;
        let (design, studies) = self.design_and_studies();
        design.reductions.set(&how.options);
        let study = &studies[place];
        let found = Convergence {
            study: study.name.clone(),
            kind: study.kind.to_owned(),
            tolerance: how.tolerance,
            quantities: Vec::new(),
            ladders: Vec::new(),
            notes: Vec::new(),
            failure: None,
        };
        let mut climb = Climb { design, study, progress, found, done: 0, all: 1 };
        if let Err(end) = climb.all() {
            climb.found.failure = Some(*end);
        }
        Ok(climb.finished())
    }

    /// The place of a study that has rows and bodies that deform in it.
    fn convergent(&self, name: &str) -> Result<usize, RunError> {
        self.runs(name)?;
        let place = self.study_list().iter().position(|study| study.name == name).unwrap_or(0);
        let study = &self.study_list()[place];
        let of = match &study.task {
            Task::Motion { .. } | Task::Statics { .. } | Task::Dynamics(_) => {
                let any = self.design().bodies.iter().any(|body| body.flexible.is_some());
                return if any && study.flexible {
                    Ok(place)
                } else {
                    Err(RunError::Rigid { study: name.to_owned(), switched_off: any })
                };
            }
            Task::Ask(ask) => Some(ask.of.clone()),
            Task::Modes(_) | Task::Parts(_) | Task::Later => None,
        };
        Err(RunError::NoRows { study: name.to_owned(), kind: study.kind.to_owned(), of })
    }
}

/// Up both ladders.
struct Climb<'a> {
    design: &'a mut Design,
    study: &'a Study,
    progress: &'a mut dyn Progress,
    found: Convergence,
    /// Runs that are done, and all that there will be.
    done: usize,
    all: usize,
}

impl Climb<'_> {
    fn all(&mut self) -> Result<(), End> {
        let own = Own::of(self.design, self.study, self.progress)?;
        let counts = counts(own.most_modes(), own.all_held_twice(self.design));
        self.all = counts.len() + SCALES.len();
        let climbed = self.over_modes(&own, &counts);
        own.restore(self.design);
        climbed?;
        if !self.progress.cancelled() {
            self.over_mesh(&own);
            own.restore(self.design);
        }
        Ok(())
    }

    /// All counts come from one reduction with the largest.
    fn over_modes(&mut self, own: &Own, counts: &[usize]) -> Result<(), End> {
        let mut ladder = Ladder { over: Over::Modes, rungs: Vec::new(), ended: None };
        own.keep(self.design, counts.last().copied().unwrap_or(0));
        let full = self.full(own)?;
        for &count in counts {
            self.design.reductions.clear();
            own.keep(self.design, count);
            for (body, found) in &full {
                flex::keep_fewer(self.design, self.study, *body, &found.reduced)?;
            }
            let plural = if count == 1 { "" } else { "s" };
            match self.rung(count as f64, &format!("{count} mode{plural}")) {
                Some(rung) => ladder.rungs.push(rung),
                None => {
                    ladder.ended = Some("stopped by the user".to_owned());
                    break;
                }
            }
        }
        self.found.ladders.push(ladder);
        Ok(())
    }

    /// Reductions of the solids as the design is now.
    fn full(&mut self, own: &Own) -> Result<Vec<(usize, Found)>, End> {
        let mut full = Vec::new();
        for body in own.solids() {
            let name = format!("{}: most modes", self.study.name);
            let mut share = Share { whole: self.progress, study: &name, index: self.done, count: self.all };
            full.push((body, flex::of_body(self.design, self.study, body, &mut share)?));
        }
        Ok(full)
    }

    /// Each mesh is reduced anew.
    fn over_mesh(&mut self, own: &Own) {
        let fixed = own.with_given_meshes(self.design);
        let note = |name: &String| format!("body `{name}` has its mesh from a file: it stays as it is");
        self.found.notes.extend(fixed.iter().map(note));
        if fixed.len() == own.count() {
            return;
        }
        let mut ladder = Ladder { over: Over::Mesh, rungs: Vec::new(), ended: None };
        for scale in SCALES {
            self.design.reductions.clear();
            own.scale(self.design, scale);
            let Some(rung) = self.rung(scale, &format!("sizes x {scale}")) else {
                ladder.ended = Some("stopped by the user".to_owned());
                break;
            };
            // Without a row there was no mesh, or no reduction of it: finer ones will fare no better.
            let never_ran = rung.values.iter().all(Option::is_none);
            if let Some(why) = rung.failure.as_ref().filter(|_| never_ran) {
                ladder.ended = Some(why.clone());
                break;
            }
            ladder.rungs.push(rung);
        }
        self.found.ladders.push(ladder);
    }

    /// Runs the study as the design is now; `None` where the user stopped it.
    fn rung(&mut self, setting: f64, label: &str) -> Option<Rung> {
        let label = format!("{}: {label}", self.study.name);
        let mut share = Share { whole: self.progress, study: &label, index: self.done, count: self.all };
        let result = run::run(self.design, self.study, &mut share);
        self.done += 1;
        if self.progress.cancelled() {
            return None;
        }
        Some(watched::rung(setting, &result, &mut self.found.quantities))
    }

    fn finished(mut self) -> Convergence {
        let count = self.found.quantities.len();
        for rung in self.found.ladders.iter_mut().flat_map(|ladder| &mut ladder.rungs) {
            rung.values.resize(count, None);
        }
        let failed = self.found.ladders.iter().flat_map(|ladder| &ladder.rungs).find_map(|rung| rung.failure.clone());
        if count == 0 && self.found.failure.is_none() && !self.progress.cancelled() {
            let nothing = || {
                format!("study `{}` has nothing to compare: no drive force, and no stress to trust", self.found.study)
            };
            let hint = "ask a study with a drive, or one in which a flexible solid carries a load".to_owned();
            self.found.failure = Some(Failure { message: failed.unwrap_or_else(nothing), hints: vec![hint] });
        }
        self.found
    }
}
