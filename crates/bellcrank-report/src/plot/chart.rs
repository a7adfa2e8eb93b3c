//! Lines over an axis.

use super::curve;
use super::frame::Frame;
use super::legend::{Legend, stroke};
use super::scale::Scale;
use super::svg::Svg;
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

pub(super) const WIDTH: f64 = 720.0;
pub(super) const LEFT: f64 = 78.0;
pub(super) const RIGHT: f64 = 18.0;
const TOP: f64 = 38.0;
const PLOT_HEIGHT: f64 = 290.0;
/// Between the frame and the key: tick texts and the axis label.
const BELOW: f64 = 52.0;

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
        let frame = Frame { x: &x, y: &y };
        frame.draw_grid(&mut svg);
        self.draw_curves(&mut svg, &x, &y);
        frame.draw(&mut svg, &self.title, (&self.x.label(), &self.y.label()));
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
}
