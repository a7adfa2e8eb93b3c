//! How often a response falls where, with limits and estimates.

use super::Axis;
use super::bars::rectangle;
use super::curve;
use super::frame::Frame;
use super::scale::Scale;
use super::svg::{Anchor, Svg};

/// A vertical line with a name.
pub(crate) struct Mark {
    pub(crate) name: &'static str,
    pub(crate) at: f64,
    pub(crate) style: MarkStyle,
}

#[derive(Clone, Copy)]
pub(crate) enum MarkStyle {
    Limit,
    Nominal,
    WorstCase,
}

impl MarkStyle {
    fn stroke(self) -> &'static str {
        match self {
            Self::Limit => "stroke=\"#a8201a\" stroke-width=\"2\"",
            Self::Nominal => "stroke=\"#222\" stroke-width=\"1.2\"",
            Self::WorstCase => "stroke=\"#8a2b78\" stroke-width=\"1.4\" stroke-dasharray=\"7 3 2 3\"",
        }
    }
}

/// Display numbers throughout.
pub(crate) struct Histogram {
    pub(crate) title: String,
    pub(crate) x: Axis,
    /// From, to, share of the samples.
    pub(crate) bins: Vec<(f64, f64, f64)>,
    /// Mean and deviation of a normal curve over it.
    pub(crate) normal: (f64, f64),
    pub(crate) marks: Vec<Mark>,
}

const WIDTH: f64 = 720.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 18.0;
/// Names of marks stand in the room above the frame, on three lines.
const TOP: f64 = 76.0;
const BOTTOM: f64 = 326.0;
const BAR: &str = "fill=\"#8fb8db\" stroke=\"#0b5fa5\" stroke-width=\"0.6\"";
const NORMAL: &str = "stroke=\"#c4510a\" stroke-width=\"1.8\" stroke-dasharray=\"8 3\"";
const SMALL: &str = "font-size=\"11\" stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";

impl Histogram {
    /// The plot as an SVG document.
    pub(crate) fn svg(&self) -> String {
        let mut svg = Svg::new((WIDTH, BOTTOM + 80.0), &self.title, "");
        let x = Scale::new(self.reach(), &self.x, (LEFT, WIDTH - RIGHT), 0.04);
        let y = Scale::over((0.0, 1.08 * self.highest()), "", (BOTTOM, TOP));
        let frame = Frame { x: &x, y: &y };
        frame.draw_grid(&mut svg);
        for &(from, to, share) in &self.bins {
            let (left, right, top) = (x.at(from), x.at(to), y.at(100.0 * share));
            rectangle(&mut svg, (left, top), (right - left, BOTTOM - top), BAR);
        }
        self.draw_normal(&mut svg, &x, &y);
        self.draw_marks(&mut svg, &x);
        let up = if self.bins.is_empty() { "density, % of the highest" } else { "samples / %" };
        frame.draw(&mut svg, "", (&self.x.label(), up));
        svg.label((LEFT, 20.0), Anchor::Start, super::frame::BOLD, &self.title);
        self.draw_key(&mut svg);
        svg.finish()
    }

    fn reach(&self) -> impl Iterator<Item = f64> {
        let bins = self.bins.iter().flat_map(|(from, to, _)| [*from, *to]);
        let (mean, deviation) = self.normal;
        let curve = [mean - 3.5 * deviation, mean + 3.5 * deviation];
        bins.chain(curve).chain(self.marks.iter().map(|mark| mark.at))
    }

    /// Percent.
    fn highest(&self) -> f64 {
        let bars = self.bins.iter().map(|bin| 100.0 * bin.2).fold(0.0, f64::max);
        bars.max(self.normal_at(self.normal.0)).max(1e-9)
    }

    /// The normal curve in percent a bin, or of its own top without bins.
    fn normal_at(&self, at: f64) -> f64 {
        let (mean, deviation) = self.normal;
        let away = (at - mean) / deviation;
        let bell = (-0.5 * away * away).exp();
        match self.bins.first() {
            Some((from, to, _)) => 100.0 * bell * (to - from) / deviation / std::f64::consts::TAU.sqrt(),
            None => 100.0 * bell,
        }
    }

    fn draw_normal(&self, svg: &mut Svg, x: &Scale, y: &Scale) {
        let (mean, deviation) = self.normal;
        if !(deviation > 0.0 && deviation.is_finite()) {
            return;
        }
        let place = |i: i32| mean + deviation * 4.0 * f64::from(i) / 60.0;
        let inside = |at: &f64| (x.ticks.from..=x.ticks.to).contains(at);
        let points: Vec<_> =
            (-60..=60).map(place).filter(inside).map(|at| (x.at(at), y.at(self.normal_at(at)))).collect();
        svg.path(&curve::path(&points), NORMAL);
    }

    /// Each name stands above its line, on a line of its own kind so that neighbours do not collide.
    fn draw_marks(&self, svg: &mut Svg, x: &Scale) {
        for mark in &self.marks {
            let at = x.at(mark.at);
            let lift = match mark.style {
                MarkStyle::WorstCase => 32.0,
                MarkStyle::Limit => 19.0,
                MarkStyle::Nominal => 6.0,
            };
            svg.line((at, TOP - lift + 2.0), (at, BOTTOM), mark.style.stroke());
            let wide = 3.3 * mark.name.chars().count() as f64;
            let middle = at.clamp(LEFT + wide - 30.0, WIDTH - RIGHT - wide);
            svg.label((middle, TOP - lift - 1.0), Anchor::Middle, SMALL, mark.name);
        }
    }

    fn draw_key(&self, svg: &mut Svg) {
        let y = BOTTOM + 62.0;
        let mut x = LEFT;
        if !self.bins.is_empty() {
            rectangle(svg, (x, y - 9.0), (26.0, 10.0), BAR);
            svg.label((x + 33.0, y), Anchor::Start, "", "Monte Carlo samples");
            x += 190.0;
        }
        svg.line((x, y - 4.0), (x + 34.0, y - 4.0), NORMAL);
        svg.label((x + 41.0, y), Anchor::Start, "", "normal curve from the derivatives");
    }
}
