//! Where to take up reading after a bracket or brace that is never closed.
//!
//! Lists and inline tables may span lines, so a forgotten `}` would swallow the rest of the file
//! and every line of it would be in error. Two kinds of line show that one was forgotten: a header
//! (`[bodies.link1]`), and `key =` right below the line that opened a brace and put entries after
//! it without a comma at its end.

use std::ops::Range;

use toml_parser::lexer::{Token, TokenKind};

/// Pieces of the tokens to be parsed one after the other; one piece where nothing was forgotten.
pub(super) fn pieces(text: &str, tokens: &[Token]) -> Vec<Range<usize>> {
    let mut scan = Scan { text, tokens, open: Vec::new(), line: 0 };
    let mut pieces = Vec::new();
    let mut start = 0;
    for at in 0..tokens.len() {
        if scan.cuts_at(at) {
            pieces.push(start..at);
            start = at;
        }
        scan.pass(at);
    }
    pieces.push(start..tokens.len());
    pieces
}

struct Scan<'t> {
    text: &'t str,
    tokens: &'t [Token],
    /// Brackets and braces that are open, with their lines.
    open: Vec<(TokenKind, usize)>,
    line: usize,
}

impl Scan<'_> {
    fn kind(&self, at: usize) -> TokenKind {
        self.tokens.get(at).map_or(TokenKind::Eof, Token::kind)
    }

    /// Whether reading must start anew before this token.
    fn cuts_at(&mut self, at: usize) -> bool {
        let Some(&(opener, opened_on)) = self.open.last() else { return false };
        let starts_line = at > 0 && self.kind(at - 1) == TokenKind::Newline;
        if !starts_line {
            return false;
        }
        let first = self.skip_spaces(at);
        let brace_above = opener == TokenKind::LeftCurlyBracket && opened_on + 1 == self.line;
        let cut = self.is_header(first) || (brace_above && self.is_assignment(first) && self.entry_ends_before(at));
        if cut {
            self.open.clear();
        }
        cut
    }

    fn pass(&mut self, at: usize) {
        match self.kind(at) {
            TokenKind::Newline => self.line += 1,
            kind @ (TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket) => self.open.push((kind, self.line)),
            TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => {
                self.open.pop();
            }
            // A string over several lines.
            TokenKind::MlBasicString | TokenKind::MlLiteralString => {
                let span = self.tokens[at].span();
                let inside = self.text.get(span.start()..span.end()).unwrap_or("");
                self.line += inside.matches('\n').count();
            }
            _ => {}
        }
    }

    fn skip_spaces(&self, mut at: usize) -> usize {
        while self.kind(at) == TokenKind::Whitespace {
            at += 1;
        }
        at
    }

    /// `[name`, where the name is no value.
    fn is_header(&self, mut at: usize) -> bool {
        if self.kind(at) != TokenKind::LeftSquareBracket {
            return false;
        }
        while self.kind(at) == TokenKind::LeftSquareBracket {
            at += 1;
        }
        let name = self.skip_spaces(at);
        let word = self.tokens.get(name).map(Token::span).and_then(|s| self.text.get(s.start()..s.end())).unwrap_or("");
        self.kind(name) == TokenKind::Atom
            && word.starts_with(|c: char| c.is_ascii_alphabetic())
            && !["true", "false", "inf", "nan"].contains(&word)
            && matches!(self.kind(self.skip_spaces(name + 1)), TokenKind::RightSquareBracket | TokenKind::Dot)
    }

    /// `key =`
    fn is_assignment(&self, at: usize) -> bool {
        self.kind(at) == TokenKind::Atom && self.kind(self.skip_spaces(at + 1)) == TokenKind::Equals
    }

    /// Whether the line that ends before this token ends an entry: neither with a comma nor with
    /// what opens a brace.
    fn entry_ends_before(&self, at: usize) -> bool {
        let blank = |kind| matches!(kind, TokenKind::Newline | TokenKind::Whitespace | TokenKind::Comment);
        let last = (0..at).rev().map(|i| self.kind(i)).find(|&kind| !blank(kind));
        last.is_some_and(|kind| !matches!(kind, TokenKind::Comma | TokenKind::LeftCurlyBracket))
    }
}
