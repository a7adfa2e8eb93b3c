//! Text, spans, TOML tree, units, expressions, parameters and diagnostics of bellcrank's model
//! files. No file is opened and nothing printed here; what a body or a joint is, is not known here.
//!
//! In reading order:
//! 1. [`Sources`] keep texts under names; a [`Span`] is a place in one of them. [`load`] refuses
//!    bytes that are no text.
//! 2. [`Diagnostic`]s say what is wrong, where, and what to do; [`Diagnostics`] collect, sort and
//!    render them.
//! 3. [`parse`] makes the [`Table`] of a text, with the place of every key and value, and goes on
//!    after errors.
//! 4. [`Dimension`] and [`Unit`]: what a value measures.
//! 5. [`Expression`]: a value with its names resolved and its dimension checked, evaluated over any
//!    [`Number`]. [`Response`], [`Constraint`] and [`Condition`] are what studies ask.
//! 6. [`ParameterSet`]: named values that depend on each other, and their [`Override`]s.
//!    [`rewrite_parameters`] writes other values into the text of a file, [`written_value`] a value in
//!    a unit.
//! 7. [`Reader`] and [`Fields`]: what a schema asks of a table, with all reports of what it did not
//!    get.
//!
//! ```
//! use bellcrank_doc::{Diagnostics, Dimension, Fields, ParameterSet, Reader, Sources, load, parse};
//!
//! let text = b"[parameters]\nl5 = '950 mm'\n[link]\nlength = 'l5/2 - 50 mm'\nmas = '3 kg'\n";
//! let mut sources = Sources::new();
//! let mut diagnostics = Diagnostics::new();
//! let id = load(&mut sources, "link.toml", text, &mut diagnostics).unwrap();
//! let tree = parse(&sources, id, &mut diagnostics);
//! let table = |name: &str| tree.get(name).and_then(|entry| entry.value.as_table()).unwrap();
//!
//! let parameters = ParameterSet::read(table("parameters"), &mut diagnostics);
//! let reader = Reader::new(&parameters);
//! let link = Fields::new(&reader, table("link"), "link `1`");
//! let length = link.quantity("length", Dimension::LENGTH).unwrap();
//! let mass = link.quantity("mass", Dimension::MASS);
//! link.finish();
//!
//! assert_eq!(length.eval(parameters.values(), &[]), 0.425);
//! assert!(mass.is_none());
//! diagnostics.append(reader.finish());
//! assert_eq!(diagnostics.render(&sources, false), "\
//! error: unknown key `mas` in link `1`
//!    ┌─ link.toml:5:1
//!  5 │ mas = '3 kg'
//!    │ ^^^
//! hint: did you mean `mass`?
//! hint: known keys: `length`, `mass`
//! ");
//! ```

mod diagnostic;
mod dimension;
mod expression;
mod fields;
mod nearest;
mod number;
mod overrides;
mod parameters;
mod quantity;
mod render;
mod rewrite;
mod source;
mod text;
mod toml;
mod tree;
mod units;
mod words;
mod written;

pub use diagnostic::{Diagnostic, Diagnostics, Finding, Label, Severity};
pub use dimension::Dimension;
pub use expression::{
    Comparison, Condition, Constraint, Expression, NoSignals, Reduction, ReductionKind, Response, Scope, Signals,
};
pub use fields::{Fields, Reader};
pub use nearest::nearest;
pub use number::Number;
pub use overrides::Override;
pub use parameters::{Distribution, Parameter, ParameterSet, Spread};
pub use quantity::written_value;
pub use render::RENDER_LIMIT;
pub use rewrite::{RewriteError, rewrite_parameters};
pub use source::{Location, SourceId, Sources, Span, Spanned};
pub use text::{MAX_BYTES, check_size, decode, load};
pub use toml::parse;
pub use tree::{Entry, Table, Text, Value, ValueKind};
pub use units::{Unit, unit, unit_names};
