//! Outlines cut at each other: vertices and the pieces of curves between them. Decisions in `f64`.

use std::collections::HashMap;

use super::crossing::crossings;
use super::segment::Segment;
use super::vector::{Point, distance, sub};
use crate::Curve;

/// Where a vertex comes from.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Origin {
    /// An end (0 or 1) of a segment.
    End(usize, usize),
    /// The place where two segments meet.
    Meeting(usize, usize),
}

/// A piece of one or several segments that run together.
#[derive(Clone, Debug)]
pub(crate) struct Strand {
    /// Vertices at its ends.
    pub(crate) ends: [usize; 2],
    /// Tangent of a quarter of the angle it runs through, positive counter-clockwise: its form between the ends.
    pub(crate) bulge: f64,
    /// The segments it is a piece of, and whether they run the same way.
    pub(crate) sources: Vec<(usize, bool)>,
}

/// Vertices and strands that meet only there.
pub(crate) struct Arrangement {
    pub(crate) vertices: Vec<Point<f64>>,
    pub(crate) origins: Vec<Origin>,
    pub(crate) strands: Vec<Strand>,
}

/// Cuts segments at each other. Places nearer than the tolerance are one.
pub(crate) fn arrange(segments: &[Segment<f64>], tolerance: f64) -> Arrangement {
    let mut places = Places { vertices: Vec::new(), origins: Vec::new(), grid: HashMap::new(), tolerance };
    let mut ends = Vec::new();
    for (i, segment) in segments.iter().enumerate() {
        ends.push([0, 1].map(|end| places.add(segment.ends[end], Origin::End(i, end))));
    }
    for (i, j) in near_pairs(segments, tolerance) {
        for p in crossings(&segments[i], &segments[j], tolerance) {
            places.add(p, Origin::Meeting(i, j));
        }
    }
    let strands = strands(segments, &ends, &places.vertices, tolerance);
    Arrangement { vertices: places.vertices, origins: places.origins, strands }
}

/// Vertices so far, found again by the square of a grid they lie in.
struct Places {
    vertices: Vec<Point<f64>>,
    origins: Vec<Origin>,
    grid: HashMap<[i64; 2], Vec<usize>>,
    tolerance: f64,
}

impl Places {
    /// The vertex at a place, new where none is near.
    fn add(&mut self, p: Point<f64>, origin: Origin) -> usize {
        let square = p.map(|x| (x / self.tolerance / 4.0).floor() as i64);
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [i, j]));
        let known = around
            .filter_map(|d| self.grid.get(&[square[0].saturating_add(d[0]), square[1].saturating_add(d[1])]))
            .flatten()
            .find(|v| distance(self.vertices[**v], p) <= self.tolerance);
        if let Some(known) = known {
            return *known;
        }
        self.grid.entry(square).or_default().push(self.vertices.len());
        self.vertices.push(p);
        self.origins.push(origin);
        self.vertices.len() - 1
    }
}

/// Pairs of segments whose boxes overlap.
fn near_pairs(segments: &[Segment<f64>], tolerance: f64) -> Vec<(usize, usize)> {
    let boxes: Vec<_> = segments.iter().map(|s| s.bounds(tolerance)).collect();
    let apart = |i: usize, j: usize| (0..2).any(|k| boxes[i][1][k] < boxes[j][0][k] || boxes[j][1][k] < boxes[i][0][k]);
    let pairs = (0..segments.len()).flat_map(|i| (i + 1..segments.len()).map(move |j| (i, j)));
    pairs.filter(|(i, j)| !apart(*i, *j)).collect()
}

/// Each segment cut at every vertex that lies on it; pieces that run together become one.
fn strands(segments: &[Segment<f64>], ends: &[[usize; 2]], vertices: &[Point<f64>], tolerance: f64) -> Vec<Strand> {
    let mut strands: Vec<Strand> = Vec::new();
    let mut between: HashMap<[usize; 2], Vec<usize>> = HashMap::new();
    for (i, segment) in segments.iter().enumerate() {
        let stops = stops(segment, ends[i], vertices, tolerance);
        for (a, b) in stops.iter().zip(stops.iter().skip(1)).filter(|(a, b)| a != b) {
            let bulge = bulge(segment, vertices[*a], vertices[*b]);
            let forward = a < b;
            let (ends, bulge) = if forward { ([*a, *b], bulge) } else { ([*b, *a], -bulge) };
            let chord = distance(vertices[*a], vertices[*b]);
            let known = between.entry(ends).or_default();
            // Sagittas differ by half the chord times the difference of bulges.
            let same = known.iter().find(|s| (strands[**s].bulge - bulge).abs() * chord / 2.0 <= 10.0 * tolerance);
            match same {
                Some(s) => strands[*s].sources.push((i, forward)),
                None => {
                    known.push(strands.len());
                    strands.push(Strand { ends, bulge, sources: vec![(i, forward)] });
                }
            }
        }
    }
    strands
}

/// Vertices on a segment in the order along it, its ends first and last: chains of outlines stay closed.
fn stops(segment: &Segment<f64>, ends: [usize; 2], vertices: &[Point<f64>], tolerance: f64) -> Vec<usize> {
    let [low, high] = segment.bounds(tolerance);
    let near = |p: &Point<f64>| (0..2).all(|k| p[k] >= low[k] && p[k] <= high[k]);
    let on = vertices.iter().enumerate().filter(|(_, p)| near(p) && segment.holds(**p, tolerance));
    let inner = on.filter(|(v, _)| !ends.contains(v)).map(|(v, p)| (segment.along(*p), v));
    let mut inner: Vec<(f64, usize)> = inner.filter(|(along, _)| *along > 0.0 && *along < segment.length()).collect();
    inner.sort_by(|a, b| a.0.total_cmp(&b.0));
    [ends[0]].into_iter().chain(inner.into_iter().map(|(_, v)| v)).chain([ends[1]]).collect()
}

/// Bulge of the piece of a segment between two places on it.
fn bulge(segment: &Segment<f64>, a: Point<f64>, b: Point<f64>) -> f64 {
    match &segment.curve {
        Curve::Line => 0.0,
        Curve::Arc { center, .. } => {
            let (u, v) = (sub(a, *center), sub(b, *center));
            let angle = (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1]);
            (angle / 4.0).tan()
        }
    }
}
