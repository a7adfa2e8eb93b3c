//! From written values to checked ones, by what they are for.

use super::ast::{Node, NodeKind, Parsed, Tolerance};
use super::check::{Checker, Known, Relation, Resolve, Typed, mismatch_hint};
use super::token::Written;
use super::{Comparison, Condition, Constraint, Expression, Reduction, Response, Scope, parse};
use crate::{Diagnostic, Diagnostics, Dimension};

/// Parameters that are looked through for a hint.
const HINTED: usize = 2000;

/// What a value is for.
#[derive(Clone, Copy)]
pub(crate) struct Purpose<'a> {
    /// Its name in messages, as "`length` of joint `B`".
    pub(crate) what: &'a str,
    /// The dimension it must have; `None` takes any.
    pub(crate) dimension: Option<Dimension>,
}

impl Resolve for Scope<'_> {
    fn resolve(&mut self, name: &str) -> Known {
        if let Some(index) = self.parameters.index(name) {
            return self.parameters.known(index);
        }
        match self.signals.lookup(name) {
            Some((index, dimension)) => Known::Signal { index, dimension },
            None if self.parameters.is_faulty(name) => Known::Faulty,
            None => Known::Unknown,
        }
    }

    fn names(&self) -> Vec<String> {
        let parameters = self.parameters.all().iter().take(HINTED).map(|p| p.name.clone());
        parameters.chain(self.signals.names()).collect()
    }

    fn has_signals(&self) -> bool {
        !self.signals.names().is_empty()
    }
}

/// One value, parsed before.
pub(crate) fn parsed(
    tree: &Parsed,
    text: &str,
    purpose: Purpose<'_>,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
) -> Option<Expression> {
    refuse_tolerance(tree, diagnostics)?;
    let node = single(tree, purpose.what, diagnostics)?;
    side(node, text, purpose, names, diagnostics, None)
}

/// A value that may have a tolerance, without it.
pub(crate) fn nominal(
    tree: &Parsed,
    text: &str,
    purpose: Purpose<'_>,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
) -> Option<Expression> {
    let node = single(tree, purpose.what, diagnostics)?;
    let end = tree.tolerance.as_ref().map_or(text.len(), |tolerance| tolerance.bytes.start);
    let text = if tree.tolerance.is_some() { text.get(..end).unwrap_or(text).trim() } else { text };
    side(node, text, purpose, names, diagnostics, None)
}

/// What follows the `±` of a value.
pub(crate) fn half_width(
    tolerance: &Tolerance,
    text: &str,
    purpose: Purpose<'_>,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
) -> Option<Expression> {
    let text = text.get(tolerance.bytes.end..).unwrap_or(text).trim();
    side(&tolerance.half_width, text, purpose, names, diagnostics, None)
}

/// One number of a run.
pub(crate) fn response(
    written: Written<'_>,
    what: &str,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
) -> Option<Response> {
    let tree = tree(written, diagnostics)?;
    let node = single(&tree, what, diagnostics)?;
    let mut reductions = Vec::new();
    let purpose = Purpose { what, dimension: None };
    let value = side(node, written.text, purpose, names, diagnostics, Some(&mut reductions))?;
    Some(Response { value, reductions })
}

/// A comparison at one instant.
pub(crate) fn condition(
    written: Written<'_>,
    what: &str,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
) -> Option<Condition> {
    let tree = tree(written, diagnostics)?;
    let (left, comparison, right) = compared(&tree, written, what, names, diagnostics, None)?;
    Some(Condition { left, comparison, right })
}

/// A comparison of numbers of a run.
pub(crate) fn constraint(
    written: Written<'_>,
    what: &str,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
) -> Option<Constraint> {
    let tree = tree(written, diagnostics)?;
    let mut reductions = Vec::new();
    let sides = compared(&tree, written, what, names, diagnostics, Some(&mut reductions))?;
    let (left, comparison, right) = sides;
    Some(Constraint { left, comparison, right, reductions })
}

fn tree(written: Written<'_>, diagnostics: &mut Diagnostics) -> Option<Parsed> {
    let tree = parse(written).map_err(|fault| diagnostics.push(fault)).ok()?;
    refuse_tolerance(&tree, diagnostics)?;
    Some(tree)
}

fn refuse_tolerance(tree: &Parsed, diagnostics: &mut Diagnostics) -> Option<()> {
    let Some(Tolerance { sign, span, .. }) = &tree.tolerance else { return Some(()) };
    diagnostics.push(Tolerance::misplaced(sign, *span));
    None
}

/// The value of a text that compares nothing.
fn single<'t>(tree: &'t Parsed, what: &str, diagnostics: &mut Diagnostics) -> Option<&'t Node> {
    let Some((_, span, _)) = &tree.right else { return Some(&tree.left) };
    let message = format!("{what} is a value, found a comparison");
    diagnostics.push(Diagnostic::error("expression", *span, message));
    None
}

/// Checks and compiles one tree.
fn side(
    node: &Node,
    text: &str,
    purpose: Purpose<'_>,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
    reductions: Option<&mut Vec<Reduction>>,
) -> Option<Expression> {
    let mut checker = Checker::new(names, diagnostics, reductions);
    let typed = checker.node(node)?;
    let dimension = wanted(&mut checker, typed, node, purpose)?;
    let program = checker.program();
    Some(Expression { program, dimension, span: node.span, written: text.to_owned() })
}

/// The dimension that a value is read as; `None` after an error.
fn wanted(checker: &mut Checker<'_>, typed: Typed, node: &Node, purpose: Purpose<'_>) -> Option<Dimension> {
    let Some(wanted) = purpose.dimension else {
        return Some(typed.dimension.unwrap_or(Dimension::NONE));
    };
    let Some(found) = typed.dimension.filter(|found| !found.agrees(wanted)) else {
        return Some(wanted);
    };
    let message = format!("{} needs {}, found {}", purpose.what, wanted.phrase(), found.phrase());
    let error = Diagnostic::error("dimension", node.span, message).label(found.phrase());
    let error = checker.definition(error, node);
    checker.report(match wanted_hint(node, found, wanted) {
        Some(hint) => error.hint(hint),
        None => error,
    });
    None
}

fn wanted_hint(node: &Node, found: Dimension, wanted: Dimension) -> Option<String> {
    match &node.kind {
        NodeKind::Number(value) => Some(format!("write `\"{value} {}\"`", wanted.example_unit())),
        NodeKind::Negate(inner) => match &inner.kind {
            NodeKind::Number(value) => Some(format!("write `\"-{value} {}\"`", wanted.example_unit())),
            _ => mismatch_hint(found, wanted),
        },
        _ if wanted == Dimension::FREQUENCY && found == Dimension::ANGULAR_VELOCITY => {
            Some("a count in a time is written in Hz, or as `10 1/min`".to_owned())
        }
        _ => mismatch_hint(found, wanted),
    }
}

/// Both sides of a comparison, of one dimension.
fn compared(
    tree: &Parsed,
    written: Written<'_>,
    what: &str,
    names: &mut dyn Resolve,
    diagnostics: &mut Diagnostics,
    mut reductions: Option<&mut Vec<Reduction>>,
) -> Option<(Expression, Comparison, Expression)> {
    let Some((comparison, _, right)) = &tree.right else {
        let message = format!("{what} is a comparison, found a value");
        let error = Diagnostic::error("expression", tree.left.span, message);
        diagnostics.push(error.hint(format!("compare it: `{} <= ...`", written.text.trim())));
        return None;
    };
    let mut left_checker = Checker::new(names, diagnostics, reductions.as_deref_mut());
    let left_typed = left_checker.node(&tree.left);
    let left_program = left_checker.program();
    let mut checker = Checker::new(names, diagnostics, reductions);
    let right_typed = checker.node(right);
    let (left_typed, right_typed) = (left_typed?, right_typed?);
    let common = checker.same(left_typed, &tree.left, right_typed, right, Relation::Comparing)?;
    let dimension = common.unwrap_or(Dimension::NONE);
    let expression =
        |program, node: &Node| Expression { program, dimension, span: node.span, written: written.text.to_owned() };
    let right_program = checker.program();
    Some((expression(left_program, &tree.left), *comparison, expression(right_program, right)))
}
