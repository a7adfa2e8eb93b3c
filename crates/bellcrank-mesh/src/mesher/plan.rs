//! The arrangement of a stack as the mesher sees it: only edges between cells that are filled differently.

use bellcrank_solid::{Curve, Edge, Stack};

use super::MesherError;

/// What is filled over a place of the plane: one entry an interval of height.
pub(super) type Pattern = Vec<bool>;

pub(super) struct Plan<'a> {
    pub(super) stack: &'a Stack<f64>,
    /// Places of the edges of the stack that are kept.
    pub(super) edges: Vec<usize>,
    /// Different ways to be filled; the first is empty.
    pub(super) patterns: Vec<Pattern>,
    /// Pattern on the left and the right of each kept edge.
    pub(super) sides: Vec<[usize; 2]>,
    /// Bore that each kept edge lies on.
    pub(super) bores: Vec<Option<usize>>,
    /// Diagonal of the box round the kept edges.
    pub(super) extent: f64,
}

impl<'a> Plan<'a> {
    pub(super) fn of(stack: &'a Stack<f64>) -> Result<Plan<'a>, MesherError> {
        let empty = vec![false; stack.levels.len().saturating_sub(1)];
        let mut patterns = vec![empty];
        let cells: Vec<usize> = stack.cells.iter().map(|cell| place(&mut patterns, &cell.filled)).collect();
        let side = |cell: Option<usize>| cell.map_or(0, |cell| cells[cell]);
        let all = stack.edges.iter().map(|edge| edge.cells.map(side));
        let kept: Vec<(usize, [usize; 2])> = all.enumerate().filter(|(_, [left, right])| left != right).collect();
        if kept.is_empty() {
            return Err(MesherError::Empty);
        }
        let (edges, sides): (Vec<usize>, Vec<[usize; 2]>) = kept.into_iter().unzip();
        let extent = extent(edges.iter().flat_map(|&edge| stack.edges[edge].ends).map(|end| stack.vertices[end]));
        let bores = edges.iter().map(|&edge| bore_of(stack, &stack.edges[edge], extent)).collect();
        Ok(Plan { stack, edges, patterns, sides, bores, extent })
    }

    pub(super) fn edge(&self, kept: usize) -> &Edge<f64> {
        &self.stack.edges[self.edges[kept]]
    }

    pub(super) fn ends(&self, kept: usize) -> [[f64; 2]; 2] {
        self.edge(kept).ends.map(|end| self.stack.vertices[end])
    }

    /// Angle that an arc turns through, with its sign; `None` for lines.
    pub(super) fn sweep(&self, kept: usize) -> Option<f64> {
        let Curve::Arc { center, counter_clockwise, .. } = &self.edge(kept).curve else { return None };
        let [a, b] = self.ends(kept).map(|p| (p[1] - center[1]).atan2(p[0] - center[0]));
        let turn = (b - a).rem_euclid(std::f64::consts::TAU);
        Some(if *counter_clockwise { turn } else { turn - std::f64::consts::TAU })
    }

    pub(super) fn length(&self, kept: usize) -> f64 {
        let [a, b] = self.ends(kept);
        match (&self.edge(kept).curve, self.sweep(kept)) {
            (Curve::Arc { radius, .. }, Some(sweep)) => radius * sweep.abs(),
            _ => (b[0] - a[0]).hypot(b[1] - a[1]),
        }
    }

    /// Place at a fraction of the length.
    pub(super) fn at(&self, kept: usize, fraction: f64) -> [f64; 2] {
        let [a, b] = self.ends(kept);
        match (&self.edge(kept).curve, self.sweep(kept)) {
            (Curve::Arc { center, radius, .. }, Some(sweep)) => {
                let angle = (a[1] - center[1]).atan2(a[0] - center[0]) + sweep * fraction;
                [center[0] + radius * angle.cos(), center[1] + radius * angle.sin()]
            }
            _ => [a[0] + (b[0] - a[0]) * fraction, a[1] + (b[1] - a[1]) * fraction],
        }
    }

    /// Direction to the left of the edge at a fraction of its length.
    pub(super) fn left(&self, kept: usize, fraction: f64) -> [f64; 2] {
        let [a, b] = self.ends(kept);
        match (&self.edge(kept).curve, self.sweep(kept)) {
            (Curve::Arc { center, counter_clockwise, .. }, Some(sweep)) => {
                let angle = (a[1] - center[1]).atan2(a[0] - center[0]) + sweep * fraction;
                let inward = if *counter_clockwise { -1.0 } else { 1.0 };
                [inward * angle.cos(), inward * angle.sin()]
            }
            _ => {
                let length = (b[0] - a[0]).hypot(b[1] - a[1]);
                [-(b[1] - a[1]) / length, (b[0] - a[0]) / length]
            }
        }
    }

    /// Whether the edge is an arc with material outside and none inside of its circle, at some height.
    pub(super) fn concave(&self, kept: usize) -> bool {
        let Curve::Arc { counter_clockwise, .. } = self.edge(kept).curve else { return false };
        let [left, right] = self.sides[kept].map(|side| &self.patterns[side]);
        let (inside, outside) = if counter_clockwise { (left, right) } else { (right, left) };
        inside.iter().zip(outside).any(|(&inside, &outside)| outside && !inside)
    }
}

fn place(patterns: &mut Vec<Pattern>, filled: &Pattern) -> usize {
    patterns.iter().position(|pattern| pattern == filled).unwrap_or_else(|| {
        patterns.push(filled.clone());
        patterns.len() - 1
    })
}

fn extent(points: impl Iterator<Item = [f64; 2]>) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in points {
        for i in 0..2 {
            low[i] = low[i].min(point[i]);
            high[i] = high[i].max(point[i]);
        }
    }
    (high[0] - low[0]).hypot(high[1] - low[1])
}

fn bore_of(stack: &Stack<f64>, edge: &Edge<f64>, extent: f64) -> Option<usize> {
    let Curve::Arc { center, radius, .. } = &edge.curve else { return None };
    stack.bores.iter().position(|bore| {
        let apart = (center[0] - bore.center[0]).hypot(center[1] - bore.center[1]);
        apart.max((radius - bore.diameter / 2.0).abs()) < 1e-9 * extent
    })
}
