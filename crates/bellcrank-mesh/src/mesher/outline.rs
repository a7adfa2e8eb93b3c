//! Edges of the plan divided by the size field.

use bellcrank_solid::Curve;

use super::MesherError;
use super::field::Field;
use super::plan::Plan;

/// A piece of an edge: the side of a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    pub(super) ends: [u32; 2],
    /// Place among the kept edges of the plan; the segment runs as it does.
    pub(super) edge: usize,
    /// Its middle on the edge.
    pub(super) middle: [f64; 2],
}

/// Divided edges.
pub(super) struct Outline {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) segments: Vec<Segment>,
}

/// Steps of the integral of 1/size along an edge.
const STEPS: usize = 64;
/// Rounds of halving arcs whose chords cut into something.
const ROUNDS: usize = 16;

pub(super) fn divide(plan: &Plan, field: &Field) -> Result<Outline, MesherError> {
    let mut cuts: Vec<Vec<f64>> = (0..plan.edges.len()).map(|edge| fractions(plan, field, edge)).collect();
    for _ in 0..ROUNDS {
        let outline = build(plan, &cuts);
        let bad = collisions(plan, &outline)?;
        if bad.is_empty() {
            return Ok(outline);
        }
        for segment in bad {
            halve(plan, &outline, segment, &mut cuts);
        }
    }
    let outline = build(plan, &cuts);
    let bad = collisions(plan, &outline)?;
    match bad.first() {
        None => Ok(outline),
        Some(&segment) => Err(MesherError::Crossing(outline.segments[segment].middle)),
    }
}

/// How many pieces an edge is divided into.
pub(super) fn pieces(plan: &Plan, field: &Field, edge: usize) -> usize {
    (cumulative(plan, field, edge)[STEPS] - 0.1).ceil().max(1.0) as usize
}

/// ∫ ds / size from the beginning of an edge to each step.
fn cumulative(plan: &Plan, field: &Field, edge: usize) -> [f64; STEPS + 1] {
    let step = plan.length(edge) / STEPS as f64;
    let mut sums = [0.0; STEPS + 1];
    for k in 0..STEPS {
        let middle = plan.at(edge, (k as f64 + 0.5) / STEPS as f64);
        sums[k + 1] = sums[k] + step / field.at(middle);
    }
    sums
}

/// Where an edge is cut, from 0 to 1.
fn fractions(plan: &Plan, field: &Field, edge: usize) -> Vec<f64> {
    let sums = cumulative(plan, field, edge);
    let count = pieces(plan, field, edge);
    let mut cuts = vec![0.0];
    for piece in 1..count {
        let target = sums[STEPS] * piece as f64 / count as f64;
        let k = sums.partition_point(|&sum| sum < target).clamp(1, STEPS);
        let within = (target - sums[k - 1]) / (sums[k] - sums[k - 1]);
        cuts.push((k as f64 - 1.0 + within) / STEPS as f64);
    }
    cuts.push(1.0);
    cuts
}

fn build(plan: &Plan, cuts: &[Vec<f64>]) -> Outline {
    let mut outline = Outline { points: Vec::new(), segments: Vec::new() };
    let mut corners = std::collections::HashMap::new();
    for (edge, cuts) in cuts.iter().enumerate() {
        let [first, last] = plan.edge(edge).ends.map(|end| {
            *corners.entry(end).or_insert_with(|| {
                outline.points.push(plan.stack.vertices[end]);
                outline.points.len() as u32 - 1
            })
        });
        let mut from = first;
        for (k, pair) in cuts.windows(2).enumerate() {
            let to = if k + 2 == cuts.len() {
                last
            } else {
                outline.points.push(plan.at(edge, pair[1]));
                outline.points.len() as u32 - 1
            };
            let middle = plan.at(edge, (pair[0] + pair[1]) / 2.0);
            outline.segments.push(Segment { ends: [from, to], edge, middle });
            from = to;
        }
    }
    outline
}

/// Cuts the piece of an edge that a segment is in two.
fn halve(plan: &Plan, outline: &Outline, segment: usize, cuts: &mut [Vec<f64>]) {
    let edge = outline.segments[segment].edge;
    let first = outline.segments.iter().position(|other| other.edge == edge).unwrap_or(segment);
    let piece = segment - first;
    // Several pieces of one edge may be cut in a round: find this one again by its middle.
    let middle = outline.segments[segment].middle;
    let gap = |pair: &[f64]| {
        let at = plan.at(edge, (pair[0] + pair[1]) / 2.0);
        (at[0] - middle[0]).hypot(at[1] - middle[1])
    };
    let nearest = cuts[edge].windows(2).enumerate().min_by(|(_, a), (_, b)| gap(a).total_cmp(&gap(b)));
    let place = nearest.map_or(piece, |(place, _)| place);
    let half = (cuts[edge][place] + cuts[edge][place + 1]) / 2.0;
    cuts[edge].insert(place + 1, half);
}

/// Arc segments whose chord meets another segment, or that have a point between chord and arc.
fn collisions(plan: &Plan, outline: &Outline) -> Result<Vec<usize>, MesherError> {
    let place = |point: u32| outline.points[point as usize];
    let low = |s: usize| {
        let [a, b] = outline.segments[s].ends.map(place);
        a[0].min(b[0]).min(outline.segments[s].middle[0])
    };
    let high = |s: usize| {
        let [a, b] = outline.segments[s].ends.map(place);
        a[0].max(b[0]).max(outline.segments[s].middle[0])
    };
    let mut order: Vec<usize> = (0..outline.segments.len()).collect();
    order.sort_by(|&a, &b| low(a).total_cmp(&low(b)));
    let mut bad = std::collections::BTreeSet::new();
    for (k, &s) in order.iter().enumerate() {
        let reach = high(s);
        for &t in order[k + 1..].iter().take_while(|&&t| low(t) <= reach) {
            let (a, b) = (&outline.segments[s], &outline.segments[t]);
            let cross = crossing(a.ends.map(place), b.ends.map(place), a.ends.iter().any(|end| b.ends.contains(end)));
            for (arc, other) in [(s, t), (t, s)] {
                if cross && is_arc(plan, outline, arc) || swallows(plan, outline, arc, other) {
                    bad.insert(arc);
                }
            }
            if cross && !is_arc(plan, outline, s) && !is_arc(plan, outline, t) {
                return Err(MesherError::Crossing(a.middle));
            }
        }
    }
    Ok(bad.into_iter().collect())
}

fn is_arc(plan: &Plan, outline: &Outline, segment: usize) -> bool {
    matches!(plan.edge(outline.segments[segment].edge).curve, Curve::Arc { .. })
}

fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether two chords meet elsewhere than in a common end.
fn crossing([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2], joined: bool) -> bool {
    !joined && cross(a, b, c) * cross(a, b, d) < 0.0 && cross(c, d, a) * cross(c, d, b) < 0.0
}

/// Whether an end of another segment lies between an arc segment's chord and its arc.
fn swallows(plan: &Plan, outline: &Outline, arc: usize, other: usize) -> bool {
    let segment = &outline.segments[arc];
    let Curve::Arc { center, radius, .. } = &plan.edge(segment.edge).curve else { return false };
    let [a, b] = segment.ends.map(|end| outline.points[end as usize]);
    let side = cross(a, b, segment.middle);
    outline.segments[other].ends.iter().filter(|end| !segment.ends.contains(end)).any(|&end| {
        let p = outline.points[end as usize];
        let inside = (p[0] - center[0]).hypot(p[1] - center[1]) < radius * (1.0 - 1e-9);
        inside && cross(a, b, p) * side > 0.0
    })
}
