//! From a layout to a stack: what separates nothing is left out.

use std::collections::HashMap;

use bellcrank_math::Real;

use super::connection::Table;
use super::layout::{Filling, Layout};
use crate::plane::faces::{Arc, Half, faces};
use crate::plane::segment::{arcs, sweep};
use crate::plane::vector::{Point, cross, distance, dot, sub, values};
use crate::{Cell, Curve, Edge};

/// Vertices, edges and cells of what is filled.
pub(crate) struct Remains<T> {
    pub(crate) vertices: Vec<Point<T>>,
    pub(crate) edges: Vec<Edge<T>>,
    pub(crate) cells: Vec<Cell>,
}

/// A strand that stays, run forward, and the places of its two sides in the table.
#[derive(Clone, Copy)]
struct Border {
    strand: usize,
    sides: [usize; 2],
}

/// Leaves out strands with the same filling on both sides, and joins pieces of one curve.
pub(crate) fn dissolve<T: Real>(layout: &Layout<T>, filling: &Filling<T>, table: &Table, tolerance: f64) -> Remains<T> {
    let outside = table.len() - 1;
    let side = |strand: usize| layout.faces.sides[strand].map(|side| side.unwrap_or(outside));
    let all = (0..layout.arcs.len()).map(|strand| Border { strand, sides: side(strand) });
    let borders: Vec<Border> = all.filter(|b| table[b.sides[0]] != table[b.sides[1]]).collect();
    let curves: Vec<Curve<T>> = borders.iter().map(|b| curve(layout, filling, table, b)).collect();
    let mut builder = Builder {
        layout,
        remains: Remains { vertices: Vec::new(), edges: Vec::new(), cells: Vec::new() },
        numbers: HashMap::new(),
    };
    let mut sides = Vec::new();
    for run in runs(layout, &borders, &curves, tolerance) {
        let (first, forward) = run[0];
        let [l, r] = borders[first].sides;
        let count = builder.run(&run, &borders, &curves[first]);
        sides.extend(std::iter::repeat_n(if forward { [l, r] } else { [r, l] }, count));
    }
    builder.cells(&sides, table);
    builder.remains
}

/// Curve of a border: that of the first interval in which it separates.
fn curve<T: Real>(layout: &Layout<T>, filling: &Filling<T>, table: &Table, border: &Border) -> Curve<T> {
    let [l, r] = border.sides.map(|side| &table[side]);
    let interval = l.iter().zip(r).position(|(l, r)| l != r).unwrap_or(0);
    layout.source(filling.owner(layout, border.strand, interval)).curve
}

/// Chains of borders of one curve, each as long as it can be.
fn runs<T: Real>(layout: &Layout<T>, borders: &[Border], curves: &[Curve<T>], tolerance: f64) -> Vec<Vec<Half>> {
    let plain: Vec<Curve<f64>> = curves.iter().map(Curve::values).collect();
    let ends = |(border, forward): Half| {
        let [a, b] = layout.arcs[borders[border].strand].ends;
        if forward { [a, b] } else { [b, a] }
    };
    let mut fans = vec![Vec::new(); layout.plane.vertices.len()];
    (0..borders.len()).flat_map(|i| [(i, true), (i, false)]).for_each(|half: Half| fans[ends(half)[0]].push(half));
    let next = |half: Half| -> Option<Half> {
        let [from, at] = ends(half);
        let [a, b] = fans[at][..] else { return None };
        let onward = if a == (half.0, !half.1) { b } else { a };
        let places = [from, at, ends(onward)[1]].map(|v| layout.plane.vertices[v]);
        let curves = [run(&plain[half.0], half.1), run(&plain[onward.0], onward.1)];
        (onward.0 != half.0 && same(&curves, places, tolerance)).then_some(onward)
    };
    let mut taken = vec![false; borders.len()];
    let mut runs = Vec::new();
    for i in 0..borders.len() {
        if taken[i] {
            continue;
        }
        let mut start = (i, false);
        while let Some(before) = next(start).filter(|h| h.0 != i) {
            start = before;
        }
        let mut half = (start.0, !start.1);
        let mut run = Vec::new();
        loop {
            taken[half.0] = true;
            run.push(half);
            match next(half).filter(|h| !taken[h.0]) {
                Some(onward) => half = onward,
                None => break,
            }
        }
        runs.push(run);
    }
    runs
}

fn run(curve: &Curve<f64>, forward: bool) -> Curve<f64> {
    if forward { curve.clone() } else { curve.reversed() }
}

/// Whether two pieces that follow each other are of one curve.
fn same(curves: &[Curve<f64>; 2], [from, at, to]: [Point<f64>; 3], tolerance: f64) -> bool {
    match curves {
        [Curve::Line, Curve::Line] => {
            let (u, v) = (sub(at, from), sub(to, at));
            let whole = distance(from, to);
            dot(u, v) > 0.0 && cross(u, v).abs() <= 2.0 * tolerance * whole
        }
        [
            Curve::Arc { center: a, radius: r, counter_clockwise: x },
            Curve::Arc { center: b, radius: s, counter_clockwise: y },
        ] => x == y && distance(*a, *b) <= 4.0 * tolerance && (r - s).abs() <= 4.0 * tolerance,
        _ => false,
    }
}

struct Builder<'a, T> {
    layout: &'a Layout<T>,
    remains: Remains<T>,
    numbers: HashMap<usize, usize>,
}

impl<T: Real> Builder<'_, T> {
    fn vertex(&mut self, v: usize) -> usize {
        let (layout, vertices) = (self.layout, &mut self.remains.vertices);
        *self.numbers.entry(v).or_insert_with(|| {
            vertices.push(layout.vertex(v));
            vertices.len() - 1
        })
    }

    /// Makes edges of a run, and says how many: an arc is cut into equal parts, each shorter than half a turn.
    fn run(&mut self, run: &[Half], borders: &[Border], curve: &Curve<T>) -> usize {
        let ends = |(border, forward): Half| {
            let [a, b] = self.layout.arcs[borders[border].strand].ends;
            if forward { [a, b] } else { [b, a] }
        };
        let Some(last) = run.last() else { return 0 };
        let [start, end] = [ends(run[0])[0], ends(*last)[1]];
        let curve = if run[0].1 { curve.clone() } else { curve.reversed() };
        let turn = match curve.values() {
            Curve::Line => 0.0,
            Curve::Arc { center, counter_clockwise, .. } => run
                .iter()
                .map(|half| ends(*half).map(|v| self.layout.plane.vertices[v]))
                .map(|[a, b]| sweep(center, a, b, counter_clockwise))
                .sum(),
        };
        let [a, b] = [self.vertex(start), self.vertex(end)];
        let mut stops = vec![a];
        if let Curve::Arc { center, radius, .. } = &curve {
            let places = [a, b].map(|v| self.remains.vertices[v]);
            let pieces = arcs(*center, *radius, places[0], places[1], turn);
            for piece in pieces.iter().skip(1) {
                stops.push(self.remains.vertices.len());
                self.remains.vertices.push(piece.ends[0]);
            }
        }
        stops.push(b);
        for pair in stops.windows(2) {
            self.remains.edges.push(Edge { ends: [pair[0], pair[1]], curve: curve.clone(), cells: [None, None] });
        }
        stops.len() - 1
    }

    /// Cells between the edges; `sides` are the places of what is left and right of each edge in the table.
    fn cells(&mut self, sides: &[[usize; 2]], table: &Table) {
        let vertices: Vec<Point<f64>> = self.remains.vertices.iter().map(|p| values(*p)).collect();
        let arcs: Vec<Arc> = self.remains.edges.iter().map(|edge| arc(edge, &vertices)).collect();
        let faces = faces(&vertices, &arcs);
        let mut numbers = vec![None; faces.cells.len()];
        for (i, loops) in faces.cells.into_iter().enumerate() {
            let (edge, forward) = loops[0][0];
            let filled = table[sides[edge][usize::from(!forward)]].clone();
            if filled.contains(&true) {
                numbers[i] = Some(self.remains.cells.len());
                self.remains.cells.push(Cell { loops, filled });
            }
        }
        for (edge, sides) in self.remains.edges.iter_mut().zip(&faces.sides) {
            edge.cells = sides.map(|side| side.and_then(|cell| numbers[cell]));
        }
    }
}

fn arc<T: Real>(edge: &Edge<T>, vertices: &[Point<f64>]) -> Arc {
    let bulge = match edge.curve.values() {
        Curve::Line => 0.0,
        Curve::Arc { center, counter_clockwise, .. } => {
            let [a, b] = edge.ends.map(|v| vertices[v]);
            (sweep(center, a, b, counter_clockwise) / 4.0).tan()
        }
    };
    Arc { ends: edge.ends, bulge }
}
