//! On random trees of every joint, in the plane and in space: the recursions against the passes in world axes, and
//! against each other.

use super::Recursions;
use crate::mass_matrix::MassMatrix;
use crate::mechanism::Mechanism;
use crate::topology::Motion;
use crate::workspace::NodeState;
use crate::{Blueprint, Body, BodyId, Joint, JointKind, Place, dynamics, kinematics};
use bellcrank_math::{Components, Planar, Space, Spatial, matrix_from_rpy};

/// Numbers in −1..1 that a seed determines.
struct Draw(u64);

impl Draw {
    fn one(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        2.0 * ((self.0 >> 11) as f64 / 9_007_199_254_740_992.0) - 1.0
    }
    fn below(&mut self, n: usize) -> usize {
        ((0.5 + 0.5 * self.one()) * n as f64) as usize
    }
    fn three(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.one())
    }
    fn numbers(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.one()).collect()
    }
}

fn kind(draw: &mut Draw, planar: bool) -> JointKind<f64> {
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    if planar {
        let turned = if draw.one() > 0.0 { z } else { [0.0, 0.0, -1.0] };
        return [JointKind::Revolute { axis: turned }, JointKind::Prismatic { axis: y }, JointKind::Planar]
            [draw.below(3)]
        .clone();
    }
    let axis = draw.three();
    let kinds = [
        JointKind::Revolute { axis },
        JointKind::Prismatic { axis },
        JointKind::Cylindrical { axis },
        JointKind::Screw { axis, pitch: 0.3 },
        JointKind::Universal { axis: x, axis2: y },
        JointKind::Spherical,
        JointKind::Weld,
        JointKind::Free,
    ];
    kinds[draw.below(kinds.len())].clone()
}

fn place(draw: &mut Draw, body: usize, planar: bool) -> Place<f64> {
    let flat = |v: [f64; 3]| if planar { [v[0], v[1], 0.0] } else { v };
    let turn = draw.three();
    let turn = if planar { [0.0, 0.0, turn[2]] } else { turn };
    Place { body: BodyId(body), position: flat(draw.three()), rotation: matrix_from_rpy(&turn) }
}

/// A tree of a few bodies; every third joint is passed backwards.
fn tree(draw: &mut Draw, planar: bool) -> Blueprint<f64> {
    let mut bodies = vec![Body { mass: 0.0, center: [0.0; 3], inertia: [[0.0; 3]; 3] }];
    let mut joints = Vec::new();
    for i in 1..=1 + draw.below(6) {
        // A tensor of two point masses and a ball: positive definite and full.
        let (a, b) = (draw.three(), draw.three());
        let inertia = std::array::from_fn(|r| {
            std::array::from_fn(|c| {
                let unit = f64::from(u8::from(r == c));
                let of = |p: &[f64; 3]| unit * p.iter().map(|x| x * x).sum::<f64>() - p[r] * p[c];
                of(&a) + of(&b) + 0.1 * unit
            })
        });
        let center = draw.three();
        let center = if planar { [center[0], center[1], 0.0] } else { center };
        bodies.push(Body { mass: 1.5 + draw.one(), center, inertia });
        let parent = draw.below(i);
        let mut places = [place(draw, parent, planar), place(draw, i, planar)];
        if draw.below(3) == 0 {
            places.swap(0, 1);
        }
        joints.push(Joint { kind: kind(draw, planar), places: Some(places), start: Vec::new(), at_start: false });
    }
    let gravity = if planar { [0.3, -9.81, 0.0] } else { [0.3, -9.81, 1.2] };
    Blueprint { gravity, bodies, joints, forces: Vec::new(), flexible: Vec::new(), inputs: 0 }
}

/// Torques and mass matrix in world axes, and twice the kinetic energy.
fn in_world_axes<S: Space<T = f64>>(mech: &Mechanism<S>, q: &[f64], v: &[f64], a: &[f64]) -> (Vec<f64>, Vec<f64>, f64) {
    let mut x = vec![NodeState::<S>::default(); mech.nodes.len()];
    kinematics::positions(mech, q, &mut x);
    kinematics::velocities(mech, v, &mut x);
    kinematics::accelerations(mech, v, Some(a), &mut x);
    dynamics::own_wrenches(mech, &mut x);
    x.iter_mut().for_each(|x| (x.f, x.n) = (x.own_f, x.own_n));
    dynamics::gather(mech, &mut x);
    let mut tau = vec![0.0; mech.nv];
    dynamics::project(mech, &x, &mut tau);
    let mut mass = MassMatrix::new(mech);
    mass.evaluate(mech, &x);
    let mut m = vec![0.0; mech.nv * mech.nv];
    for (&(i, j), value) in mass.entries.iter().zip(&mass.values) {
        (m[i * mech.nv + j], m[j * mech.nv + i]) = (*value, *value);
    }
    let energy = mech.nodes.iter().zip(&x).filter_map(|(node, x)| {
        let body = node.inertia?;
        let v = x.v + S::cross(x.w, S::rotate(&x.R, body.center));
        Some(body.mass * v.dot(v) + x.w.dot(S::apply_inertia(&body.about_center, &x.R, x.w)))
    });
    (tau, m, energy.sum())
}

fn close(a: &[f64], b: &[f64], what: &str) {
    let size = b.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    for (a, b) in a.iter().zip(b) {
        assert!((a - b).abs() < 1e-12 * size, "{what}: {a} against {b}");
    }
}

/// The least pivot of a Cholesky factorization; negative where the matrix is not positive definite.
fn least_pivot(m: &[f64], n: usize) -> f64 {
    let mut l = m.to_vec();
    let mut least = f64::INFINITY;
    for k in 0..n {
        least = least.min(l[k * n + k]);
        for i in k + 1..n {
            let factor = l[i * n + k] / l[k * n + k];
            (k + 1..n).for_each(|j| l[i * n + j] -= factor * l[k * n + j]);
        }
    }
    least
}

fn random_trees<S: Space<T = f64>>(planar: bool) {
    let mut draw = Draw(7);
    for _ in 0..200 {
        let mech = Mechanism::<S>::build(&tree(&mut draw, planar)).expect("builds");
        let nv = mech.nv;
        let (mut q, v, a) = (draw.numbers(mech.nq), draw.numbers(nv), draw.numbers(nv));
        for node in mech.nodes.iter().filter(|n| n.motion == Motion::Ball) {
            crate::attitude::normalize(&mut q[node.q..node.q + 4]);
        }
        let mut r = Recursions::new(&mech);
        let (mut tau, mut bias, mut m) = (vec![0.0; nv], vec![0.0; nv], vec![f64::NAN; nv * nv]);
        r.inverse_dynamics(&q, &v, &a, &mut tau);
        r.inverse_dynamics(&q, &v, &vec![0.0; nv], &mut bias);
        r.mass_matrix(&q, &mut m);
        let (known_tau, known_m, energy) = in_world_axes(&mech, &q, &v, &a);
        close(&tau, &known_tau, "torques");
        close(&m, &known_m, "masses");
        let times = |u: &[f64]| -> Vec<f64> {
            m.chunks(nv.max(1)).map(|row| row.iter().zip(u).map(|(m, u)| m * u).sum()).collect()
        };
        let sum: Vec<f64> = times(&a).iter().zip(&bias).map(|(m, h)| m + h).collect();
        close(&sum, &tau, "M a + h");
        close(&[times(&v).iter().zip(&v).map(|(m, v)| m * v).sum::<f64>()], &[energy], "energy");
        assert!(nv == 0 || least_pivot(&m, nv) > 0.0, "positive definite");
    }
}

#[test]
fn random_trees_of_the_plane() {
    random_trees::<Planar<f64>>(true);
}

#[test]
fn random_trees_of_space() {
    random_trees::<Spatial<f64>>(false);
}
