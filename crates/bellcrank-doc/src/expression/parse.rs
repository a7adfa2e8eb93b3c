//! From tokens to the tree.
//!
//! ```text
//! value   = sum [ "±" sum ] [ ("<" | "<=" | ">" | ">=" | "==") sum ]
//! sum     = product { ("+" | "-") product }
//! product = signed { ("*" | "/") signed }
//! signed  = ("-" | "+") signed | power
//! power   = atom [ "^" signed ]                     right to left; -x^2 is -(x^2)
//! atom    = number [ units ] | unit | name | name "(" sum { "," sum } ")" | "(" sum ")" [ units ]
//! units   = unit { ("*" | "/") unit }               unit = name [ "^" integer ], or "1/" unit
//! ```
//! A number and its units bind tighter than any operator: `l5/2 mm` is `l5/(2 mm)`. The product of
//! units goes on over `*` and `/` while a unit follows; no parameter can have a unit's name, so
//! `2 m*x` is the product of 2 m and `x`. A unit that stands alone is one of it: `1/s`, `5/mm`.
//! `±` (also `+/-`, and `+-` after an operand) sets the tolerance of a parameter: `732 mm ± 0.1 mm`. A
//! number without a unit before it takes the unit of the number after it: `732 ± 0.1 mm`. A
//! tolerance is a difference: there 1 degC is 1 K.
//! Parts of dotted names that hold `-` are quoted: `joint.'left-knee'.position`.

use std::ops::Range;

use super::ast::{Node, NodeKind, Operator, Parsed, Tolerance};
use super::function::Function;
use super::token::{Token, TokenKind, Written, tokens};
use crate::units::{self, Unit};
use crate::{Diagnostic, Dimension, Span};

/// Deepest nesting of parentheses, signs and powers.
const MAX_NESTING: usize = 64;
/// Highest tree; a chain of n sums is n high.
const MAX_DEPTH: usize = 256;

type Result<T> = std::result::Result<T, Diagnostic>;

/// Reads a whole value.
pub(crate) fn parse(written: Written<'_>) -> Result<Parsed> {
    value(Parser::new(tokens(written)?))
}

/// Reads a whole value that is a difference: 2 degC are 2 K.
pub(crate) fn parse_difference(written: Written<'_>) -> Result<Parsed> {
    value(Parser { differences: true, ..Parser::new(tokens(written)?) })
}

fn value(mut parser: Parser) -> Result<Parsed> {
    let mut left = parser.sum()?;
    let tolerance = parser.tolerance(&mut left)?;
    let right = match parser.peek() {
        TokenKind::Compare(comparison) => {
            let comparison = *comparison;
            let span = parser.advance();
            Some((comparison, span, parser.sum()?))
        }
        _ => None,
    };
    match parser.peek() {
        TokenKind::End => Ok(Parsed { left, tolerance, right }),
        _ => Err(parser.unexpected()),
    }
}

/// Reads a unit that stands alone (`kg*m^2`).
pub(crate) fn parse_unit(written: &str) -> std::result::Result<Unit, String> {
    let nowhere = Span::new(crate::Sources::new().add("", ""), 0, 0);
    let written = Written { text: written, span: nowhere, origin: None };
    let mut parser = match tokens(written) {
        Ok(tokens) => Parser::new(tokens),
        Err(fault) => return Err(fault.message),
    };
    let unit = parser.units().map_err(|fault| fault.message)?;
    match (unit, parser.peek()) {
        (Some(unit), TokenKind::End) => Ok(unit),
        _ => Err(format!("`{}` is not a unit", written.text)),
    }
}

/// A value that is a number with at most a unit, perhaps with a tolerance, as its text has it.
pub(crate) struct Plain {
    /// The unit, of the number or of both sides of `±`: its bytes.
    pub(crate) unit: Option<(Range<usize>, Unit)>,
}

/// What a value's text has of a plain number; `None` where it has more.
pub(crate) fn plain(text: &str) -> Option<Plain> {
    let nowhere = Span::new(crate::Sources::new().add("", ""), 0, 0);
    let mut parser = Parser::new(tokens(Written { text, span: nowhere, origin: None }).ok()?);
    let unit = parser.plain()?;
    let unit = match (unit, parser.peek()) {
        (unit, TokenKind::End) | (unit @ Some(_), TokenKind::PlusMinus(_)) => unit,
        (None, TokenKind::PlusMinus(_)) => {
            parser.advance();
            let unit = parser.plain()?;
            if *parser.peek() != TokenKind::End {
                return None;
            }
            unit
        }
        _ => return None,
    };
    Some(Plain { unit })
}

struct Parser {
    tokens: Vec<Token>,
    at: usize,
    nesting: usize,
    /// Whether units have no offset.
    differences: bool,
}

impl Parser {
    fn new(tokens: Vec<Token>) -> Parser {
        Parser { tokens, at: 0, nesting: 0, differences: false }
    }

    /// `±` and what follows it.
    fn tolerance(&mut self, nominal: &mut Node) -> Result<Option<Tolerance>> {
        let TokenKind::PlusMinus(sign) = *self.peek() else { return Ok(None) };
        let bytes = self.tokens.get(self.at).map_or(0..0, |token| token.bytes.clone());
        let span = self.advance();
        let half_width = match self.shared_unit(nominal)? {
            Some(half_width) => half_width,
            None => {
                let before = std::mem::replace(&mut self.differences, true);
                let half_width = self.sum()?;
                self.differences = before;
                half_width
            }
        };
        Ok(Some(Tolerance { sign, span, bytes, half_width }))
    }

    /// `0.1 mm` after `732 ±`: the unit is that of both.
    fn shared_unit(&mut self, nominal: &mut Node) -> Result<Option<Node>> {
        let (Some(value), TokenKind::Number(half_width)) = (nominal.literal(), self.peek().clone()) else {
            return Ok(None);
        };
        let before = self.at;
        let start = self.advance();
        let unit = self.units()?;
        let Some(unit) = unit.filter(|_| *self.peek() == TokenKind::End) else {
            self.at = before;
            return Ok(None);
        };
        let span = start.to(self.last());
        nominal.kind = NodeKind::Quantity(unit.to_si(value), unit.dimension);
        Ok(Some(Node::leaf(NodeKind::Quantity(difference(unit).to_si(half_width), unit.dimension), span)))
    }

    /// A number with a sign and a unit, if it has any; the unit. `None` when something else is there.
    fn plain(&mut self) -> Option<Option<(Range<usize>, Unit)>> {
        if matches!(self.peek(), TokenKind::Minus | TokenKind::Plus) {
            self.advance();
        }
        let TokenKind::Number(_) = self.peek() else { return None };
        self.advance();
        let start = self.at;
        let unit = self.units().ok()?;
        let bytes = |at: usize| self.tokens.get(at).map(|token| token.bytes.clone());
        Some(unit.and_then(|unit| Some((bytes(start)?.start..bytes(self.at.checked_sub(1)?)?.end, unit))))
    }

    fn peek(&self) -> &TokenKind {
        self.ahead(0)
    }

    fn ahead(&self, by: usize) -> &TokenKind {
        self.tokens.get(self.at + by).map_or(&TokenKind::End, |t| &t.kind)
    }

    fn here(&self) -> Span {
        let last = self.tokens.len() - 1;
        self.tokens[self.at.min(last)].span
    }

    fn advance(&mut self) -> Span {
        let span = self.here();
        self.at += 1;
        span
    }

    fn take(&mut self, kind: &TokenKind) -> Option<Span> {
        (self.peek() == kind).then(|| self.advance())
    }

    /// The unit that is the token `by` ahead; a name with a parenthesis is a function.
    fn unit_ahead(&self, by: usize) -> Option<Unit> {
        match (self.ahead(by), self.ahead(by + 1)) {
            (TokenKind::Name(name), TokenKind::Open) if Function::named(name).is_some() => None,
            (TokenKind::Name(name), _) => units::single(name),
            _ => None,
        }
    }

    fn sum(&mut self) -> Result<Node> {
        let mut left = self.product()?;
        loop {
            let operator = match self.peek() {
                TokenKind::Plus => Operator::Add,
                TokenKind::Minus => Operator::Subtract,
                _ => return Ok(left),
            };
            self.advance();
            let right = self.product()?;
            left = within_depth(Node::binary(operator, left, right))?;
        }
    }

    fn product(&mut self) -> Result<Node> {
        let mut left = self.signed()?;
        loop {
            let operator = match self.peek() {
                TokenKind::Star => Operator::Multiply,
                TokenKind::Slash => Operator::Divide,
                _ => return Ok(left),
            };
            self.advance();
            let right = self.signed()?;
            left = within_depth(Node::binary(operator, left, right))?;
        }
    }

    /// Every recursion passes here.
    fn signed(&mut self) -> Result<Node> {
        self.nesting += 1;
        if self.nesting > MAX_NESTING {
            return Err(too_deep(self.here()));
        }
        let node = match self.peek() {
            TokenKind::Minus => {
                let sign = self.advance();
                self.negated(sign)
            }
            TokenKind::Plus => {
                self.advance();
                self.signed()
            }
            _ => self.power(),
        };
        self.nesting -= 1;
        node
    }

    /// What follows a minus sign. The sign belongs to the number of a unit with an offset:
    /// -5 degC is 268.15 K.
    fn negated(&mut self, sign: Span) -> Result<Node> {
        if let (TokenKind::Number(value), Some(unit)) = (self.peek(), self.unit_ahead(1))
            && unit.offset != 0.0
        {
            return self.number(-*value);
        }
        let inner = self.signed()?;
        let (span, depth) = (sign.to(inner.span), inner.depth + 1);
        within_depth(Node { kind: NodeKind::Negate(Box::new(inner)), span, depth })
    }

    fn power(&mut self) -> Result<Node> {
        let base = self.atom()?;
        if self.take(&TokenKind::Caret).is_none() {
            return Ok(base);
        }
        let exponent = self.signed()?;
        within_depth(Node::binary(Operator::Power, base, exponent))
    }

    fn atom(&mut self) -> Result<Node> {
        match self.peek().clone() {
            TokenKind::Number(value) => self.number(value),
            TokenKind::Open => self.group(),
            TokenKind::Name(name) => match self.unit_ahead(0) {
                Some(_) => self.lone_unit(),
                None => self.name(name),
            },
            _ => Err(self.unexpected()),
        }
    }

    /// A number with its units, if it has any.
    fn number(&mut self, value: f64) -> Result<Node> {
        let span = self.advance();
        self.refuse_decimal_comma(span)?;
        let unit = self.units()?;
        let span = span.to(self.last());
        match unit {
            Some(unit) => {
                let unit = if self.differences { difference(unit) } else { unit };
                Ok(Node::leaf(NodeKind::Quantity(unit.to_si(value), unit.dimension), span))
            }
            None => {
                self.refuse_word(span)?;
                Ok(Node::leaf(NodeKind::Number(value), span))
            }
        }
    }

    /// Span of the token read last.
    fn last(&self) -> Span {
        self.tokens.get(self.at.saturating_sub(1)).map_or(self.here(), |t| t.span)
    }

    fn group(&mut self) -> Result<Node> {
        let open = self.advance();
        let mut node = self.sum()?;
        let Some(close) = self.take(&TokenKind::Close) else {
            return Err(self.unexpected().also(open, "this parenthesis is never closed"));
        };
        node.span = open.to(close);
        let start = self.here();
        let Some(unit) = self.units()? else { return Ok(node) };
        let span = start.to(self.last());
        if unit.offset != 0.0 {
            return Err(offset_misused(span));
        }
        let unit = Node::leaf(NodeKind::Quantity(unit.factor, unit.dimension), span);
        within_depth(Node::binary(Operator::Multiply, node, unit))
    }

    /// A unit without a number: one of it. Products are left to the operators, which agree.
    fn lone_unit(&mut self) -> Result<Node> {
        let start = self.here();
        let Some(unit) = self.unit_power()? else { return Err(self.unexpected()) };
        let span = start.to(self.last());
        if unit.offset != 0.0 {
            return Err(offset_misused(span));
        }
        Ok(Node::leaf(NodeKind::Quantity(unit.factor, unit.dimension), span))
    }

    fn name(&mut self, name: String) -> Result<Node> {
        let span = self.advance();
        if *self.peek() == TokenKind::Open && !name.contains('.') {
            return self.call(name, span);
        }
        self.refuse_word(span)?;
        Ok(Node::leaf(NodeKind::Name(name), span))
    }

    fn call(&mut self, name: String, name_span: Span) -> Result<Node> {
        let open = self.advance();
        let mut arguments = vec![self.sum()?];
        while self.take(&TokenKind::Comma).is_some() {
            arguments.push(self.sum()?);
        }
        let Some(close) = self.take(&TokenKind::Close) else {
            return Err(self.unexpected().also(open, "this parenthesis is never closed"));
        };
        let depth = arguments.iter().map(|a| a.depth).max().unwrap_or(0) + 1;
        let kind = NodeKind::Call { name, name_span, arguments };
        within_depth(Node { kind, span: name_span.to(close), depth })
    }

    /// The product of units that starts here; `None` when no unit does. An offset stays only when
    /// the unit is alone.
    fn units(&mut self) -> Result<Option<Unit>> {
        let Some(mut product) = self.first_unit()? else { return Ok(None) };
        loop {
            let divides = match self.peek() {
                TokenKind::Star => false,
                TokenKind::Slash => true,
                _ => return Ok(Some(product)),
            };
            let Some(next) = self.next_unit()? else { return Ok(Some(product)) };
            product = combined(product, next, divides).ok_or_else(|| too_high(self.last()))?;
        }
    }

    /// A unit, or `1/` and a unit.
    fn first_unit(&mut self) -> Result<Option<Unit>> {
        let inverse = *self.peek() == TokenKind::Number(1.0)
            && *self.ahead(1) == TokenKind::Slash
            && self.unit_ahead(2).is_some();
        if !inverse {
            return self.unit_power();
        }
        self.advance();
        let one = Unit { factor: 1.0, offset: 0.0, dimension: Dimension::NONE };
        let unit = self.next_unit()?;
        Ok(unit.and_then(|unit| combined(one, unit, true)))
    }

    /// After `*` or `/`: a unit, or a product of units in parentheses. Takes nothing when neither
    /// follows.
    fn next_unit(&mut self) -> Result<Option<Unit>> {
        if self.unit_ahead(1).is_some() {
            self.advance();
            return self.unit_power();
        }
        if *self.ahead(1) != TokenKind::Open || self.unit_ahead(2).is_none() {
            return Ok(None);
        }
        let before = self.at;
        self.at += 2;
        self.nesting += 1;
        if self.nesting > MAX_NESTING {
            return Err(too_deep(self.here()));
        }
        let unit = self.units()?;
        self.nesting -= 1;
        if self.take(&TokenKind::Close).is_some() {
            return Ok(unit);
        }
        // Units, but not only: `5 N/(m*x)` is arithmetic.
        self.at = before;
        Ok(None)
    }

    /// One unit with its exponent.
    fn unit_power(&mut self) -> Result<Option<Unit>> {
        let Some(unit) = self.unit_ahead(0) else { return Ok(None) };
        self.advance();
        if *self.peek() != TokenKind::Caret {
            return Ok(Some(unit));
        }
        let start = self.advance();
        let negative = self.take(&TokenKind::Minus).is_some();
        let TokenKind::Number(exponent) = *self.peek() else { return Err(self.exponent_wanted()) };
        self.advance();
        if *self.peek() == TokenKind::Caret {
            let error = Diagnostic::error("expression", start.to(self.here()), "a unit with two exponents");
            return Err(error.hint("set the number and its unit in parentheses: `(2 m^2)^2`"));
        }
        let exponent = if negative { -exponent } else { exponent };
        let raised = raised(unit, exponent).ok_or_else(|| too_high(start.to(self.last())))?;
        Ok(Some(raised))
    }

    fn exponent_wanted(&self) -> Diagnostic {
        Diagnostic::error("expression", self.here(), "the exponent of a unit is a whole number")
            .hint("set the number and its unit in parentheses: `(2 m)^n`")
    }

    /// After an operand: a word that should have been a unit or needs an operator.
    fn refuse_word(&self, operand: Span) -> Result<()> {
        let TokenKind::Name(word) = self.peek() else { return Ok(()) };
        let called = *self.ahead(1) == TokenKind::Open;
        let after_number =
            matches!(self.tokens.get(self.at.saturating_sub(1)).map(|t| &t.kind), Some(TokenKind::Number(_)));
        if after_number && !called && !word.contains('.') {
            let error = Diagnostic::error("unknown-unit", self.here(), format!("unknown unit `{word}`"));
            let hint = match units::suggestion(word) {
                Some(unit) => format!("did you mean `{unit}`?"),
                None => format!("for a product with a parameter write `*{word}`"),
            };
            return Err(error.hint(hint));
        }
        let error = Diagnostic::error("expression", self.here(), format!("an operator is missing before `{word}`"));
        let hint = match units::single(word) {
            Some(_) => format!("a unit follows a number or `)`; for a product write `* 1 {word}`"),
            None => format!("for a product write `*{word}`"),
        };
        Err(error.also(operand, "after this").hint(hint))
    }

    fn refuse_decimal_comma(&self, number: Span) -> Result<()> {
        let comma = *self.peek() == TokenKind::Comma;
        let digits =
            matches!(self.ahead(1), TokenKind::Number(_)) && !self.tokens.get(self.at + 1).is_some_and(|t| t.spaced);
        if comma && digits && self.nesting == 1 {
            let error = Diagnostic::error("expression", number.to(self.here()), "a number with a comma");
            return Err(error.hint("decimals are set off by a point: `3.5`"));
        }
        Ok(())
    }

    fn unexpected(&self) -> Diagnostic {
        if let TokenKind::Name(word) = self.peek() {
            let error = Diagnostic::error("expression", self.here(), format!("an operator is missing before `{word}`"));
            return error.hint(format!("for a product write `*{word}`"));
        }
        if let TokenKind::PlusMinus(sign) = self.peek() {
            return Tolerance::misplaced(sign, self.here());
        }
        let message = match self.peek() {
            TokenKind::End if self.tokens.len() == 1 => "the expression is empty",
            TokenKind::End => "the expression ends here; expected a number, a name or `(`",
            TokenKind::Close => "a `)` without its `(`, or after an operator",
            TokenKind::Compare(_) => "a second comparison",
            TokenKind::Comma => "a comma outside of a function's arguments",
            TokenKind::Number(_) | TokenKind::Open => "an operator is missing here",
            _ => "expected a number, a name or `(`",
        };
        let report = Diagnostic::error("expression", self.here(), message);
        match self.peek() {
            TokenKind::Compare(_) => report.hint("write two: `a <= b` and `b <= c`"),
            _ => report,
        }
    }
}

/// A unit of differences: 1 degC is 1 K.
fn difference(unit: Unit) -> Unit {
    Unit { offset: 0.0, ..unit }
}

fn combined(a: Unit, b: Unit, divides: bool) -> Option<Unit> {
    let (factor, dimension) = match divides {
        true => (a.factor / b.factor, a.dimension.over(b.dimension)?),
        false => (a.factor * b.factor, a.dimension.times(b.dimension)?),
    };
    Some(Unit { factor, offset: 0.0, dimension })
}

fn raised(unit: Unit, exponent: f64) -> Option<Unit> {
    let whole = exponent.fract() == 0.0 && exponent.abs() <= 100.0;
    let dimension = unit.dimension.power(exponent).filter(|_| whole)?;
    Some(Unit { factor: unit.factor.powi(exponent as i32), offset: 0.0, dimension })
}

fn too_high(span: Span) -> Diagnostic {
    Diagnostic::error("expression", span, "this power of a unit cannot be meant; exponents are whole and below 100")
}

fn offset_misused(span: Span) -> Diagnostic {
    Diagnostic::error("expression", span, "`degC` needs a number right before it")
        .hint("write `20 degC`, or `K` for a difference")
}

fn within_depth(node: Node) -> Result<Node> {
    if node.depth > MAX_DEPTH { Err(too_deep(node.span)) } else { Ok(node) }
}

fn too_deep(span: Span) -> Diagnostic {
    Diagnostic::error("expression-too-deep", span, "this expression is nested too deep")
        .hint("name parts of it as parameters")
}
