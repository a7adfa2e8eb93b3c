//! Outward passes: poses, velocities, accelerations.
//!
//! With the node's axis s (world axes, at the node's origin): `ω = ω_P + s_ω q̇`,
//! `v = v_P + ω_P × r + s_v q̇`, and the accelerations are their derivatives. Featherstone (2008) §4.1,
//! §5.3, with classical instead of spatial accelerations and every vector in world axes.

use crate::mechanism::{Mechanism, Node};
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::{Real, Space};

/// Poses and motion axes of all nodes from the positions `q` (nq; m, rad, quaternions).
#[inline]
pub(crate) fn positions<S: Space>(mech: &Mechanism<S>, q: &[S::T], x: &mut [NodeState<S>]) {
    for (i, node) in mech.nodes.iter().enumerate().skip(1) {
        let (before, rest) = x.split_at_mut(i);
        place(node, q, &before[node.parent], &mut rest[0]);
    }
    note(mech, x, 0, q, |node| node.q);
}

#[inline(always)]
fn place<S: Space>(node: &Node<S>, q: &[S::T], parent: &NodeState<S>, x: &mut NodeState<S>) {
    let base = S::compose(&parent.R, &node.place.rotation);
    let mut r = S::rotate(&parent.R, node.place.origin);
    match node.motion {
        Motion::Turn => {
            x.R = S::turn(&base, (node.sign * q[node.q]).sin_cos());
            x.s_w = S::turn_axis(&base) * node.sign;
        }
        Motion::Slide => {
            x.R = base;
            x.s_v = S::slide_axis(&base) * node.sign;
            r += x.s_v * q[node.q];
        }
        Motion::Screw(lead) => {
            x.R = S::turn(&base, (node.sign * q[node.q]).sin_cos());
            x.s_w = S::turn_axis(&base) * node.sign;
            x.s_v = S::slide_axis(&base) * (node.sign * lead);
            r += x.s_v * q[node.q];
        }
        Motion::Fixed => x.R = base,
        Motion::Ball => {
            let quaternion = [q[node.q], q[node.q + 1], q[node.q + 2], q[node.q + 3]];
            x.R = S::compose(&base, &S::from_quaternion(&quaternion));
            x.base = base;
        }
    }
    x.r = r;
    x.p = parent.p + r;
}

/// Angular velocity of a ball against its parent, world axes.
#[inline]
fn ball_spin<S: Space>(node: &Node<S>, v: &[S::T], base: &S::Rotation) -> S::Angular {
    S::rotate_angular(base, S::angular(&[v[node.v], v[node.v + 1], v[node.v + 2]]))
}

/// Velocities and the accelerations that they alone cause (joint accelerations zero).
#[inline]
pub(crate) fn velocities<S: Space>(mech: &Mechanism<S>, v: &[S::T], x: &mut [NodeState<S>]) {
    for (i, node) in mech.nodes.iter().enumerate().skip(1) {
        let (before, rest) = x.split_at_mut(i);
        let (parent, x) = (&before[node.parent], &mut rest[0]);
        let wr = S::cross(parent.w, x.r);
        x.w = parent.w;
        x.v = parent.v + wr;
        match node.motion {
            Motion::Fixed => {}
            Motion::Turn => x.w += x.s_w * v[node.v],
            Motion::Slide => x.v += x.s_v * v[node.v],
            Motion::Screw(_) => {
                x.w += x.s_w * v[node.v];
                x.v += x.s_v * v[node.v];
            }
            Motion::Ball => x.w += ball_spin(node, v, &x.base),
        }
    }
    note(mech, x, 1, v, |node| node.v);
}

/// Accelerations from joint accelerations `a` (nv), or from velocities alone (`None`).
#[inline]
pub(crate) fn accelerations<S: Space>(mech: &Mechanism<S>, v: &[S::T], a: Option<&[S::T]>, x: &mut [NodeState<S>]) {
    let two = S::T::from_f64(2.0);
    for (i, node) in mech.nodes.iter().enumerate().skip(1) {
        let (before, rest) = x.split_at_mut(i);
        let (parent, x) = (&before[node.parent], &mut rest[0]);
        x.wd = parent.wd;
        x.vd = parent.vd + S::cross(parent.wd, x.r) + S::cross(parent.w, S::cross(parent.w, x.r));
        match node.motion {
            Motion::Fixed => {}
            Motion::Turn => turn_rate(node, v, a, parent, x),
            Motion::Slide => slide_rate(node, v, a, parent, x, two),
            Motion::Screw(_) => {
                turn_rate(node, v, a, parent, x);
                slide_rate(node, v, a, parent, x, two);
            }
            Motion::Ball => {
                x.wd += S::cross_angular(parent.w, ball_spin(node, v, &x.base));
                if let Some(a) = a {
                    x.wd += ball_spin(node, a, &x.base);
                }
            }
        }
    }
    match a {
        Some(a) => note(mech, x, 2, a, |node| node.v),
        None => deforming(mech).for_each(|i| x[i].deform[2] = S::T::zero()),
    }
}

/// Nodes of the coordinates of flexible bodies.
fn deforming<S: Space>(mech: &Mechanism<S>) -> impl Iterator<Item = usize> + '_ {
    mech.flexible.iter().flat_map(|body| body.nodes.iter().copied())
}

/// Keeps a number of each coordinate of the flexible bodies, where their inertia looks for it.
#[inline]
fn note<S: Space>(
    mech: &Mechanism<S>,
    x: &mut [NodeState<S>],
    order: usize,
    numbers: &[S::T],
    at: impl Fn(&Node<S>) -> usize,
) {
    deforming(mech).for_each(|i| x[i].deform[order] = numbers[at(&mech.nodes[i])]);
}

#[inline(always)]
fn turn_rate<S: Space>(node: &Node<S>, v: &[S::T], a: Option<&[S::T]>, parent: &NodeState<S>, x: &mut NodeState<S>) {
    x.wd += S::cross_angular(parent.w, x.s_w * v[node.v]);
    if let Some(a) = a {
        x.wd += x.s_w * a[node.v];
    }
}

#[inline(always)]
fn slide_rate<S: Space>(
    node: &Node<S>,
    v: &[S::T],
    a: Option<&[S::T]>,
    parent: &NodeState<S>,
    x: &mut NodeState<S>,
    two: S::T,
) {
    x.vd += S::cross(parent.w, x.s_v) * (two * v[node.v]);
    if let Some(a) = a {
        x.vd += x.s_v * a[node.v];
    }
}
