//! The frame of a plot: grid, marks, title, axis labels.

use super::scale::Scale;
use super::svg::{Anchor, Svg, px};

const FRAME: &str = "stroke=\"#222\" stroke-width=\"1\"";
const GRID: &str = "stroke=\"#ddd\" stroke-width=\"0.7\"";
const ZERO: &str = "stroke=\"#999\" stroke-width=\"0.9\"";
/// A title over the frame.
pub(crate) const BOLD: &str = "font-weight=\"600\" font-size=\"14\"";

/// Two scales that span a plot.
pub(crate) struct Frame<'a> {
    pub(crate) x: &'a Scale,
    pub(crate) y: &'a Scale,
}

impl Frame<'_> {
    /// Lines and numbers at the marks.
    pub(crate) fn draw_grid(&self, svg: &mut Svg) {
        self.draw_columns(svg);
        let (x, y) = (self.x, self.y);
        for &mark in &y.ticks.marks {
            let at = y.at_mark(mark);
            svg.line((x.pixels.0, at), (x.pixels.1, at), line_at(mark, y));
            svg.label((x.pixels.0 - 7.0, at + 4.0), Anchor::End, "", &y.text(mark));
        }
    }

    /// Only those of the horizontal axis.
    pub(crate) fn draw_columns(&self, svg: &mut Svg) {
        let (x, y) = (self.x, self.y);
        for &mark in &x.ticks.marks {
            let at = x.at_mark(mark);
            svg.line((at, y.pixels.0), (at, y.pixels.1), line_at(mark, x));
            svg.label((at, y.pixels.0 + 17.0), Anchor::Middle, "", &x.text(mark));
        }
    }

    /// Box, title and labels, over what was drawn before.
    pub(crate) fn draw(&self, svg: &mut Svg, title: &str, labels: (&str, &str)) {
        let (left, right, top, bottom) = (self.x.pixels.0, self.x.pixels.1, self.y.pixels.1, self.y.pixels.0);
        let frame = format!("M{} {}V{}H{}V{}Z", px(left), px(top), px(bottom), px(right), px(top));
        svg.path(&frame, FRAME);
        svg.label((left, top - 14.0), Anchor::Start, BOLD, &fitted(title, 1.15 * (right - left)));
        let middle = (f64::midpoint(left, right), bottom + 38.0);
        svg.label(middle, Anchor::Middle, "", &fitted(labels.0, right));
        let y_middle = px(f64::midpoint(top, bottom));
        let turned = format!("transform=\"rotate(-90 16 {y_middle})\"");
        let tall = fitted(labels.1, bottom - top + 30.0);
        svg.label((16.0, f64::midpoint(top, bottom)), Anchor::Middle, &turned, &tall);
    }
}

/// `text` cut to about `width` px of 12 px letters, with an ellipsis before what is left of its end.
///
/// Ends say more than beginnings: the unit of an axis, the last part of a signal's name.
pub(crate) fn fitted(text: &str, width: f64) -> String {
    const LETTER: f64 = 6.7;
    let most = (width / LETTER).max(2.0) as usize;
    let count = text.chars().count();
    if count <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().skip(count + 1 - most).collect();
    format!("…{kept}")
}

/// The line through zero stands out a little.
fn line_at(mark: f64, scale: &Scale) -> &'static str {
    if scale.is_zero(mark) { ZERO } else { GRID }
}

#[cfg(test)]
mod tests {
    use super::fitted;

    #[test]
    fn long_labels_keep_their_end() {
        assert_eq!(fitted("short / mm", 200.0), "short / mm");
        assert_eq!(fitted("max(abs(drive.slide.force)) / N", 67.0), "…rce)) / N");
    }
}
