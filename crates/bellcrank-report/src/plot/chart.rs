//! Lines over an axis.

use super::curve;
use super::legend::{Legend, stroke};
use super::svg::{Anchor, Svg, px};
use super::ticks::{Ticks, span};
use super::{Axis, Curve};

/// A chart of several lines over one axis.
pub(crate) struct Chart<'a> {
    pub(crate) title: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    /// Where the values stand on the axis, display numbers.
    pub(crate) across: Vec<f64>,
    pub(crate) curves: Vec<Curve<'a>>,
}

const WIDTH: f64 = 720.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 38.0;
const PLOT_HEIGHT: f64 = 290.0;
/// Between the frame and the key: tick texts and the axis label.
const BELOW: f64 = 52.0;
const FRAME: &str = "stroke=\"#222\" stroke-width=\"1\"";
const GRID: &str = "stroke=\"#ddd\" stroke-width=\"0.7\"";
const ZERO: &str = "stroke=\"#999\" stroke-width=\"0.9\"";

impl Chart<'_> {
    /// The chart as an SVG document.
    pub(crate) fn svg(&self) -> String {
        let legend = Legend::new(self.curves.iter().map(|c| c.name).collect(), WIDTH - LEFT - RIGHT);
        let bottom = TOP + PLOT_HEIGHT;
        let height = bottom + BELOW + legend.height() + 8.0;
        let mut svg = Svg::new((WIDTH, height), &self.title, "");
        let y_values = self.curves.iter().flat_map(|curve| curve.y.iter().copied());
        let x = Scale::new(self.across.iter().copied(), &self.x, (LEFT, WIDTH - RIGHT), 0.0);
        let y = Scale::new(y_values, &self.y, (bottom, TOP), 0.05);
        draw_grid(&mut svg, &x, &y);
        self.draw_curves(&mut svg, &x, &y);
        self.draw_frame(&mut svg, &x, &y);
        legend.draw(&mut svg, (LEFT, bottom + BELOW));
        svg.finish()
    }

    fn draw_curves(&self, svg: &mut Svg, x: &Scale, y: &Scale) {
        for (index, curve) in self.curves.iter().enumerate() {
            let points: Vec<_> = self.across.iter().zip(&curve.y).map(|(a, b)| (x.at(*a), y.at(*b))).collect();
            let style = format!("{} stroke-linejoin=\"round\"", stroke(index));
            svg.path(&curve::path(&points), &style);
        }
    }

    fn draw_frame(&self, svg: &mut Svg, x: &Scale, y: &Scale) {
        let (left, right, top, bottom) = (x.pixels.0, x.pixels.1, y.pixels.1, y.pixels.0);
        let frame = format!("M{} {}V{}H{}V{}Z", px(left), px(top), px(bottom), px(right), px(top));
        svg.path(&frame, FRAME);
        let bold = "font-weight=\"600\" font-size=\"14\"";
        svg.label((left, TOP - 14.0), Anchor::Start, bold, &self.title);
        let middle = (f64::midpoint(left, right), bottom + 38.0);
        svg.label(middle, Anchor::Middle, "", &self.x.label());
        let y_middle = px(f64::midpoint(top, bottom));
        let turned = format!("transform=\"rotate(-90 16 {y_middle})\"");
        svg.label((16.0, f64::midpoint(top, bottom)), Anchor::Middle, &turned, &self.y.label());
    }
}

/// Display numbers to pixels.
struct Scale {
    ticks: Ticks,
    pixels: (f64, f64),
}

impl Scale {
    fn new(values: impl Iterator<Item = f64>, axis: &Axis, pixels: (f64, f64), margin: f64) -> Self {
        let count = (pixels.1 - pixels.0).abs() / 70.0;
        Self { ticks: Ticks::new(span(values, margin), count.max(2.0), &axis.unit), pixels }
    }

    fn at(&self, value: f64) -> f64 {
        let part = (value - self.ticks.from) / (self.ticks.to - self.ticks.from);
        self.pixels.0 + part * (self.pixels.1 - self.pixels.0)
    }
}

fn draw_grid(svg: &mut Svg, x: &Scale, y: &Scale) {
    for &mark in &x.ticks.marks {
        let at = x.at(mark);
        svg.line((at, y.pixels.0), (at, y.pixels.1), line_at(mark, x));
        svg.label((at, y.pixels.0 + 17.0), Anchor::Middle, "", &x.ticks.text(mark));
    }
    for &mark in &y.ticks.marks {
        let at = y.at(mark);
        svg.line((x.pixels.0, at), (x.pixels.1, at), line_at(mark, y));
        svg.label((x.pixels.0 - 7.0, at + 4.0), Anchor::End, "", &y.ticks.text(mark));
    }
}

/// The line through zero stands out a little.
fn line_at(mark: f64, scale: &Scale) -> &'static str {
    let zero = mark.abs() < 1e-9 * (scale.ticks.to - scale.ticks.from);
    if zero { ZERO } else { GRID }
}
