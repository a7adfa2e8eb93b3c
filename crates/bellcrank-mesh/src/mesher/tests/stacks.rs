//! Stacks made by hand.

use std::f64::consts::PI;

use bellcrank_solid::{Bore, Cell, Curve, Edge, Stack};

pub(super) const BORE: f64 = 0.02;
pub(super) const BOSS: f64 = 0.032;
pub(super) const PLATE: f64 = 0.06;
pub(super) const PLATE_TOP: f64 = 0.012;
pub(super) const HEIGHT: f64 = 0.03;

pub(super) type Case = (&'static str, Stack<f64>, f64);

pub(super) fn all() -> Vec<Case> {
    vec![block_with_bore(), boss_on_plate(), drop(), fork()]
}

fn empty(levels: Vec<f64>, filled: &[&[bool]]) -> Stack<f64> {
    let cells = filled.iter().map(|filled| Cell { loops: Vec::new(), filled: filled.to_vec() }).collect();
    let moments = bellcrank_solid::Moments::default();
    Stack { vertices: Vec::new(), edges: Vec::new(), cells, levels, bores: Vec::new(), moments, warnings: Vec::new() }
}

/// Lines from corner to corner, the first cell on their left.
fn outline(stack: &mut Stack<f64>, corners: &[[f64; 2]], cells: [Option<usize>; 2]) {
    let first = stack.vertices.len();
    stack.vertices.extend(corners);
    let count = corners.len();
    let lines = (0..count).map(|k| Edge { ends: [first + k, first + (k + 1) % count], curve: Curve::Line, cells });
    stack.edges.extend(lines);
}

/// A circle of three arcs, the first cell inside.
fn circle(stack: &mut Stack<f64>, center: [f64; 2], radius: f64, cells: [Option<usize>; 2]) {
    let first = stack.vertices.len();
    for k in 0..3 {
        let angle = 0.3 + 2.0 * PI * f64::from(k) / 3.0;
        stack.vertices.push([center[0] + radius * angle.cos(), center[1] + radius * angle.sin()]);
    }
    let curve = Curve::Arc { center, radius, counter_clockwise: true };
    let arcs = (0..3).map(|k| Edge { ends: [first + k, first + (k + 1) % 3], curve: curve.clone(), cells });
    stack.edges.extend(arcs);
}

fn bore(stack: &mut Stack<f64>, center: [f64; 2], radius: f64, layers: &[[f64; 2]], around: usize) {
    circle(stack, center, radius, [None, Some(around)]);
    let eye = stack.bores.len();
    stack.bores.push(Bore { eye, center, diameter: 2.0 * radius, layers: layers.to_vec() });
}

/// A block of 120 mm by 60 mm by 10 mm with a bore that is not in its middle.
pub(super) fn block_with_bore() -> Case {
    let mut stack = empty(vec![-0.003, 0.007], &[&[true]]);
    outline(&mut stack, &[[0.0, 0.0], [0.12, 0.0], [0.12, 0.06], [0.0, 0.06]], [Some(0), None]);
    bore(&mut stack, [0.04, 0.027], 0.015, &[[-0.003, 0.007]], 0);
    ("block with bore", stack, (0.12 * 0.06 - PI * 0.015 * 0.015) * 0.01)
}

/// A round boss on a round plate, bored through.
pub(super) fn boss_on_plate() -> Case {
    let mut stack = empty(vec![0.0, PLATE_TOP, HEIGHT], &[&[true, true], &[true, false]]);
    circle(&mut stack, [0.0; 2], PLATE, [Some(1), None]);
    circle(&mut stack, [0.0; 2], BOSS, [Some(0), Some(1)]);
    bore(&mut stack, [0.0; 2], BORE, &[[0.0, HEIGHT]], 0);
    let ring = |radius: f64| PI * (radius * radius - BORE * BORE);
    ("boss on plate", stack, ring(PLATE) * PLATE_TOP + ring(BOSS) * (HEIGHT - PLATE_TOP))
}

/// A bored disc, and between two tangents to it a plate half as high: two cusps in plan.
pub(super) fn drop() -> Case {
    let (radius, tip, hole) = (0.03_f64, 0.1_f64, 0.012);
    let mut stack = empty(vec![0.0, 0.01, 0.02], &[&[true, true], &[true, false]]);
    let half = (radius / tip).acos();
    let touch = |side: f64| [radius * half.cos(), side * radius * half.sin()];
    let back = |side: f64| [-radius * 0.5, side * radius * 0.75_f64.sqrt()];
    stack.vertices.extend([touch(-1.0), [tip, 0.0], touch(1.0), back(1.0), back(-1.0)]);
    let curve = Curve::Arc { center: [0.0; 2], radius, counter_clockwise: true };
    let mut edge = |from, to, curve: &Curve<f64>, cells| {
        stack.edges.push(Edge { ends: [from, to], curve: curve.clone(), cells });
    };
    edge(0, 1, &Curve::Line, [Some(1), None]);
    edge(1, 2, &Curve::Line, [Some(1), None]);
    edge(2, 3, &curve, [Some(0), None]);
    edge(3, 4, &curve, [Some(0), None]);
    edge(4, 0, &curve, [Some(0), None]);
    edge(0, 2, &curve, [Some(0), Some(1)]);
    bore(&mut stack, [0.0; 2], hole, &[[0.0, 0.02]], 0);
    let disc = PI * (radius * radius - hole * hole);
    let kite = radius * tip * half.sin() - half * radius * radius;
    ("drop", stack, disc * 0.02 + kite * 0.01)
}

/// Two plates with a gap between them, joined at one end.
pub(super) fn fork() -> Case {
    let levels = vec![-0.02, -0.012, 0.012, 0.02];
    let mut stack = empty(levels, &[&[true, true, true], &[true, false, true]]);
    stack.vertices.extend([[0.0, 0.0], [0.03, 0.0], [0.1, 0.0], [0.1, 0.05], [0.03, 0.05], [0.0, 0.05]]);
    let mut line = |from, to, cells| stack.edges.push(Edge { ends: [from, to], curve: Curve::Line, cells });
    line(0, 1, [Some(0), None]);
    line(1, 2, [Some(1), None]);
    line(2, 3, [Some(1), None]);
    line(3, 4, [Some(1), None]);
    line(4, 5, [Some(0), None]);
    line(5, 0, [Some(0), None]);
    line(1, 4, [Some(0), Some(1)]);
    bore(&mut stack, [0.07, 0.024], 0.01, &[[-0.02, -0.012], [0.012, 0.02]], 1);
    let prong = 0.07 * 0.05 - PI * 0.01 * 0.01;
    ("fork", stack, 0.03 * 0.05 * 0.04 + prong * 0.016)
}
