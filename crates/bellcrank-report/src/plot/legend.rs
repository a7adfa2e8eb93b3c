//! Line styles and the key that explains them.

use super::svg::{Anchor, Svg};

/// Colours that stay apart for colour-blind readers (after Okabe and Ito, darkened for lines).
const COLOURS: [&str; 8] = ["#0b5fa5", "#c4510a", "#12805c", "#8a2b78", "#000000", "#9a7400", "#4a90c2", "#7a3b10"];
/// Dash patterns that tell the lines apart in black and white.
const DASHES: [&str; 8] = ["", "7 3", "2 2.5", "9 3 2 3", "13 4", "5 2 1.5 2 1.5 2", "1 3", "16 3 3 3"];

/// The colour of the line of that index.
pub(crate) fn color(index: usize) -> &'static str {
    COLOURS[index % COLOURS.len()]
}

/// The stroke of the line of that index.
pub(crate) fn stroke(index: usize) -> String {
    let (colour, dash) = (color(index), DASHES[index % DASHES.len()]);
    let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
    format!("stroke=\"{colour}\" stroke-width=\"1.6\"{dash}")
}

const ROW: f64 = 18.0;
const SAMPLE: f64 = 34.0;

/// A key of several columns below a chart.
pub(crate) struct Legend<'a> {
    names: Vec<&'a str>,
    columns: usize,
    width: f64,
}

impl<'a> Legend<'a> {
    /// A key for `names` that is `width` px wide at most.
    pub(crate) fn new(names: Vec<&'a str>, width: f64) -> Self {
        let longest = names.iter().map(|name| name.chars().count()).max().unwrap_or(0);
        // Labels are about 6.4 px a character at 12 px.
        let column = SAMPLE + 24.0 + 6.4 * longest as f64;
        let columns = ((width / column).floor() as usize).clamp(1, names.len().max(1));
        Self { names, columns, width }
    }

    /// Height, px.
    pub(crate) fn height(&self) -> f64 {
        self.names.len().div_ceil(self.columns) as f64 * ROW
    }

    pub(crate) fn draw(&self, svg: &mut Svg, corner: (f64, f64)) {
        self.draw_with(svg, corner, stroke);
    }

    /// With line styles of the chart's own.
    pub(crate) fn draw_with(&self, svg: &mut Svg, corner: (f64, f64), stroke: impl Fn(usize) -> String) {
        let column = self.width / self.columns as f64;
        for (index, name) in self.names.iter().enumerate() {
            let x = corner.0 + column * (index % self.columns) as f64;
            let y = corner.1 + ROW * ((index / self.columns) as f64 + 0.5);
            svg.line((x, y), (x + SAMPLE, y), &stroke(index));
            svg.label((x + SAMPLE + 6.0, y + 4.0), Anchor::Start, "", name);
        }
    }
}
