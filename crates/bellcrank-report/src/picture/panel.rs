//! One shape of a part in a rectangle of the picture.

use bellcrank_results::{Contour, ContourShape};

use super::axes::Axes;
use super::canvas::{Canvas, Rect};
use super::labels::{self, INK, Label};
use super::palette::{Lookup, NONE, Rgb};
use super::raster::{Corner, Raster, Stroke};
use super::surface::{corner_normals, deformed, nearest};
use super::vector::{V3, bounds, dot, sub, unit};

/// Samples of a pixel, across and down.
const FINE: usize = 2;
/// Marks with a label.
const MOST_MARKS: usize = 12;
/// Where the light comes from: over the reader's left shoulder.
const LAMP: V3 = [-0.42, 0.5, 0.76];
const EDGE: Rgb = [0x10, 0x16, 0x1e];
/// The undeformed part.
const GHOST: Rgb = [0x8d, 0x99, 0xa6];

/// A part as it is to be drawn.
pub(crate) struct Panel<'a> {
    pub(crate) contour: &'a Contour,
    pub(crate) shape: &'a ContourShape,
    /// Values by node, display units; empty where there are none.
    pub(crate) values: &'a [f32],
    pub(crate) colours: Option<&'a Lookup>,
    pub(crate) axes: &'a Axes,
    /// Times the displacement.
    pub(crate) scale: f32,
    /// Sharp edges, for the undeformed part and to set off the deformed one.
    pub(crate) outline: &'a [[u32; 2]],
    pub(crate) marks: bool,
}

/// From the part to samples.
struct Eye<'a> {
    axes: &'a Axes,
    middle: [f32; 2],
    scale: f32,
    size: [f32; 2],
}

impl Eye<'_> {
    fn sees(&self, p: V3) -> V3 {
        let [x, y, z] = turned(self.axes, p);
        let across = self.size[0] / 2.0 + self.scale * (x - self.middle[0]);
        let down = self.size[1] / 2.0 - self.scale * (y - self.middle[1]);
        [across, down, self.scale * z]
    }
}

fn turned(axes: &Axes, p: V3) -> V3 {
    axes.map(|axis| dot(axis, p))
}

impl Panel<'_> {
    /// Draws the part as large as `rect` allows.
    pub(crate) fn draw(&self, canvas: &mut Canvas, rect: Rect) {
        let size = [FINE * rect.width as usize, FINE * rect.height as usize];
        let nodes = deformed(self.contour, self.shape, self.scale);
        let eye = self.eye(&nodes, size.map(|pixels| pixels as f32));
        let places: Vec<V3> = nodes.iter().map(|p| eye.sees(*p)).collect();
        let mut raster = Raster::new(size[0], size[1]);
        self.surface(&mut raster, &nodes, &places);
        let mut ghost = Vec::new();
        if self.scale > 0.0 {
            self.ghost(&mut raster, &eye);
            ghost = std::mem::replace(&mut raster.ink, vec![0; size[0] * size[1]]);
        }
        self.edges(&mut raster, &places);
        self.resolve(canvas, rect, &raster, &ghost);
        if self.marks {
            self.label(canvas, rect, &raster, &places);
        }
    }

    fn eye(&self, nodes: &[V3], size: [f32; 2]) -> Eye<'_> {
        let all = nodes.iter().chain(&self.contour.nodes).map(|p| turned(self.axes, *p));
        let (low, high) = bounds(all).unwrap_or(([-1.0; 3], [1.0; 3]));
        // Labels stand beside the part.
        let room = if self.marks && !self.contour.marks.is_empty() { 0.8 } else { 0.93 };
        let fits = |k: usize| room * size[k] / (high[k] - low[k]).max(1e-12);
        let middle = [0, 1].map(|k| f32::midpoint(low[k], high[k]));
        Eye { axes: self.axes, middle, scale: fits(0).min(fits(1)), size }
    }

    fn surface(&self, raster: &mut Raster, nodes: &[V3], places: &[V3]) {
        let normals = corner_normals(self.contour, nodes);
        for (t, normals) in self.contour.triangles.iter().zip(&normals) {
            let corner = |k: usize| Corner {
                at: places[t[k] as usize],
                value: self.values.get(t[k] as usize).copied().unwrap_or(f32::NAN),
                light: light(turned(self.axes, normals[k])),
            };
            raster.triangle(&[corner(0), corner(1), corner(2)]);
        }
    }

    fn ghost(&self, raster: &mut Raster, eye: &Eye<'_>) {
        let stroke = Stroke { width: FINE, ink: 255, before: 0.0 };
        for [a, b] in self.outline.iter().map(|edge| edge.map(|node| eye.sees(self.contour.nodes[node as usize]))) {
            raster.line(a, b, stroke);
        }
    }

    /// Edges of elements, fainter the denser they are, and the sharp ones.
    fn edges(&self, raster: &mut Raster, places: &[V3]) {
        let ends = |edge: &[u32; 2]| edge.map(|node| places[node as usize]);
        let before = 1.5 * FINE as f32;
        let ink = fade(self.contour.edges.iter().map(ends), FINE as f32);
        if ink > 0 {
            let stroke = Stroke { width: FINE, ink, before };
            self.contour.edges.iter().map(ends).for_each(|[a, b]| raster.line(a, b, stroke));
        }
        let stroke = Stroke { width: FINE, ink: 190, before };
        self.outline.iter().map(ends).for_each(|[a, b]| raster.line(a, b, stroke));
    }

    /// Samples to pixels.
    fn resolve(&self, canvas: &mut Canvas, rect: Rect, raster: &Raster, ghost: &[u8]) {
        for y in 0..raster.height / FINE {
            for x in 0..raster.width / FINE {
                let mut sum = [0.0; 3];
                let mut seen = false;
                for sample in samples(raster.width, x, y) {
                    let colour = self.sample(raster, sample, ghost.get(sample).copied().unwrap_or(0));
                    seen |= colour.is_some();
                    let colour = colour.unwrap_or([255.0; 3]);
                    (0..3).for_each(|k| sum[k] += colour[k]);
                }
                if seen {
                    let mean = sum.map(|total| (total / (FINE * FINE) as f32).round() as u8);
                    canvas.mix(rect.x as i64 + x as i64, rect.y as i64 + y as i64, mean, 1.0);
                }
            }
        }
    }

    /// The colour of a sample; nothing where the paper is bare.
    fn sample(&self, raster: &Raster, sample: usize, ghost: u8) -> Option<[f32; 3]> {
        let part = raster.seen(sample).map(|(value, light)| {
            let colour = self.colours.map_or(NONE, |colours| colours.colour(value));
            colour.map(|c| lit(f32::from(c), light))
        });
        let ink = raster.ink[sample];
        if part.is_none() && ink == 0 && ghost == 0 {
            return None;
        }
        let mut colour = part.unwrap_or([255.0; 3]);
        for (ink, of) in [(ghost, GHOST), (ink, EDGE)] {
            let share = f32::from(ink) / 255.0;
            (0..3).for_each(|k| colour[k] += share * (f32::from(of[k]) - colour[k]));
        }
        Some(colour)
    }

    fn label(&self, canvas: &mut Canvas, rect: Rect, raster: &Raster, places: &[V3]) {
        let marks = &self.contour.marks[..self.contour.marks.len().min(MOST_MARKS)];
        let at: Vec<V3> = marks.iter().map(|mark| mark.at).collect();
        let pixel = |place: V3| [rect.x + place[0] / FINE as f32, rect.y + place[1] / FINE as f32];
        let labels = marks.iter().zip(nearest(self.contour, &at)).map(|(mark, node)| Label {
            at: pixel(places[node]),
            text: mark.label.clone(),
            doubtful: mark.doubtful,
            hidden: raster.hides(places[node], 3.0 * FINE as f32),
        });
        let covered = |x: f32, y: f32| raster.covers((x - rect.x) * FINE as f32, (y - rect.y) * FINE as f32);
        labels::draw(canvas, &labels.collect::<Vec<_>>(), rect, &covered);
    }
}

/// Indices of the samples of a pixel.
fn samples(width: usize, x: usize, y: usize) -> impl Iterator<Item = usize> {
    (0..FINE * FINE).map(move |k| (FINE * y + k / FINE) * width + FINE * x + k % FINE)
}

/// How bright a surface is that stands this way to the reader: colours stay readable.
fn light(normal: V3) -> f32 {
    let facing = if normal[2] < 0.0 { normal.map(|x| -x) } else { normal };
    0.62 + 0.3 * dot(facing, unit(LAMP)).max(0.0) + 0.14 * facing[2]
}

/// A colour under that light; what is brighter than all turns paler.
fn lit(colour: f32, light: f32) -> f32 {
    if light <= 1.0 { colour * light } else { 255.0 - (255.0 - colour) * (2.0 - light) }
}

/// Ink of lines of that length on the picture: none where they would cover it.
fn fade(lines: impl Iterator<Item = [V3; 2]>, pixel: f32) -> u8 {
    let (mut total, mut count) = (0.0, 0.0_f32);
    for [a, b] in lines.filter(|[a, b]| a.iter().chain(b).all(|x| x.is_finite())) {
        let d = sub(a, b);
        total += d[0].hypot(d[1]) / pixel;
        count += 1.0;
    }
    let mean = total / count.max(1.0);
    (130.0 * ((mean - 2.5) / 9.0).clamp(0.0, 1.0)) as u8
}

/// The text of a caption over a panel.
pub(crate) fn caption(canvas: &mut Canvas, rect: Rect, text: &str) {
    canvas.text([rect.x + 6.0, rect.y + 17.0], 15.0, INK, &super::text::fitted(text, 15.0, rect.width - 12.0));
}
