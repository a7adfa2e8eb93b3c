//! `[parameters]`: named values that depend on each other.

use crate::{Diagnostics, Dimension, Expression, Number, Override, Span, Table};

/// One parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name.
    pub name: String,
    /// Place of the name in its definition.
    pub span: Span,
    /// What it measures.
    pub dimension: Dimension,
    /// Its definition over the other parameters (an override's, where there is one).
    pub expression: Expression,
    /// Its definition as written.
    pub written: String,
    /// Lower bound, SI.
    pub min: Option<f64>,
    /// Upper bound, SI.
    pub max: Option<f64>,
    /// Tolerance (half width), SI.
    pub tolerance: Option<f64>,
    /// The author's note; empty without one.
    pub note: String,
}

/// All parameters of a model, in written order, with their values.
#[derive(Clone, Debug, Default)]
pub struct ParameterSet {
    all: Vec<Parameter>,
    values: Vec<f64>,
}

impl ParameterSet {
    /// Reads a `[parameters]` table; faulty ones are reported, and kept out.
    pub fn read(table: &Table, diagnostics: &mut Diagnostics) -> ParameterSet {
        todo!()
    }

    /// In written order; an index of this slice is the index used everywhere.
    #[must_use]
    pub fn all(&self) -> &[Parameter] {
        &self.all
    }

    /// Index of a name.
    #[must_use]
    pub fn index(&self, name: &str) -> Option<usize> {
        todo!()
    }

    /// A parameter by name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&Parameter> {
        self.index(name).and_then(|i| self.all.get(i))
    }

    /// SI values by index.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Indices stay the same: expressions compiled against `self` hold for the result. `Err` has
    /// every fault of the overrides; `Ok` may come with warnings.
    pub fn with_overrides(
        &self,
        overrides: &[Override],
    ) -> Result<(ParameterSet, Diagnostics), Diagnostics> {
        todo!()
    }

    /// All values, with those of `fixed` (index, value) in place of their definitions and all that
    /// depend on them following. Derivatives: seed the chosen ones in `fixed`.
    #[must_use]
    pub fn evaluate<N: Number>(&self, fixed: &[(usize, N)]) -> Vec<N> {
        todo!()
    }
}
