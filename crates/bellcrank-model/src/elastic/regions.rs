//! Where stress is looked for: bores, fillets and holes, and the rest of the surface; and where it means nothing.

use std::f64::consts::TAU;

use bellcrank_fem::{SizeField, element_sizes};
use bellcrank_mesh::Mesh;
use bellcrank_results::Unit;
use bellcrank_solid::{Curve, Edge, Stack};

use super::meshing::Solid;
use super::vector::{V3, norm, sub};
use crate::build::Form;
use crate::design::Plane;

/// Nodes that are looked at together.
#[derive(Clone, Debug)]
pub(super) struct Region {
    /// `bore B`, `fillet at [732, -60] mm`, `elsewhere`.
    pub(super) name: String,
    /// Part of a signal's name: `bore.B`, `fillet.1`, `elsewhere`.
    pub(super) key: String,
    pub(super) nodes: Vec<u32>,
}

/// Places round which stress grows without bound as the mesh gets finer, each with the reach of that: elements of the
/// first mesh, so that it does not change with the mesh.
#[derive(Clone, Debug, Default)]
pub(super) struct Doubtful {
    edges: SizeField,
    held: SizeField,
}

/// Why stress at a place means nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Doubt {
    /// A re-entrant edge without a radius.
    Edge,
    /// Nodes that are held in all directions.
    Held,
}

impl Doubt {
    pub(super) fn words(self) -> &'static str {
        match self {
            Doubt::Edge => "at a sharp edge",
            Doubt::Held => "at what is held",
        }
    }
}

impl Doubtful {
    /// Of the first mesh; `held` are the nodes that supports or rigid couplings hold.
    pub(super) fn new(mesh: &Mesh, held: &[u32]) -> Doubtful {
        let sizes = SizeField::new(mesh, &element_sizes(mesh));
        let sharp = mesh.node_sets.get("sharp").map_or(&[][..], Vec::as_slice);
        let field = |nodes: &[u32]| {
            let places = nodes.iter().map(|&node| mesh.nodes[node as usize]);
            SizeField::of_points(places.map(|at| (at, sizes.at(at))).collect())
        };
        Doubtful { edges: field(sharp), held: field(held) }
    }

    /// Whether a place is within an element of such a one.
    pub(super) fn at(&self, place: V3) -> Option<Doubt> {
        let near =
            |field: &SizeField| field.nearest(place).is_some_and(|(at, size)| norm(sub(at, place)) <= 1.01 * size);
        if near(&self.edges) {
            return Some(Doubt::Edge);
        }
        near(&self.held).then_some(Doubt::Held)
    }
}

/// The regions of a mesh, those without nodes left out.
pub(super) fn regions(solid: &Solid, mesh: &Mesh, length: &Unit) -> Vec<Region> {
    let mut all: Vec<Region> = Vec::new();
    for (set, nodes) in mesh.node_sets.iter().filter(|(set, _)| set.starts_with("bore.")) {
        all.push(Region { name: set.replacen('.', " ", 1), key: set.clone(), nodes: nodes.clone() });
    }
    let surface = mesh.face_sets.get("surface").cloned().unwrap_or_else(|| mesh.boundary());
    let surface = mesh.nodes_of_faces(&surface);
    let mut taken = vec![false; mesh.nodes.len()];
    if let Form::Stack { stack, plane } = &solid.form {
        all.extend(arcs(stack, *plane, mesh, &surface, length));
        near_arcs(stack, *plane, mesh, &surface, &mut taken);
    }
    all.iter().flat_map(|region| &region.nodes).for_each(|&node| taken[node as usize] = true);
    let rest = surface.into_iter().filter(|&node| !taken[node as usize]).collect();
    all.push(Region { name: "elsewhere".to_owned(), key: "elsewhere".to_owned(), nodes: rest });
    all.retain(|region| !region.nodes.is_empty());
    all
}

/// A circle of concave arcs that is no bore.
struct Circle {
    center: [f64; 2],
    radius: f64,
    /// All of its arcs together.
    angle: f64,
    edges: Vec<usize>,
}

fn arcs(stack: &Stack<f64>, plane: Plane, mesh: &Mesh, surface: &[u32], length: &Unit) -> Vec<Region> {
    let places = in_plan(mesh, surface, plane);
    let mut counts = [0, 0];
    let mut found = Vec::new();
    for circle in circles(stack).into_iter().filter(|circle| !is_bore(stack, circle)) {
        let hole = circle.angle > 0.99 * TAU;
        let on = |at: [f64; 2]| circle.edges.iter().any(|&edge| is_on(stack, &stack.edges[edge], at));
        let nodes: Vec<u32> = surface.iter().zip(&places).filter(|(_, at)| on(**at)).map(|(node, _)| *node).collect();
        counts[usize::from(hole)] += 1;
        let (word, count) = if hole { ("hole", counts[1]) } else { ("fillet", counts[0]) };
        let at = if hole { circle.center } else { middle(stack, circle.edges[0], &circle) };
        let at = at.map(|x| rounded(tidy(x, circle.radius), length)).join(", ");
        found.push(Region {
            name: format!("{word} at [{at}] {}", length.symbol),
            key: format!("{word}.{count}"),
            nodes,
        });
    }
    found
}

/// Four digits are enough to find it.
fn rounded(x: f64, unit: &Unit) -> String {
    let rounded: f64 = format!("{:.3e}", unit.show(x)).parse().unwrap_or(f64::NAN);
    format!("{}", rounded + 0.0)
}

/// What is zero but for rounding.
fn tidy(x: f64, size: f64) -> f64 {
    if x.abs() < 1e-9 * size { 0.0 } else { x }
}

fn in_plan(mesh: &Mesh, nodes: &[u32], plane: Plane) -> Vec<[f64; 2]> {
    let [right, up, _] = plane.axes();
    nodes.iter().map(|&node| mesh.nodes[node as usize]).map(|at| [at[right], at[up]]).collect()
}

/// Nodes beside a bore, fillet or hole have its stress: they are not elsewhere.
fn near_arcs(stack: &Stack<f64>, plane: Plane, mesh: &Mesh, surface: &[u32], taken: &mut [bool]) {
    const BESIDE: f64 = 0.25;
    let circles = circles(stack);
    for (&node, at) in surface.iter().zip(in_plan(mesh, surface, plane)) {
        let near = |circle: &Circle| {
            let away = (at[0] - circle.center[0]).hypot(at[1] - circle.center[1]);
            (away - circle.radius).abs() < BESIDE * circle.radius
        };
        taken[node as usize] |= circles.iter().any(near);
    }
}

fn circles(stack: &Stack<f64>) -> Vec<Circle> {
    let mut all: Vec<Circle> = Vec::new();
    for (index, edge) in stack.edges.iter().enumerate() {
        let Curve::Arc { center, radius, counter_clockwise } = &edge.curve else { continue };
        if !is_concave(stack, edge, *counter_clockwise) {
            continue;
        }
        let angle = turn(stack, edge, *center);
        let same = |circle: &&mut Circle| {
            let apart = (circle.center[0] - center[0]).hypot(circle.center[1] - center[1]);
            apart.max((circle.radius - radius).abs()) < 1e-7 * radius
        };
        match all.iter_mut().find(same) {
            Some(circle) => {
                circle.angle += angle;
                circle.edges.push(index);
            }
            None => all.push(Circle { center: *center, radius: *radius, angle, edges: vec![index] }),
        }
    }
    all
}

fn is_bore(stack: &Stack<f64>, circle: &Circle) -> bool {
    stack.bores.iter().any(|bore| {
        let apart = (circle.center[0] - bore.center[0]).hypot(circle.center[1] - bore.center[1]);
        apart.max((circle.radius - bore.diameter / 2.0).abs()) < 1e-7 * circle.radius
    })
}

/// Whether there is material outside of the circle and none inside at some height.
fn is_concave(stack: &Stack<f64>, edge: &Edge<f64>, counter_clockwise: bool) -> bool {
    let [left, right] = edge.cells;
    let (inside, outside) = if counter_clockwise { (left, right) } else { (right, left) };
    let filled = |cell: Option<usize>, interval: usize| cell.is_some_and(|cell| stack.cells[cell].filled[interval]);
    let intervals = stack.levels.len().saturating_sub(1);
    (0..intervals).any(|interval| !filled(inside, interval) && filled(outside, interval))
}

/// Angle of an arc that is shorter than half a turn.
fn turn(stack: &Stack<f64>, edge: &Edge<f64>, center: [f64; 2]) -> f64 {
    let [a, b] = edge.ends.map(|end| stack.vertices[end]).map(|at| (at[1] - center[1]).atan2(at[0] - center[0]));
    let turn = (b - a).rem_euclid(TAU);
    turn.min(TAU - turn)
}

/// An arc shorter than half a turn lies on one side of its chord: the right one where it runs counter-clockwise.
fn is_on(stack: &Stack<f64>, edge: &Edge<f64>, [x, y]: [f64; 2]) -> bool {
    let Curve::Arc { center, radius, counter_clockwise } = &edge.curve else { return false };
    if ((x - center[0]).hypot(y - center[1]) - radius).abs() > 1e-6 * radius {
        return false;
    }
    let [a, b] = edge.ends.map(|end| stack.vertices[end]);
    let side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    let side = if *counter_clockwise { -side } else { side };
    side >= -1e-6 * radius * radius
}

/// The middle of an arc.
fn middle(stack: &Stack<f64>, edge: usize, circle: &Circle) -> [f64; 2] {
    let [a, b] = stack.edges[edge].ends.map(|end| stack.vertices[end]);
    let chord: [f64; 2] = std::array::from_fn(|i| f64::midpoint(a[i], b[i]) - circle.center[i]);
    let length = chord[0].hypot(chord[1]);
    std::array::from_fn(|i| circle.center[i] + chord[i] * circle.radius / length.max(f64::MIN_POSITIVE))
}
