//! A recipe laid out: every cell of the plane and interval of height filled or not.

use std::collections::VecDeque;

use bellcrank_math::Real;

use super::recipe::{Layer, Piece, Recipe};
use crate::plane::arrangement::{Arrangement, Origin, arrange};
use crate::plane::faces::{Arc, Faces, faces};
use crate::plane::segment::{Segment, meet};
use crate::plane::vector::Point;

/// Cells of all outlines of a recipe times the intervals between all ends of its layers.
pub(crate) struct Layout<T> {
    pub(crate) segments: Vec<Segment<T>>,
    /// Outline of each segment.
    pub(crate) outline_of: Vec<usize>,
    pub(crate) plane: Arrangement,
    pub(crate) arcs: Vec<Arc>,
    pub(crate) faces: Faces,
    pub(crate) levels: Levels<T>,
    /// For each cell and each outline, whether it is within.
    pub(crate) within: Vec<Vec<bool>>,
}

/// Ends of layers; those nearer than the tolerance are one.
pub(crate) struct Levels<T> {
    pub(crate) heights: Vec<T>,
    /// For each piece and each of its layers, the levels at its ends.
    pub(crate) spans: Vec<Vec<[usize; 2]>>,
}

impl<T: Real> Levels<T> {
    fn new(pieces: &[Piece<T>], tolerance: f64) -> Self {
        let joined = pieces.iter().filter(|p| p.joins()).flat_map(|p| p.layers.iter().flatten().flatten());
        let taken = pieces.iter().filter(|p| !p.joins()).flat_map(|p| p.layers.iter().flatten().flatten());
        let mut ends: Vec<T> = joined.chain(taken).copied().collect();
        // A stable sort: of ends at one height, the first of what is joined gives the level.
        ends.sort_by(|a, b| a.value().total_cmp(&b.value()));
        let mut heights: Vec<T> = Vec::new();
        for end in ends {
            if heights.last().is_none_or(|last| end.value() - last.value() > tolerance) {
                heights.push(end);
            }
        }
        let nearest = |z: T| {
            let above = heights.partition_point(|h| h.value() + tolerance < z.value());
            above.min(heights.len().saturating_sub(1))
        };
        let last = heights.len().saturating_sub(1);
        let span = |l: &Layer<T>| [l[0].map_or(0, nearest), l[1].map_or(last, nearest)];
        let spans = pieces.iter().map(|p| p.layers.iter().map(span).collect()).collect();
        Levels { heights, spans }
    }

    pub(crate) fn count(&self) -> usize {
        self.heights.len().saturating_sub(1)
    }

    /// Whether a piece is there in an interval.
    pub(crate) fn active(&self, piece: usize, interval: usize) -> bool {
        self.spans[piece].iter().any(|[a, b]| (*a..*b).contains(&interval))
    }
}

/// Cuts all outlines of a recipe at each other and finds what each cell is within.
pub(crate) fn lay_out<T: Real>(recipe: &Recipe<T>, tolerance: f64) -> Layout<T> {
    let outline_of = recipe.outlines.iter().enumerate().flat_map(|(i, o)| std::iter::repeat_n(i, o.len())).collect();
    let segments: Vec<Segment<T>> = recipe.outlines.iter().flatten().cloned().collect();
    let plain: Vec<Segment<f64>> = segments.iter().map(Segment::values).collect();
    // Sides that two roundings leave nothing of.
    let plane = arrange(&plain, tolerance);
    let arcs: Vec<Arc> = plane.strands.iter().map(|s| Arc { ends: s.ends, bulge: s.bulge }).collect();
    let faces = faces(&plane.vertices, &arcs);
    let levels = Levels::new(&recipe.pieces, tolerance);
    let mut layout = Layout { segments, outline_of, plane, arcs, faces, levels, within: Vec::new() };
    layout.within = layout.within(recipe.outlines.len());
    layout
}

impl<T: Real> Layout<T> {
    /// Cells within each outline: how often it runs round them changes by one across its strands.
    fn within(&self, outlines: usize) -> Vec<Vec<bool>> {
        let count = self.faces.cells.len();
        let outside = count;
        let mut across: Vec<Vec<(usize, usize, bool)>> = vec![Vec::new(); count + 1];
        for (strand, sides) in self.faces.sides.iter().enumerate() {
            let [l, r] = sides.map(|side| side.unwrap_or(outside));
            across[l].push((strand, r, false));
            across[r].push((strand, l, true));
        }
        let mut turns: Vec<Option<Vec<i32>>> = vec![None; count + 1];
        turns[outside] = Some(vec![0; outlines]);
        let mut queue = VecDeque::from([outside]);
        while let Some(cell) = queue.pop_front() {
            for (strand, other, leftward) in &across[cell] {
                if turns[*other].is_some() {
                    continue;
                }
                let mut there = turns[cell].clone().unwrap_or_default();
                for (segment, forward) in &self.plane.strands[*strand].sources {
                    there[self.outline_of[*segment]] += if forward == leftward { 1 } else { -1 };
                }
                turns[*other] = Some(there);
                queue.push_back(*other);
            }
        }
        let flags = |t: Option<Vec<i32>>| t.map_or(vec![false; outlines], |t| t.iter().map(|n| *n != 0).collect());
        turns.into_iter().map(flags).collect()
    }

    /// What a cell is within; the place after the last one is the outside.
    pub(crate) fn bits(&self, cell: Option<usize>) -> &[bool] {
        &self.within[cell.unwrap_or(self.faces.cells.len())]
    }

    /// Place of a vertex with its derivatives.
    pub(crate) fn vertex(&self, v: usize) -> Point<T> {
        match self.plane.origins[v] {
            Origin::End(segment, end) => self.segments[segment].ends[end],
            Origin::Meeting(a, b) => {
                meet([&self.segments[a], &self.segments[b]], [T::zero(); 2], self.plane.vertices[v])
            }
        }
    }

    /// A segment that a strand is a piece of, run as the strand does.
    pub(crate) fn source(&self, (segment, forward): (usize, bool)) -> Segment<T> {
        let segment = &self.segments[segment];
        if forward { segment.clone() } else { segment.reversed() }
    }
}

/// Rule that says what is filled.
pub(crate) struct Filling<'a, T> {
    pub(crate) pieces: &'a [Piece<T>],
    pub(crate) levels: &'a Levels<T>,
    /// Whether nothing is taken away.
    pub(crate) joined_only: bool,
}

impl<T: Real> Filling<'_, T> {
    /// Whether a place within these outlines is filled in an interval.
    pub(crate) fn filled(&self, within: &[bool], interval: usize) -> bool {
        self.filled_if(within, |piece| self.levels.active(piece, interval))
    }

    /// The same with another rule of which pieces are there.
    pub(crate) fn filled_if(&self, within: &[bool], active: impl Fn(usize) -> bool) -> bool {
        let mut filled = false;
        for (i, piece) in self.pieces.iter().enumerate() {
            if !piece.joins() && self.joined_only || !active(i) || !piece.holds(within) {
                continue;
            }
            if !piece.joins() {
                return false;
            }
            filled = true;
        }
        filled
    }

    /// Of the segments that run together in a strand between filled and empty, one that the boundary follows: the
    /// first one whose outline alone makes the difference.
    pub(crate) fn owner(&self, layout: &Layout<T>, strand: usize, interval: usize) -> (usize, bool) {
        let sources = &layout.plane.strands[strand].sources;
        let [left, right] = layout.faces.sides[strand].map(|side| layout.bits(side));
        let full = self.filled(left, interval);
        let alone = |source: &&(usize, bool)| {
            let outline = layout.outline_of[source.0];
            let mut bits = left.to_vec();
            bits[outline] = right[outline];
            self.filled(&bits, interval) != full
        };
        *sources.iter().find(alone).unwrap_or(&sources[0])
    }
}
