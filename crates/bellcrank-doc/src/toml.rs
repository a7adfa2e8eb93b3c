//! From text to the tree.

use crate::{Diagnostics, SourceId, Sources, Table};

/// The tree of a whole text. Syntax errors and repeated names are reported; all that could be
/// read is returned.
pub fn parse(sources: &Sources, id: SourceId, diagnostics: &mut Diagnostics) -> Table {
    todo!()
}
