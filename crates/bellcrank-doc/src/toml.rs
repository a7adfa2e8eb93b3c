//! From text to the tree.
//!
//! `toml_parser` gives tokens, events and every syntax error; what tables mean (headers, dotted
//! keys, repeated names) is decided here, so that a repeated name can be shown at both its places
//! and reading goes on after every fault.

mod build;
mod recover;
mod syntax;
#[cfg(test)]
mod tests;

use toml_parser::Source;
use toml_parser::parser::{Event, RecursionGuard, ValidateWhitespace, parse_document};

use crate::{Diagnostics, SourceId, Sources, Table};

/// Deepest nesting of brackets and braces.
const MAX_DEPTH: u32 = 64;

/// The tree of a whole text. Syntax errors and repeated names are reported; all that could be
/// read is returned.
pub fn parse(sources: &Sources, id: SourceId, diagnostics: &mut Diagnostics) -> Table {
    let text = sources.text(id);
    let source = Source::new(text);
    let mut errors = syntax::Errors::new(text);
    let events = events(source, &mut errors);
    let mut builder = build::Builder::new(id, source, errors);
    builder.document(&events);
    let (tree, errors, own) = builder.finish();
    errors.report(id, diagnostics);
    diagnostics.append(own);
    tree
}

/// The events of all pieces of the text, in order.
fn events(source: Source<'_>, errors: &mut syntax::Errors<'_>) -> Vec<Event> {
    let tokens = source.lex().into_vec();
    let mut events: Vec<Event> = Vec::with_capacity(tokens.len());
    let end = tokens.last().copied();
    for piece in recover::pieces(source.input(), &tokens) {
        let whole = piece.end == tokens.len();
        let mut piece = tokens.get(piece).unwrap_or_default().to_vec();
        // Every piece needs an end of its own.
        piece.extend(end.filter(|_| !whole));
        let mut checked = ValidateWhitespace::new(&mut events, source);
        let mut guarded = RecursionGuard::new(&mut checked, MAX_DEPTH);
        parse_document(&piece, &mut guarded, errors);
    }
    events
}
