//! Names resolved, dimensions checked, operations laid down: one walk over the tree.

use super::ast::{Node, NodeKind, Operator};
use super::function::{Function, function_names, reserved};
use super::program::{At, Op, Program};
use super::{Expression, HUGE, Reduction, ReductionKind};
use crate::{Diagnostic, Diagnostics, Dimension, Span, nearest, unit_names};

/// What a name stands for.
pub(crate) enum Known {
    Parameter {
        index: usize,
        dimension: Dimension,
        value: f64,
        defined: Span,
    },
    Signal {
        index: usize,
        dimension: Dimension,
    },
    /// Its definition has been reported; stay silent.
    Faulty,
    Unknown,
}

/// Where names are looked up.
pub(crate) trait Resolve {
    fn resolve(&mut self, name: &str) -> Known;
    /// All names, for hints.
    fn names(&self) -> Vec<String>;
    /// Whether any signal can be named here.
    fn has_signals(&self) -> bool;
}

/// What a node turned out to be.
#[derive(Clone, Copy)]
pub(super) struct Typed {
    at: At,
    /// `None` is a literal 0, which fits everywhere.
    pub(super) dimension: Option<Dimension>,
    /// The value, where it does not depend on signals.
    value: Option<f64>,
}

/// One walk over one tree.
pub(super) struct Checker<'r> {
    names: &'r mut dyn Resolve,
    diagnostics: &'r mut Diagnostics,
    ops: Vec<Op>,
    /// In a response: the reductions so far. Elsewhere curves are not reduced.
    reductions: Option<&'r mut Vec<Reduction>>,
}

impl<'r> Checker<'r> {
    pub(super) fn new(
        names: &'r mut dyn Resolve,
        diagnostics: &'r mut Diagnostics,
        reductions: Option<&'r mut Vec<Reduction>>,
    ) -> Checker<'r> {
        Checker { names, diagnostics, ops: Vec::new(), reductions }
    }

    /// The operations of the tree that was walked.
    pub(super) fn program(self) -> Program {
        Program { ops: self.ops }
    }

    /// Walks a tree; `None` after an error, which has been reported.
    pub(super) fn node(&mut self, node: &Node) -> Option<Typed> {
        match &node.kind {
            NodeKind::Number(value) => {
                let dimension = (*value != 0.0).then_some(Dimension::NONE);
                Some(self.constant(*value, dimension))
            }
            NodeKind::Quantity(value, dimension) => Some(self.constant(*value, Some(*dimension))),
            NodeKind::Name(name) => self.name(name, node.span),
            NodeKind::Negate(inner) => {
                let start = self.ops.len();
                let inner = self.node(inner)?;
                self.push(start, Op::Negate(inner.at), inner.dimension, &[inner], node)
            }
            NodeKind::Binary(operator, sides) => self.binary(*operator, sides, node),
            NodeKind::Call { name, name_span, arguments } => self.call(name, *name_span, arguments, node),
        }
    }

    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    fn constant(&mut self, value: f64, dimension: Option<Dimension>) -> Typed {
        self.ops.push(Op::Constant(value));
        Typed { at: self.last(), dimension, value: Some(value) }
    }

    fn last(&self) -> At {
        self.ops.len().saturating_sub(1) as At
    }

    /// Lays down an operation whose operands were laid down from `start` on. Constants are folded;
    /// a value that is not finite is reported where it arises.
    fn push(
        &mut self,
        start: usize,
        op: Op,
        dimension: Option<Dimension>,
        operands: &[Typed],
        node: &Node,
    ) -> Option<Typed> {
        let constant = self.ops.get(start..).is_some_and(|ops| {
            // Operands that are folded are one constant each.
            ops.len() == operands.len() && ops.iter().all(|o| matches!(o, Op::Constant(_)))
        });
        self.ops.push(op);
        let known: Option<Vec<f64>> = operands.iter().map(|o| o.value).collect();
        let value = known.map(|operands| apply(op, &operands));
        if let Some(value) = value.filter(|v| !v.is_finite() || v.abs() > HUGE) {
            let diagnostic = not_finite(op, operands, value, node);
            self.report(diagnostic);
            return None;
        }
        if let (true, Some(value)) = (constant, value) {
            self.ops.truncate(start);
            return Some(self.constant(value, dimension));
        }
        Some(Typed { at: self.last(), dimension, value })
    }

    fn name(&mut self, name: &str, span: Span) -> Option<Typed> {
        if name == "pi" {
            return Some(self.constant(std::f64::consts::PI, Some(Dimension::NONE)));
        }
        match self.names.resolve(name) {
            Known::Parameter { index, dimension, value, .. } => {
                self.ops.push(Op::Parameter(index as u32));
                Some(Typed { at: self.last(), dimension: Some(dimension), value: Some(value) })
            }
            Known::Signal { index, dimension } => self.signal(name, index, dimension, span),
            Known::Faulty => None,
            Known::Unknown => {
                let diagnostic = self.unknown(name, span);
                self.report(diagnostic);
                None
            }
        }
    }

    fn signal(&mut self, name: &str, index: usize, dimension: Dimension, span: Span) -> Option<Typed> {
        if self.reductions.is_some() {
            let message = format!("`{name}` is a curve; one number is needed here");
            let hint = format!("reduce it: `max({name})`, `range({name})`, `last({name})` ...");
            self.report(Diagnostic::error("not-one-number", span, message).hint(hint));
            return None;
        }
        self.ops.push(Op::Signal(index as u32));
        Some(Typed { at: self.last(), dimension: Some(dimension), value: None })
    }

    fn unknown(&self, name: &str, span: Span) -> Diagnostic {
        if self.diagnostics.is_full() {
            return Diagnostic::error("unknown-name", span, "unknown name");
        }
        if !self.names.has_signals() && (name == "time" || name.contains('.')) {
            let message = format!("`{name}` changes along a run and cannot be used here");
            return Diagnostic::error("unknown-name", span, message).hint("only parameters can be used here");
        }
        if let Some(kind) = reserved(name).filter(|kind| *kind == "a function") {
            return Diagnostic::error("unknown-name", span, format!("`{name}` is {kind}"))
                .hint(format!("write `{name}(...)`"));
        }
        let names = self.names.names();
        let error = Diagnostic::error("unknown-name", span, format!("unknown name `{name}`"));
        if let Some(whole) = names.iter().find(|n| n.strip_prefix(name).is_some_and(|rest| rest.starts_with('-'))) {
            return error.hint(format!("a part with `-` is quoted: `{}`", quoted(whole)));
        }
        let others = ["pi"].into_iter().chain(unit_names()).chain(function_names());
        let candidates = names.iter().map(String::as_str);
        // A parameter first: units are short, and near to everything short.
        error.did_you_mean(nearest(name, candidates).or_else(|| nearest(name, others)))
    }

    fn binary(&mut self, operator: Operator, sides: &[Node; 2], node: &Node) -> Option<Typed> {
        let start = self.ops.len();
        let [left, right] = sides;
        // Both sides are walked before giving up: each may have its own errors.
        let (a, b) = (self.node(left), self.node(right));
        let (a, b) = (a?, b?);
        let plain = |typed: Typed| typed.dimension.unwrap_or(Dimension::NONE);
        let too_high =
            || Diagnostic::error("dimension", node.span, "the powers of units in this are too high to be meant");
        let (op, dimension) = match operator {
            Operator::Add => (Op::Add(a.at, b.at), self.same(a, left, b, right, Relation::Adding)?),
            Operator::Subtract => (Op::Subtract(a.at, b.at), self.same(a, left, b, right, Relation::Subtracting)?),
            Operator::Multiply => (Op::Multiply(a.at, b.at), self.product(plain(a).times(plain(b)), too_high)?),
            Operator::Divide => (Op::Divide(a.at, b.at), self.product(plain(a).over(plain(b)), too_high)?),
            Operator::Power => self.power((a, left), (b, right))?,
        };
        self.push(start, op, dimension, &[a, b], node)
    }

    fn product(&mut self, dimension: Option<Dimension>, fault: impl Fn() -> Diagnostic) -> Option<Option<Dimension>> {
        if dimension.is_none() {
            self.report(fault());
        }
        dimension.map(Some)
    }

    /// The common dimension of two sides; the outer `None` after an error.
    pub(super) fn same(
        &mut self,
        a: Typed,
        left: &Node,
        b: Typed,
        right: &Node,
        relation: Relation,
    ) -> Option<Option<Dimension>> {
        let (Some(x), Some(y)) = (a.dimension, b.dimension) else {
            return Some(a.dimension.or(b.dimension));
        };
        if x.agrees(y) {
            return Some(Some(x.plainer(y)));
        }
        let message = relation.message(x, y);
        let mut error =
            Diagnostic::error("dimension", right.span, message).label(y.phrase()).also(left.span, x.phrase());
        error = self.definition(error, right);
        error = self.definition(error, left);
        if let Some(hint) = mismatch_hint(x, y) {
            error = error.hint(hint);
        }
        self.report(error);
        None
    }

    /// Adds where an operand that is a parameter is defined.
    pub(super) fn definition(&mut self, diagnostic: Diagnostic, operand: &Node) -> Diagnostic {
        let NodeKind::Name(name) = &operand.kind else { return diagnostic };
        match self.names.resolve(name) {
            Known::Parameter { dimension, defined, .. } => {
                diagnostic.also(defined, format!("`{name}` is {}, defined here", dimension.phrase()))
            }
            _ => diagnostic,
        }
    }

    fn power(&mut self, (a, base): (Typed, &Node), (b, exponent): (Typed, &Node)) -> Option<(Op, Option<Dimension>)> {
        let found = b.dimension.unwrap_or(Dimension::NONE);
        if !found.is_none() {
            let message = format!("an exponent is a plain number, found {}", found.phrase());
            let error = Diagnostic::error("dimension", exponent.span, message).label(found.phrase());
            let error = self.definition(error, exponent);
            self.report(error);
            return None;
        }
        let constant = match self.ops.get(b.at as usize) {
            Some(Op::Constant(value)) => Some(*value),
            _ => None,
        };
        let op = match constant.filter(|n| n.fract() == 0.0 && n.abs() <= 1000.0) {
            Some(whole) => Op::PowerWhole(a.at, whole as i32),
            None => Op::Power(a.at, b.at),
        };
        let Some(dimension) = a.dimension.filter(|d| !d.is_none()) else {
            return Some((op, Some(Dimension::NONE)));
        };
        match constant.map(|n| dimension.power(n)) {
            Some(Some(dimension)) => Some((op, Some(dimension))),
            Some(None) => {
                let message = format!("this power of {} has no dimension that could be meant", dimension.phrase());
                self.report(Diagnostic::error("dimension", exponent.span, message).also(base.span, dimension.phrase()));
                None
            }
            None => {
                let message = format!("the exponent of {} must be written as a number", dimension.phrase());
                self.report(Diagnostic::error("dimension", exponent.span, message).also(base.span, dimension.phrase()));
                None
            }
        }
    }

    fn call(&mut self, name: &str, name_span: Span, arguments: &[Node], node: &Node) -> Option<Typed> {
        let reduction = ReductionKind::named(name);
        if let (Some(kind), [curve, place @ ..]) = (reduction, arguments)
            && arguments.len() == kind.arguments()
        {
            return self.reduction(kind, name_span, curve, place.first(), node);
        }
        let Some(function) = Function::named(name) else {
            if let Some(kind) = reduction {
                self.report(wrong_count(name, &kind.arguments().to_string(), arguments, node));
                return None;
            }
            let error = Diagnostic::error("unknown-function", name_span, format!("unknown function `{name}`"));
            let error = match self.names.resolve(name) {
                Known::Unknown => error.did_you_mean(nearest(name, function_names())),
                _ => error.hint(format!("for a product write `{name}*(...)`")),
            };
            self.report(error);
            return None;
        };
        let (fewest, most) = function.arguments();
        if !(fewest..=most).contains(&arguments.len()) {
            let wanted = if most == usize::MAX { format!("{fewest} or more") } else { fewest.to_string() };
            self.report(wrong_count(name, &wanted, arguments, node));
            return None;
        }
        let start = self.ops.len();
        let typed: Vec<Option<Typed>> = arguments.iter().map(|a| self.node(a)).collect();
        let typed: Option<Vec<Typed>> = typed.into_iter().collect();
        self.apply_function(function, name, &typed?, arguments, node, start)
    }

    fn apply_function(
        &mut self,
        function: Function,
        name: &str,
        typed: &[Typed],
        arguments: &[Node],
        node: &Node,
        start: usize,
    ) -> Option<Typed> {
        if let ([a], [argument]) = (typed, arguments) {
            let dimension = self.one_dimension(function, name, *a, argument)?;
            return self.push(start, Op::One(function, a.at), dimension, typed, node);
        }
        let (first, rest) = typed.split_first()?;
        let mut result = *first;
        for (next, argument) in rest.iter().zip(arguments.iter().skip(1)) {
            let left = arguments.first()?;
            let common = self.same(result, left, *next, argument, Relation::Comparing)?;
            let dimension = if function == Function::Atan2 { Some(Dimension::ANGLE) } else { common };
            // Folding takes the operands away, so it waits for the last step.
            let from = if arguments.len() == 2 { start } else { usize::MAX };
            result = self.push(from, Op::Two(function, result.at, next.at), dimension, &[result, *next], node)?;
        }
        Some(result)
    }

    /// Dimension of a function of one value; the outer `None` after an error.
    fn one_dimension(
        &mut self,
        function: Function,
        name: &str,
        a: Typed,
        argument: &Node,
    ) -> Option<Option<Dimension>> {
        let found = a.dimension.unwrap_or(Dimension::NONE);
        let none = found.is_none();
        match function {
            Function::Sin | Function::Cos | Function::Tan if none || found == Dimension::ANGLE => {
                Some(Some(Dimension::NONE))
            }
            Function::Asin | Function::Acos | Function::Atan if none => Some(Some(Dimension::ANGLE)),
            Function::Sqrt => {
                let fault = || {
                    Diagnostic::error(
                        "dimension",
                        argument.span,
                        format!("no square root of {} can be meant", found.phrase()),
                    )
                };
                self.product(found.power(0.5), fault)
            }
            Function::Abs => Some(a.dimension),
            Function::Sign => Some(Some(Dimension::NONE)),
            _ => {
                let wanted = if matches!(function, Function::Sin | Function::Cos | Function::Tan) {
                    "an angle"
                } else {
                    "a plain number"
                };
                let message = format!("`{name}` takes {wanted}, found {}", found.phrase());
                let error = Diagnostic::error("dimension", argument.span, message).label(found.phrase());
                let error = self.definition(error, argument);
                self.report(error);
                None
            }
        }
    }

    fn reduction(
        &mut self,
        kind: ReductionKind,
        name_span: Span,
        curve: &Node,
        place: Option<&Node>,
        node: &Node,
    ) -> Option<Typed> {
        let Some(reductions) = self.reductions.as_deref_mut() else {
            let of = if kind == ReductionKind::At { "" } else { " of one value" };
            let message = format!("`{}`{of} reduces a curve to a number; that has no place here", kind.name());
            let error = Diagnostic::error("reduction", name_span, message);
            let hint = match kind {
                ReductionKind::Min | ReductionKind::Max => format!("of several values: `{}(a, b)`", kind.name()),
                _ => "reductions stand in responses, objectives and limits of studies".to_owned(),
            };
            self.report(error.hint(hint));
            return None;
        };
        // Both are walked before giving up: each may have its own errors.
        let curve = expression(curve, self.names, self.diagnostics);
        let place = place.map(|place| expression(place, &mut OnlyParameters(self.names), self.diagnostics));
        let (curve, place) = (curve?, if let Some(place) = place { Some(place?) } else { None });
        let dimension = curve.dimension();
        reductions.push(Reduction { kind, curve, place, span: node.span });
        let index = reductions.len() - 1;
        self.ops.push(Op::Signal(index as u32));
        Some(Typed { at: self.last(), dimension: Some(dimension), value: None })
    }
}

/// A part of a value, compiled on its own.
fn expression(node: &Node, names: &mut dyn Resolve, diagnostics: &mut Diagnostics) -> Option<Expression> {
    let mut checker = Checker::new(names, diagnostics, None);
    let typed = checker.node(node)?;
    let dimension = typed.dimension.unwrap_or(Dimension::NONE);
    let program = checker.program();
    Some(Expression { program, dimension, span: node.span, written: String::new() })
}

/// Names without the signals among them.
struct OnlyParameters<'r>(&'r mut dyn Resolve);

impl Resolve for OnlyParameters<'_> {
    fn resolve(&mut self, name: &str) -> Known {
        match self.0.resolve(name) {
            Known::Signal { .. } => Known::Unknown,
            known => known,
        }
    }

    fn names(&self) -> Vec<String> {
        self.0.names()
    }

    fn has_signals(&self) -> bool {
        false
    }
}

fn wrong_count(name: &str, wanted: &str, arguments: &[Node], node: &Node) -> Diagnostic {
    let plural = if wanted == "1" { "" } else { "s" };
    let message = format!("`{name}` takes {wanted} value{plural}, found {}", arguments.len());
    let error = Diagnostic::error("arguments", node.span, message);
    match name {
        "at" => error.hint("a curve and a place: `at(drive.slide.force, 15 deg)`"),
        _ => error,
    }
}

/// Why two sides must have one dimension.
#[derive(Clone, Copy)]
pub(super) enum Relation {
    Adding,
    Subtracting,
    Comparing,
}

impl Relation {
    fn message(self, left: Dimension, right: Dimension) -> String {
        let (left, right) = (left.phrase(), right.phrase());
        match self {
            Relation::Adding => format!("adding {right} to {left}"),
            Relation::Subtracting => format!("subtracting {right} from {left}"),
            Relation::Comparing => format!("comparing {left} with {right}"),
        }
    }
}

/// What to do about two dimensions that differ.
pub(super) fn mismatch_hint(a: Dimension, b: Dimension) -> Option<String> {
    let pair = |x, y| (a == x && b == y) || (a == y && b == x);
    if pair(Dimension::ANGULAR_VELOCITY, Dimension::FREQUENCY) {
        return Some("write turning speeds in rpm or rad/s (1 Hz is 60 rpm)".to_owned());
    }
    if pair(Dimension::ANGLE, Dimension::NONE) {
        return Some("an angle has a unit: `30 deg`, `0.5 rad`, `(pi/6) rad`".to_owned());
    }
    let other = if a.is_none() { b } else { a };
    let unitless = a.is_none() != b.is_none();
    unitless
        .then(|| format!("a number without a unit is a plain number; give it one, as `35 {}`", other.example_unit()))
}

fn apply(op: Op, operands: &[f64]) -> f64 {
    let at = |i: usize| operands.get(i).copied().unwrap_or(f64::NAN);
    let (a, b) = (Op::Constant(at(0)), Op::Constant(at(1)));
    let op = match op {
        Op::Negate(_) => Op::Negate(0),
        Op::Add(..) => Op::Add(0, 1),
        Op::Subtract(..) => Op::Subtract(0, 1),
        Op::Multiply(..) => Op::Multiply(0, 1),
        Op::Divide(..) => Op::Divide(0, 1),
        Op::PowerWhole(_, n) => Op::PowerWhole(0, n),
        Op::Power(..) => Op::Power(0, 1),
        Op::One(function, _) => Op::One(function, 0),
        Op::Two(function, ..) => Op::Two(function, 0, 1),
        leaf => leaf,
    };
    Program { ops: vec![a, b, op] }.eval(&[], &[])
}

/// The report of a value that is no number, with the reason where it is plain.
fn not_finite(op: Op, operands: &[Typed], value: f64, node: &Node) -> Diagnostic {
    let operand = |i: usize| operands.get(i).and_then(|o| o.value).unwrap_or(f64::NAN);
    let message = match op {
        Op::Divide(..) if operand(1) == 0.0 => "division by zero".to_owned(),
        Op::One(Function::Sqrt, _) => format!("the square root of a negative number ({})", operand(0)),
        Op::One(Function::Asin | Function::Acos, _) => {
            format!("the argument is {}; it must lie within -1 and 1", operand(0))
        }
        Op::Power(..) | Op::PowerWhole(..) => {
            format!("{} to the power {} is no finite number", operand(0), power_of(op, operand(1)))
        }
        _ if value.is_finite() => format!("this is {value:e}, too large to mean anything"),
        _ => format!("this is {value}, not a finite number"),
    };
    Diagnostic::error("not-finite", node.span, message)
}

fn power_of(op: Op, operand: f64) -> f64 {
    match op {
        Op::PowerWhole(_, n) => f64::from(n),
        _ => operand,
    }
}

/// A dotted name with quotes around the parts that need them.
fn quoted(name: &str) -> String {
    let parts = name.split('.').map(|part| if part.contains('-') { format!("'{part}'") } else { part.to_owned() });
    parts.collect::<Vec<_>>().join(".")
}
