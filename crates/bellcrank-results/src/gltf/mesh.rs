//! Forms as triangles.

use super::{plate, surface};
use crate::Shape;
use crate::solid::vector::{V3, along, cross, norm, perpendicular, sub, unit};

/// Parts of a full turn.
pub(super) const AROUND: u32 = 24;
/// Parts from the pole of a ball to its equator.
const DOWN: u32 = 6;

/// Triangles with normals.
#[derive(Default)]
pub(super) struct Mesh {
    pub(super) positions: Vec<[f32; 3]>,
    pub(super) normals: Vec<[f32; 3]>,
    pub(super) indices: Vec<u32>,
}

impl Mesh {
    pub(super) fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    /// Adds a form; one without size adds nothing.
    pub(super) fn push(&mut self, shape: &Shape) {
        match shape {
            Shape::Rod { from, to, radius, round } if norm(sub(*to, *from)) > 1e-9 && *radius > 0.0 => {
                self.push_rod(*from, *to, *radius, *round);
            }
            Shape::Ball { center, radius } if *radius > 0.0 => self.push_ball(*center, *radius),
            Shape::Block { center, along, across, size } => self.push_block(*center, *along, *across, *size),
            Shape::Plate { points, normal, radius, thickness } if *radius > 0.0 => {
                plate::push(self, points, *normal, *radius, *thickness);
            }
            Shape::Surface(of) => surface::push(self, of),
            _ => {}
        }
    }

    /// A corner; gives its index.
    pub(super) fn vertex(&mut self, at: V3, normal: V3) -> u32 {
        let index = self.positions.len() as u32;
        self.positions.push(at.map(|x| x as f32));
        self.normals.push(unit(normal, [0.0, 0.0, 1.0]).map(|x| x as f32));
        index
    }

    pub(super) fn triangle(&mut self, a: u32, b: u32, c: u32) {
        self.indices.extend([a, b, c]);
    }

    fn push_rod(&mut self, from: V3, to: V3, radius: f64, round: bool) {
        let axis = unit(sub(to, from), [0.0, 0.0, 1.0]);
        let profile: Vec<Ring> =
            if round { rounded(norm(sub(to, from)), radius) } else { tube(norm(sub(to, from)), radius) };
        self.push_turned(from, axis, &profile);
        if !round {
            self.push_disc(from, axis.map(|x| -x), radius);
            self.push_disc(to, axis, radius);
        }
    }

    fn push_ball(&mut self, center: V3, radius: f64) {
        self.push_turned(center, [0.0, 0.0, 1.0], &rounded(0.0, radius));
    }

    /// A surface of revolution about `axis`; rings follow each other along it.
    fn push_turned(&mut self, origin: V3, axis: V3, rings: &[Ring]) {
        let (x, y) = frame(axis);
        let start = self.positions.len() as u32;
        for ring in rings {
            for k in 0..=AROUND {
                let out = direction(x, y, f64::from(k) / f64::from(AROUND));
                let at = along(along(origin, ring.height, axis), ring.radius, out);
                self.vertex(at, along(out.map(|c| c * ring.slope[0]), ring.slope[1], axis));
            }
        }
        for (low, pair) in (0u32..).zip(rings.windows(2)) {
            for k in 0..AROUND {
                let a = start + low * (AROUND + 1) + k;
                let (b, c, d) = (a + 1, a + AROUND + 1, a + AROUND + 2);
                // At a pole one of the two triangles has no area.
                if pair[0].radius > 0.0 {
                    self.triangle(a, b, d);
                }
                if pair[1].radius > 0.0 {
                    self.triangle(a, d, c);
                }
            }
        }
    }

    fn push_disc(&mut self, center: V3, normal: V3, radius: f64) {
        let (x, y) = frame(normal);
        let rim: Vec<V3> =
            (0..AROUND).map(|k| along(center, radius, direction(x, y, f64::from(k) / f64::from(AROUND)))).collect();
        self.push_convex(&rim, normal);
    }

    /// A convex polygon, counter-clockwise about its normal.
    pub(super) fn push_convex(&mut self, corners: &[V3], normal: V3) {
        let start = self.positions.len() as u32;
        for corner in corners {
            self.vertex(*corner, normal);
        }
        for k in 2..corners.len() as u32 {
            self.triangle(start, start + k - 1, start + k);
        }
    }

    fn push_block(&mut self, center: V3, length: V3, width: V3, size: V3) {
        let axes = [length, width, cross(length, width)];
        for k in 0..3 {
            let (u, v) = (axes[(k + 1) % 3], axes[(k + 2) % 3]);
            let (du, dv) = (size[(k + 1) % 3] / 2.0, size[(k + 2) % 3] / 2.0);
            for side in [1.0, -1.0] {
                let middle = along(center, side * size[k] / 2.0, axes[k]);
                let corner = |a: f64, b: f64| along(along(middle, a * du * side, u), b * dv, v);
                let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
                self.push_convex(&corners, axes[k].map(|x| x * side));
            }
        }
    }
}

/// A circle of a surface of revolution: its place, size, and normal as outward and along components.
struct Ring {
    height: f64,
    radius: f64,
    slope: [f64; 2],
}

fn tube(length: f64, radius: f64) -> Vec<Ring> {
    [0.0, length].map(|height| Ring { height, radius, slope: [1.0, 0.0] }).into()
}

/// Half balls around both ends of a tube; a ball where that has no length.
fn rounded(length: f64, radius: f64) -> Vec<Ring> {
    let ring = |middle: f64, side: f64, part: u32| {
        let (sin, cos) = (std::f64::consts::FRAC_PI_2 * f64::from(part) / f64::from(DOWN)).sin_cos();
        // An exact pole has no area around it.
        let out = if part == DOWN { 0.0 } else { cos };
        Ring { height: middle + side * radius * sin, radius: radius * out, slope: [out, side * sin] }
    };
    let below = (0..=DOWN).rev().map(|part| ring(0.0, -1.0, part));
    let above = (u32::from(length == 0.0)..=DOWN).map(|part| ring(length, 1.0, part));
    below.chain(above).collect()
}

/// Two directions that with `axis` make right-handed axes.
pub(super) fn frame(axis: V3) -> (V3, V3) {
    let x = perpendicular(axis);
    (x, cross(axis, x))
}

/// The direction `turn` full turns from `x` towards `y`.
pub(super) fn direction(x: V3, y: V3, turn: f64) -> V3 {
    let (sin, cos) = (std::f64::consts::TAU * turn).sin_cos();
    std::array::from_fn(|k| cos * x[k] + sin * y[k])
}
