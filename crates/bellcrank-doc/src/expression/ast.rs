//! What was written, before names and dimensions are looked at.

use super::Comparison;
use crate::{Dimension, Span};

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

/// A whole value: a sum, or two sums compared.
#[derive(Clone, Debug)]
pub(crate) struct Parsed {
    pub(crate) left: Node,
    pub(crate) right: Option<(Comparison, Span, Node)>,
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
