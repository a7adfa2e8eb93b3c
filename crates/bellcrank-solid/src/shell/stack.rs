//! Boundary of a stack.

use std::collections::HashMap;

use super::space::Place;
use super::{Face, Form, Path, SharpEdge, Shell, ShellEdge, Surface};
use crate::plane::faces::{Arc, Half, faces};
use crate::plane::segment::sweep;
use crate::{Curve, Edge, Stack};

impl Stack<f64> {
    /// Its boundary. Faces at one height that touch are one; so are walls of one edge of the plan one above the other.
    pub fn shell(&self) -> Shell {
        let mut builder = Builder::new(self);
        builder.walls();
        for level in 0..self.levels.len() {
            builder.floors(level);
        }
        builder.shell
    }

    /// Triangles that are nowhere further from the boundary than the tolerance, in m.
    pub fn surface(&self, chord_tolerance: f64) -> Surface {
        self.shell().surface(chord_tolerance)
    }

    /// Re-entrant edges, along z and where one layer ends beside another.
    pub fn sharp_edges(&self) -> Vec<SharpEdge> {
        self.shell().sharp_edges()
    }

    /// Whether what is left or right of an edge is filled below or above a level.
    fn filled(&self, cell: Option<usize>, interval: Option<usize>) -> bool {
        let (Some(cell), Some(interval)) = (cell, interval) else { return false };
        self.cells[cell].filled.get(interval) == Some(&true)
    }

    /// 1 where a cell's material ends at a level, -1 where it begins, 0 where nothing changes.
    fn floor(&self, cell: Option<usize>, level: usize) -> i8 {
        i8::from(self.filled(cell, level.checked_sub(1))) - i8::from(self.filled(cell, Some(level)))
    }

    /// 1 where an edge has material on its left only in an interval, -1 on its right only, 0 else.
    fn wall(&self, edge: &Edge<f64>, interval: usize) -> i8 {
        let [l, r] = edge.cells.map(|cell| self.filled(cell, Some(interval)));
        i8::from(l) - i8::from(r)
    }
}

struct Builder<'a> {
    stack: &'a Stack<f64>,
    shell: Shell,
    vertices: HashMap<(usize, usize), usize>,
    /// Edge of the shell over an edge of the plan, at a level.
    level: HashMap<(usize, usize), usize>,
    /// Edge of the shell at a vertex of the plan, in an interval.
    upright: HashMap<(usize, usize), usize>,
}

impl<'a> Builder<'a> {
    fn new(stack: &'a Stack<f64>) -> Self {
        let mut builder = Self {
            stack,
            shell: Shell::default(),
            vertices: HashMap::new(),
            level: HashMap::new(),
            upright: HashMap::new(),
        };
        for level in 0..stack.levels.len() {
            for (i, edge) in stack.edges.iter().enumerate() {
                let [l, r] = edge.cells.map(|cell| stack.floor(cell, level));
                if l != r {
                    builder.flat_edge(i, edge, level);
                }
            }
        }
        builder.upright_edges();
        builder
    }

    fn vertex(&mut self, v: usize, level: usize) -> usize {
        let [x, y] = self.stack.vertices[v];
        let place: Place = [x, y, self.stack.levels[level]];
        *self.vertices.entry((v, level)).or_insert_with(|| {
            self.shell.vertices.push(place);
            self.shell.vertices.len() - 1
        })
    }

    fn flat_edge(&mut self, i: usize, edge: &Edge<f64>, level: usize) {
        let ends = edge.ends.map(|v| self.vertex(v, level));
        let path = match &edge.curve {
            Curve::Line => Path::Line,
            Curve::Arc { center: [x, y], radius, counter_clockwise } => {
                let up = if *counter_clockwise { 1.0 } else { -1.0 };
                let center = [*x, *y, self.stack.levels[level]];
                Path::Circle { center, axis: [0.0, 0.0, up], radius: *radius }
            }
        };
        self.level.insert((i, level), self.shell.edges.len());
        self.shell.edges.push(ShellEdge { ends, path });
    }

    /// Edges along z between the levels at which anything else meets them.
    fn upright_edges(&mut self) {
        let intervals = self.stack.levels.len().saturating_sub(1);
        for interval in 0..intervals {
            let mut corners: Vec<usize> = Vec::new();
            let walls = self.stack.edges.iter().filter(|edge| self.stack.wall(edge, interval) != 0);
            walls.for_each(|edge| corners.extend(edge.ends));
            corners.sort_unstable();
            corners.dedup();
            for v in corners {
                let below = interval.checked_sub(1).and_then(|below| self.upright.get(&(v, below))).copied();
                let goes_on = below.filter(|_| !self.vertices.contains_key(&(v, interval)));
                let edge = goes_on.unwrap_or_else(|| {
                    let bottom = self.vertex(v, interval);
                    self.shell.edges.push(ShellEdge { ends: [bottom, bottom], path: Path::Line });
                    self.shell.edges.len() - 1
                });
                self.upright.insert((v, interval), edge);
            }
        }
        // Each ends where the next one does not go on.
        for interval in 0..intervals {
            for v in 0..self.stack.vertices.len() {
                let Some(edge) = self.upright.get(&(v, interval)).copied() else { continue };
                if self.upright.get(&(v, interval + 1)) != Some(&edge) {
                    self.shell.edges[edge].ends[1] = self.vertex(v, interval + 1);
                }
            }
        }
    }

    fn walls(&mut self) {
        let stack = self.stack;
        let intervals = stack.levels.len().saturating_sub(1);
        for (i, edge) in stack.edges.iter().enumerate() {
            let mut low = 0;
            while low < intervals {
                let side = stack.wall(edge, low);
                let mut high = low + 1;
                while high < intervals && side != 0 && !self.level.contains_key(&(i, high)) {
                    high += 1;
                }
                if side != 0 {
                    self.wall(i, side > 0, [low, high]);
                }
                low = high;
            }
        }
    }

    fn wall(&mut self, i: usize, left: bool, [low, high]: [usize; 2]) {
        let edge = &self.stack.edges[i];
        let (Some(bottom), Some(top)) = (self.level.get(&(i, low)), self.level.get(&(i, high))) else { return };
        let [a, b] = if left { edge.ends } else { [edge.ends[1], edge.ends[0]] };
        let mut walk = vec![(*bottom, left)];
        walk.extend(self.column(b, low, high).into_iter().map(|e| (e, true)));
        walk.push((*top, !left));
        walk.extend(self.column(a, low, high).into_iter().rev().map(|e| (e, false)));
        let form = self.wall_form(edge, left);
        self.shell.faces.push(Face { form, loops: vec![walk] });
    }

    /// Edges at a vertex of the plan between two levels.
    fn column(&self, v: usize, low: usize, high: usize) -> Vec<usize> {
        let mut column: Vec<usize> = (low..high).filter_map(|k| self.upright.get(&(v, k))).copied().collect();
        column.dedup();
        column
    }

    fn wall_form(&self, edge: &Edge<f64>, left: bool) -> Form {
        let [a, b] = edge.ends.map(|v| self.stack.vertices[v]);
        match &edge.curve {
            Curve::Line => {
                let along = [b[0] - a[0], b[1] - a[1]];
                let length = along[0].hypot(along[1]) * if left { 1.0 } else { -1.0 };
                Form::Plane { point: [a[0], a[1], 0.0], normal: [along[1] / length, -along[0] / length, 0.0] }
            }
            Curve::Arc { center, radius, counter_clockwise } => Form::Cylinder {
                point: [center[0], center[1], 0.0],
                axis: [0.0, 0.0, 1.0],
                radius: *radius,
                convex: *counter_clockwise == left,
            },
        }
    }

    /// Faces at a level.
    fn floors(&mut self, level: usize) {
        let stack = self.stack;
        let there: Vec<usize> = (0..stack.edges.len()).filter(|i| self.level.contains_key(&(*i, level))).collect();
        let arcs: Vec<Arc> = there.iter().map(|i| arc(&stack.edges[*i], &stack.vertices)).collect();
        for loops in faces(&stack.vertices, &arcs).cells {
            let (arc, forward) = loops[0][0];
            let side = stack.floor(stack.edges[there[arc]].cells[usize::from(!forward)], level);
            if side == 0 {
                continue;
            }
            let edges = |walk: &Vec<Half>| -> Vec<Half> {
                let halves = walk.iter().filter_map(|(arc, f)| Some((*self.level.get(&(there[*arc], level))?, *f)));
                if side > 0 { halves.collect() } else { halves.rev().map(|(e, f)| (e, !f)).collect() }
            };
            let loops = loops.iter().map(edges).collect();
            let form = Form::Plane { point: [0.0, 0.0, stack.levels[level]], normal: [0.0, 0.0, f64::from(side)] };
            self.shell.faces.push(Face { form, loops });
        }
    }
}

fn arc(edge: &Edge<f64>, vertices: &[[f64; 2]]) -> Arc {
    let bulge = match edge.curve {
        Curve::Line => 0.0,
        Curve::Arc { center, counter_clockwise, .. } => {
            let [a, b] = edge.ends.map(|v| vertices[v]);
            (sweep(center, a, b, counter_clockwise) / 4.0).tan()
        }
    };
    Arc { ends: edge.ends, bulge }
}
