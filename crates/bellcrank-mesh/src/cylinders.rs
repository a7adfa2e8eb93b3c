//! Cylinders among the surfaces of a mesh: bores and pins that joints can be hung on.

use crate::boundary::{cross, dot};
use crate::{Face, Mesh};

/// Face sets that lie on one cylinder.
#[derive(Clone, Debug, PartialEq)]
pub struct Cylinder {
    /// Names of the face sets.
    pub sets: Vec<String>,
    /// Point of the axis in the middle of the length, in m.
    pub center: [f64; 3],
    /// Direction of the axis; its largest component is positive.
    pub axis: [f64; 3],
    /// Radius in m.
    pub radius: f64,
    /// Length along the axis in m.
    pub length: f64,
    /// Whether the material is outside: a hole, not a pin.
    pub bore: bool,
}

/// Nodes may be off the cylinder by this part of its radius.
const TOLERANCE: f64 = 2e-3;
/// A set whose normals turn by less than this part of what a half cylinder's do is taken for plane.
const LEAST_TURN: f64 = 1e-4;

impl Mesh {
    /// Cylinders among the face sets. Sets on one cylinder (a bore in two halves) are told together; sets that go round
    /// less than about 20° are left out.
    pub fn cylinders(&self) -> Vec<Cylinder> {
        let mut found: Vec<Cylinder> = Vec::new();
        for (name, faces) in &self.face_sets {
            let Some(cylinder) = self.cylinder(name, faces) else { continue };
            match found.iter_mut().find(|other| same(other, &cylinder)) {
                Some(other) => join(other, cylinder),
                None => found.push(cylinder),
            }
        }
        found
    }

    fn cylinder(&self, name: &str, faces: &[Face]) -> Option<Cylinder> {
        let samples: Vec<([f64; 3], [f64; 3])> = faces.iter().flat_map(|&face| self.samples(face)).collect();
        let nodes: Vec<[f64; 3]> =
            self.nodes_of_faces(faces).into_iter().map(|node| self.nodes[node as usize]).collect();
        if nodes.len() < 6 {
            return None;
        }
        let axis = axis_of(&samples)?;
        let fit = fit(&nodes, axis)?;
        let off = |p: &[f64; 3]| (fit.distance(*p) - fit.radius).abs();
        if nodes.iter().map(off).fold(0.0, f64::max) > TOLERANCE * fit.radius {
            return None;
        }
        let along: Vec<f64> = nodes.iter().map(|p| dot(sub(*p, fit.center), fit.axis)).collect();
        let (low, high) = along.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &t| (l.min(t), h.max(t)));
        let outward: f64 = samples.iter().map(|(p, n)| dot(fit.radial(*p), *n)).sum();
        let middle = (low + high) / 2.0;
        let center = std::array::from_fn(|i| fit.center[i] + middle * fit.axis[i]);
        let axis = upright(fit.axis);
        let length = high - low;
        Some(Cylinder { sets: vec![name.to_owned()], center, axis, radius: fit.radius, length, bore: outward < 0.0 })
    }

    /// Place and normal, of the length of the area, at the integration points of a face.
    fn samples(&self, face: Face) -> Vec<([f64; 3], [f64; 3])> {
        let form = self.face_shape(face);
        let places: Vec<[f64; 3]> = self.face_nodes(face).map(|node| self.nodes[node as usize]).collect();
        let at = |point: &crate::Point| {
            let (mut n, mut d) = ([0.0; 8], [[0.0; 2]; 8]);
            form.evaluate([point.at[0], point.at[1]], &mut n, &mut d);
            let along = |c: usize| -> [f64; 3] {
                std::array::from_fn(|i| places.iter().zip(&d).map(|(place, d)| place[i] * d[c]).sum())
            };
            let place = std::array::from_fn(|i| places.iter().zip(&n).map(|(place, n)| place[i] * n).sum());
            (place, cross(along(0), along(1)).map(|c| c * point.weight))
        };
        form.points().iter().map(at).collect()
    }
}

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

/// With its largest component positive.
fn upright(axis: [f64; 3]) -> [f64; 3] {
    let largest = axis.into_iter().fold(0.0, |most: f64, c| if c.abs() > most.abs() { c } else { most });
    axis.map(|c| c * largest.signum())
}

/// The direction that no normal has: the largest column of the adjugate of Σ n nᵀ.
fn axis_of(samples: &[([f64; 3], [f64; 3])]) -> Option<[f64; 3]> {
    let mut m = [[0.0; 3]; 3];
    for (_, n) in samples {
        let length = dot(*n, *n).sqrt();
        for i in 0..3 {
            (0..3).for_each(|j| m[i][j] += n[i] * n[j] / length);
        }
    }
    let trace = m[0][0] + m[1][1] + m[2][2];
    let columns = [cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])];
    let best = columns.into_iter().max_by(|a, b| dot(*a, *a).total_cmp(&dot(*b, *b)))?;
    let length = dot(best, best).sqrt();
    // A half cylinder has (trace/2)² here, a plane nothing.
    (length > LEAST_TURN * trace * trace).then(|| best.map(|c| c / length))
}

struct Fit {
    center: [f64; 3],
    axis: [f64; 3],
    radius: f64,
}

impl Fit {
    fn radial(&self, p: [f64; 3]) -> [f64; 3] {
        let from = sub(p, self.center);
        let along = dot(from, self.axis);
        std::array::from_fn(|i| from[i] - along * self.axis[i])
    }

    fn distance(&self, p: [f64; 3]) -> f64 {
        let r = self.radial(p);
        dot(r, r).sqrt()
    }
}

/// Gauss–Newton on the distances from a cylinder, begun with an axis.
fn fit(nodes: &[[f64; 3]], axis: [f64; 3]) -> Option<Fit> {
    let count = nodes.len() as f64;
    let mean: [f64; 3] = std::array::from_fn(|i| nodes.iter().map(|p| p[i]).sum::<f64>() / count);
    let mut fit = Fit { center: mean, axis, radius: 0.0 };
    circle(nodes, &mut fit)?;
    for _ in 0..8 {
        let (u, v) = beside(fit.axis);
        let (mut normal, mut right) = ([[0.0; 5]; 5], [0.0; 5]);
        for &p in nodes {
            let radial = fit.radial(p);
            let distance = dot(radial, radial).sqrt();
            let along = dot(sub(p, fit.center), fit.axis);
            let (a, b) = (dot(radial, u) / distance, dot(radial, v) / distance);
            let row = [-a, -b, -along * a, -along * b, -1.0];
            for i in 0..5 {
                right[i] -= row[i] * (distance - fit.radius);
                (0..5).for_each(|j| normal[i][j] += row[i] * row[j]);
            }
        }
        let step = solve(normal, right)?;
        for i in 0..3 {
            fit.center[i] += step[0] * u[i] + step[1] * v[i];
            fit.axis[i] += step[2] * u[i] + step[3] * v[i];
        }
        let length = dot(fit.axis, fit.axis).sqrt();
        fit.axis = fit.axis.map(|c| c / length);
        fit.radius += step[4];
    }
    (fit.radius.is_finite() && fit.radius > 0.0).then_some(fit)
}

/// Two directions square to an axis and to each other.
fn beside(axis: [f64; 3]) -> ([f64; 3], [f64; 3]) {
    let other = if axis[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
    let u = cross(axis, other);
    let length = dot(u, u).sqrt();
    let u = u.map(|c| c / length);
    (u, cross(axis, u))
}

/// Centre and radius of the circle that nodes lie on, seen along the axis (Kåsa, 1976).
fn circle(nodes: &[[f64; 3]], fit: &mut Fit) -> Option<()> {
    let (u, v) = beside(fit.axis);
    let (mut normal, mut right) = ([[0.0; 5]; 5], [0.0; 5]);
    for &p in nodes {
        let from = sub(p, fit.center);
        let row = [dot(from, u), dot(from, v), 1.0];
        let square = row[0] * row[0] + row[1] * row[1];
        for i in 0..3 {
            right[i] += row[i] * square;
            (0..3).for_each(|j| normal[i][j] += row[i] * row[j]);
        }
    }
    (3..5).for_each(|i| normal[i][i] = 1.0);
    let [a, b, c, ..] = solve(normal, right)?;
    (0..3).for_each(|i| fit.center[i] += (a * u[i] + b * v[i]) / 2.0);
    fit.radius = (c + (a * a + b * b) / 4.0).sqrt();
    fit.radius.is_finite().then_some(())
}

/// Gaussian elimination with pivots; `None` when singular.
fn solve(mut m: [[f64; 5]; 5], mut b: [f64; 5]) -> Option<[f64; 5]> {
    for k in 0..5 {
        let pivot = (k..5).max_by(|&i, &j| m[i][k].abs().total_cmp(&m[j][k].abs()))?;
        m.swap(k, pivot);
        b.swap(k, pivot);
        if m[k][k].abs() < 1e-300 {
            return None;
        }
        for i in k + 1..5 {
            let factor = m[i][k] / m[k][k];
            (k..5).for_each(|j| m[i][j] -= factor * m[k][j]);
            b[i] -= factor * b[k];
        }
    }
    for k in (0..5).rev() {
        let known: f64 = (k + 1..5).map(|j| m[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / m[k][k];
    }
    Some(b)
}

fn same(a: &Cylinder, b: &Cylinder) -> bool {
    let apart = sub(b.center, a.center);
    let along = dot(apart, a.axis);
    let aside: [f64; 3] = std::array::from_fn(|i| apart[i] - along * a.axis[i]);
    let close = 2.0 * TOLERANCE * a.radius;
    let turned = cross(a.axis, b.axis);
    let touching = along.abs() <= (a.length + b.length) / 2.0 + close;
    a.bore == b.bore
        && touching
        && (a.radius - b.radius).abs() < close
        && dot(aside, aside).sqrt() < close
        && dot(turned, turned).sqrt() < 2.0 * TOLERANCE
}

/// Sets of the second go to the first; the length covers both.
fn join(a: &mut Cylinder, mut b: Cylinder) {
    let along = dot(sub(b.center, a.center), a.axis);
    let low = (-a.length / 2.0).min(along - b.length / 2.0);
    let high = (a.length / 2.0).max(along + b.length / 2.0);
    let middle = (low + high) / 2.0;
    (0..3).for_each(|i| a.center[i] += middle * a.axis[i]);
    a.length = high - low;
    a.sets.append(&mut b.sets);
}
