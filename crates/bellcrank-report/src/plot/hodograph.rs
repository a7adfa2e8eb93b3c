//! A force vector's path: one component over another, same scale on both, around the origin.

use super::curve;
use super::svg::{Anchor, Svg, px};
use super::ticks::Ticks;
use crate::number;

/// The path of a vector's tip, display numbers.
pub(crate) struct Hodograph<'a> {
    pub(crate) title: String,
    /// Names of the two components, as `fx`.
    pub(crate) axes: (&'a str, &'a str),
    pub(crate) unit: &'a str,
    pub(crate) x: Vec<f64>,
    pub(crate) y: Vec<f64>,
}

const SIZE: f64 = 300.0;
const TITLE: f64 = 34.0;
const EDGE: f64 = 14.0;
const RING: &str = "fill=\"none\" stroke=\"#ddd\" stroke-width=\"0.8\"";
const CROSS: &str = "stroke=\"#999\" stroke-width=\"0.9\"";
const SPOKE: &str = "stroke=\"#e6e6e6\" stroke-width=\"0.7\"";
const PATH: &str = "stroke=\"#0b5fa5\" stroke-width=\"1.8\" stroke-linejoin=\"round\"";
const VECTOR: &str = "stroke=\"#c4510a\" stroke-width=\"1.2\" stroke-dasharray=\"5 3\"";
/// Small print with a white edge, readable where a line passes.
const SMALL: &str = "font-size=\"10\" fill=\"#555\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";

impl Hodograph<'_> {
    /// The picture as an SVG document.
    ///
    /// `data-ox`, `data-oy` (px) and `data-scale` (px per unit) let the report move a marker on it.
    pub(crate) fn svg(&self) -> String {
        let rings = Ticks::new((0.0, self.reach()), 4.0, "");
        let origin = (SIZE / 2.0, TITLE + SIZE / 2.0);
        let scale = (SIZE / 2.0 - EDGE - 8.0) / rings.to;
        let extra = format!(" data-ox=\"{}\" data-oy=\"{}\" data-scale=\"{scale:e}\"", px(origin.0), px(origin.1));
        let mut svg = Svg::new((SIZE, SIZE + TITLE), &self.title, &extra);
        let bold = "font-weight=\"600\" font-size=\"13\"";
        svg.label((8.0, 20.0), Anchor::Start, bold, &self.title);
        self.draw_web(&mut svg, &rings, origin, scale);
        self.draw_path(&mut svg, origin, scale);
        svg.finish()
    }

    /// The largest magnitude, and 1 where there is none to show.
    fn reach(&self) -> f64 {
        let sizes = self.x.iter().zip(&self.y).map(|(x, y)| x.hypot(*y));
        let reach = sizes.filter(|size| size.is_finite()).fold(0.0, f64::max);
        if reach < 1e-9 { 1.0 } else { reach }
    }

    fn draw_web(&self, svg: &mut Svg, rings: &Ticks, origin: (f64, f64), scale: f64) {
        let radius = SIZE / 2.0 - EDGE;
        for turn in [30.0_f64, 60.0, 120.0, 150.0] {
            let (sin, cos) = turn.to_radians().sin_cos();
            let tip = |side: f64| (origin.0 + side * radius * cos, origin.1 - side * radius * sin);
            svg.line(tip(-1.0), tip(1.0), SPOKE);
        }
        svg.line((origin.0 - radius, origin.1), (origin.0 + radius, origin.1), CROSS);
        svg.line((origin.0, origin.1 - radius), (origin.0, origin.1 + radius), CROSS);
        for &ring in rings.marks.iter().filter(|mark| **mark > 0.0) {
            svg.circle(origin, ring * scale, RING);
            let at = (origin.0 + 3.0, origin.1 - ring * scale - 3.0);
            svg.label(at, Anchor::Start, SMALL, &rings.text(ring));
        }
        let (x, y) = self.axes;
        let x_at = (SIZE - 4.0, origin.1 - 5.0);
        svg.label(x_at, Anchor::End, SMALL, &format!("{x} / {}", number::unit(self.unit)));
        let y_at = (origin.0 - 5.0, TITLE + 10.0);
        svg.label(y_at, Anchor::End, SMALL, &format!("{y} / {}", number::unit(self.unit)));
    }

    fn draw_path(&self, svg: &mut Svg, origin: (f64, f64), scale: f64) {
        let place = |(x, y): (&f64, &f64)| (origin.0 + x * scale, origin.1 - y * scale);
        let points: Vec<_> = self.x.iter().zip(&self.y).map(place).collect();
        let finite = |p: &&(f64, f64)| p.0.is_finite() && p.1.is_finite();
        let size = |p: &(f64, f64)| (p.0 - origin.0).hypot(p.1 - origin.1);
        let farthest = points.iter().filter(finite).max_by(|a, b| size(a).total_cmp(&size(b)));
        if let Some(&tip) = farthest {
            svg.line(origin, tip, VECTOR);
        }
        svg.path(&curve::path(&points), PATH);
        // The start is hollow, the end is full: the sense in which the path runs.
        if let Some(&start) = points.iter().find(finite) {
            svg.circle(start, 3.5, "fill=\"#fff\" stroke=\"#0b5fa5\" stroke-width=\"1.4\"");
        }
        if let Some(&end) = points.iter().rev().find(finite) {
            svg.circle(end, 3.0, "fill=\"#0b5fa5\"");
        }
    }
}
