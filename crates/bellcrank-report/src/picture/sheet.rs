//! The whole picture: title, the part in one or several shapes, colour bar, axes.

use bellcrank_results::{Contour, ContourField, ContourShape, Unit};

use super::axes::{Axes, plan, tilted};
use super::bar;
use super::canvas::{Canvas, Rect};
use super::labels::{INK, SOFT};
use super::palette::{Lookup, Rgb};
use super::panel::{Panel, caption};
use super::scale::Scale;
use super::surface::{largest_displacement, outline, usual_scale};
use super::text;
use super::vector::{bounds, dot, length};
use crate::number;

const WIDTH: f32 = 1280.0;
const HEAD: f32 = 74.0;
const MARGIN: f32 = 24.0;
/// Of the colour bar with its numbers.
const BAR: f32 = 190.0;
/// Shapes in one picture.
const MOST: usize = 12;
/// Turn to the right and height from which parts are seen, as the interactive drawing begins.
pub(crate) const TILT: (f32, f32) = (0.34, 0.42);

/// The picture of a contour with a surface.
pub(crate) fn drawn(contour: &Contour) -> Canvas {
    let still = [ContourShape::default()];
    let shapes = if contour.shapes.is_empty() { &still } else { contour.shapes.as_slice() };
    let shown = &shapes[..shapes.len().min(MOST)];
    let fields: Vec<ContourField> = shown.iter().map(|shape| first_field(contour, shape, shown.len() > 1)).collect();
    let scale = Scale::of(&fields.iter().collect::<Vec<_>>());
    let axes = tilted(&plan(contour), TILT.0, TILT.1);
    let grid = Grid::of(shown.len(), flatness(contour, &axes));
    let mut canvas = Canvas::white(WIDTH as usize, grid.height() as usize);
    heading(&mut canvas, contour, shapes, shown.len());
    let colours = scale.as_ref().map(Lookup::new);
    let sharp = outline(contour);
    for (index, (shape, field)) in shown.iter().zip(&fields).enumerate() {
        let values: Vec<f32> = field.values.iter().map(|si| field.unit.show(f64::from(*si)) as f32).collect();
        let panel = Panel {
            contour,
            shape,
            values: &values,
            colours: colours.as_ref(),
            axes: &axes,
            scale: usual_scale(contour, shape),
            outline: &sharp,
            marks: shown.len() == 1,
        };
        let cell = grid.cell(index);
        panel.draw(&mut canvas, cell);
        if shown.len() > 1 {
            caption(&mut canvas, cell, &shape.name);
        }
    }
    triad(&mut canvas, &axes);
    if let Some(scale) = &scale {
        // The axes stand below.
        let height = (canvas.height as f32 - HEAD - 90.0).min(600.0);
        bar::draw(&mut canvas, scale, Rect { x: WIDTH - BAR, y: HEAD, width: BAR - 10.0, height }, &notes(scale));
    }
    canvas
}

/// The fields of a shape; how far it moves where it has none.
pub(crate) fn fields(contour: &Contour, shape: &ContourShape) -> Vec<ContourField> {
    if shape.fields.is_empty() { vec![movement(contour, shape)] } else { shape.fields.clone() }
}

/// The field that is shown first; how far it moves where there is none. Of shapes of arbitrary size beside each
/// other each is shown against its own largest value.
fn first_field(contour: &Contour, shape: &ContourShape, several: bool) -> ContourField {
    let field = shape.fields.first().cloned().unwrap_or_else(|| movement(contour, shape));
    if !(several && shape.swings) {
        return field;
    }
    let most = field.values.iter().filter(|v| v.is_finite()).fold(0.0_f32, |most, v| most.max(v.abs()));
    let share = |value: &f32| if most > 0.0 { value / most } else { 0.0 };
    let values = field.values.iter().map(share).collect();
    ContourField { name: format!("{} / its largest", field.name), unit: Unit::one(), values, ceiling: None }
}

fn movement(contour: &Contour, shape: &ContourShape) -> ContourField {
    let most = largest_displacement(shape);
    let values = if most > 0.0 {
        shape.displacement.iter().map(|u| length(*u) / most).collect()
    } else {
        vec![f32::NAN; contour.nodes.len()]
    };
    ContourField { name: "displacement / its largest".to_owned(), unit: Unit::one(), values, ceiling: None }
}

/// Height over width of the part as it is seen.
fn flatness(contour: &Contour, axes: &Axes) -> f32 {
    let seen = contour.nodes.iter().map(|p| axes.map(|axis| dot(axis, *p)));
    bounds(seen).map_or(1.0, |(low, high)| (high[1] - low[1]) / (high[0] - low[0]).max(1e-12))
}

/// Panels beside and below each other.
struct Grid {
    across: usize,
    down: usize,
    /// Height of a cell over its width.
    flat: f32,
}

impl Grid {
    fn of(count: usize, flatness: f32) -> Self {
        let across = (1..).find(|n| n * n >= count).unwrap_or(1);
        let down = count.div_ceil(across);
        // As high as the colour bar needs.
        let least = 0.42 * across as f32 / down as f32;
        let flat = if count == 1 { 0.68 } else { (flatness + 0.2).clamp(least, least.max(0.8)) };
        Self { across, down, flat }
    }

    fn size(&self) -> (f32, f32) {
        let width = ((WIDTH - BAR - 2.0 * MARGIN) / self.across as f32).floor();
        (width, (width * self.flat).floor())
    }

    fn height(&self) -> f32 {
        HEAD + self.size().1 * self.down as f32 + MARGIN
    }

    fn cell(&self, index: usize) -> Rect {
        let (width, height) = self.size();
        let (column, row) = (index % self.across, index / self.across);
        Rect { x: MARGIN + width * column as f32, y: HEAD + height * row as f32, width, height }
    }
}

fn heading(canvas: &mut Canvas, contour: &Contour, shapes: &[ContourShape], shown: usize) {
    let room = WIDTH - 2.0 * MARGIN;
    canvas.text([MARGIN, 34.0], 21.0, INK, &text::fitted(&contour.title, 21.0, room));
    canvas.text([MARGIN, 59.0], 15.0, SOFT, &text::fitted(&below(contour, shapes, shown), 15.0, room));
}

/// Which shape, how much deformed.
fn below(contour: &Contour, shapes: &[ContourShape], shown: usize) -> String {
    let first = &shapes[0];
    let some = if shown < shapes.len() { format!("first {shown} of {} shapes", shapes.len()) } else { String::new() };
    let name = if shapes.len() == 1 { first.name.clone() } else { some };
    let parts = [name, deformation(contour, &shapes[..shown]), undeformed(shapes)];
    parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" · ")
}

fn undeformed(shapes: &[ContourShape]) -> String {
    let moves = shapes.iter().any(|shape| largest_displacement(shape) > 0.0);
    if moves { "grey lines: undeformed".to_owned() } else { String::new() }
}

/// `deformation × 120`.
fn deformation(contour: &Contour, shapes: &[ContourShape]) -> String {
    if shapes.iter().all(|shape| largest_displacement(shape) <= 0.0) {
        return String::new();
    }
    if shapes.iter().any(|shape| shape.swings) {
        return "deformation of arbitrary size".to_owned();
    }
    let scales: Vec<f32> = shapes.iter().map(|shape| usual_scale(contour, shape)).collect();
    let text = |scale: f32| number::alone(f64::from(scale));
    match scales.as_slice() {
        [one] if *one == 1.0 => "deformation true to scale".to_owned(),
        [one, rest @ ..] if rest.iter().all(|scale| scale == one) => format!("deformation × {}", text(*one)),
        all => format!("deformation × {}", all.iter().map(|scale| text(*scale)).collect::<Vec<_>>().join(", ")),
    }
}

/// Least and largest value, and what stands for what has no number.
fn notes(scale: &Scale) -> Vec<String> {
    vec![format!("largest {}", scale.text(scale.most)), format!("least {}", scale.text(scale.least))]
}

/// The body's axes, below the bar.
fn triad(canvas: &mut Canvas, axes: &Axes) {
    const COLOURS: [(Rgb, &str); 3] = [([0xb3, 0x26, 0x1e], "x"), ([0x12, 0x80, 0x5c], "y"), ([0x0b, 0x5f, 0xa5], "z")];
    let foot = [WIDTH - BAR + 40.0, canvas.height as f32 - 40.0];
    let mut order = [0, 1, 2];
    order.sort_by(|a, b| axes[2][*a].total_cmp(&axes[2][*b]));
    for k in order {
        let along = [axes[0][k], -axes[1][k]];
        let tip = [foot[0] + 30.0 * along[0], foot[1] + 30.0 * along[1]];
        let (colour, name) = COLOURS[k];
        canvas.line(foot, tip, 2.4, colour);
        let beyond = [foot[0] + 41.0 * along[0] - 4.0, foot[1] + 41.0 * along[1] + 4.0];
        canvas.text(beyond, 13.0, colour, name);
    }
}
