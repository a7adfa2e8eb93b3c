//! Other values for parameters: `set = { m1 = "0 kg" }` and `--set m1=0kg`.

use crate::{Diagnostic, Diagnostics, Sources, Span, Table, Text};

/// A new definition of one parameter.
#[derive(Clone, Debug)]
pub struct Override {
    /// The parameter.
    pub name: String,
    /// Where the override names it.
    pub name_span: Span,
    /// The new definition, as written.
    pub(crate) written: crate::tree::Value,
}

impl Override {
    /// The overrides of a `set` table; entries that are no values are reported.
    pub fn from_table(table: &Table, diagnostics: &mut Diagnostics) -> Vec<Override> {
        todo!()
    }

    /// The override of one `--set` argument `NAME=VALUE`. The argument becomes a source named
    /// `--set`, so that faults in it are shown like faults in a file.
    pub fn from_argument(sources: &mut Sources, argument: &str) -> Result<Override, Diagnostic> {
        todo!()
    }
}
