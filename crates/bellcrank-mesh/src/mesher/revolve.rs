//! Bodies of revolution: stepped ones as stacks of discs, others as a triangulated profile swept round.

mod sweep;

use std::f64::consts::TAU;

use bellcrank_solid::{Cell, Curve, Edge, Revolved, Stack};

use super::{MesherError, Sizes, mesh_stack};
use crate::{Mesh, Shape};

/// Meshes a body of revolution; face sets `surface`, and `top` and `bottom` of stepped bodies.
///
/// A profile of lines along and square to the axis gives discs, meshed as [`mesh_stack`] does. With a cone in it, the
/// profile is swept round and gives tetrahedra only: `shape` then says no more than whether there are mid-side
/// nodes. Every node of the surface lies on the true surface.
///
/// # Errors
///
/// As [`mesh_stack`], and when the profile encloses nothing or crosses its axis or itself.
pub fn mesh_revolved(revolved: &Revolved<f64>, shape: Shape, sizes: &Sizes) -> Result<Mesh, MesherError> {
    super::sizes::check(sizes, shape)?;
    let profile = tidy(&revolved.profile)?;
    let back = Axes::of(revolved);
    // Sizes are asked for in the axes of the body, and the mesh is made in those of the profile.
    let background = sizes.background.map(|wanted| move |at| wanted(back.place(at)));
    let background = background.as_ref().map(|wanted| wanted as &dyn Fn([f64; 3]) -> f64);
    let sizes = Sizes { background, ..*sizes };
    let stepped = profile_sides(&profile).all(|[a, b]| a[0] == b[0] || a[1] == b[1]);
    let mut mesh = if stepped {
        mesh_stack(&discs(&profile), &[], shape, &sizes)?
    } else {
        sweep::sweep(&profile, shape, &sizes)?
    };
    mesh.nodes.iter_mut().for_each(|place| *place = back.place(*place));
    Ok(mesh)
}

fn profile_sides(profile: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> + '_ {
    (0..profile.len()).map(|k| [profile[k], profile[(k + 1) % profile.len()]])
}

/// The profile counter-clockwise in (r, h), without doubled corners; what is on the axis but for rounding is on it.
fn tidy(profile: &[[f64; 2]]) -> Result<Vec<[f64; 2]>, MesherError> {
    let extent = profile.iter().flatten().fold(0.0_f64, |most, c| most.max(c.abs()));
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * extent;
    let mut tidy: Vec<[f64; 2]> = Vec::new();
    for &[r, h] in profile {
        let before = tidy.last().copied().unwrap_or([f64::INFINITY; 2]);
        // Corners that differ by rounding only give sides that are square but for rounding.
        let r = if near(r, 0.0) {
            0.0
        } else if near(r, before[0]) {
            before[0]
        } else {
            r
        };
        let h = if near(h, before[1]) { before[1] } else { h };
        if [r, h] != before {
            tidy.push([r, h]);
        }
    }
    if tidy.len() > 1 && tidy.first() == tidy.last() {
        tidy.pop();
    }
    let twice: f64 = profile_sides(&tidy).map(|[a, b]| a[0] * b[1] - b[0] * a[1]).sum();
    if tidy.len() < 3 || twice == 0.0 || !twice.is_finite() || tidy.iter().any(|corner| corner[0] < 0.0) {
        return Err(MesherError::Profile);
    }
    if twice < 0.0 {
        tidy.reverse();
    }
    Ok(tidy)
}

/// Axes of the profile in those of the body.
#[derive(Clone, Copy)]
struct Axes {
    base: [f64; 3],
    columns: [[f64; 3]; 3],
}

impl Axes {
    fn of(revolved: &Revolved<f64>) -> Axes {
        let axis = revolved.axis;
        let other = if axis[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let v = crate::boundary::cross(axis, other);
        let length = crate::boundary::dot(v, v).sqrt();
        let v = v.map(|c| c / length);
        let u = crate::boundary::cross(v, axis);
        Axes { base: revolved.base, columns: [u, v, axis] }
    }

    fn place(&self, at: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.base[i] + (0..3).map(|c| self.columns[c][i] * at[c]).sum::<f64>())
    }
}

/// A stepped body as rings between circles.
fn discs(profile: &[[f64; 2]]) -> Stack<f64> {
    let sorted = |c: usize| {
        let mut all: Vec<f64> = profile.iter().map(|corner| corner[c]).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    };
    let (mut radii, levels) = (sorted(0), sorted(1));
    radii.retain(|&radius| radius > 0.0);
    let middle = |k: usize| (if k == 0 { 0.0 } else { radii[k - 1] } + radii[k]) / 2.0;
    let filled = |k: usize| {
        levels.windows(2).map(|pair| inside(profile, [middle(k), (pair[0] + pair[1]) / 2.0])).collect::<Vec<bool>>()
    };
    let rings: Vec<Vec<bool>> = (0..radii.len()).map(filled).collect();
    let mut number = Vec::new();
    let mut cells = Vec::new();
    for filled in rings {
        number.push(filled.contains(&true).then_some(cells.len()));
        if filled.contains(&true) {
            cells.push(Cell { loops: Vec::new(), filled });
        }
    }
    let mut stack = Stack { vertices: Vec::new(), edges: Vec::new(), cells, levels, ..empty() };
    for (k, &radius) in radii.iter().enumerate() {
        circle(&mut stack, radius, [number[k], number.get(k + 1).copied().flatten()]);
    }
    stack
}

fn empty() -> Stack<f64> {
    Stack {
        vertices: Vec::new(),
        edges: Vec::new(),
        cells: Vec::new(),
        levels: Vec::new(),
        bores: Vec::new(),
        moments: bellcrank_solid::Moments::default(),
        warnings: Vec::new(),
    }
}

/// A circle of three arcs round the axis.
fn circle(stack: &mut Stack<f64>, radius: f64, cells: [Option<usize>; 2]) {
    let first = stack.vertices.len();
    let angles = [0.0, TAU / 3.0, 2.0 * TAU / 3.0];
    stack.vertices.extend(angles.map(|angle: f64| [radius * angle.cos(), radius * angle.sin()]));
    let curve = Curve::Arc { center: [0.0; 2], radius, counter_clockwise: true };
    let arc = |k: usize| Edge { ends: [first + k, first + (k + 1) % 3], curve: curve.clone(), cells };
    stack.edges.extend((0..3).map(arc));
}

fn inside(profile: &[[f64; 2]], [r, h]: [f64; 2]) -> bool {
    let crossed = profile_sides(profile)
        .filter(|[a, b]| (a[1] > h) != (b[1] > h) && r < a[0] + (h - a[1]) / (b[1] - a[1]) * (b[0] - a[0]));
    crossed.count() % 2 == 1
}
