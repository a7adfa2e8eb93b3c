//! Diagnostics as text for people.

use crate::{Diagnostics, Sources};

/// Diagnostics shown in full; the rest is counted.
pub const RENDER_LIMIT: usize = 50;

impl Diagnostics {
    /// All of them (at most [`RENDER_LIMIT`]) with source lines, carets and hints; ANSI colours
    /// only when asked.
    #[must_use]
    pub fn render(&self, sources: &Sources, color: bool) -> String {
        todo!()
    }
}
