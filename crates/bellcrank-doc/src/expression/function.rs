//! The functions of expressions.

use super::ReductionKind;

/// A function of one, two or several values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sqrt,
    Abs,
    Sign,
    Min,
    Max,
}

const FUNCTIONS: &[(&str, Function)] = &[
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
    ("asin", Function::Asin),
    ("acos", Function::Acos),
    ("atan", Function::Atan),
    ("atan2", Function::Atan2),
    ("sqrt", Function::Sqrt),
    ("abs", Function::Abs),
    ("sign", Function::Sign),
    ("min", Function::Min),
    ("max", Function::Max),
];

const REDUCTIONS: &[(&str, ReductionKind)] = &[
    ("min", ReductionKind::Min),
    ("max", ReductionKind::Max),
    ("mean", ReductionKind::Mean),
    ("rms", ReductionKind::Rms),
    ("range", ReductionKind::Range),
    ("first", ReductionKind::First),
    ("last", ReductionKind::Last),
    ("at", ReductionKind::At),
];

impl Function {
    pub(crate) fn named(name: &str) -> Option<Function> {
        FUNCTIONS.iter().find(|(n, _)| *n == name).map(|(_, f)| *f)
    }

    /// Fewest and most arguments.
    pub(crate) fn arguments(self) -> (usize, usize) {
        match self {
            Function::Atan2 => (2, 2),
            Function::Min | Function::Max => (2, usize::MAX),
            _ => (1, 1),
        }
    }
}

impl ReductionKind {
    /// `max`, `rms`, ...
    #[must_use]
    pub fn name(self) -> &'static str {
        REDUCTIONS.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }

    /// How many arguments it takes: the curve, and the place of `at`.
    pub(crate) fn arguments(self) -> usize {
        if self == ReductionKind::At { 2 } else { 1 }
    }

    pub(crate) fn named(name: &str) -> Option<ReductionKind> {
        REDUCTIONS.iter().find(|(n, _)| *n == name).map(|(_, kind)| *kind)
    }
}

/// Names of all functions and reductions.
pub(crate) fn function_names() -> impl Iterator<Item = &'static str> {
    let only_reductions = REDUCTIONS.iter().map(|(n, _)| *n).filter(|n| Function::named(n).is_none());
    FUNCTIONS.iter().map(|(n, _)| *n).chain(only_reductions)
}

/// Whether a parameter may not have this name, and what it is instead.
pub(crate) fn reserved(name: &str) -> Option<&'static str> {
    if crate::units::single(name).is_some() {
        return Some("a unit");
    }
    match name {
        "pi" => Some("a constant"),
        "time" => Some("a signal"),
        _ if function_names().any(|n| n == name) => Some("a function"),
        _ => None,
    }
}
