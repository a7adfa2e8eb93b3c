//! Where labels of places stand so that they hide neither each other nor the part.

use super::canvas::{Canvas, Rect};
use super::palette::Rgb;
use super::text;

pub(crate) const INK: Rgb = [0x1d, 0x27, 0x33];
pub(crate) const SOFT: Rgb = [0x56, 0x62, 0x70];
const PAPER: Rgb = [255; 3];
const CAUTION: Rgb = [0x8a, 0x5a, 0x00];
const SIZE: f32 = 14.0;
const PAD: f32 = 5.0;

/// A place in the picture with what is to be said about it.
pub(crate) struct Label {
    pub(crate) at: [f32; 2],
    pub(crate) text: String,
    /// Its number is not to be trusted.
    pub(crate) doubtful: bool,
    /// It lies behind the part.
    pub(crate) hidden: bool,
}

/// Draws labels inside `room`; `covered` tells where the part is.
pub(crate) fn draw(canvas: &mut Canvas, labels: &[Label], room: Rect, covered: &dyn Fn(f32, f32) -> bool) {
    let mut boxes: Vec<Rect> = Vec::new();
    for label in labels {
        let place = best_place(label, &boxes, labels, room, covered);
        boxes.push(place);
    }
    for (label, place) in labels.iter().zip(&boxes) {
        leader(canvas, label, *place);
    }
    for (label, place) in labels.iter().zip(boxes) {
        plate(canvas, label, place);
    }
}

/// The dearest word first: on the picture, off the other labels, off their places, off the part, near.
fn best_place(label: &Label, taken: &[Rect], labels: &[Label], room: Rect, covered: &dyn Fn(f32, f32) -> bool) -> Rect {
    let size = [text::width(&label.text, SIZE) + 2.0 * PAD, SIZE + 2.0 * PAD];
    let cost = |place: &Rect| {
        let area = size[0] * size[1];
        let outside = area - place.overlap(room);
        let over: f32 = taken.iter().map(|other| place.grown(3.0).overlap(*other)).sum();
        let dots = labels.iter().filter(|other| dot_box(other.at).overlap(*place) > 0.0).count();
        let hidden = share_covered(*place, covered);
        let [x, y] = place.middle();
        let far = (x - label.at[0]).hypot(y - label.at[1]);
        10.0 * outside / area + 8.0 * over / area + 3.0 * dots as f32 + 1.5 * hidden + far / 300.0
    };
    let places = candidates(label.at, size);
    places.into_iter().min_by(|a, b| cost(a).total_cmp(&cost(b))).unwrap_or(Rect {
        x: label.at[0],
        y: label.at[1],
        width: size[0],
        height: size[1],
    })
}

fn dot_box(at: [f32; 2]) -> Rect {
    Rect { x: at[0] - 5.0, y: at[1] - 5.0, width: 10.0, height: 10.0 }
}

/// Boxes around a place, in 16 directions at several distances.
fn candidates(at: [f32; 2], [width, height]: [f32; 2]) -> Vec<Rect> {
    let around = |distance: f32| {
        (0..16).map(move |k| {
            let (s, c) = (k as f32 * std::f32::consts::TAU / 16.0 - 0.9).sin_cos();
            let middle = [at[0] + c * (distance + 0.5 * width), at[1] + s * (distance + 0.5 * height)];
            Rect { x: middle[0] - 0.5 * width, y: middle[1] - 0.5 * height, width, height }
        })
    };
    [22.0, 45.0, 75.0, 110.0, 160.0, 220.0].into_iter().flat_map(around).collect()
}

fn share_covered(place: Rect, covered: &dyn Fn(f32, f32) -> bool) -> f32 {
    let spots = (0..15).map(|k| {
        let (across, down) = ((k % 5) as f32 / 4.0, (k / 5) as f32 / 2.0);
        covered(place.x + across * place.width, place.y + down * place.height)
    });
    spots.filter(|on| *on).count() as f32 / 15.0
}

fn leader(canvas: &mut Canvas, label: &Label, place: Rect) {
    let end = [label.at[0].clamp(place.x, place.x + place.width), label.at[1].clamp(place.y, place.y + place.height)];
    canvas.line(label.at, end, 3.6, PAPER);
    canvas.line(label.at, end, 1.4, colour(label));
    canvas.disk(
        label.at,
        4.6,
        if label.hidden { PAPER } else { colour(label) },
        if label.hidden { colour(label) } else { PAPER },
    );
}

/// What is not to be trusted stands on hatched ground.
fn plate(canvas: &mut Canvas, label: &Label, place: Rect) {
    canvas.fill(place, PAPER, 0.94);
    if label.doubtful {
        canvas.hatch(place, [0xd9, 0xa6, 0x3a], 0.45);
        canvas.fill(place.grown(-4.0), PAPER, 0.8);
    }
    canvas.rim(place, colour(label));
    canvas.text([place.x + PAD, place.y + PAD + 0.8 * SIZE], SIZE, colour(label), &label.text);
}

fn colour(label: &Label) -> Rgb {
    if label.doubtful { CAUTION } else { INK }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_one_place_stand_apart() {
        let label = |k: usize| Label {
            at: [200.0, 150.0],
            text: format!("bore {k}: 148.2 MPa"),
            doubtful: false,
            hidden: false,
        };
        let labels: Vec<Label> = (0..6).map(label).collect();
        let room = Rect { x: 0.0, y: 0.0, width: 400.0, height: 300.0 };
        let mut boxes: Vec<Rect> = Vec::new();
        for label in &labels {
            let place = best_place(label, &boxes, &labels, room, &|_, _| false);
            assert!(boxes.iter().all(|other| other.overlap(place) == 0.0));
            assert!((place.overlap(room) - place.width * place.height).abs() < 0.1);
            boxes.push(place);
        }
    }
}
