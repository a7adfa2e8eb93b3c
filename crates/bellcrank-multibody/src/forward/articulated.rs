//! `M a = τ` of a tree in O(n): articulated bodies (Featherstone 2008 §7.3), without M.
//!
//! World axes, references at the nodes' origins. What the motion asks for beside `M a` stands in τ already, so the
//! recursion carries forces and accelerations of a machine at rest.

use crate::mass_matrix::{ball_axis, push_of};
use crate::mechanism::Mechanism;
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::Space;

/// Components of a wrench or motion: forces or velocities first, then moments or turning.
type Six = [f64; 6];
type Matrix = [Six; 6];

/// Pivots below this part of the largest inertia mean that no mass moves along.
const MASSLESS: f64 = 1e-13;

/// One motion of a node, factored.
#[derive(Clone, Copy, Debug, Default)]
struct Freedom {
    /// Axis, and what its unit acceleration asks of the articulated body.
    axis: Six,
    image: Six,
    /// 1 / (axis · image).
    inverse: f64,
    /// Velocity component.
    v: usize,
}

/// Articulated inertias of a tree, factored.
#[derive(Clone, Debug)]
pub(crate) struct Articulated {
    inertia: Vec<Matrix>,
    force: Vec<Six>,
    motion: Vec<Six>,
    /// Free motions of all nodes, node after node, outermost first within a node.
    freedom: Vec<Freedom>,
    /// Where the motions of each node begin.
    first: Vec<usize>,
    /// Scaled force left along each motion.
    left: Vec<f64>,
}

impl Articulated {
    /// Room for a tree; components in `prescribed` are no unknowns.
    pub(crate) fn new<S: Space<T = f64>>(mech: &Mechanism<S>, prescribed: impl Fn(usize) -> bool) -> Self {
        let (mut freedom, mut first) = (Vec::new(), Vec::new());
        for node in &mech.nodes {
            first.push(freedom.len());
            let all = node.v..node.v + node.motion.dofs();
            freedom.extend(all.rev().filter(|&v| !prescribed(v)).map(|v| Freedom { v, ..Freedom::default() }));
        }
        first.push(freedom.len());
        let nodes = mech.nodes.len();
        Self {
            inertia: vec![[[0.0; 6]; 6]; nodes],
            force: vec![[0.0; 6]; nodes],
            motion: vec![[0.0; 6]; nodes],
            left: vec![0.0; freedom.len()],
            freedom,
            first,
        }
    }

    /// Factors at the poses of `x`; false where no mass moves along with a coordinate.
    pub(crate) fn factor<S: Space<T = f64>>(&mut self, mech: &Mechanism<S>, x: &[NodeState<S>]) -> bool {
        for ((node, x), inertia) in mech.nodes.iter().zip(x).zip(&mut self.inertia) {
            *inertia = match &node.inertia {
                Some(body) => columns_of::<S>(|axis| push_of(body, x, axis)),
                None => [[0.0; 6]; 6],
            };
        }
        for i in (1..mech.nodes.len()).rev() {
            let largest = (0..6).fold(0.0, |m: f64, k| m.max(self.inertia[i][k][k]));
            for k in self.first[i]..self.first[i + 1] {
                let axis = axis_of(mech, x, i, self.freedom[k].v);
                let image = times(&self.inertia[i], &axis);
                let pivot = dot(&axis, &image);
                if pivot <= MASSLESS * largest {
                    return false;
                }
                let inverse = 1.0 / pivot;
                self.freedom[k] = Freedom { axis, image, inverse, v: self.freedom[k].v };
                take_off(&mut self.inertia[i], &image, inverse);
            }
            let moved = moved::<S>(&self.inertia[i], x[i].r);
            add(&mut self.inertia[mech.nodes[i].parent], &moved);
        }
        true
    }

    /// Solves `M a = tau` over the free components; the others of `a` stay.
    pub(crate) fn solve<S: Space<T = f64>>(
        &mut self,
        mech: &Mechanism<S>,
        x: &[NodeState<S>],
        tau: &[f64],
        a: &mut [f64],
    ) {
        self.force.fill([0.0; 6]);
        for i in (1..mech.nodes.len()).rev() {
            for k in self.first[i]..self.first[i + 1] {
                let f = self.freedom[k];
                self.left[k] = (tau[f.v] - dot(&f.axis, &self.force[i])) * f.inverse;
                let left = self.left[k];
                self.force[i].iter_mut().zip(&f.image).for_each(|(p, u)| *p += u * left);
            }
            let shifted = shifted_force::<S>(&self.force[i], x[i].r);
            self.force[mech.nodes[i].parent].iter_mut().zip(&shifted).for_each(|(p, s)| *p += s);
        }
        self.motion[0] = [0.0; 6];
        for (i, (node, x)) in mech.nodes.iter().zip(x).enumerate().skip(1) {
            let mut motion = shifted_motion::<S>(&self.motion[node.parent], x.r);
            for k in (self.first[i]..self.first[i + 1]).rev() {
                let f = self.freedom[k];
                let acceleration = self.left[k] - f.inverse * dot(&f.image, &motion);
                a[f.v] = acceleration;
                motion.iter_mut().zip(&f.axis).for_each(|(m, s)| *m += s * acceleration);
            }
            self.motion[i] = motion;
        }
    }
}

fn dot(a: &Six, b: &Six) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn times(m: &Matrix, x: &Six) -> Six {
    std::array::from_fn(|i| dot(&m[i], x))
}

fn add(to: &mut Matrix, other: &Matrix) {
    to.iter_mut().flatten().zip(other.iter().flatten()).for_each(|(t, o)| *t += o);
}

/// `I − u uᵀ / d`.
fn take_off(m: &mut Matrix, u: &Six, inverse: f64) {
    for (row, ui) in m.iter_mut().zip(u) {
        let factor = ui * inverse;
        row.iter_mut().zip(u).for_each(|(m, uj)| *m -= factor * uj);
    }
}

/// The axis of velocity component `v` of node `i`.
fn axis_of<S: Space<T = f64>>(mech: &Mechanism<S>, x: &[NodeState<S>], i: usize, v: usize) -> Six {
    let zero = (S::Vector::default(), S::Angular::default());
    join::<S>(match mech.nodes[i].motion {
        Motion::Fixed => zero,
        Motion::Turn => (zero.0, x[i].s_w),
        Motion::Slide => (x[i].s_v, zero.1),
        Motion::Screw(_) => (x[i].s_v, x[i].s_w),
        Motion::Ball => (zero.0, ball_axis(&x[i], v - mech.nodes[i].v)),
    })
}

fn join<S: Space<T = f64>>((v, w): (S::Vector, S::Angular)) -> Six {
    let (v, w) = (S::spread(v), S::spread_angular(w));
    [v[0], v[1], v[2], w[0], w[1], w[2]]
}

fn split<S: Space<T = f64>>(x: &Six) -> (S::Vector, S::Angular) {
    (S::vector(&[x[0], x[1], x[2]]), S::angular(&[x[3], x[4], x[5]]))
}

/// The matrix whose columns are the images of unit motions (symmetric).
fn columns_of<S: Space<T = f64>>(image: impl Fn((S::Vector, S::Angular)) -> (S::Vector, S::Angular)) -> Matrix {
    std::array::from_fn(|k| {
        let mut unit = [0.0; 6];
        unit[k] = 1.0;
        join::<S>(image(split::<S>(&unit)))
    })
}

/// An inertia about a point at `r` from a new reference.
fn moved<S: Space<T = f64>>(m: &Matrix, r: S::Vector) -> Matrix {
    columns_of::<S>(|axis| {
        let motion = shifted_motion::<S>(&join::<S>(axis), r);
        split::<S>(&shifted_force::<S>(&times(m, &motion), r))
    })
}

/// Acceleration at `r` from the reference.
fn shifted_motion<S: Space<T = f64>>(motion: &Six, r: S::Vector) -> Six {
    let (v, w) = split::<S>(motion);
    join::<S>((v + S::cross(w, r), w))
}

/// A wrench at `r` about the reference.
fn shifted_force<S: Space<T = f64>>(force: &Six, r: S::Vector) -> Six {
    let (f, n) = split::<S>(force);
    join::<S>((f, n + S::moment(r, f)))
}
