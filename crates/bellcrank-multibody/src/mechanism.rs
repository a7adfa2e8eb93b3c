//! A mechanism, frozen: the tree of elementary motions and the links that measure and close.

use crate::constraint::{Link, Measure, RowKind};
use crate::flexible::Deforming;
use crate::forces::Element;
use crate::topology::{Branch, Motion};
use crate::{Blueprint, BuildError, Coordinate, JointId};
use bellcrank_math::{Frame, Space};

/// An elementary motion in the tree. Node 0 is the ground.
#[derive(Clone, Debug)]
pub(crate) struct Node<S: Space> {
    pub(crate) parent: usize,
    /// Pose of the frame before the motion in the parent node's frame, `X_PN₀`.
    pub(crate) place: Frame<S>,
    pub(crate) motion: Motion<S::T>,
    /// −1 where the joint is passed from its second to its first place.
    pub(crate) sign: S::T,
    /// First position number and first velocity component.
    pub(crate) q: usize,
    pub(crate) v: usize,
    /// Joint it belongs to; none for the floating of a body that nothing carries.
    pub(crate) joint: Option<JointId>,
    pub(crate) inertia: Option<Inertia<S>>,
}

/// Mass properties in node axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inertia<S: Space> {
    pub(crate) mass: S::T,
    pub(crate) center: S::Vector,
    pub(crate) about_center: S::Inertia,
}

/// A body: its node and its frame there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Carried<S: Space> {
    pub(crate) node: usize,
    pub(crate) frame: Frame<S>,
    /// Centre of mass in node axes, m.
    pub(crate) center: S::Vector,
}

/// Where a joint coordinate comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Source {
    /// The coordinate of a tree node.
    Node(usize),
    /// Measured on a link.
    Measured {
        /// The link.
        link: usize,
        /// What is measured.
        measure: Measure,
    },
}

/// A coupling of two coordinates: `b − ratio·a − offset = 0`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coupling<T> {
    pub(crate) joint: JointId,
    pub(crate) a: Source,
    pub(crate) b: Source,
    pub(crate) ratio: T,
    pub(crate) offset: T,
}

/// A joint's place in the tree.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TreeJoint {
    /// The node that the far body hangs on.
    pub(crate) last: usize,
    /// Passed from the second place to the first.
    pub(crate) reversed: bool,
}

/// A mechanism, frozen after [`Mechanism::build`] and shared by any number of workspaces.
#[derive(Clone, Debug)]
pub struct Mechanism<S: Space> {
    /// How the tree was grown.
    pub(crate) tree: Vec<Branch>,
    pub(crate) gravity: S::Vector,
    pub(crate) nodes: Vec<Node<S>>,
    pub(crate) bodies: Vec<Carried<S>>,
    /// One a joint with places; links with rows close loops.
    pub(crate) links: Vec<Link<S>>,
    /// Links that close loops, in the order of their rows.
    pub(crate) closing: Vec<usize>,
    pub(crate) link_of: Vec<Option<usize>>,
    pub(crate) tree_joint: Vec<Option<TreeJoint>>,
    pub(crate) couplings: Vec<Coupling<S::T>>,
    pub(crate) sources: Vec<Vec<Source>>,
    pub(crate) elements: Vec<Element<S>>,
    pub(crate) flexible: Vec<Deforming<S>>,
    pub(crate) nq: usize,
    pub(crate) nv: usize,
    /// Rows of all closing links.
    pub(crate) link_rows: usize,
    /// A length typical of the machine, m: the mean distance of places from their body's first place.
    pub(crate) size: f64,
    pub(crate) inputs: usize,
}

impl<S: Space> Mechanism<S> {
    /// Picks the spanning tree and the closing joints and works out all that does not change.
    pub fn build(blueprint: &Blueprint<S::T>) -> Result<Self, BuildError> {
        crate::builder::build(blueprint)
    }
    /// Rows of loops and couplings together.
    pub(crate) fn rows(&self) -> usize {
        self.link_rows + self.couplings.len()
    }
    pub(crate) fn source(&self, c: Coordinate) -> Option<Source> {
        self.sources.get(c.joint.0)?.get(c.index).copied()
    }
}

/// Rows of a link in words.
pub(crate) fn row_name<S: Space>(link: &Link<S>, row: usize) -> &'static str {
    match link.rows[row] {
        RowKind::Point(i) => ["along world x", "along world y", "along world z"][i.min(2)],
        RowKind::Along(i) => ["along x of the joint", "along y of the joint", "along z of the joint"][i.min(2)],
        RowKind::Perpendicular(a, b) => turning_name(a, b),
        RowKind::Held(Measure::Distance) => "distance",
        RowKind::Held(_) => "coordinate",
        RowKind::ScrewLead => "advance of the screw",
    }
}

fn turning_name(a: usize, b: usize) -> &'static str {
    ["turning about x of the joint", "turning about y of the joint", "turning about z of the joint"][(3 - a - b).min(2)]
}
