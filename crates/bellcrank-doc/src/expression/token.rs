//! From written text to tokens.

use std::ops::Range;

use super::Comparison;
use crate::{Diagnostic, Span, Text, units};

/// Longest expression text, in bytes.
const MAX_TEXT: usize = 10_000;

/// Text of an expression and how it lies in its source.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Written<'t> {
    pub(crate) text: &'t str,
    /// Place of the whole value.
    pub(crate) span: Span,
    /// Byte of the source where the text starts, if it stands there as it is.
    pub(crate) origin: Option<usize>,
}

impl<'t> Written<'t> {
    pub(crate) fn of(text: &'t Text, span: Span) -> Written<'t> {
        Written { text: &text.value, span, origin: text.origin }
    }

    /// Place in the source of bytes of the text; the whole value where escapes blur it.
    pub(super) fn place(&self, start: usize, end: usize) -> Span {
        match self.origin {
            Some(origin) => Span::new(self.span.source, origin + start, origin + end),
            None => self.span,
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum TokenKind {
    Number(f64),
    /// A dotted name, quotes of its parts removed.
    Name(String),
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Open,
    Close,
    Comma,
    Compare(Comparison),
    /// `±`, as it was written.
    PlusMinus(&'static str),
    End,
}

#[derive(Clone, Debug)]
pub(super) struct Token {
    pub(super) kind: TokenKind,
    pub(super) span: Span,
    /// Bytes of the text.
    pub(super) bytes: Range<usize>,
    /// Whether blanks stand before it.
    pub(super) spaced: bool,
}

/// All tokens, the last one [`TokenKind::End`].
pub(super) fn tokens(written: Written<'_>) -> Result<Vec<Token>, Diagnostic> {
    if written.text.len() > MAX_TEXT {
        let message = format!("an expression of {} characters; at most {MAX_TEXT} are read", written.text.len());
        return Err(Diagnostic::error("expression-too-long", written.span, message));
    }
    let mut lexer = Lexer { written, at: 0, after_operand: false };
    let mut tokens = Vec::new();
    loop {
        let token = lexer.next()?;
        let done = token.kind == TokenKind::End;
        lexer.after_operand = matches!(token.kind, TokenKind::Number(_) | TokenKind::Name(_) | TokenKind::Close);
        tokens.push(token);
        if done {
            return Ok(tokens);
        }
    }
}

struct Lexer<'t> {
    written: Written<'t>,
    /// Byte of the text that is next.
    at: usize,
    /// Whether an operand ends there.
    after_operand: bool,
}

impl<'t> Lexer<'t> {
    fn rest(&self) -> &'t str {
        self.written.text.get(self.at..).unwrap_or("")
    }

    fn next(&mut self) -> Result<Token, Diagnostic> {
        let before = self.at;
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start().len();
        let start = self.at;
        let kind = self.kind()?;
        let (span, bytes) = (self.written.place(start, self.at), start..self.at);
        Ok(Token { kind, span, bytes, spaced: start > before })
    }

    fn kind(&mut self) -> Result<TokenKind, Diagnostic> {
        let rest = self.rest();
        let Some(first) = rest.chars().next() else { return Ok(TokenKind::End) };
        let second = rest.chars().nth(1);
        if first.is_ascii_digit() || (first == '.' && second.is_some_and(|c| c.is_ascii_digit())) {
            return self.number();
        }
        if first.is_ascii_alphabetic() || first == '_' {
            return self.name();
        }
        if let Some(sign) = self.plus_minus() {
            self.at += sign.len();
            return Ok(TokenKind::PlusMinus(sign));
        }
        let (kind, length) = match (first, second) {
            ('<', Some('=')) => (TokenKind::Compare(Comparison::LessOrEqual), 2),
            ('>', Some('=')) => (TokenKind::Compare(Comparison::GreaterOrEqual), 2),
            ('=', Some('=')) => (TokenKind::Compare(Comparison::Equal), 2),
            ('<', _) => (TokenKind::Compare(Comparison::Less), 1),
            ('>', _) => (TokenKind::Compare(Comparison::Greater), 1),
            ('*', Some('*')) => return Err(self.fault(2, "`**` is not an operator").hint("a power is written `^`")),
            ('+', _) => (TokenKind::Plus, 1),
            ('-', _) => (TokenKind::Minus, 1),
            ('*', _) => (TokenKind::Star, 1),
            ('/', _) => (TokenKind::Slash, 1),
            ('^', _) => (TokenKind::Caret, 1),
            ('(', _) => (TokenKind::Open, 1),
            (')', _) => (TokenKind::Close, 1),
            (',', _) => (TokenKind::Comma, 1),
            _ => return Err(self.unexpected(first)),
        };
        self.at += length;
        Ok(kind)
    }

    /// `+-` is one sign only where two signs would be odd: after an operand, without a blank between.
    fn plus_minus(&self) -> Option<&'static str> {
        let signs = if self.after_operand { &["±", "+/-", "+-"][..] } else { &["±", "+/-"] };
        signs.iter().copied().find(|sign| self.rest().starts_with(sign))
    }

    /// `12`, `.5`, `1.5e-3`. An `e` without digits starts a name.
    fn number(&mut self) -> Result<TokenKind, Diagnostic> {
        let rest = self.rest();
        let bytes = rest.as_bytes();
        let digits = |from: usize| bytes.iter().skip(from).take_while(|b| b.is_ascii_digit()).count();
        let mut length = digits(0);
        if bytes.get(length) == Some(&b'.') {
            length += 1 + digits(length + 1);
        }
        if matches!(bytes.get(length), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(length + 1), Some(b'+' | b'-')));
            let exponent = digits(length + 1 + sign);
            if exponent > 0 {
                length += 1 + sign + exponent;
            }
        }
        let value: f64 = rest.get(..length).and_then(|t| t.parse().ok()).unwrap_or(f64::NAN);
        if !value.is_finite() || value.abs() > super::HUGE {
            return Err(self.fault(length, "this number is too large to mean anything"));
        }
        self.at += length;
        Ok(TokenKind::Number(value))
    }

    /// `a`, `joint.B.position`, `joint.'left-knee'.position`.
    fn name(&mut self) -> Result<TokenKind, Diagnostic> {
        let mut name = self.word().to_owned();
        while let Some(after) = self.rest().strip_prefix('.') {
            let quote = after.chars().next();
            let part = match quote {
                Some(quote @ ('\'' | '"')) => self.quoted(quote)?,
                Some(c) if c.is_ascii_alphanumeric() || c == '_' => {
                    self.at += 1;
                    self.word()
                }
                _ => return Err(self.fault(1, format!("`{name}.` needs a name after its dot"))),
            };
            name.push('.');
            name.push_str(part);
        }
        Ok(TokenKind::Name(name))
    }

    fn word(&mut self) -> &'t str {
        let rest = self.rest();
        let end = rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(rest.len());
        self.at += end;
        rest.get(..end).unwrap_or("")
    }

    /// `.'left-knee'`, from its dot on.
    fn quoted(&mut self, quote: char) -> Result<&'t str, Diagnostic> {
        let inside = self.rest().get(2..).unwrap_or("");
        let Some(end) = inside.find(quote) else {
            return Err(self.fault(2, "this quote is never closed"));
        };
        self.at += 2 + end + 1;
        Ok(inside.get(..end).unwrap_or(""))
    }

    fn unexpected(&self, c: char) -> Diagnostic {
        let error = self.fault(c.len_utf8(), format!("`{c}` has no meaning in an expression"));
        let hint = match c {
            '·' | '×' => Some("a product is written `*`".to_owned()),
            '−' | '–' => Some("a minus is written `-`".to_owned()),
            '²' => Some("a square is written `^2`".to_owned()),
            '³' => Some("a cube is written `^3`".to_owned()),
            'π' => Some("write `pi`".to_owned()),
            '%' => Some("a part is a plain number: `1 %` of `l1` is `0.01*l1`".to_owned()),
            '=' => Some("a comparison is written `==`, `<=` or `>=`".to_owned()),
            _ => units::suggestion(
                &self.rest().chars().take_while(|c| c.is_alphanumeric() || !c.is_ascii()).collect::<String>(),
            )
            .map(|unit| format!("write `{unit}`")),
        };
        match hint {
            Some(hint) => error.hint(hint),
            None => error,
        }
    }

    fn fault(&self, length: usize, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error("expression", self.written.place(self.at, self.at + length), message)
    }
}
