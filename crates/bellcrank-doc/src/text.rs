//! From bytes to text: what is refused before parsing.

use crate::{Diagnostic, Diagnostics, SourceId, Sources};

/// Largest file that is read, 16 MiB; a model is some kilobytes.
pub const MAX_BYTES: usize = 16 * 1024 * 1024;

/// Refuses what is larger than [`MAX_BYTES`]; to be asked before the file is read into memory.
pub fn check_size(name: &str, bytes: u64) -> Result<(), Diagnostic> {
    todo!()
}

/// UTF-8 text without a byte order mark, or why it is none. The diagnostic has no place.
pub fn decode(bytes: &[u8]) -> Result<String, Diagnostic> {
    todo!()
}

/// Adds the text of a file under `name`, whatever is in it, and reports what is wrong with it
/// (too large, binary, not UTF-8, empty). `None` when there is nothing to parse.
pub fn load(
    sources: &mut Sources,
    name: &str,
    bytes: &[u8],
    diagnostics: &mut Diagnostics,
) -> Option<SourceId> {
    todo!()
}
