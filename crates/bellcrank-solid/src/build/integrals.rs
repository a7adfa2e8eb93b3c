//! Moments of a layout, with derivatives that hold where outlines and layers coincide.
//!
//! Where outlines run together or layers end at one height, which is how links are drawn, the place of a vertex or a
//! level has derivatives of one of them only. Here each piece of the boundary moves as the outline or layer that it
//! belongs to. First derivatives of an integral depend on nothing else.

use bellcrank_math::Real;

use super::layout::{Filling, Layout};
use crate::Curve;
use crate::moments::{Moments, Plane};
use crate::plane::segment::Segment;
use crate::plane::vector::{Point, constant, sub};

/// Moments of what is filled.
pub(crate) fn moments<T: Real>(layout: &Layout<T>, filling: &Filling<T>, middle: Point<f64>) -> Moments<T> {
    let places: Vec<Point<T>> =
        (0..layout.plane.vertices.len()).map(|v| sub(layout.vertex(v), constant(middle))).collect();
    let heights: Vec<f64> = layout.levels.heights.iter().map(|z| z.value()).collect();
    let Some(base) = heights.first() else { return Moments::default() };
    let mut sum = Moments::default();
    for interval in 0..layout.levels.count() {
        let region = region(layout, filling, &places, interval, middle);
        let ends = [interval, interval + 1].map(|level| T::from_f64(heights[level] - base));
        sum.add(&region.between(ends[0], ends[1]), T::one());
    }
    let cells = cells(layout, &places, middle);
    for (level, height) in heights.iter().enumerate() {
        for (cell, plane) in cells.iter().enumerate() {
            let rise = rise(layout, filling, cell, level);
            if !rise.is_zero() {
                sum.add(&plane.at(T::from_f64(height - base)), rise);
            }
        }
    }
    sum.shifted([T::from_f64(middle[0]), T::from_f64(middle[1]), T::from_f64(*base)])
}

/// Integrals over what is filled in an interval.
fn region<T: Real>(
    layout: &Layout<T>,
    filling: &Filling<T>,
    places: &[Point<T>],
    interval: usize,
    middle: Point<f64>,
) -> Plane<T> {
    let full: Vec<bool> = layout.within.iter().map(|bits| filling.filled(bits, interval)).collect();
    let outside = full.len() - 1;
    let mut sum = Plane::default();
    for (i, strand) in layout.plane.strands.iter().enumerate() {
        let [left, right] = layout.faces.sides[i].map(|side| full[side.unwrap_or(outside)]);
        if left == right {
            continue;
        }
        let whole = shifted(layout.source(filling.owner(layout, i, interval)), middle);
        let ends = strand.ends.map(|v| places[v]);
        sum.add(&if left {
            Plane::boundary(&whole, ends)
        } else {
            Plane::boundary(&whole.reversed(), [ends[1], ends[0]])
        });
    }
    sum
}

/// A segment seen from the middle.
fn shifted<T: Real>(segment: Segment<T>, middle: Point<f64>) -> Segment<T> {
    let curve = match segment.curve {
        Curve::Line => Curve::Line,
        Curve::Arc { center, radius, counter_clockwise } => {
            Curve::Arc { center: sub(center, constant(middle)), radius, counter_clockwise }
        }
    };
    Segment { ends: segment.ends.map(|p| sub(p, constant(middle))), curve }
}

/// Integrals over each cell.
fn cells<T: Real>(layout: &Layout<T>, places: &[Point<T>], middle: Point<f64>) -> Vec<Plane<T>> {
    let mut sums = vec![Plane::default(); layout.faces.cells.len()];
    for (i, strand) in layout.plane.strands.iter().enumerate() {
        let whole = shifted(layout.source(strand.sources[0]), middle);
        let ends = strand.ends.map(|v| places[v]);
        let [left, right] = layout.faces.sides[i];
        if let Some(cell) = left {
            sums[cell].add(&Plane::boundary(&whole, ends));
        }
        if let Some(cell) = right {
            sums[cell].add(&Plane::boundary(&whole.reversed(), [ends[1], ends[0]]));
        }
    }
    sums
}

/// How much higher the material of a cell ends at a level than the level's value: nothing but derivatives and what
/// the tolerance took. Negative where the material begins there; zero where nothing changes.
fn rise<T: Real>(layout: &Layout<T>, filling: &Filling<T>, cell: usize, level: usize) -> T {
    let bits = &layout.within[cell];
    let levels = &layout.levels;
    let active =
        |piece: usize, interval: Option<usize>| interval.is_some_and(|i| i < levels.count() && levels.active(piece, i));
    let (below, above) = (level.checked_sub(1), Some(level));
    let full = filling.filled_if(bits, |p| active(p, below));
    if full == filling.filled_if(bits, |p| active(p, above)) {
        return T::zero();
    }
    // The first layer that alone makes the difference, or else the first one that has to do with it.
    let changes: Vec<usize> = (0..filling.pieces.len()).filter(|p| active(*p, below) != active(*p, above)).collect();
    let alone = |p: &&usize| filling.filled_if(bits, |q| active(q, if q == **p { above } else { below })) != full;
    let here = |p: &&usize| filling.pieces[**p].holds(bits);
    let Some(owner) = changes.iter().find(alone).or(changes.iter().find(here)) else { return T::zero() };
    let ends = filling.pieces[*owner].layers.iter().zip(&levels.spans[*owner]);
    let end = ends.flat_map(|(layer, span)| [(layer[0], span[0]), (layer[1], span[1])]).find(|(_, l)| *l == level);
    let height = end.and_then(|(end, _)| end).unwrap_or(levels.heights[level]);
    let rise = height - T::from_f64(levels.heights[level].value());
    if full { rise } else { -rise }
}
