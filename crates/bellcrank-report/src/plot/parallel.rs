//! Designs as lines over parallel axes, one axis a column.

use super::curve;
use super::frame::{BOLD, fitted};
use super::scale::Scale;
use super::svg::{Anchor, Svg};
use crate::number;

/// A column in display numbers.
pub(crate) struct Ruler<'a> {
    pub(crate) name: &'a str,
    pub(crate) unit: &'a str,
    pub(crate) values: Vec<f64>,
    /// It is varied, not found.
    pub(crate) input: bool,
}

/// The columns of a sweep side by side; lines are coloured by the last one.
pub(crate) struct Parallel<'a> {
    pub(crate) title: String,
    pub(crate) rulers: Vec<Ruler<'a>>,
}

const WIDTH: f64 = 720.0;
const EDGE: f64 = 62.0;
const TOP: f64 = 84.0;
const BOTTOM: f64 = 330.0;
const RULER: &str = "stroke=\"#222\" stroke-width=\"1.1\"";
const FAILED: &str = "stroke=\"#888\" stroke-width=\"0.8\" stroke-dasharray=\"3 3\" stroke-opacity=\"0.6\"";
const SMALL: &str = "font-size=\"10.5\" fill=\"#333\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";

impl Parallel<'_> {
    /// The plot as an SVG document.
    pub(crate) fn svg(&self) -> String {
        let mut svg = Svg::new((WIDTH, BOTTOM + 60.0), &self.title, "");
        let scales: Vec<Scale> = self
            .rulers
            .iter()
            .map(|r| Scale::over(super::ticks::span(r.values.iter().copied(), 0.0), r.unit, (BOTTOM, TOP)))
            .collect();
        let rows = self.rulers.iter().map(|ruler| ruler.values.len()).max().unwrap_or(0);
        for row in 0..rows {
            self.draw_design(&mut svg, &scales, row);
        }
        for (index, (ruler, scale)) in self.rulers.iter().zip(&scales).enumerate() {
            self.draw_ruler(&mut svg, index, ruler, scale);
        }
        svg.label((EDGE - 46.0, 20.0), Anchor::Start, BOLD, &self.title);
        let colour = self.rulers.last().map_or("", |ruler| ruler.name);
        let key = format!("Colour: {}, from low (blue) to high (orange). Dashed: failed.", fitted(colour, 260.0));
        svg.label((EDGE - 46.0, BOTTOM + 44.0), Anchor::Start, "fill=\"#555\"", &key);
        svg.finish()
    }

    fn place(&self, index: usize) -> f64 {
        let steps = self.rulers.len().saturating_sub(1).max(1) as f64;
        EDGE + (WIDTH - 2.0 * EDGE) * index as f64 / steps
    }

    fn draw_design(&self, svg: &mut Svg, scales: &[Scale], row: usize) {
        let value = |index: usize| self.rulers[index].values.get(row).copied().unwrap_or(f64::NAN);
        let points: Vec<_> = (0..scales.len()).map(|i| (self.place(i), scales[i].at(value(i)))).collect();
        let last = scales.len().saturating_sub(1);
        let share = scales.last().map_or(f64::NAN, |s| (value(last) - s.ticks.from) / (s.ticks.to - s.ticks.from));
        let style = if share.is_finite() {
            format!("stroke=\"{}\" stroke-width=\"0.9\" stroke-opacity=\"0.5\"", tint(share))
        } else {
            FAILED.to_owned()
        };
        svg.path(&curve::path(&points), &style);
    }

    /// Names stand on two levels, in turn, where there is little room between rulers.
    fn draw_ruler(&self, svg: &mut Svg, index: usize, ruler: &Ruler<'_>, scale: &Scale) {
        let x = self.place(index);
        let room = (WIDTH - 2.0 * EDGE) / self.rulers.len().saturating_sub(1).max(1) as f64;
        svg.line((x, TOP), (x, BOTTOM), RULER);
        for &mark in &scale.ticks.marks {
            let y = scale.at_mark(mark);
            svg.line((x - 4.0, y), (x, y), RULER);
            svg.label((x - 6.0, y + 3.5), Anchor::End, SMALL, &scale.text(mark));
        }
        let name = if ruler.unit.is_empty() {
            ruler.name.to_owned()
        } else {
            format!("{} / {}", ruler.name, number::unit(ruler.unit))
        };
        let staggered = index % 2 == 1;
        let level = TOP - if staggered { 30.0 } else { 12.0 };
        let anchor = if index == 0 {
            Anchor::Start
        } else if index + 1 == self.rulers.len() {
            Anchor::End
        } else {
            Anchor::Middle
        };
        let x_name = x + if index == 0 {
            -46.0
        } else if index + 1 == self.rulers.len() {
            46.0
        } else {
            0.0
        };
        let weight = if ruler.input { "font-size=\"11\"" } else { "font-size=\"11\" font-weight=\"600\"" };
        svg.label((x_name, level), anchor, weight, &fitted(&name, 1.75 * room));
        if staggered {
            svg.line((x, level + 4.0), (x, TOP), "stroke=\"#bbb\" stroke-width=\"0.7\"");
        }
        let word = if ruler.input { "varied" } else { "found" };
        svg.label((x, BOTTOM + 16.0), Anchor::Middle, "font-size=\"10.5\" fill=\"#555\"", word);
    }
}

/// From blue over grey to orange.
fn tint(share: f64) -> String {
    const STOPS: [[f64; 3]; 3] = [[11.0, 95.0, 165.0], [150.0, 150.0, 150.0], [196.0, 81.0, 10.0]];
    let along = 2.0 * share.clamp(0.0, 1.0);
    let (from, part) = if along < 1.0 { (0, along) } else { (1, along - 1.0) };
    let mix = |k: usize| (STOPS[from][k] + part * (STOPS[from + 1][k] - STOPS[from][k])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::tint;

    #[test]
    fn colours_run_from_blue_to_orange() {
        assert_eq!([tint(0.0), tint(0.5), tint(1.0)], ["#0b5fa5", "#969696", "#c4510a"]);
    }
}
