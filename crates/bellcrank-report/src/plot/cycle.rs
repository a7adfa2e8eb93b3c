//! A cycle chart: what moves when, a lane for each axis of the machine.

use bellcrank_results::{Move, Programme};

use super::bars::rectangle;
use super::chart::{LEFT, RIGHT, WIDTH};
use super::frame::{BOLD, Frame, fitted};
use super::scale::Scale;
use super::svg::{Anchor, Svg, px};
use super::{Axis, legend};
use crate::number;

/// The moves of a study over its time.
pub(crate) struct Cycle<'a> {
    pub(crate) title: String,
    pub(crate) of: &'a Programme,
    /// The study lasts until then, s.
    pub(crate) until: f64,
}

const TOP: f64 = 38.0;
const LANE: f64 = 44.0;
const BAR: f64 = 20.0;
const BELOW: f64 = 50.0;
/// Room that a letter of a small label takes.
const LETTER: f64 = 6.3;
const SMALL: &str = "font-size=\"10.5\"";
const SMALL_LIGHT: &str = "font-size=\"10.5\" fill=\"#fff\"";
const SEPARATOR: &str = "stroke=\"#bbb\" stroke-width=\"0.7\"";

impl Cycle<'_> {
    /// The chart as an SVG document. Its frame lies over that of the other charts; where the time axis is, is told
    /// in the attributes `data-x0`, `data-x1` (px), `data-t0` and `data-t1` (display numbers).
    pub(crate) fn svg(&self) -> String {
        let lanes = self.lanes();
        let bottom = TOP + LANE * lanes.len() as f64;
        let axis = Axis { name: "time".to_owned(), unit: self.of.time.symbol.clone() };
        let until = self.of.time.show(self.until);
        let x = Scale::new([0.0, until].into_iter(), &axis, (LEFT, WIDTH - RIGHT), 0.0);
        let data = format!(
            " data-x0=\"{}\" data-x1=\"{}\" data-t0=\"{}\" data-t1=\"{}\" data-top=\"{}\" data-bottom=\"{}\"",
            px(x.pixels.0),
            px(x.pixels.1),
            x.ticks.from,
            x.ticks.to,
            px(TOP),
            px(bottom)
        );
        let mut svg = Svg::new((WIDTH, bottom + BELOW), &self.title, &data);
        let y = Scale::over((0.0, 1.0), "", (bottom, TOP));
        let frame = Frame { x: &x, y: &y };
        frame.draw_columns(&mut svg);
        for (index, joint) in lanes.iter().enumerate() {
            let top = TOP + LANE * index as f64;
            if index > 0 {
                svg.line((LEFT, top), (WIDTH - RIGHT, top), SEPARATOR);
            }
            draw_name(&mut svg, top + LANE / 2.0, joint);
            let moves = self.of.moves.iter().filter(|one| one.joint == *joint);
            moves.for_each(|one| self.draw_move(&mut svg, &x, top, legend::color(index), one));
        }
        frame.draw(&mut svg, "", (&axis.label(), ""));
        svg.label((12.0, TOP - 14.0), Anchor::Start, BOLD, &fitted(&self.title, 1.15 * (WIDTH - 24.0)));
        svg.finish()
    }

    /// The coordinates in the order in which they first move.
    fn lanes(&self) -> Vec<&str> {
        let mut lanes: Vec<&str> = Vec::new();
        for one in &self.of.moves {
            if !lanes.contains(&one.joint.as_str()) {
                lanes.push(&one.joint);
            }
        }
        lanes
    }

    fn draw_move(&self, svg: &mut Svg, x: &Scale, top: f64, color: &str, one: &Move) {
        if one.start >= self.until {
            return;
        }
        let time = |si: f64| x.at(self.of.time.show(si.min(self.until)));
        let (from, to) = (time(one.start), time(one.end.unwrap_or(self.until)));
        let middle = top + 0.62 * LANE;
        svg.raw(&format!("<g><title>{}</title>\n", crate::html::Escaped(&self.told(one))));
        if one.holds() {
            let style = format!("stroke=\"{color}\" stroke-width=\"2\" stroke-dasharray=\"3 3\"");
            svg.line((from, middle), (to, middle), &style);
        } else {
            let style = format!("fill=\"{color}\" stroke=\"#fff\" stroke-width=\"1\"");
            rectangle(svg, (from, middle - BAR / 2.0), ((to - from).max(1.0), BAR), &style);
            self.draw_way(svg, (from, to), middle, one);
        }
        svg.raw("</g>\n");
        if let Some(name) = self.begins_motion(one) {
            let at = (from + 2.0, top + 0.62 * LANE - BAR / 2.0 - 4.0);
            let room = time(self.next_in_lane(one)) - from;
            if room > 3.0 * LETTER {
                svg.label(at, Anchor::Start, SMALL, &cut(name, room));
            }
        }
    }

    /// The way inside of a bar, with how it goes where there is room.
    fn draw_way(&self, svg: &mut Svg, (from, to): (f64, f64), middle: f64, one: &Move) {
        let way = way(one);
        let long = format!("{way}, {}", one.profile);
        let fits = |text: &str| LETTER * text.chars().count() as f64 + 4.0 <= to - from;
        let Some(text) = [&long, &way].into_iter().find(|text| fits(text)) else { return };
        svg.label((f64::midpoint(from, to), middle + 4.0), Anchor::Middle, SMALL_LIGHT, text);
    }

    /// The name of the motion above its first piece.
    fn begins_motion<'m>(&self, one: &'m Move) -> Option<&'m str> {
        let first = self.of.moves.iter().find(|other| other.motion == one.motion && other.joint == one.joint)?;
        std::ptr::eq(first, one).then_some(one.motion.as_str())
    }

    /// When another motion of the same coordinate begins.
    fn next_in_lane(&self, one: &Move) -> f64 {
        let others = self.of.moves.iter().filter(|other| other.joint == one.joint && other.motion != one.motion);
        others.map(|other| other.start).filter(|start| *start > one.start).fold(self.until, f64::min)
    }

    /// Everything about a move, for who points at it.
    fn told(&self, one: &Move) -> String {
        let time = |si: f64| number::with_unit(&number::alone(self.of.time.show(si)), &self.of.time.symbol);
        let segment = one.segment.as_ref().map_or_else(String::new, |segment| format!(", segment {segment}"));
        let end = one.end.map_or_else(String::new, |end| format!(" to {}", time(end)));
        format!("{}{segment}: {} from {}{end}, {}", one.motion, one.joint, time(one.start), way(one))
            + &if one.holds() { String::new() } else { format!(", {}", one.profile) }
    }
}

/// A name in the margin, over as many lines as its parts need.
fn draw_name(svg: &mut Svg, middle: f64, name: &str) {
    const MOST: usize = 9;
    let mut lines: Vec<String> = Vec::new();
    for part in name.split_inclusive('.') {
        match lines.last_mut().filter(|line| line.chars().count() + part.chars().count() <= MOST) {
            Some(line) => line.push_str(part),
            None => lines.push(part.to_owned()),
        }
    }
    let skipped = lines.len().saturating_sub(3);
    let first = middle + 4.0 - 6.5 * (lines.len() - skipped - 1) as f64;
    for (index, line) in lines.iter().skip(skipped).enumerate() {
        svg.label((LEFT - 8.0, first + 13.0 * index as f64), Anchor::End, "", &fitted(line, LEFT - 12.0));
    }
}

/// How far it goes: `+400 mm`; where it holds the place.
fn way(one: &Move) -> String {
    let shown = |si: f64| number::typeset(&number::alone(one.unit.show(si)));
    let unit = number::unit(&one.unit.symbol);
    match one.to {
        _ if one.holds() => format!("holds {} {unit}", shown(one.from)),
        Some(to) if to >= one.from => format!("+{} {unit}", shown(to - one.from)),
        Some(to) => format!("{} {unit}", shown(to - one.from)),
        None => format!("from {} {unit}", shown(one.from)),
    }
}

/// `text` cut to about `width` px, with an ellipsis after what is left of it.
fn cut(text: &str, width: f64) -> String {
    let most = (width / LETTER).max(2.0) as usize;
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().take(most - 1).collect();
    format!("{kept}…")
}
