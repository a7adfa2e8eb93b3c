//! Designs as dots over two of their columns, with the front.

use super::Axis;
use super::curve;
use super::frame::Frame;
use super::scale::Scale;
use super::svg::{Anchor, Svg};

/// Display numbers throughout.
pub(crate) struct Scatter<'a> {
    pub(crate) title: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) points: Vec<(f64, f64)>,
    /// The best compromises, in order, where the axes are their responses.
    pub(crate) front: Vec<(f64, f64)>,
    /// What is said of dots that are not there.
    pub(crate) note: &'a str,
}

const WIDTH: f64 = 720.0;
const LEFT: f64 = 86.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 38.0;
const BOTTOM: f64 = 358.0;
const DOT: &str = "fill=\"#0b5fa5\" fill-opacity=\"0.45\"";
const FRONT: &str = "stroke=\"#c4510a\" stroke-width=\"1.6\"";

impl Scatter<'_> {
    /// The plot as an SVG document.
    pub(crate) fn svg(&self) -> String {
        let mut svg = Svg::new((WIDTH, BOTTOM + 76.0), &self.title, "");
        let all = || self.points.iter().chain(&self.front);
        let x = Scale::new(all().map(|p| p.0), &self.x, (LEFT, WIDTH - RIGHT), 0.04);
        let y = Scale::new(all().map(|p| p.1), &self.y, (BOTTOM, TOP), 0.05);
        let frame = Frame { x: &x, y: &y };
        frame.draw_grid(&mut svg);
        let place = |p: &(f64, f64)| (x.at(p.0), y.at(p.1));
        for point in self.points.iter().map(place).filter(finite) {
            svg.circle(point, 2.6, DOT);
        }
        let front: Vec<_> = self.front.iter().map(place).collect();
        svg.path(&curve::path(&front), FRONT);
        for point in front.iter().copied().filter(finite) {
            svg.circle(point, 3.6, "fill=\"#fff\" stroke=\"#c4510a\" stroke-width=\"1.8\"");
        }
        frame.draw(&mut svg, &self.title, (&self.x.label(), &self.y.label()));
        self.draw_key(&mut svg);
        svg.finish()
    }

    fn draw_key(&self, svg: &mut Svg) {
        let y = BOTTOM + 60.0;
        let mut x = LEFT;
        svg.circle((x + 8.0, y - 4.0), 2.6, DOT);
        svg.label((x + 18.0, y), Anchor::Start, "", "a design");
        x += 100.0;
        if !self.front.is_empty() {
            svg.line((x, y - 4.0), (x + 34.0, y - 4.0), FRONT);
            svg.circle((x + 17.0, y - 4.0), 3.6, "fill=\"#fff\" stroke=\"#c4510a\" stroke-width=\"1.8\"");
            svg.label((x + 41.0, y), Anchor::Start, "", "best compromises (Pareto front)");
            x += 260.0;
        }
        svg.label((x, y), Anchor::Start, "fill=\"#555\"", self.note);
    }
}

fn finite(point: &(f64, f64)) -> bool {
    point.0.is_finite() && point.1.is_finite()
}
