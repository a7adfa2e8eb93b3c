//! Why there is no improved model.

use std::fmt;
use std::path::PathBuf;

use bellcrank_doc::RewriteError;

use crate::Loaded;

/// Why there is no improved model.
#[derive(Debug)]
pub enum ImproveError {
    /// The study found no design that could be used.
    NoDesign {
        /// The study.
        study: String,
        /// How its search ended, as results name it; empty where there was none.
        status: String,
    },
    /// The text could not be rewritten.
    Rewrite {
        /// Why.
        error: Box<RewriteError>,
    },
    /// The new text is no model.
    Unreadable {
        /// Where it was to stand.
        path: PathBuf,
        /// What is wrong with it.
        loaded: Box<Loaded>,
    },
    /// The new model cannot be assembled or solved.
    NotSolved {
        /// Why.
        why: String,
    },
    /// The new model does not give what was found.
    Differs {
        /// A parameter or a response.
        what: String,
        /// What was found, SI.
        found: f64,
        /// What the new model gives, SI.
        gives: f64,
    },
}

impl ImproveError {
    /// What to try.
    #[must_use]
    pub fn hints(&self) -> Vec<String> {
        let hint = match self {
            ImproveError::NoDesign { .. } => return Vec::new(),
            ImproveError::Unreadable { .. } | ImproveError::Rewrite { .. } => {
                "the values found are in the results; put them into the file by hand"
            }
            ImproveError::NotSolved { .. } | ImproveError::Differs { .. } => {
                "`start` values that follow the parameters keep the machine on the branch that was optimized"
            }
        };
        vec![hint.to_owned()]
    }
}

impl fmt::Display for ImproveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ImproveError::NoDesign { study, status } => match status.as_str() {
                "infeasible" => write!(f, "study `{study}` found no design that meets all constraints"),
                "interrupted" => write!(f, "study `{study}` was interrupted before it was done"),
                "no-start" => write!(f, "study `{study}` had no design to start from"),
                "iteration-limit" => {
                    write!(f, "study `{study}` reached its limit of iterations before its constraints were met")
                }
                _ => write!(f, "study `{study}` found no design"),
            },
            ImproveError::Rewrite { error } => write!(f, "{error}"),
            ImproveError::Unreadable { path, loaded } => {
                let findings = loaded.diagnostics.findings(&loaded.sources);
                let first = findings.iter().find(|finding| finding.severity == "error");
                let message = first.map_or("", |finding| finding.message.as_str());
                write!(f, "as `{}` the improved model cannot be read: {message}", path.display())
            }
            ImproveError::NotSolved { why } => write!(f, "the improved model cannot be solved when read anew: {why}"),
            ImproveError::Differs { what, found, gives } => {
                write!(
                    f,
                    "read anew, the improved model gives {gives} (SI) for `{what}` where the search found {found}"
                )
            }
        }
    }
}

impl std::error::Error for ImproveError {}
