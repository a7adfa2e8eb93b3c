//! A checked model: what it is made of, and what can be asked of it.

use bellcrank_multibody::{Blueprint, Engine};
use bellcrank_results::{Drawing, ParameterRow, RunResult, SpaceKind, StudyResult};

use crate::{Check, Progress, RunError};

/// A study as the file names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudyInfo {
    /// Name.
    pub name: String,
    /// Kind, as in the file.
    pub kind: String,
    /// Whether this version runs it.
    pub available: bool,
}

/// A checked model: every value has been evaluated and is sound.
#[derive(Debug)]
pub struct Model {}

impl Model {
    /// Name: the stem of the file's name.
    #[must_use]
    pub fn name(&self) -> &str {
        todo!()
    }
    /// Title from the file; the name without one.
    #[must_use]
    pub fn title(&self) -> &str {
        todo!()
    }
    /// Plane or space.
    #[must_use]
    pub fn space(&self) -> SpaceKind {
        todo!()
    }
    /// Parameters as used, those of subsystems with their prefix.
    #[must_use]
    pub fn parameters(&self) -> Vec<ParameterRow> {
        todo!()
    }
    /// Names of the bodies, without the ground.
    #[must_use]
    pub fn bodies(&self) -> Vec<&str> {
        todo!()
    }
    /// Names of the joints.
    #[must_use]
    pub fn joints(&self) -> Vec<&str> {
        todo!()
    }
    /// Names of the forces.
    #[must_use]
    pub fn forces(&self) -> Vec<&str> {
        todo!()
    }
    /// Names of the motions.
    #[must_use]
    pub fn motions(&self) -> Vec<&str> {
        todo!()
    }
    /// The studies in the order of the file.
    #[must_use]
    pub fn studies(&self) -> Vec<StudyInfo> {
        todo!()
    }
    /// What the mechanism is made of, in SI numbers.
    #[must_use]
    pub fn blueprint(&self) -> Blueprint<f64> {
        todo!()
    }
    /// A mechanism ready to be assembled.
    #[must_use]
    pub fn engine(&self) -> Box<dyn Engine> {
        todo!()
    }
    /// The stick drawing.
    #[must_use]
    pub fn drawing(&self) -> Drawing {
        todo!()
    }
    /// Facts about the mechanism: what `bellcrank check` shows.
    #[must_use]
    pub fn check(&self) -> Check {
        todo!()
    }
    /// Runs one study. What goes wrong on the way is in [`StudyResult::failure`], with the rows up to there.
    ///
    /// # Errors
    /// When there is no such study, or this version does not run its kind.
    pub fn run(&self, _study: &str, _progress: &mut dyn Progress) -> Result<StudyResult, RunError> {
        todo!()
    }
    /// Runs some studies, or all when none is named; studies of a kind that this version does not run are then
    /// left out with a warning.
    ///
    /// # Errors
    /// When a named study does not exist or is not available; nothing is run then.
    pub fn run_all(&self, _studies: &[String], _progress: &mut dyn Progress) -> Result<RunResult, RunError> {
        todo!()
    }
}
