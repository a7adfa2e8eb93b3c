//! Loops and cells between strands.

use std::collections::HashMap;

use super::vector::{Point, cross, distance, dot, sub, wrap};

/// A strand as faces see it: vertices at its ends and its bulge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arc {
    pub(crate) ends: [usize; 2],
    pub(crate) bulge: f64,
}

/// A strand run forward or backward.
pub(crate) type Half = (usize, bool);

/// Cells of a plane cut by strands.
pub(crate) struct Faces {
    /// Loops of each bounded cell, the outer one first, with the cell on the left.
    pub(crate) cells: Vec<Vec<Vec<Half>>>,
    /// Cell left and right of each strand; `None` is the unbounded one.
    pub(crate) sides: Vec<[Option<usize>; 2]>,
}

impl Arc {
    pub(crate) fn angle(&self) -> f64 {
        4.0 * self.bulge.atan()
    }

    fn run(&self, forward: bool) -> Arc {
        if forward { *self } else { Arc { ends: [self.ends[1], self.ends[0]], bulge: -self.bulge } }
    }
}

struct Plane<'a> {
    vertices: &'a [Point<f64>],
    arcs: &'a [Arc],
}

/// Links strands to loops, and loops to cells.
pub(crate) fn faces(vertices: &[Point<f64>], arcs: &[Arc]) -> Faces {
    let plane = Plane { vertices, arcs };
    let loops = plane.loops();
    let areas: Vec<f64> = loops.iter().map(|l| plane.area(l)).collect();
    let mut cell_of_loop = vec![None; loops.len()];
    let mut cells = Vec::new();
    for (i, _) in areas.iter().enumerate().filter(|(_, a)| **a > 0.0) {
        cell_of_loop[i] = Some(cells.len());
        cells.push(vec![loops[i].clone()]);
    }
    let parts = plane.parts();
    let part = |l: &[Half]| parts[arcs[l[0].0].ends[0]];
    let outer: Vec<usize> = (0..loops.len()).filter(|i| areas[*i] > 0.0).collect();
    for i in (0..loops.len()).filter(|i| areas[*i] <= 0.0) {
        let place = vertices[arcs[loops[i][0].0].ends[0]];
        let around = outer.iter().filter(|o| part(&loops[**o]) != part(&loops[i]) && plane.winds(&loops[**o], place));
        if let Some(o) = around.min_by(|a, b| areas[**a].total_cmp(&areas[**b])) {
            cell_of_loop[i] = cell_of_loop[*o];
            if let Some(cell) = cell_of_loop[*o] {
                cells[cell].push(loops[i].clone());
            }
        }
    }
    let mut sides = vec![[None; 2]; arcs.len()];
    for (l, cell) in loops.iter().zip(&cell_of_loop) {
        l.iter().for_each(|(arc, forward)| sides[*arc][usize::from(!forward)] = *cell);
    }
    Faces { cells, sides }
}

/// Half-strands that leave each vertex, counter-clockwise.
pub(crate) fn fans(vertices: &[Point<f64>], arcs: &[Arc]) -> Vec<Vec<Half>> {
    let plane = Plane { vertices, arcs };
    let mut fans = vec![Vec::new(); vertices.len()];
    for (i, arc) in arcs.iter().enumerate() {
        fans[arc.ends[0]].push((i, true));
        fans[arc.ends[1]].push((i, false));
    }
    fans.into_iter().map(|fan| plane.sorted(fan)).collect()
}

impl Plane<'_> {
    fn loops(&self) -> Vec<Vec<Half>> {
        let mut before: HashMap<Half, Half> = HashMap::new();
        for fan in fans(self.vertices, self.arcs) {
            fan.iter().zip(fan.iter().cycle().skip(1)).for_each(|(a, b)| {
                before.insert(*b, *a);
            });
        }
        let mut seen = vec![[false; 2]; self.arcs.len()];
        let mut loops = Vec::new();
        for start in (0..self.arcs.len()).flat_map(|i| [(i, true), (i, false)]) {
            let mut walk = Vec::new();
            let mut half = start;
            while !std::mem::replace(&mut seen[half.0][usize::from(half.1)], true) {
                walk.push(half);
                half = before.get(&(half.0, !half.1)).copied().unwrap_or(start);
            }
            if !walk.is_empty() {
                loops.push(walk);
            }
        }
        loops
    }

    fn chord(&self, half: Half) -> f64 {
        let [a, b] = self.arcs[half.0].ends;
        distance(self.vertices[a], self.vertices[b])
    }

    /// Direction from its first vertex to where a half-strand is at a distance from it.
    fn direction(&self, (arc, forward): Half, at: f64) -> f64 {
        let arc = self.arcs[arc].run(forward);
        let along = sub(self.vertices[arc.ends[1]], self.vertices[arc.ends[0]]);
        let half = arc.angle() / 2.0;
        let part = at / distance(along, [0.0; 2]);
        along[1].atan2(along[0]) - half + (part * half.sin()).clamp(-1.0, 1.0).asin()
    }

    /// Half-strands from one vertex, counter-clockwise. Tangent ones are told apart away from the vertex, where
    /// they have parted by more than rounding.
    fn sorted(&self, mut fan: Vec<Half>) -> Vec<Half> {
        let near = fan.iter().map(|h| self.chord(*h)).fold(f64::INFINITY, f64::min) / 2.0;
        fan.sort_by(|a, b| wrap(self.direction(*a, near)).total_cmp(&wrap(self.direction(*b, near))));
        let gap = |i: usize| {
            let (a, b) = (fan[i], fan[(i + 1) % fan.len()]);
            (self.direction(b, near) - self.direction(a, near)).rem_euclid(std::f64::consts::TAU)
        };
        if let Some(widest) = (0..fan.len()).max_by(|i, j| gap(*i).total_cmp(&gap(*j))) {
            let start = (widest + 1) % fan.len();
            fan.rotate_left(start);
        }
        for _ in 0..fan.len() {
            for i in 1..fan.len() {
                if self.swapped(fan[i - 1], fan[i], near) {
                    fan.swap(i - 1, i);
                }
            }
        }
        fan
    }

    fn swapped(&self, a: Half, b: Half, near: f64) -> bool {
        if wrap(self.direction(b, near) - self.direction(a, near)).abs() > 1e-3 {
            return false;
        }
        let far = self.chord(a).min(self.chord(b)) / 2.0;
        wrap(self.direction(b, far) - self.direction(a, far)) < 0.0
    }

    /// Signed area within a loop.
    fn area(&self, walk: &[Half]) -> f64 {
        let origin = self.vertices[self.arcs[walk[0].0].ends[0]];
        walk.iter()
            .map(|(arc, forward)| {
                let arc = self.arcs[*arc].run(*forward);
                let [a, b] = arc.ends.map(|v| sub(self.vertices[v], origin));
                cross(a, b) / 2.0 + segment_area(distance(a, b), arc.angle())
            })
            .sum()
    }

    /// Whether a loop runs round a place that is not on it.
    fn winds(&self, walk: &[Half], p: Point<f64>) -> bool {
        let turns: f64 = walk.iter().map(|(arc, forward)| self.seen_from(self.arcs[*arc].run(*forward), p)).sum();
        turns.abs() > std::f64::consts::PI
    }

    /// Angle under which an arc is seen from a place.
    fn seen_from(&self, arc: Arc, p: Point<f64>) -> f64 {
        let [a, b] = arc.ends.map(|v| sub(self.vertices[v], p));
        let chord = cross(a, b).atan2(dot(a, b));
        let half = arc.angle() / 2.0;
        // Seen from a place between the chord and the arc, the arc goes the other way round. There the inscribed
        // angle is larger than that of a place on the arc, pi - half; on the other side of the chord it is negative.
        let between = chord * half < 0.0 && chord.abs() > std::f64::consts::PI - half.abs();
        if between { chord + std::f64::consts::TAU * half.signum() } else { chord }
    }

    /// For each vertex, a number that is the same for all it is connected with.
    fn parts(&self) -> Vec<usize> {
        let mut parts = Union::new(self.vertices.len());
        self.arcs.iter().for_each(|arc| parts.join(arc.ends[0], arc.ends[1]));
        (0..self.vertices.len()).map(|v| parts.root(v)).collect()
    }
}

/// Area between an arc and its chord, signed as the angle.
fn segment_area(chord: f64, angle: f64) -> f64 {
    let half = angle.abs() / 2.0;
    if half < 1e-4 {
        return chord * chord * angle / 12.0;
    }
    let radius = chord / 2.0 / half.sin();
    radius * radius * (half - half.sin() * half.cos()) * angle.signum()
}

/// Disjoint sets.
pub(crate) struct Union(Vec<usize>);

impl Union {
    pub(crate) fn new(count: usize) -> Self {
        Union((0..count).collect())
    }

    pub(crate) fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    pub(crate) fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.root(i), self.root(j));
        self.0[i] = j;
    }
}
