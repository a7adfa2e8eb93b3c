//! Re-entrant corners of what is joined, rounded layer by layer.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use bellcrank_math::Real;

use super::layout::{Filling, Layout};
use super::recipe::{Kind, Recipe};
use crate::plane::crossing::{circle_circle, line_circle};
use crate::plane::faces::{Half, fans};
use crate::plane::outline::Outline;
use crate::plane::segment::{Segment, arcs, meet, sweep};
use crate::plane::vector::{Point, add, cross, distance, dot, left, scale, sub, unit, values, wrap};
use crate::{Curve, Fault, Part};

/// Corners flatter than this (rad) are left as they are: what a fillet would add there is shorter than it is useful.
const FLAT: f64 = 0.02;

/// Outline of what a fillet adds, and what it needs of the curves at its corner.
struct Fillet<T> {
    outline: Outline<T>,
    needed: [f64; 2],
}

/// Adds the fillets of all layers to a recipe. `layout` is the recipe's so far.
pub(crate) fn add_fillets<T: Real>(
    recipe: &mut Recipe<T>,
    layout: &Layout<T>,
    radius: T,
    tolerance: f64,
) -> Vec<Fault> {
    let filling = Filling { pieces: &recipe.pieces, levels: &layout.levels, joined_only: true };
    let mut faults = Vec::new();
    let mut found = Vec::new();
    for interval in 0..layout.levels.count() {
        let layer = Layer::new(layout, &filling, interval);
        let (fillets, wrong) = layer.fillets(radius, tolerance);
        faults.extend(wrong);
        found.extend(fillets.into_iter().map(|outline| (interval, outline)));
    }
    for (interval, outline) in found {
        let ends = [interval, interval + 1].map(|level| Some(layout.levels.heights[level]));
        let outline = recipe.outline(outline);
        recipe.piece(Kind::Joined(Part::Fillet), outline, vec![ends]);
    }
    faults
}

/// Boundary of what is joined in one interval.
struct Layer<'a, T> {
    layout: &'a Layout<T>,
    interval: [f64; 2],
    /// For each strand that bounds, a segment it is a piece of, run as the strand.
    whole: BTreeMap<usize, Segment<T>>,
    /// Bounding half-strands that leave each vertex, counter-clockwise.
    fans: Vec<Vec<Half>>,
    full: Vec<bool>,
}

/// The bounding strands from a corner as far as they follow one curve.
struct Run {
    /// First and last strand, smaller number first: the same from both ends.
    key: [usize; 2],
    length: f64,
}

/// A corner between two curves, with nothing between them; half-strands leave it.
struct Corner {
    vertex: usize,
    /// The one that the empty sector begins at, counter-clockwise, and the one it ends at.
    halves: [Half; 2],
}

impl<'a, T: Real> Layer<'a, T> {
    fn new(layout: &'a Layout<T>, filling: &Filling<T>, interval: usize) -> Self {
        let full: Vec<bool> = layout.within.iter().map(|bits| filling.filled(bits, interval)).collect();
        let side = |cell: Option<usize>| full[cell.unwrap_or(full.len() - 1)];
        let bounds = |strand: &usize| {
            let [l, r] = layout.faces.sides[*strand].map(side);
            l != r
        };
        let strands = (0..layout.arcs.len()).filter(bounds);
        let whole: BTreeMap<_, _> = strands.map(|s| (s, layout.source(filling.owner(layout, s, interval)))).collect();
        let mut fans = fans(&layout.plane.vertices, &layout.arcs);
        fans.iter_mut().for_each(|fan| fan.retain(|(strand, _)| whole.contains_key(strand)));
        let interval = [interval, interval + 1].map(|level| layout.levels.heights[level].value());
        Layer { layout, interval, whole, fans, full }
    }

    /// Outlines that round the re-entrant corners, and corners where that does not fit.
    fn fillets(&self, radius: T, tolerance: f64) -> (Vec<Outline<T>>, Vec<Fault>) {
        let mut uses: BTreeMap<[usize; 2], (f64, f64, usize)> = BTreeMap::new();
        let (mut outlines, mut faults) = (Vec::new(), Vec::new());
        let fault = |vertex: usize, needed: f64, length: f64| Fault::FilletTooLarge {
            at: self.layout.plane.vertices[vertex],
            layer: self.interval,
            radius: radius.value(),
            needed,
            length,
        };
        for corner in self.corners() {
            let runs = corner.halves.map(|half| self.run(half, tolerance));
            let Some(fillet) = self.fillet(&corner, radius, tolerance) else {
                faults.push(fault(corner.vertex, f64::INFINITY, runs[0].length.min(runs[1].length)));
                continue;
            };
            for (run, needed) in runs.iter().zip(fillet.needed) {
                let used = uses.entry(run.key).or_insert((0.0, run.length, corner.vertex));
                used.0 += needed;
            }
            outlines.push(fillet.outline);
        }
        let short = uses.values().filter(|(needed, length, _)| *needed > length + tolerance);
        faults.extend(short.map(|(needed, length, vertex)| fault(*vertex, *needed, *length)));
        (outlines, faults)
    }

    /// Corners with more than half a turn of material.
    fn corners(&self) -> Vec<Corner> {
        let mut corners = Vec::new();
        for (vertex, fan) in self.fans.iter().enumerate() {
            for (a, b) in fan.iter().zip(fan.iter().cycle().skip(1)) {
                let beside = self.layout.faces.sides[a.0][usize::from(!a.1)];
                let empty = !self.full[beside.unwrap_or(self.full.len() - 1)];
                if empty && self.opening(*a, *b) < PI - FLAT {
                    corners.push(Corner { vertex, halves: [*a, *b] });
                }
            }
        }
        corners
    }

    /// Angle from one half-strand counter-clockwise to another: in [0, 2 pi], both ends for tangent ones.
    fn opening(&self, a: Half, b: Half) -> f64 {
        let angle = self.tangent(b) - self.tangent(a);
        if wrap(angle).abs() > 1e-3 {
            return angle.rem_euclid(TAU);
        }
        // From one direction, the one that curves more to the left is the one that a cusp ends at.
        if self.curvature(b) > self.curvature(a) { 0.0 } else { TAU }
    }

    /// Curvature of a half-strand as it leaves its vertex, positive to the left.
    fn curvature(&self, (strand, forward): Half) -> f64 {
        let arc = self.layout.arcs[strand];
        let [a, b] = arc.ends.map(|v| self.layout.plane.vertices[v]);
        let leftward = 2.0 * (arc.angle() / 2.0).sin() / distance(a, b);
        if forward { leftward } else { -leftward }
    }

    /// Direction in which a half-strand leaves its vertex.
    fn tangent(&self, (strand, forward): Half) -> f64 {
        let arc = self.layout.arcs[strand];
        let [a, b] = arc.ends.map(|v| self.layout.plane.vertices[v]);
        let along = if forward { sub(b, a) } else { sub(a, b) };
        let turn = if forward { arc.angle() } else { -arc.angle() };
        along[1].atan2(along[0]) - turn / 2.0
    }

    /// The segment of a half-strand, run away from its vertex.
    fn outward(&self, (strand, forward): Half) -> Option<Segment<T>> {
        let whole = self.whole.get(&strand)?;
        Some(if forward { whole.clone() } else { whole.reversed() })
    }

    fn run(&self, start: Half, tolerance: f64) -> Run {
        let (mut half, mut length) = (start, 0.0);
        while let Some(whole) = self.outward(half).map(|s| s.values()) {
            let [a, b] = self.ends(half);
            let ends = [a, b].map(|v| self.layout.plane.vertices[v]);
            length += Segment { ends, curve: whole.curve.clone() }.length();
            let [x, y] = self.fans[b][..] else { break };
            let onward = if x == (half.0, !half.1) { y } else { x };
            let same = self.outward(onward).is_some_and(|s| same(&whole, &s.values(), tolerance));
            if !same || onward.0 == start.0 {
                break;
            }
            half = onward;
        }
        Run { key: [start.0.min(half.0), start.0.max(half.0)], length }
    }

    fn ends(&self, (strand, forward): Half) -> [usize; 2] {
        let [a, b] = self.layout.arcs[strand].ends;
        if forward { [a, b] } else { [b, a] }
    }

    /// The arc that touches both curves at a corner, and what is between; `None` where there is none.
    fn fillet(&self, corner: &Corner, radius: T, tolerance: f64) -> Option<Fillet<T>> {
        let at = self.layout.plane.vertices[corner.vertex];
        let [a, b] = [self.outward(corner.halves[0])?, self.outward(corner.halves[1])?];
        // Run away from the corner, the empty sector is left of the first curve and right of the second.
        let plain = [a.values(), b.values()];
        let r = radius.value();
        let centers = meetings(&plain[0], r, &plain[1], -r, tolerance);
        let needed = |center: &Point<f64>| {
            let lengths = [0, 1].map(|i| ahead(&plain[i], at, plain[i].foot(*center), tolerance));
            Some([lengths[0]?, lengths[1]?])
        };
        let fits = centers.into_iter().filter_map(|c| needed(&c).map(|n| (c, n)));
        let (near, needed) = fits.min_by(|x, y| (x.1[0] + x.1[1]).total_cmp(&(y.1[0] + y.1[1])))?;
        let center = meet([&a, &b], [radius, -radius], near);
        let tip = meet([&a, &b], [T::zero(); 2], at);
        let feet = [a.foot(center), b.foot(center)];
        let round = sweep(values(center), values(feet[1]), values(feet[0]), true);
        let round = if round > PI { round - TAU } else { round };
        let mut outline = piece(&a, tip, feet[0]);
        outline.extend(arcs(center, radius, feet[0], feet[1], -round));
        outline.extend(piece(&b, tip, feet[1]).iter().rev().map(Segment::reversed));
        Some(Fillet { outline, needed })
    }
}

/// Whether two segments are pieces of one line or circle.
fn same(a: &Segment<f64>, b: &Segment<f64>, tolerance: f64) -> bool {
    match (&a.curve, &b.curve) {
        (Curve::Line, Curve::Line) => b.ends.iter().all(|p| a.offset(*p).0.abs() <= 4.0 * tolerance),
        (Curve::Arc { center, radius, .. }, Curve::Arc { center: other, radius: size, .. }) => {
            distance(*center, *other) <= 4.0 * tolerance && (radius - size).abs() <= 4.0 * tolerance
        }
        _ => false,
    }
}

/// Places at distances to the left of two curves.
fn meetings(a: &Segment<f64>, to_a: f64, b: &Segment<f64>, to_b: f64, tolerance: f64) -> Vec<Point<f64>> {
    match (moved(a, to_a), moved(b, to_b)) {
        (Some(Moved::Line(p, q)), Some(Moved::Line(v, w))) => {
            let (d, e) = (unit(sub(q, p)), unit(sub(w, v)));
            let sine = cross(d, e);
            if sine.abs() < 1e-9 { Vec::new() } else { vec![add(p, scale(d, cross(sub(v, p), e) / sine))] }
        }
        (Some(Moved::Line(p, q)), Some(Moved::Circle(c, r))) | (Some(Moved::Circle(c, r)), Some(Moved::Line(p, q))) => {
            line_circle([p, q], c, r, tolerance)
        }
        (Some(Moved::Circle(c, r)), Some(Moved::Circle(d, s))) => circle_circle((c, r), (d, s), tolerance),
        _ => Vec::new(),
    }
}

enum Moved {
    Line(Point<f64>, Point<f64>),
    Circle(Point<f64>, f64),
}

/// A curve moved to its left; `None` for a circle that would have no radius left.
fn moved(segment: &Segment<f64>, by: f64) -> Option<Moved> {
    match &segment.curve {
        Curve::Line => {
            let shift = scale(left(unit(sub(segment.ends[1], segment.ends[0]))), by);
            Some(Moved::Line(add(segment.ends[0], shift), add(segment.ends[1], shift)))
        }
        Curve::Arc { center, radius, counter_clockwise } => {
            let r = if *counter_clockwise { radius - by } else { radius + by };
            (r > 0.0).then_some(Moved::Circle(*center, r))
        }
    }
}

/// Length along a curve from one place on it to another less than half a turn ahead; `None` when it is behind.
fn ahead(curve: &Segment<f64>, from: Point<f64>, to: Point<f64>, tolerance: f64) -> Option<f64> {
    match &curve.curve {
        Curve::Line => {
            let length = dot(sub(to, from), unit(sub(curve.ends[1], curve.ends[0])));
            (length > tolerance).then_some(length)
        }
        Curve::Arc { center, radius, counter_clockwise } => {
            let angle = {
                let (u, v) = (sub(from, *center), sub(to, *center));
                let angle = cross(u, v).atan2(dot(u, v));
                if *counter_clockwise { angle } else { -angle }
            };
            (angle * radius > tolerance).then_some(angle * radius)
        }
    }
}

/// The piece of a curve between two places on it, in its direction.
fn piece<T: Real>(curve: &Segment<T>, from: Point<T>, to: Point<T>) -> Outline<T> {
    match &curve.curve {
        Curve::Line => vec![Segment::line(from, to)],
        Curve::Arc { center, radius, counter_clockwise } => {
            let turn = sweep(values(*center), values(from), values(to), *counter_clockwise);
            arcs(*center, *radius, from, to, turn)
        }
    }
}
