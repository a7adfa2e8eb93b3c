//! Re-entrant corners of what is joined, rounded layer by layer.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use bellcrank_math::Real;

use super::layout::{Filling, Layout};
use super::recipe::{Kind, Recipe};
use crate::plane::faces::{Half, fans};
use crate::plane::outline::Outline;
use crate::plane::segment::{Segment, arcs, meet, sweep};
use crate::plane::tangent::{ahead, meetings, piece, same};
use crate::plane::vector::{Point, distance, sub, values, wrap};
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
    let mut found: Vec<Found<T>> = Vec::new();
    for interval in 0..layout.levels.count() {
        let layer = Layer::new(layout, &filling, interval);
        let (fillets, wrong) = layer.fillets(radius, tolerance);
        wrong.into_iter().for_each(|fault| told_once(&mut faults, fault));
        for (corner, outline) in fillets {
            match found.iter_mut().find(|f| f.levels[1] == interval && f.corner == corner) {
                Some(below) => below.levels[1] = interval + 1,
                None => found.push(Found { corner, outline, levels: [interval, interval + 1] }),
            }
        }
    }
    for fillet in found {
        let ends = fillet.levels.map(|level| Some(layout.levels.heights[level]));
        let outline = recipe.outline(fillet.outline);
        recipe.piece(Kind::Joined(Part::Fillet), outline, vec![ends]);
    }
    faults
}

/// A fillet of one or several layers.
struct Found<T> {
    corner: Corner,
    outline: Outline<T>,
    levels: [usize; 2],
}

/// Adds a fault; that of the same corner one layer below is extended instead.
fn told_once(faults: &mut Vec<Fault>, fault: Fault) {
    let Fault::FilletTooLarge { at, layer, .. } = &fault else { return faults.push(fault) };
    for known in faults.iter_mut() {
        if let Fault::FilletTooLarge { at: place, layer: [_, top], .. } = known
            && place == at
            && *top == layer[0]
        {
            *top = layer[1];
            return;
        }
    }
    faults.push(fault);
}

/// Boundary of what is joined in one interval.
struct Layer<'a, T> {
    layout: &'a Layout<T>,
    interval: [f64; 2],
    /// For each strand that bounds, the segment it is a piece of, and whether it runs as the strand.
    owners: BTreeMap<usize, (usize, bool)>,
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

/// A corner between two curves with nothing between them, or two such corners and what is between them.
#[derive(Clone, Debug, PartialEq)]
struct Corner {
    /// Where the two curves begin: the same vertex, or both ends of what is left out.
    vertices: [usize; 2],
    /// Half-strands that leave them: the empty sector lies left of the first and right of the second.
    halves: [Half; 2],
    /// What is left out, from the first vertex to the second.
    between: Vec<Half>,
    /// Segments that the two half-strands are pieces of.
    owners: [usize; 2],
}

/// How much of a run its two corners need.
struct Use {
    length: f64,
    needed: f64,
    /// The corner it begins at with the empty side on its right, and the one with it on its left.
    corners: [Option<usize>; 2],
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
        let owners: BTreeMap<_, _> = strands.map(|s| (s, filling.owner(layout, s, interval))).collect();
        let mut fans = fans(&layout.plane.vertices, &layout.arcs);
        fans.iter_mut().for_each(|fan| fan.retain(|(strand, _)| owners.contains_key(strand)));
        let interval = [interval, interval + 1].map(|level| layout.levels.heights[level].value());
        Layer { layout, interval, owners, fans, full }
    }

    /// Outlines that round the re-entrant corners, and corners where that does not fit.
    ///
    /// Where two corners need more than there is between them, what is between is left out: the fillet touches the
    /// curves beyond, as a ball would that rolls along the boundary.
    fn fillets(&self, radius: T, tolerance: f64) -> (Vec<(Corner, Outline<T>)>, Vec<Fault>) {
        let mut corners = self.corners();
        loop {
            let fillets: Vec<Option<Fillet<T>>> = corners.iter().map(|c| self.fillet(c, radius, tolerance)).collect();
            let uses = self.uses(&corners, &fillets, tolerance);
            let mut short: Vec<&Use> = uses.values().filter(|u| u.needed > u.length + tolerance).collect();
            short.sort_by(|a, b| a.length.total_cmp(&b.length));
            let pair = short.iter().find_map(|u| match u.corners {
                [Some(x), Some(y)] if x != y => Some([x, y]),
                _ => None,
            });
            if let Some([x, y]) = pair {
                let merged = self.merged(&corners[x], &corners[y], tolerance);
                corners[x] = merged;
                corners.remove(y);
                continue;
            }
            let faults = short.iter().filter_map(|u| {
                let corner = u.corners.iter().flatten().next()?;
                let at = self.layout.plane.vertices[corners[*corner].vertices[0]];
                let (radius, needed, length) = (radius.value(), u.needed, u.length);
                Some(Fault::FilletTooLarge { at, layer: self.interval, radius, needed, length })
            });
            let faults = faults.collect();
            let fit = corners.into_iter().zip(fillets).filter_map(|(c, f)| f.map(|f| (c, f.outline)));
            return (fit.collect(), faults);
        }
    }

    /// What all corners need of the runs between them; everything where no fillet is possible.
    fn uses(&self, corners: &[Corner], fillets: &[Option<Fillet<T>>], tolerance: f64) -> BTreeMap<[usize; 2], Use> {
        let mut uses: BTreeMap<[usize; 2], Use> = BTreeMap::new();
        for (i, (corner, fillet)) in corners.iter().zip(fillets).enumerate() {
            let needed = fillet.as_ref().map_or([f64::INFINITY; 2], |f| f.needed);
            for side in [0, 1] {
                let run = self.run(corner.halves[side], tolerance);
                let used = Use { length: run.length, needed: 0.0, corners: [None; 2] };
                let used = uses.entry(run.key).or_insert(used);
                used.needed += needed[side];
                used.corners[1 - side] = Some(i);
            }
        }
        uses
    }

    /// Two corners as one; the second follows the first along its second half-strand.
    fn merged(&self, first: &Corner, second: &Corner, tolerance: f64) -> Corner {
        let mut between = first.between.clone();
        between.extend(self.walk(first.halves[1], tolerance));
        between.extend(&second.between);
        Corner {
            vertices: [first.vertices[0], second.vertices[1]],
            halves: [first.halves[0], second.halves[1]],
            between,
            owners: [first.owners[0], second.owners[1]],
        }
    }

    /// Corners with more than half a turn of material.
    fn corners(&self) -> Vec<Corner> {
        let mut corners = Vec::new();
        for (vertex, fan) in self.fans.iter().enumerate() {
            for (a, b) in fan.iter().zip(fan.iter().cycle().skip(1)) {
                let beside = self.layout.faces.sides[a.0][usize::from(!a.1)];
                let empty = !self.full[beside.unwrap_or(self.full.len() - 1)];
                if empty && self.opening(*a, *b) < PI - FLAT {
                    let owners = [a, b].map(|half| self.owners.get(&half.0).map_or(0, |owner| owner.0));
                    let (vertices, halves) = ([vertex; 2], [*a, *b]);
                    corners.push(Corner { vertices, halves, between: Vec::new(), owners });
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
        let whole = self.layout.source(*self.owners.get(&strand)?);
        Some(if forward { whole } else { whole.reversed() })
    }

    /// Half-strands from one on, as far as they follow one curve.
    fn walk(&self, start: Half, tolerance: f64) -> Vec<Half> {
        let mut walk = vec![start];
        let mut half = start;
        while let Some(whole) = self.outward(half).map(|s| s.values()) {
            let [x, y] = self.fans[self.ends(half)[1]][..] else { break };
            let onward = if x == (half.0, !half.1) { y } else { x };
            let same = self.outward(onward).is_some_and(|s| same(&whole, &s.values(), tolerance));
            if !same || onward.0 == start.0 {
                break;
            }
            half = onward;
            walk.push(half);
        }
        walk
    }

    fn run(&self, start: Half, tolerance: f64) -> Run {
        let walk = self.walk(start, tolerance);
        let last = walk.last().map_or(start.0, |half| half.0);
        let length = walk.iter().map(|half| self.piece_of(*half).length()).sum();
        Run { key: [start.0.min(last), start.0.max(last)], length }
    }

    /// A half-strand as a segment.
    fn piece_of(&self, half: Half) -> Segment<f64> {
        let ends = self.ends(half).map(|v| self.layout.plane.vertices[v]);
        Segment { ends, curve: self.outward(half).map_or(Curve::Line, |s| s.curve.values()) }
    }

    fn ends(&self, (strand, forward): Half) -> [usize; 2] {
        let [a, b] = self.layout.arcs[strand].ends;
        if forward { [a, b] } else { [b, a] }
    }

    /// The arc that touches both curves at a corner, and what is between; `None` where there is none.
    fn fillet(&self, corner: &Corner, radius: T, tolerance: f64) -> Option<Fillet<T>> {
        let at = corner.vertices.map(|v| self.layout.plane.vertices[v]);
        let [a, b] = [self.outward(corner.halves[0])?, self.outward(corner.halves[1])?];
        // Run away from the corner, the empty sector is left of the first curve and right of the second.
        let plain = [a.values(), b.values()];
        let r = radius.value();
        let centers = meetings(&plain[0], r, &plain[1], -r, tolerance);
        let needed = |center: &Point<f64>| {
            let lengths = [0, 1].map(|i| ahead(&plain[i], at[i], plain[i].foot(*center), tolerance));
            Some([lengths[0]?, lengths[1]?])
        };
        let fits = centers.into_iter().filter_map(|c| needed(&c).map(|n| (c, n)));
        let (near, needed) = fits.min_by(|x, y| (x.1[0] + x.1[1]).total_cmp(&(y.1[0] + y.1[1])))?;
        let center = meet([&a, &b], [radius, -radius], near);
        let [first, last] = corner.vertices.map(|v| self.layout.vertex(v));
        let tips = [a.foot(first), b.foot(last)];
        let feet = [a.foot(center), b.foot(center)];
        let round = sweep(values(center), values(feet[1]), values(feet[0]), true);
        let round = if round > PI { round - TAU } else { round };
        let mut outline = piece(&a, tips[0], feet[0]);
        outline.extend(arcs(center, radius, feet[0], feet[1], -round));
        outline.extend(piece(&b, tips[1], feet[1]).iter().rev().map(Segment::reversed));
        for half in corner.between.iter().rev() {
            let [from, to] = self.ends(*half).map(|v| self.layout.vertex(v));
            outline.extend(piece(&self.outward(*half)?, from, to).iter().rev().map(Segment::reversed));
        }
        Some(Fillet { outline, needed })
    }
}
