//! Why a study was not run at all. A run that stops on its way leaves a result with a failure instead.

use std::fmt;

use crate::schema::AVAILABLE;

/// A study that was not run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RunError {
    /// No study has this name (the command line is wrong).
    UnknownStudy {
        /// The name asked for.
        name: String,
        /// The nearest name there is.
        nearest: Option<String>,
        /// All names there are.
        known: Vec<String>,
    },
    /// This version does not run studies of this kind.
    NotAvailable {
        /// The study.
        study: String,
        /// Its kind.
        kind: String,
    },
    /// This version does not ask this of a study of dynamics.
    NotAsked {
        /// The study.
        study: String,
        /// Its kind.
        kind: String,
    },
    /// Convergence is asked of a study that has no rows of its own.
    NoRows {
        /// The study.
        study: String,
        /// Its kind.
        kind: String,
        /// The study that it asks, if any.
        of: Option<String>,
    },
    /// Convergence is asked of a study without flexible bodies.
    Rigid {
        /// The study.
        study: String,
        /// There are such bodies; the study makes them rigid.
        switched_off: bool,
    },
}

impl RunError {
    /// What to try.
    #[must_use]
    pub fn hints(&self) -> Vec<String> {
        match self {
            RunError::UnknownStudy { nearest: Some(name), .. } => vec![format!("did you mean `{name}`?")],
            RunError::UnknownStudy { known, .. } if known.is_empty() => {
                vec!["the file has no studies: add a `[studies.NAME]` table".to_owned()]
            }
            RunError::UnknownStudy { known, .. } => vec![format!("studies of this file: {}", known.join(", "))],
            RunError::NotAvailable { .. } => vec![format!("this version runs {}", AVAILABLE.join(", "))],
            RunError::NotAsked { .. } => {
                let hint = "ask a study of kind kinematics, inverse-dynamics or statics; of dynamics there are `sweep` \
                            and `sizing`";
                vec![hint.to_owned()]
            }
            RunError::NoRows { of: Some(of), .. } => vec![format!("ask the study that it asks: `{of}`")],
            RunError::NoRows { .. } => {
                vec!["ask a study of kind kinematics, inverse-dynamics, statics or dynamics".to_owned()]
            }
            RunError::Rigid { switched_off: true, .. } => {
                vec!["take `flexible = false` out of the study".to_owned()]
            }
            RunError::Rigid { .. } => {
                let hint = "a body with a solid or a beam deforms by `flexible = true`: docs/flexible.md";
                vec![hint.to_owned()]
            }
        }
    }
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RunError::UnknownStudy { name, .. } => write!(f, "there is no study `{name}`"),
            RunError::NotAvailable { study, kind } => {
                write!(f, "study `{study}`: studies of kind `{kind}` are not in this version")
            }
            RunError::NotAsked { study, kind } => {
                write!(f, "study `{study}`: this version has no `{kind}` of a study of kind `dynamics`")
            }
            RunError::NoRows { study, kind, .. } => {
                write!(f, "study `{study}` is of kind `{kind}`, which has no rows to compare")
            }
            RunError::Rigid { study, .. } => write!(f, "study `{study}` has no flexible bodies"),
        }
    }
}

impl std::error::Error for RunError {}
