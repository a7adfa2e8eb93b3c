//! Inward pass: the forces that the motion asks for, recursive Newton–Euler (Featherstone 2008 §5.3).

use crate::mechanism::{Mechanism, Node};
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::{Components, Space};

/// Each node's own demand: inertia less weight less applied wrench, about its origin.
#[inline]
pub(crate) fn own_wrenches<S: Space>(mech: &Mechanism<S>, x: &mut [NodeState<S>]) {
    for (node, x) in mech.nodes.iter().zip(x.iter_mut()) {
        (x.own_f, x.own_n) = (-x.ext_f, -x.ext_n);
        if let Some(body) = &node.inertia {
            let c = S::rotate(&x.R, body.center);
            let wc = S::cross(x.w, c);
            let a_c = x.vd + S::cross(x.wd, c) + S::cross(x.w, wc);
            let f = (a_c - mech.gravity) * body.mass;
            let h = S::apply_inertia(&body.about_center, &x.R, x.w);
            let n = S::apply_inertia(&body.about_center, &x.R, x.wd) + S::cross_angular(x.w, h);
            x.own_f += f;
            x.own_n += n + S::moment(c, f);
        }
    }
    crate::flexible::add_demands(mech, x);
}

/// Sums the demands that `f`, `n` hold toward the root.
#[inline]
pub(crate) fn gather<S: Space>(mech: &Mechanism<S>, x: &mut [NodeState<S>]) {
    for i in (1..mech.nodes.len()).rev() {
        let (f, n, r) = (x[i].f, x[i].n, x[i].r);
        let parent = &mut x[mech.nodes[i].parent];
        parent.f += f;
        parent.n += n + S::moment(r, f);
    }
}

/// Generalized forces `tau` (nv; N, N·m) along the tree's velocity components from gathered wrenches.
#[inline]
pub(crate) fn project<S: Space>(mech: &Mechanism<S>, x: &[NodeState<S>], tau: &mut [S::T]) {
    for (node, x) in mech.nodes.iter().zip(x).skip(1) {
        project_node(node, x, tau);
    }
    for i in mech.flexible.iter().flat_map(|body| &body.nodes) {
        tau[mech.nodes[*i].v] += x[*i].own_t;
    }
}

#[inline(always)]
fn project_node<S: Space>(node: &Node<S>, x: &NodeState<S>, tau: &mut [S::T]) {
    match node.motion {
        Motion::Fixed => {}
        Motion::Turn => tau[node.v] = x.s_w.dot(x.n),
        Motion::Slide => tau[node.v] = x.s_v.dot(x.f),
        Motion::Screw(_) => tau[node.v] = x.s_w.dot(x.n) + x.s_v.dot(x.f),
        Motion::Ball => {
            let n = S::spread_angular(S::rotate_angular(&S::transpose(&x.base), x.n));
            tau[node.v..node.v + 3].copy_from_slice(&n);
        }
    }
}
