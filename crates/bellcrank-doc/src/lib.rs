//! Text, spans, TOML tree, units, expressions, parameters and diagnostics of bellcrank's model
//! files.

mod diagnostic;
mod dimension;
mod expression;
mod fields;
mod nearest;
mod number;
mod overrides;
mod parameters;
mod render;
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
pub use parameters::{Parameter, ParameterSet};
pub use render::RENDER_LIMIT;
pub use source::{Location, SourceId, Sources, Span, Spanned};
pub use text::{MAX_BYTES, check_size, decode, load};
pub use toml::parse;
pub use tree::{Entry, Table, Text, Value, ValueKind};
pub use units::{Unit, unit, unit_names};
