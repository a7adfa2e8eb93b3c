//! The colour bar: what the colours mean.

use super::canvas::{Canvas, Rect};
use super::labels::{INK, SOFT};
use super::palette::{ABOVE, Lookup};
use super::scale::Scale;
use super::text;

const WIDTH: f32 = 24.0;
const SIZE: f32 = 14.0;

/// Draws the bar with its numbers inside `room`, upright; `notes` stand below it.
pub(crate) fn draw(canvas: &mut Canvas, scale: &Scale, room: Rect, notes: &[String]) {
    let head = heading(canvas, scale, room);
    let tail = 19.0 * notes.len() as f32 + 16.0;
    let bar = Rect { x: room.x, y: room.y + head, width: WIDTH, height: room.height - head - tail };
    let bar = if scale.is_cut() { above(canvas, scale, bar) } else { bar };
    bands(canvas, scale, bar);
    numbers(canvas, scale, bar);
    for (line, note) in notes.iter().enumerate() {
        let y = room.y + room.height - tail + 26.0 + 19.0 * line as f32;
        canvas.text([room.x, y], 13.0, SOFT, &text::fitted(note, 13.0, room.width));
    }
}

/// What is shown, on as many lines as it takes; gives their height.
fn heading(canvas: &mut Canvas, scale: &Scale, room: Rect) -> f32 {
    let lines = wrapped(&scale.heading(), 15.0, room.width);
    for (line, words) in lines.iter().enumerate() {
        canvas.text([room.x, room.y + 15.0 + 19.0 * line as f32], 15.0, INK, words);
    }
    19.0 * lines.len() as f32 + 12.0
}

/// `text` in lines of that width, broken at spaces.
pub(crate) fn wrapped(words: &str, size: f32, room: f32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match longer.filter(|longer| text::width(longer, size) <= room) {
            Some(longer) => *lines.last_mut().expect("a line was made longer") = longer,
            None => lines.push(text::fitted(word, size, room)),
        }
    }
    lines
}

/// The colour of what lies above the bar; gives what is left of it.
fn above(canvas: &mut Canvas, scale: &Scale, bar: Rect) -> Rect {
    let block = Rect { height: 22.0, ..bar };
    canvas.fill(block, ABOVE, 1.0);
    canvas.rim(block, INK);
    canvas.text([bar.x + WIDTH + 9.0, bar.y + 16.0], SIZE, INK, &format!("above {}", scale.end()));
    Rect { y: bar.y + 36.0, height: bar.height - 36.0, ..bar }
}

fn bands(canvas: &mut Canvas, scale: &Scale, bar: Rect) {
    let lookup = Lookup::new(scale);
    for band in 0..scale.bands() {
        let (from, to) = scale.band(band);
        let (top, bottom) = (height_of(scale, bar, to), height_of(scale, bar, from));
        let colour = lookup.colour(f64::midpoint(from, to) as f32);
        canvas.fill(Rect { y: top, height: bottom - top, ..bar }, colour, 1.0);
    }
    canvas.rim(bar, INK);
}

fn height_of(scale: &Scale, bar: Rect, value: f64) -> f32 {
    let share = (value - scale.low) / (scale.high - scale.low);
    bar.y + bar.height * (1.0 - share as f32)
}

fn numbers(canvas: &mut Canvas, scale: &Scale, bar: Rect) {
    let end = (scale.high, scale.end());
    // A cut end need not be round; its number comes before a neighbour that stands in its way.
    let near = |value: f64| (height_of(scale, bar, value) - bar.y).abs() < 15.0 && value != scale.high;
    let marks = scale.marks.iter().filter(|(value, _)| !(scale.is_cut() && near(*value)));
    let has_end = scale.marks.iter().any(|(value, _)| (value - scale.high).abs() < 1e-9 * scale.step);
    for (value, text) in marks.chain((!has_end).then_some(&end)) {
        let y = height_of(scale, bar, *value);
        canvas.fill(Rect { x: bar.x + WIDTH, y: y - 0.5, width: 5.0, height: 1.0 }, INK, 1.0);
        canvas.text([bar.x + WIDTH + 9.0, y + 0.36 * SIZE], SIZE, INK, text);
    }
}
