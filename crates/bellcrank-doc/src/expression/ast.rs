//! What was written, before names and dimensions are looked at.

use std::ops::Range;

use super::Comparison;
use crate::{Diagnostic, Dimension, Span};

#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) kind: NodeKind,
    /// With its parentheses.
    pub(crate) span: Span,
    /// Longest way down to a leaf; bounded by the parser.
    pub(super) depth: usize,
}

#[derive(Clone, Debug)]
pub(crate) enum NodeKind {
    /// A number without a unit.
    Number(f64),
    /// A number with a unit, in SI.
    Quantity(f64, Dimension),
    /// A parameter, a signal or `pi`.
    Name(String),
    Negate(Box<Node>),
    Binary(Operator, Box<[Node; 2]>),
    Call {
        name: String,
        name_span: Span,
        arguments: Vec<Node>,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// A whole value: a sum, a sum with a tolerance, or two sums compared.
#[derive(Clone, Debug)]
pub(crate) struct Parsed {
    pub(crate) left: Node,
    pub(crate) tolerance: Option<Tolerance>,
    pub(crate) right: Option<(Comparison, Span, Node)>,
}

/// What follows `±`.
#[derive(Clone, Debug)]
pub(crate) struct Tolerance {
    /// The sign as written.
    pub(crate) sign: &'static str,
    pub(crate) span: Span,
    /// Bytes of the sign in the text.
    pub(crate) bytes: Range<usize>,
    pub(crate) half_width: Node,
}

impl Tolerance {
    /// The report of a tolerance where none can be.
    pub(crate) fn misplaced(sign: &str, span: Span) -> Diagnostic {
        let message = format!("`{sign}` sets the tolerance of a parameter and cannot stand here");
        let error = Diagnostic::error("tolerance", span, message)
            .hint("a tolerance belongs to a parameter: `[parameters] l3 = \"732 mm ± 0.1 mm\"`");
        if sign == "+-" { error.hint("for a difference write `-`") } else { error }
    }
}

impl Node {
    pub(crate) fn leaf(kind: NodeKind, span: Span) -> Node {
        Node { kind, span, depth: 1 }
    }

    pub(super) fn binary(operator: Operator, left: Node, right: Node) -> Node {
        let span = left.span.to(right.span);
        let depth = left.depth.max(right.depth) + 1;
        Node { kind: NodeKind::Binary(operator, Box::new([left, right])), span, depth }
    }

    /// A number that stands alone, without a unit.
    pub(super) fn literal(&self) -> Option<f64> {
        match &self.kind {
            NodeKind::Number(value) => Some(*value),
            NodeKind::Negate(inner) => inner.literal().map(|value| -value),
            _ => None,
        }
    }

    /// Calls `visit` with every name in the tree.
    pub(crate) fn names<'a>(&'a self, visit: &mut dyn FnMut(&'a str)) {
        match &self.kind {
            NodeKind::Number(_) | NodeKind::Quantity(..) => {}
            NodeKind::Name(name) => visit(name),
            NodeKind::Negate(inner) => inner.names(visit),
            NodeKind::Binary(_, sides) => sides.iter().for_each(|n| n.names(visit)),
            NodeKind::Call { arguments, .. } => arguments.iter().for_each(|n| n.names(visit)),
        }
    }
}
