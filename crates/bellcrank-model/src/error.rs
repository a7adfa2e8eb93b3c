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
        /// Its kind, or that of the study it asks.
        kind: String,
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
            RunError::NotAvailable { .. } => {
                vec![format!("this version runs {}", AVAILABLE.join(", "))]
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
        }
    }
}

impl std::error::Error for RunError {}
