//! A table of aligned columns.

use super::Style;
use super::paint::{Ink, clean};

/// A text and the side it is pushed to.
pub(crate) struct Cell {
    text: String,
    right: bool,
}

impl Cell {
    pub(crate) fn left(text: &str) -> Self {
        Self { text: clean(text), right: false }
    }

    pub(crate) fn right(text: &str) -> Self {
        Self { text: clean(text), right: true }
    }

    fn width(&self) -> usize {
        self.text.chars().count()
    }

    fn padded(&self, width: usize) -> String {
        let gap = " ".repeat(width.saturating_sub(self.width()));
        if self.right { gap + &self.text } else { self.text.clone() + &gap }
    }
}

/// Rows under a heading; without rows it leaves no text at all.
pub(crate) struct Grid {
    heads: Vec<&'static str>,
    rows: Vec<Vec<Cell>>,
}

impl Grid {
    pub(crate) fn new<const N: usize>(heads: [&'static str; N]) -> Self {
        Self { heads: heads.to_vec(), rows: Vec::new() }
    }

    pub(crate) fn push(&mut self, row: Vec<Cell>) {
        self.rows.push(row);
    }

    pub(crate) fn text(&self, style: &Style) -> String {
        if self.rows.is_empty() {
            return String::new();
        }
        let head = self.line(&self.head());
        let mut text = style.paint(Ink::Dim, &head) + "\n";
        for row in &self.rows {
            text.push_str(&self.line(row));
            text.push('\n');
        }
        text
    }

    /// A heading stands on the side where its numbers stand.
    fn head(&self) -> Vec<Cell> {
        let right = |index: usize| self.rows.iter().filter_map(|row| row.get(index)).any(|c| c.right);
        let cell = |(index, text): (usize, &&'static str)| Cell { text: (*text).to_owned(), right: right(index) };
        self.heads.iter().enumerate().map(cell).collect()
    }

    fn line(&self, row: &[Cell]) -> String {
        let cells: Vec<String> = row.iter().enumerate().map(|(index, cell)| cell.padded(self.width(index))).collect();
        format!("  {}", cells.join("  ")).trim_end().to_owned()
    }

    /// A row with a single cell is a remark and may be as wide as it likes.
    fn width(&self, index: usize) -> usize {
        let head = self.heads.get(index).map_or(0, |head| head.chars().count());
        let full = self.rows.iter().filter(|row| row.len() > 1);
        full.filter_map(|row| row.get(index)).map(Cell::width).fold(head, usize::max)
    }
}
