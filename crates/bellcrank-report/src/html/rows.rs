//! Tables, one row at a time.

use bellcrank_results::Unit;

use super::{Escaped, sentence};
use crate::number;

/// The side a column is pushed to: words left, numbers right.
#[derive(Clone, Copy)]
pub(crate) enum Side {
    Left,
    Right,
}

use Side::{Left, Right};

/// A table under construction; its cells are HTML already.
pub(crate) struct Rows {
    heads: Vec<(String, Side)>,
    body: String,
}

impl Rows {
    /// Columns with their heads; heads that begin with a blank hold numbers.
    ///
    /// `["Name", " Value"]` is a column of words and one of numbers.
    pub(crate) fn new<S: AsRef<str>>(heads: &[S]) -> Self {
        let head = |text: &S| match text.as_ref().strip_prefix(' ') {
            Some(rest) => (rest.to_owned(), Right),
            None => (text.as_ref().to_owned(), Left),
        };
        Self { heads: heads.iter().map(head).collect(), body: String::new() }
    }

    /// The first cell heads its row.
    pub(crate) fn push(&mut self, cells: &[String]) {
        self.push_marked("", cells);
    }

    /// With a class on the row.
    pub(crate) fn push_marked(&mut self, class: &str, cells: &[String]) {
        let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
        self.body.push_str(&format!("<tr{class}>"));
        for (index, (cell, (_, side))) in cells.iter().zip(&self.heads).enumerate() {
            let number = if matches!(side, Right) { " class=\"n\"" } else { "" };
            match index {
                0 => self.body.push_str(&format!("<th scope=\"row\"{number}>{cell}</th>")),
                _ => self.body.push_str(&format!("<td{number}>{cell}</td>")),
            }
        }
        self.body.push_str("</tr>\n");
    }

    /// Nothing without rows.
    pub(crate) fn html(&self) -> String {
        if self.body.is_empty() {
            return String::new();
        }
        let head = |(text, side): &(String, Side)| {
            let number = if matches!(side, Right) { " class=\"n\"" } else { "" };
            format!("<th scope=\"col\"{number}>{}</th>", Escaped(text))
        };
        let heads: String = self.heads.iter().map(head).collect();
        format!(
            "<div class=\"scroll\"><table>\n<thead><tr>{heads}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
            self.body
        )
    }
}

/// A number of SI in its unit, without the unit.
pub(crate) fn number(si: f64, unit: &Unit) -> String {
    number::typeset(&number::alone(unit.show(si)))
}

/// A pure number with so many digits.
pub(crate) fn digits(value: f64, digits: usize) -> String {
    number::typeset(&number::significant(value, digits))
}

/// A unit as a cell.
pub(crate) fn symbol(unit: &Unit) -> String {
    Escaped(&number::unit(&unit.symbol)).to_string()
}

/// A name or an expression as a cell.
pub(crate) fn code(text: &str) -> String {
    format!("<code>{}</code>", Escaped(text))
}

/// Words of the program as a cell or a paragraph: names in backticks, true minus signs.
pub(crate) fn words(text: &str) -> String {
    sentence(&kept_together(&number::typeset_places(text)))
}

/// A number and its unit stay on one line: no plain blank between a digit and a short word or sign.
fn kept_together(text: &str) -> String {
    let kept = |part: &str| {
        let words: Vec<&str> = part.split(' ').collect();
        let mut joined = String::with_capacity(part.len());
        for (index, word) in words.iter().enumerate() {
            if index > 0 {
                let number = words[index - 1].ends_with(|c: char| c.is_ascii_digit() || c == '±');
                let unit =
                    word.chars().count() <= 5 && word.starts_with(|c: char| c.is_alphabetic() || c == '%' || c == '±');
                joined.push(if number && unit { '\u{a0}' } else { ' ' });
            }
            joined.push_str(word);
        }
        joined
    };
    // Between backticks stands what is to be copied as it is.
    let parts = text.split('`').enumerate();
    parts.map(|(index, part)| if index % 2 == 0 { kept(part) } else { part.to_owned() }).collect::<Vec<_>>().join("`")
}

#[cfg(test)]
mod tests {
    use super::words;

    #[test]
    fn units_do_not_leave_their_numbers() {
        assert_eq!(words("1 % more `x 1 a` is -2 N less"), "1\u{a0}% more <code>x 1 a</code> is −2\u{a0}N less");
    }
}
