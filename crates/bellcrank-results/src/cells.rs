//! Small tables of numbers and words for people with spreadsheets.

use std::io::{self, Write};

use crate::csv::{push_number, quoted};

/// One field of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Field {
    /// A number, in the unit that stands over its column; empty where it is not finite.
    Number(f64),
    /// Words.
    Text(String),
}

/// A table whose columns may hold words. Numbers are in display units, named in the heads.
#[derive(Clone, Debug, Default)]
pub struct TextTable {
    /// What stands over each column, as `value [mm]`.
    pub heads: Vec<String>,
    /// Rows of as many fields as there are heads.
    pub rows: Vec<Vec<Field>>,
}

impl From<f64> for Field {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<&str> for Field {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

/// Writes `table` as CSV, as [`write_csv`](crate::write_csv) does for columns of numbers.
///
/// # Errors
/// Whatever `out` reports.
pub fn write_text_csv(table: &TextTable, mut out: impl Write) -> io::Result<()> {
    let heads: Vec<String> = table.heads.iter().cloned().map(quoted).collect();
    let mut text = (heads.join(",") + "\n").into_bytes();
    for row in &table.rows {
        push_fields(&mut text, row);
    }
    out.write_all(&text)?;
    out.flush()
}

fn push_fields(text: &mut Vec<u8>, row: &[Field]) {
    for (index, field) in row.iter().enumerate() {
        if index > 0 {
            text.push(b',');
        }
        match field {
            Field::Number(value) => push_number(text, *value),
            Field::Text(words) => text.extend_from_slice(quoted(words.clone()).as_bytes()),
        }
    }
    text.push(b'\n');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_numbers_share_a_row() {
        let table = TextTable {
            heads: vec!["name".to_owned(), "length [mm]".to_owned()],
            rows: vec![vec!["a, \"b\"".into(), 1.5.into()], vec!["c".into(), f64::NAN.into()]],
        };
        let mut out = Vec::new();
        write_text_csv(&table, &mut out).unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), "name,length [mm]\n\"a, \"\"b\"\"\",1.5\nc,\n");
    }
}
