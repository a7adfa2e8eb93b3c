//! One column of one row group as a page: which rows have a value, then the values.

use super::thrift::{Struct, push_varint};

const DATA_PAGE: i32 = 0;
const PLAIN: i32 = 0;
const RLE: i32 = 3;

/// A page under construction.
pub(super) struct Chunk {
    /// Rows, those without a value among them.
    pub(super) rows: u64,
    /// Which rows have a value; empty where all have one by definition.
    pub(super) levels: Vec<u8>,
    /// The values that there are.
    pub(super) values: Vec<u8>,
    pub(super) statistics: Statistics,
}

/// A page that was written.
pub(super) struct Chunks {
    pub(super) start: u64,
    pub(super) bytes: u64,
    pub(super) rows: u64,
    pub(super) statistics: Statistics,
}

/// What lets a reader skip a group.
#[derive(Clone, Default)]
pub(super) struct Statistics {
    pub(super) nulls: u64,
    /// Smallest and largest value as bytes.
    pub(super) span: Option<([u8; 8], [u8; 8])>,
}

impl Chunk {
    pub(super) fn page_header(&self) -> Vec<u8> {
        let bytes = (self.levels.len() + self.values.len()) as i32;
        let data = Struct::default().i32(1, self.rows as i32).i32(2, PLAIN).i32(3, RLE).i32(4, RLE);
        Struct::default().i32(1, DATA_PAGE).i32(2, bytes).i32(3, bytes).structure(5, data).finish()
    }
}

/// Whole numbers that every row has.
pub(super) fn counts(values: &[f64]) -> Chunk {
    let whole = || values.iter().map(|value| *value as i64);
    let span = whole().min().zip(whole().max()).map(|(low, high)| (low.to_le_bytes(), high.to_le_bytes()));
    Chunk {
        rows: values.len() as u64,
        levels: Vec::new(),
        values: whole().flat_map(i64::to_le_bytes).collect(),
        statistics: Statistics { nulls: 0, span },
    }
}

/// Numbers, null where they are not finite.
pub(super) fn numbers(values: &[f64]) -> Chunk {
    let finite = || values.iter().copied().filter(|value| value.is_finite());
    let (low, high) = finite().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    // A zero may be of either sign: the format wants the wider one.
    let (low, high) = (if low == 0.0 { -0.0 } else { low }, if high == 0.0 { 0.0 } else { high });
    let span = (low <= high).then(|| (low.to_le_bytes(), high.to_le_bytes()));
    let present: Vec<bool> = values.iter().map(|value| value.is_finite()).collect();
    let mut bytes = Vec::with_capacity(8 * values.len());
    finite().for_each(|value| bytes.extend_from_slice(&value.to_le_bytes()));
    Chunk {
        rows: values.len() as u64,
        levels: levels(&present),
        values: bytes,
        statistics: Statistics { nulls: nulls(&present), span },
    }
}

/// Words, null where there are none.
pub(super) fn words(texts: &[String]) -> Chunk {
    let present: Vec<bool> = texts.iter().map(|text| !text.is_empty()).collect();
    let mut values = Vec::new();
    for text in texts.iter().filter(|text| !text.is_empty()) {
        values.extend_from_slice(&(text.len() as u32).to_le_bytes());
        values.extend_from_slice(text.as_bytes());
    }
    Chunk {
        rows: texts.len() as u64,
        levels: levels(&present),
        values,
        statistics: Statistics { nulls: nulls(&present), span: None },
    }
}

fn nulls(present: &[bool]) -> u64 {
    present.iter().filter(|present| !**present).count() as u64
}

/// Runs of rows that have a value (1) or none (0), after the length of all runs.
fn levels(present: &[bool]) -> Vec<u8> {
    let mut runs = Vec::new();
    for run in present.chunk_by(|a, b| a == b) {
        push_varint(&mut runs, (run.len() as u64) << 1);
        runs.push(u8::from(run[0]));
    }
    let mut bytes = (runs.len() as u32).to_le_bytes().to_vec();
    bytes.extend(runs);
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_tell_which_rows_have_a_value() {
        assert_eq!(levels(&[true, true, false, true]), [6, 0, 0, 0, 4, 1, 2, 0, 2, 1]);
    }

    #[test]
    fn undefined_numbers_are_null_and_not_in_the_span() {
        let chunk = numbers(&[f64::NAN, 2.5, -1.5, f64::INFINITY]);
        assert_eq!(chunk.statistics.nulls, 2);
        assert_eq!(chunk.statistics.span, Some(((-1.5_f64).to_le_bytes(), 2.5_f64.to_le_bytes())));
        assert_eq!(chunk.values.len(), 16);
        assert!(numbers(&[f64::NAN]).statistics.span.is_none());
    }
}
