//! Words of a text with their places.

use super::super::FileFault;
use super::Stop;

/// A word and where it begins: line and column, from 1.
pub(super) struct Word<'a> {
    pub(super) text: &'a [u8],
    pub(super) at: (usize, usize),
}

impl Word<'_> {
    fn wrong(&self, expected: &'static str) -> Stop {
        let found = String::from_utf8_lossy(&self.text[..self.text.len().min(40)]).into_owned();
        (self.at, FileFault::Expected { expected, found })
    }

    fn parse<T: std::str::FromStr>(&self) -> Option<T> {
        std::str::from_utf8(self.text).ok()?.parse().ok()
    }
}

pub(super) struct Tokens<'a> {
    bytes: &'a [u8],
    next: usize,
    line: usize,
    line_start: usize,
}

impl<'a> Tokens<'a> {
    pub(super) fn of(bytes: &'a [u8]) -> Tokens<'a> {
        Tokens { bytes, next: 0, line: 1, line_start: 0 }
    }

    pub(super) fn place(&self) -> (usize, usize) {
        (self.line, self.next - self.line_start + 1)
    }

    fn skip_space(&mut self) {
        while let Some(byte) = self.bytes.get(self.next).filter(|byte| byte.is_ascii_whitespace()) {
            self.next += 1;
            if *byte == b'\n' {
                self.line += 1;
                self.line_start = self.next;
            }
        }
    }

    pub(super) fn word(&mut self) -> Option<Word<'a>> {
        self.skip_space();
        let (start, at) = (self.next, self.place());
        while self.bytes.get(self.next).is_some_and(|byte| !byte.is_ascii_whitespace()) {
            self.next += 1;
        }
        (self.next > start).then(|| Word { text: &self.bytes[start..self.next], at })
    }

    pub(super) fn take(&mut self, expected: &'static str) -> Result<Word<'a>, Stop> {
        self.word().ok_or_else(|| (self.place(), FileFault::EndsEarly { within: expected }))
    }

    pub(super) fn integer(&mut self, expected: &'static str) -> Result<(i64, (usize, usize)), Stop> {
        let word = self.take(expected)?;
        word.parse().map(|value| (value, word.at)).ok_or_else(|| word.wrong(expected))
    }

    /// A number that counts or labels something.
    pub(super) fn natural(&mut self, expected: &'static str) -> Result<u64, Stop> {
        let word = self.take(expected)?;
        word.parse().ok_or_else(|| word.wrong(expected))
    }

    pub(super) fn real(&mut self, expected: &'static str) -> Result<f64, Stop> {
        let word = self.take(expected)?;
        word.parse().filter(|value: &f64| value.is_finite()).ok_or_else(|| word.wrong(expected))
    }

    /// A word that has to stand here.
    pub(super) fn expect(&mut self, what: &str) -> Result<(), Stop> {
        let word = self.take("a section")?;
        if word.text == what.as_bytes() {
            return Ok(());
        }
        let expected = if what.starts_with("$End") { "the end of the section" } else { "`$MeshFormat`" };
        Err(word.wrong(expected))
    }

    /// The rest of the line, for names with spaces; between quotation marks if there are any.
    pub(super) fn name(&mut self) -> String {
        let rest = &self.bytes[self.next..];
        let end = rest.iter().position(|&byte| byte == b'\n').unwrap_or(rest.len());
        self.next += end;
        String::from_utf8_lossy(&rest[..end]).trim().trim_matches('"').to_owned()
    }

    pub(super) fn skip_to(&mut self, what: &str) -> Result<(), Stop> {
        while let Some(word) = self.word() {
            if word.text == what.as_bytes() {
                return Ok(());
            }
        }
        Err((self.place(), FileFault::EndsEarly { within: "a section" }))
    }
}
