//! Responses over many designs.

use crate::{Table, Unit};

/// What a sweep over designs found. All rows are in the files; here is what a reader looks at.
#[derive(Clone, Debug)]
pub struct Designs {
    /// Name of the study that gives the responses.
    pub of: String,
    /// `grid`, `lhs`, `sobol` or `table`.
    pub method: String,
    /// Start of the random numbers, where the method has some.
    pub seed: Option<u64>,
    /// Designs asked for.
    pub total: u64,
    /// Designs done, those that failed included.
    pub done: u64,
    /// Designs taken over from an interrupted run.
    pub resumed: u64,
    /// Designs without a result.
    pub failed: u64,
    /// Reasons of failures, most frequent first.
    pub failures: Vec<DesignFailure>,
    /// How many leading columns of `sample` are parameters; the rest are responses.
    pub inputs: usize,
    /// A share of the rows, all of them when they are few; failed designs have NaN responses. The first column is
    /// the number of the design (`design`, unit one), before the parameters.
    pub sample: Table,
    /// One a column of `sample` after `design`.
    pub statistics: Vec<ColumnStatistics>,
    /// The best compromises of two responses.
    pub pareto: Option<ParetoFront>,
    /// Files with all rows, as names within the study's folder (`designs.csv`, `designs.parquet`).
    pub files: Vec<String>,
    /// Threads used.
    pub threads: usize,
}

/// Why designs failed.
#[derive(Clone, Debug)]
pub struct DesignFailure {
    /// The reason, as in the rows.
    pub reason: String,
    /// How many.
    pub count: u64,
    /// The first design it happened to.
    pub first: u64,
}

/// A column over all designs, SI.
#[derive(Clone, Debug)]
pub struct ColumnStatistics {
    /// Name.
    pub name: String,
    /// Display unit.
    pub unit: Unit,
    /// Smallest value and the design that has it.
    pub min: (f64, u64),
    /// Largest value and the design that has it.
    pub max: (f64, u64),
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub deviation: f64,
}

/// Designs that no other design beats in both responses.
#[derive(Clone, Debug)]
pub struct ParetoFront {
    /// Names of the two responses, and whether each is made small (else large).
    pub objectives: [(String, bool); 2],
    /// Rows of the front with the columns of the sample, ascending in the first response.
    pub front: Table,
}
