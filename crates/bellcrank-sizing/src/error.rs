//! What can go wrong: numbers that describe no duty and no drive.

use std::fmt;

/// Input that cannot be judged.
#[derive(Clone, Debug, PartialEq)]
pub enum SizingError {
    /// A duty without a row.
    NoRows,
    /// A value of a row that is no finite number.
    NotFinite {
        /// Row, from 0.
        row: usize,
        /// Which value: `position`, `effort`, `velocity`, `acceleration`, `time`.
        value: &'static str,
    },
    /// Some rows have a time and this one has none.
    TimeMissing {
        /// Row, from 0.
        row: usize,
    },
    /// The time of this row is before that of the one before it.
    TimeGoesBack {
        /// Row, from 0.
        row: usize,
    },
    /// Columns of a duty that are not of equal length.
    Lengths {
        /// Which column is the odd one.
        column: &'static str,
        /// Its length.
        found: usize,
        /// Length of the positions.
        expected: usize,
    },
    /// A number of the catalogue or of the conditions that has no meaning, e.g. a bore of zero.
    Unusable {
        /// Name of the catalogue entry; `conditions` for the conditions.
        of: String,
        /// Which number.
        value: &'static str,
        /// What it is, SI.
        found: f64,
        /// What it may be, e.g. `above 0`.
        allowed: &'static str,
    },
    /// Nothing to choose from.
    NoCandidates,
}

impl fmt::Display for SizingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SizingError::NoRows => write!(f, "the duty has no rows"),
            SizingError::NotFinite { row, value } => write!(f, "row {row}: the {value} is not a finite number"),
            SizingError::TimeMissing { row } => write!(f, "row {row} has no time, others have"),
            SizingError::TimeGoesBack { row } => write!(f, "row {row}: the time goes back"),
            SizingError::Lengths { column, found, expected } => {
                write!(f, "{found} values of {column} for {expected} positions")
            }
            SizingError::Unusable { of, value, found, allowed } => {
                write!(f, "`{of}`: {value} is {found} in SI units, it must be {allowed}")
            }
            SizingError::NoCandidates => write!(f, "the catalogue has no entry of this kind"),
        }
    }
}

impl std::error::Error for SizingError {}

/// Demands on numbers of one entry, all of which are finite.
pub(crate) struct Demands<'a>(pub(crate) &'a str);

impl Demands<'_> {
    fn that(&self, holds: bool, value: &'static str, found: f64, allowed: &'static str) -> Result<(), SizingError> {
        if holds && found.is_finite() {
            return Ok(());
        }
        Err(SizingError::Unusable { of: self.0.to_owned(), value, found, allowed })
    }
    pub(crate) fn positive(&self, value: &'static str, found: f64) -> Result<(), SizingError> {
        self.that(found > 0.0, value, found, "above 0")
    }
    pub(crate) fn not_negative(&self, value: &'static str, found: f64) -> Result<(), SizingError> {
        self.that(found >= 0.0, value, found, "0 or above")
    }
    pub(crate) fn share(&self, value: &'static str, found: f64) -> Result<(), SizingError> {
        self.that(found > 0.0 && found <= 1.0, value, found, "above 0, 1 at most")
    }
    pub(crate) fn below(&self, value: &'static str, found: f64, limit: f64) -> Result<(), SizingError> {
        self.that((0.0..limit).contains(&found), value, found, "0 or above, smaller than the bore")
    }
    pub(crate) fn below_one(&self, value: &'static str, found: f64) -> Result<(), SizingError> {
        self.that((0.0..1.0).contains(&found), value, found, "0 or above, below 1")
    }
    pub(crate) fn at_least(&self, value: &'static str, found: f64, least: f64) -> Result<(), SizingError> {
        self.that(found >= least, value, found, "the rated effort or above")
    }
    pub(crate) fn positive_if_any(&self, value: &'static str, found: Option<f64>) -> Result<(), SizingError> {
        found.map_or(Ok(()), |found| self.positive(value, found))
    }
    pub(crate) fn not_negative_if_any(&self, value: &'static str, found: Option<f64>) -> Result<(), SizingError> {
        found.map_or(Ok(()), |found| self.not_negative(value, found))
    }
}
