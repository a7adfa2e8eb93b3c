//! A flexible body on the nodes of a tree.

use super::Flexible;
use crate::mechanism::{Carried, Source};
use crate::workspace::NodeState;
use crate::{Blueprint, BuildError, Coordinate};
use bellcrank_math::{Frame, Real, Space};

/// A flexible body, resolved against the tree.
#[derive(Clone, Debug)]
pub(crate) struct Deforming<S: Space> {
    /// Carries the floating frame, which is `frame` there.
    pub(crate) node: usize,
    pub(crate) frame: Frame<S>,
    /// The node of each coordinate.
    pub(crate) nodes: Vec<usize>,
    pub(crate) data: Flexible<S::T>,
    /// `∫ φ_e·φ_f dm` at e·n + f.
    pub(crate) mass: Vec<S::T>,
    /// Value of each coordinate at which its root mean square displacement is 1 m: coordinates of different units are
    /// compared in it.
    pub(crate) metre: Vec<f64>,
}

/// Displacements of this part of the machine's size are those of a body near its strength.
const STRAINED: f64 = 1e-3;

/// Resolves the flexible bodies of a blueprint.
pub(crate) fn deforming_of<S: Space>(
    blueprint: &Blueprint<S::T>,
    bodies: &[Carried<S>],
    sources: &[Vec<Source>],
) -> Result<Vec<Deforming<S>>, BuildError> {
    blueprint.flexible.iter().map(|data| one(data, bodies, sources)).collect()
}

fn one<S: Space>(
    data: &Flexible<S::T>,
    bodies: &[Carried<S>],
    sources: &[Vec<Source>],
) -> Result<Deforming<S>, BuildError> {
    let wrong = || BuildError::Flexible(data.body);
    let body = bodies.get(data.body.0).ok_or_else(wrong)?;
    let mut nodes = Vec::with_capacity(data.coordinates());
    for joint in data.interfaces.iter().chain(&data.modes) {
        for index in 0..sources.get(joint.0).ok_or_else(wrong)?.len() {
            nodes.push(node_of(sources, Coordinate { joint: *joint, index }).ok_or_else(wrong)?);
        }
    }
    if !fits(data, nodes.len()) {
        return Err(wrong());
    }
    let trace = |m: &[[S::T; 3]; 3]| m[0][0] + m[1][1] + m[2][2];
    let mass: Vec<S::T> = data.inertia.products.iter().map(trace).collect();
    let whole = data.inertia.mass.value();
    let metre = |e: usize| {
        let square = whole / mass[e * nodes.len() + e].value();
        if square.is_finite() && square > 0.0 { square.sqrt() } else { 1.0 }
    };
    let metre = (0..nodes.len()).map(metre).collect();
    Ok(Deforming { node: body.node, frame: body.frame, nodes, data: data.clone(), mass, metre })
}

fn node_of(sources: &[Vec<Source>], c: Coordinate) -> Option<usize> {
    match sources.get(c.joint.0)?.get(c.index)? {
        Source::Node(node) => Some(*node),
        Source::Measured { .. } => None,
    }
}

/// Every list is as long as `n` coordinates ask for.
fn fits<T: Real>(data: &Flexible<T>, n: usize) -> bool {
    let inertia = &data.inertia;
    let squares = [inertia.products.len(), data.stiffness.len(), data.damping.len()];
    let shortened = data.shortenings.iter().all(|s| s.along < n && s.matrix.len() == n * n);
    [inertia.flow.len(), inertia.placed.len()] == [n; 2] && squares == [n * n; 3] && shortened
}

impl<S: Space> Deforming<S> {
    /// Number of coordinates.
    #[inline]
    pub(crate) fn count(&self) -> usize {
        self.nodes.len()
    }
    /// Units of the error of coordinate `e` and of its rate in a machine of a size: a strained body's displacement, and
    /// that at the frequency of the coordinate alone.
    pub(crate) fn error_units(&self, e: usize, size: f64) -> [f64; 2] {
        let (at, unit) = (e * self.count() + e, STRAINED * size * self.metre[e]);
        let square = self.data.stiffness[at].value() / self.mass[at].value();
        let frequency = if square.is_finite() && square > 1.0 { square.sqrt() } else { 1.0 };
        [unit, unit * frequency]
    }
    /// Coordinate, rate and second rate of coordinate `e`.
    #[inline]
    pub(crate) fn motion(&self, x: &[NodeState<S>], e: usize) -> [S::T; 3] {
        x[self.nodes[e]].deform
    }
    /// `∫ r φ_eᵀ dm` with r the place in the deformed body.
    #[inline]
    pub(crate) fn placed(&self, x: &[NodeState<S>], e: usize) -> [[S::T; 3]; 3] {
        let n = self.count();
        let mut h = self.data.inertia.placed[e];
        for l in 0..n {
            add(&mut h, &self.data.inertia.products[l * n + e], self.motion(x, l)[0]);
        }
        h
    }
}

/// `h ← h + k p`.
#[inline(always)]
pub(super) fn add<T: Real>(h: &mut [[T; 3]; 3], p: &[[T; 3]; 3], k: T) {
    for (h, p) in h.iter_mut().zip(p) {
        for (h, p) in h.iter_mut().zip(p) {
            *h += *p * k;
        }
    }
}
