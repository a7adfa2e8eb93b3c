//! A response against one parameter, small: one of many side by side.

use super::curve;
use super::frame::Frame;
use super::scale::Scale;
use super::svg::{Anchor, Svg};
use super::{Axis, ticks};

/// Display numbers throughout.
pub(crate) struct Response<'a> {
    pub(crate) title: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) across: &'a [f64],
    pub(crate) up: &'a [f64],
    /// Parameter and response as they are.
    pub(crate) here: (f64, f64),
    /// Slope there.
    pub(crate) slope: f64,
    /// The span that all of the pictures share.
    pub(crate) span: (f64, f64),
}

const WIDTH: f64 = 360.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 14.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 214.0;
const HEIGHT: f64 = 262.0;
const LINE: &str = "stroke=\"#0b5fa5\" stroke-width=\"1.8\" stroke-linejoin=\"round\"";
const TANGENT: &str = "stroke=\"#c4510a\" stroke-width=\"1.3\" stroke-dasharray=\"6 3\"";
const DOWN: &str = "stroke=\"#888\" stroke-width=\"0.8\" stroke-dasharray=\"2 2.5\"";
const SMALL: &str = "font-size=\"11\" fill=\"#a03f05\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";

impl Response<'_> {
    /// The plot as an SVG document: the curve, the present value, and the derivative as a dashed line.
    pub(crate) fn svg(&self) -> String {
        let mut svg = Svg::new((WIDTH, HEIGHT), &self.title, "");
        let places = self.across.iter().copied().chain([self.here.0]);
        let x = Scale::new(places, &self.x, (LEFT, WIDTH - RIGHT), 0.02);
        let y = Scale::over(self.span, &self.y.unit, (BOTTOM, TOP));
        let frame = Frame { x: &x, y: &y };
        frame.draw_grid(&mut svg);
        let points: Vec<_> = self.across.iter().zip(self.up).map(|(a, b)| (x.at(*a), y.at(*b))).collect();
        self.draw_tangent(&mut svg, &x, &y);
        svg.path(&curve::path(&points), LINE);
        self.draw_here(&mut svg, &x, &y);
        frame.draw(&mut svg, &self.title, (&self.x.label(), &self.y.label()));
        svg.finish()
    }

    /// As long as the frame lets it.
    fn draw_tangent(&self, svg: &mut Svg, x: &Scale, y: &Scale) {
        let (low, high) = (x.ticks.from, x.ticks.to);
        let on_line = |at: f64| self.here.1 + self.slope * (at - self.here.0);
        let inside = |value: f64| (y.ticks.from..=y.ticks.to).contains(&value);
        let steps = (0..=200).map(|i| low + (high - low) * f64::from(i) / 200.0).filter(|at| inside(on_line(*at)));
        let points: Vec<_> = steps.map(|at| (x.at(at), y.at(on_line(at)))).collect();
        svg.path(&curve::path(&points), TANGENT);
    }

    fn draw_here(&self, svg: &mut Svg, x: &Scale, y: &Scale) {
        let at = (x.at(self.here.0), y.at(self.here.1));
        if !(at.0.is_finite() && at.1.is_finite()) {
            return;
        }
        svg.line(at, (at.0, BOTTOM), DOWN);
        svg.circle(at, 4.0, "fill=\"#c4510a\" stroke=\"#fff\" stroke-width=\"1.2\"");
        let (anchor, aside) =
            if at.0 > f64::midpoint(LEFT, WIDTH) { (Anchor::End, -5.0) } else { (Anchor::Start, 5.0) };
        svg.label((at.0 + aside, BOTTOM - 6.0), anchor, SMALL, "as it is");
    }
}

/// The span of all responses, so that pictures side by side compare.
pub(crate) fn shared_span<'a>(all: impl Iterator<Item = &'a f64>) -> (f64, f64) {
    ticks::span(all.copied(), 0.06)
}
