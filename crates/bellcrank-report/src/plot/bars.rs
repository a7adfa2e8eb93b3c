//! Signed bars beside names: tornado plots and contributions.

use super::frame::{BOLD, Frame, fitted};
use super::scale::Scale;
use super::svg::{Anchor, Svg, px};

/// A bar.
pub(crate) struct Bar<'a> {
    pub(crate) name: &'a str,
    /// Its length, display number.
    pub(crate) value: f64,
    /// What stands at its end.
    pub(crate) text: String,
    /// A second, thinner bar below.
    pub(crate) second: Option<f64>,
}

/// Bars one below the other, in the order given.
pub(crate) struct Bars<'a> {
    pub(crate) title: String,
    /// What the lengths are.
    pub(crate) label: String,
    /// What thick and thin bars are, where there are thin ones.
    pub(crate) kinds: Option<[&'a str; 2]>,
    pub(crate) bars: Vec<Bar<'a>>,
}

const WIDTH: f64 = 720.0;
const TOP: f64 = 38.0;
const ROW: f64 = 26.0;
const RIGHT: f64 = 22.0;
const BELOW: f64 = 50.0;
const KEY: f64 = 22.0;
/// Names take at most this much.
const WIDEST_NAME: f64 = 240.0;
const MORE: &str = "#0b5fa5";
const LESS: &str = "#c4510a";
const THIN: &str = "fill=\"#9aa4ae\"";
/// Text over lines of the grid.
const HALO: &str = "stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"";

impl Bars<'_> {
    /// The plot as an SVG document. Bars to the left are hollow: their sign is not in colour alone.
    pub(crate) fn svg(&self) -> String {
        let bottom = TOP + ROW * self.bars.len() as f64 + 8.0;
        let key = if self.kinds.is_some() { KEY } else { 0.0 };
        let left = self.names_width();
        let mut svg = Svg::new((WIDTH, bottom + BELOW + key), &self.title, "");
        let x = Scale::over(self.span(), "", (left, WIDTH - RIGHT));
        let y = Scale::over((0.0, 1.0), "", (bottom, TOP));
        let frame = Frame { x: &x, y: &y };
        frame.draw_columns(&mut svg);
        let zero = x.at(0.0);
        for (index, bar) in self.bars.iter().enumerate() {
            let middle = TOP + 4.0 + ROW * (index as f64 + 0.5);
            svg.label((left - 9.0, middle + 4.0), Anchor::End, "", &fitted(bar.name, left - 14.0));
            draw_bar(&mut svg, &x, middle, bar);
        }
        svg.line((zero, TOP), (zero, bottom), "stroke=\"#222\" stroke-width=\"1\"");
        svg.label((12.0, TOP - 14.0), Anchor::Start, BOLD, &self.title);
        svg.label((f64::midpoint(left, WIDTH - RIGHT), bottom + 38.0), Anchor::Middle, "", &self.label);
        self.draw_key(&mut svg, (left, bottom + BELOW));
        svg.finish()
    }

    fn names_width(&self) -> f64 {
        let longest = self.bars.iter().map(|bar| bar.name.chars().count()).max().unwrap_or(0);
        (24.0 + 6.9 * longest as f64).clamp(70.0, WIDEST_NAME)
    }

    /// Room for the numbers at the ends of the longest bars.
    fn span(&self) -> (f64, f64) {
        let values = || self.bars.iter().flat_map(|bar| [Some(bar.value), bar.second]).flatten();
        let (low, high) = values().fold((0.0, 0.0), |(low, high): (f64, f64), v| (low.min(v), high.max(v)));
        let room = 0.13 * (high - low).max(f64::MIN_POSITIVE);
        let (low, high) = (if low < 0.0 { low - room } else { low }, if high > 0.0 { high + room } else { high });
        if low < high { (low, high) } else { (-1.0, 1.0) }
    }

    fn draw_key(&self, svg: &mut Svg, at: (f64, f64)) {
        let Some([thick, thin]) = self.kinds else { return };
        let (x, y) = at;
        rectangle(svg, (x, y), (26.0, 11.0), &format!("fill=\"{MORE}\""));
        svg.label((x + 33.0, y + 10.0), Anchor::Start, "", thick);
        let x = x + 60.0 + 6.7 * thick.chars().count() as f64;
        rectangle(svg, (x, y + 3.0), (26.0, 5.0), THIN);
        svg.label((x + 33.0, y + 10.0), Anchor::Start, "", thin);
    }
}

fn draw_bar(svg: &mut Svg, x: &Scale, middle: f64, bar: &Bar<'_>) {
    let zero = x.at(0.0);
    let (height, lift) = if bar.second.is_some() { (11.0, 3.5) } else { (15.0, 0.0) };
    let corner = |value: f64, height: f64, middle: f64| {
        ((zero.min(x.at(value)), middle - height / 2.0), ((x.at(value) - zero).abs(), height))
    };
    let fill = if bar.value < 0.0 {
        format!("fill=\"#f9e3d5\" stroke=\"{LESS}\" stroke-width=\"1.3\"")
    } else {
        format!("fill=\"{MORE}\"")
    };
    let (at, size) = corner(bar.value, height, middle - lift);
    rectangle(svg, at, size, &fill);
    if let Some(second) = bar.second.filter(|value| value.is_finite()) {
        let (at, size) = corner(second, 5.0, middle + 6.0);
        rectangle(svg, at, size, THIN);
    }
    let (end, anchor) =
        if bar.value < 0.0 { (x.at(bar.value) - 6.0, Anchor::End) } else { (x.at(bar.value) + 6.0, Anchor::Start) };
    svg.label((end, middle + 4.0 - lift), anchor, HALO, &bar.text);
}

/// A filled rectangle from its corner and its size, px.
pub(crate) fn rectangle(svg: &mut Svg, at: (f64, f64), size: (f64, f64), style: &str) {
    let [x, y, width, height] = [at.0, at.1, size.0, size.1].map(px);
    svg.raw(&format!("<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" {style}/>\n"));
}
