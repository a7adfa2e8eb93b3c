//! The mass matrix M(q) over the tree's velocity components, by composite bodies (Featherstone 2008 §6.2).
//!
//! World axes, references at the nodes' origins, as everywhere in this crate. Only the entries between a motion and
//! those it hangs on are there: between branches M is zero.

use crate::flexible::{Deforming, each_projection};
use crate::mechanism::{Inertia, Mechanism};
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::{Components, Real, Space};

/// A node and all it carries as one rigid body, about the node's origin.
#[derive(Clone, Copy, Debug)]
struct Composite<S: Space> {
    /// kg.
    mass: S::T,
    /// Mass times place of the centre, kg·m.
    first: S::Vector,
    /// kg·m².
    second: S::Inertia,
}

impl<S: Space> Composite<S> {
    fn nothing() -> Self {
        Self { mass: S::T::zero(), first: S::Vector::default(), second: S::Inertia::default() }
    }

    /// Force and moment about the origin that give the body the acceleration (`s_v`, `s_w`) from rest.
    #[inline(always)]
    fn push(&self, s_v: S::Vector, s_w: S::Angular) -> (S::Vector, S::Angular) {
        let f = s_v * self.mass + S::cross(s_w, self.first);
        (f, S::inertia_times(&self.second, s_w) + S::moment(self.first, s_v))
    }
}

impl<S: Space> Composite<S> {
    /// Adds a flexible body in its present shape, given by first moment and inertia about its frame, body axes.
    fn join(&mut self, body: &Deforming<S>, x: &NodeState<S>, (first, tensor): ([S::T; 3], [[S::T; 3]; 3])) {
        let frame = x.frame(&body.frame);
        let (mass, arm) = (body.data.inertia.mass, frame.origin - x.p);
        let first = S::rotate(&frame.rotation, S::vector(&first));
        let tensor = S::turn_inertia(&S::inertia(&tensor), &frame.rotation);
        let moved = S::moved_inertia(mass, first, arm);
        self.mass += mass;
        self.first += first + arm * mass;
        self.second = S::add_inertia(&self.second, &S::add_inertia(&tensor, &moved));
    }
}

/// Pairs of velocity components in the order of [`MassMatrix::deform`].
fn body_entries<S: Space>(mech: &Mechanism<S>, body: &Deforming<S>) -> Vec<(usize, usize)> {
    let carried: Vec<usize> = std::iter::once(body.node)
        .filter(|&at| at != 0)
        .chain(ancestors(mech, body.node))
        .flat_map(|at| mech.nodes[at].v..mech.nodes[at].v + mech.nodes[at].motion.dofs())
        .collect();
    let component = |e: usize| mech.nodes[body.nodes[e]].v;
    let with = |e: usize| {
        let among = (0..=e).map(move |l| (component(e), component(l)));
        carried.iter().map(move |&u| (component(e), u)).chain(among).collect::<Vec<_>>()
    };
    (0..body.count()).flat_map(with).collect()
}

/// The lower triangle of M, entry by entry; entries of the same place add up.
#[derive(Clone, Debug)]
pub(crate) struct MassMatrix<S: Space> {
    composite: Vec<Composite<S>>,
    /// Velocity components of each entry: the later and the earlier one along the tree.
    pub(crate) entries: Vec<(usize, usize)>,
    /// kg, kg·m, kg·m².
    pub(crate) values: Vec<S::T>,
}

impl<S: Space> MassMatrix<S> {
    pub(crate) fn new(mech: &Mechanism<S>) -> Self {
        let mut entries = Vec::new();
        for (i, node) in mech.nodes.iter().enumerate().skip(1) {
            for v in node.v..node.v + node.motion.dofs() {
                entries.extend((node.v..=v).map(|u| (v, u)));
                for ancestor in ancestors(mech, i) {
                    let up = &mech.nodes[ancestor];
                    entries.extend((up.v..up.v + up.motion.dofs()).map(|u| (v, u)));
                }
            }
        }
        for body in &mech.flexible {
            entries.extend(body_entries(mech, body));
        }
        let values = vec![S::T::zero(); entries.len()];
        Self { composite: vec![Composite::nothing(); mech.nodes.len()], entries, values }
    }

    /// No entries: of a machine whose masses are asked for otherwise.
    pub(crate) fn empty() -> Self {
        Self { composite: Vec::new(), entries: Vec::new(), values: Vec::new() }
    }

    /// M at the poses of `x`.
    #[inline]
    pub(crate) fn evaluate(&mut self, mech: &Mechanism<S>, x: &[NodeState<S>]) {
        if self.composite.is_empty() {
            return;
        }
        self.compose(mech, x);
        let mut k = 0;
        for (i, node) in mech.nodes.iter().enumerate().skip(1) {
            match node.motion {
                Motion::Fixed => {}
                Motion::Turn => self.column(mech, x, i, 0, (S::Vector::default(), x[i].s_w), &mut k),
                Motion::Slide => self.column(mech, x, i, 0, (x[i].s_v, S::Angular::default()), &mut k),
                Motion::Screw(_) => self.column(mech, x, i, 0, (x[i].s_v, x[i].s_w), &mut k),
                Motion::Ball => {
                    for axis in 0..3 {
                        let s = (S::Vector::default(), ball_axis(&x[i], axis));
                        self.column(mech, x, i, axis, s, &mut k);
                    }
                }
            }
        }
        self.deform(mech, x, k);
    }

    /// What flexible bodies add: of each coordinate with the motions of the floating frame, and among themselves.
    fn deform(&mut self, mech: &Mechanism<S>, x: &[NodeState<S>], mut k: usize) {
        for body in &mech.flexible {
            for (e, &node) in body.nodes.iter().enumerate() {
                let own = mech.nodes[node].v;
                each_projection(mech, x, body.node, body.push(x, e), |v, value| {
                    // A coordinate that carries the frame, too, meets itself.
                    self.values[k] = if v == own { value + value } else { value };
                    k += 1;
                });
                for l in 0..=e {
                    self.values[k] = body.mass[e * body.count() + l];
                    k += 1;
                }
            }
        }
    }

    fn compose(&mut self, mech: &Mechanism<S>, x: &[NodeState<S>]) {
        for ((node, x), c) in mech.nodes.iter().zip(x).zip(&mut self.composite) {
            *c = match &node.inertia {
                None => Composite::nothing(),
                Some(body) => {
                    let r = S::rotate(&x.R, body.center);
                    let about_center = S::turn_inertia(&body.about_center, &x.R);
                    let moved = S::moved_inertia(body.mass, S::Vector::default(), r);
                    Composite { mass: body.mass, first: r * body.mass, second: S::add_inertia(&about_center, &moved) }
                }
            };
        }
        for body in &mech.flexible {
            self.composite[body.node].join(body, &x[body.node], body.rigid(x));
        }
        for i in (1..mech.nodes.len()).rev() {
            let child = self.composite[i];
            let (r, parent) = (x[i].r, &mut self.composite[mech.nodes[i].parent]);
            let moved = S::add_inertia(&child.second, &S::moved_inertia(child.mass, child.first, r));
            parent.mass += child.mass;
            parent.first += child.first + r * child.mass;
            parent.second = S::add_inertia(&parent.second, &moved);
        }
    }

    /// Entries of one velocity component with those before it, in the order of `entries`.
    #[inline(always)]
    fn column(
        &mut self,
        mech: &Mechanism<S>,
        x: &[NodeState<S>],
        i: usize,
        axis: usize,
        (s_v, s_w): (S::Vector, S::Angular),
        k: &mut usize,
    ) {
        let (f, mut n) = self.composite[i].push(s_v, s_w);
        for earlier in 0..=axis {
            self.values[*k] = if axis == 0 { s_v.dot(f) + s_w.dot(n) } else { ball_axis(&x[i], earlier).dot(n) };
            *k += 1;
        }
        let mut at = i;
        while at != 0 {
            n += S::moment(x[at].r, f);
            at = mech.nodes[at].parent;
            let up = &x[at];
            let mut put = |value: S::T| {
                self.values[*k] = value;
                *k += 1;
            };
            match mech.nodes[at].motion {
                Motion::Fixed => {}
                Motion::Turn => put(up.s_w.dot(n)),
                Motion::Slide => put(up.s_v.dot(f)),
                Motion::Screw(_) => put(up.s_v.dot(f) + up.s_w.dot(n)),
                Motion::Ball => (0..3).for_each(|axis| put(ball_axis(up, axis).dot(n))),
            }
        }
    }
}

/// Force and moment about a node's origin that accelerate its own mass by (`s_v`, `s_w`) from rest.
pub(crate) fn push_of<S: Space>(
    body: &Inertia<S>,
    x: &NodeState<S>,
    (s_v, s_w): (S::Vector, S::Angular),
) -> (S::Vector, S::Angular) {
    let r = S::rotate(&x.R, body.center);
    let f = (s_v + S::cross(s_w, r)) * body.mass;
    (f, S::apply_inertia(&body.about_center, &x.R, s_w) + S::moment(r, f))
}

/// The axis of component `axis` of a ball: one before its motion.
#[inline(always)]
pub(crate) fn ball_axis<S: Space>(x: &NodeState<S>, axis: usize) -> S::Angular {
    let mut e = [S::T::zero(); 3];
    e[axis] = S::T::one();
    S::rotate_angular(&x.base, S::angular(&e))
}

/// Nodes that a node hangs on, nearest first, without the ground.
fn ancestors<S: Space>(mech: &Mechanism<S>, i: usize) -> impl Iterator<Item = usize> + '_ {
    std::iter::successors(Some(mech.nodes[i].parent), |&at| (at != 0).then(|| mech.nodes[at].parent))
        .filter(|&at| at != 0)
}
