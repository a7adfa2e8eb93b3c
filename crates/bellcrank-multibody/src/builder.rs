//! From a blueprint to a mechanism: nodes along the spanning tree, links for every joint.

use crate::constraint::{Link, Measure, aligned, link_of};
use crate::mechanism::{Carried, Coupling, Inertia, Mechanism, Node, Source, TreeJoint};
use crate::topology::{Branch, Edge, Motion, Step, coordinate_count, path_between, spanning_tree, steps_of};
use crate::{Blueprint, BuildError, Coordinate, Joint, JointId, JointKind, Place};
use bellcrank_math::{Frame, Real, Space};

/// Picks the spanning tree and the closing joints and works out all that does not change.
pub(crate) fn build<S: Space>(blueprint: &Blueprint<S::T>) -> Result<Mechanism<S>, BuildError> {
    let steps = checked_steps::<S>(blueprint)?;
    let tree = spanning_tree(blueprint.bodies.len(), &edges(blueprint, &steps));
    let mut builder = Builder::new(blueprint);
    for branch in &tree {
        builder.grow(branch, &steps)?;
    }
    builder.finish(tree)
}

/// Puts the numbers of a blueprint into a mechanism that was built from one of the same structure; `false` when the
/// structure differs, and the mechanism is of no use then.
pub(crate) fn refresh<S: Space>(mech: &mut Mechanism<S>, blueprint: &Blueprint<S::T>) -> Result<bool, BuildError> {
    let steps = checked_steps::<S>(blueprint)?;
    let tree = std::mem::take(&mut mech.tree);
    let mut builder = Builder::new(blueprint);
    if blueprint.joints.len() != mech.link_of.len() || blueprint.bodies.len() != mech.bodies.len() {
        return Ok(false);
    }
    for branch in &tree {
        builder.grow(branch, &steps)?;
    }
    if (builder.nq, builder.nv, builder.nodes.len()) != (mech.nq, mech.nv, mech.nodes.len()) {
        return Ok(false);
    }
    (mech.tree, mech.nodes) = (tree, builder.nodes);
    for (to, from) in mech.bodies.iter_mut().zip(builder.bodies) {
        *to = from.unwrap_or(*to);
    }
    for link in &mut mech.links {
        let joint = &blueprint.joints[link.joint.0];
        let Some(places) = &joint.places else { return Ok(false) };
        let ends = ends_of(places, &mech.bodies);
        let (ends, held) = aligned::<S>(link.joint, &joint.kind, ends)?;
        (link.ends, link.held) = (ends, held);
    }
    for coupling in &mut mech.couplings {
        let JointKind::Coupler { ratio, offset, .. } = &blueprint.joints[coupling.joint.0].kind else {
            return Ok(false);
        };
        (coupling.ratio, coupling.offset) = (*ratio, *offset);
    }
    mech.elements = crate::forces::elements_of(blueprint, &mech.bodies, &mech.sources)?;
    mech.flexible = crate::flexible::deforming_of(blueprint, &mech.bodies, &mech.sources)?;
    mech.gravity = S::vector(&blueprint.gravity);
    mech.size = typical_size(blueprint);
    Ok(true)
}

fn ends_of<S: Space>(places: &[Place<S::T>; 2], bodies: &[Carried<S>]) -> [(usize, Frame<S>); 2] {
    [0, 1].map(|i| {
        let b = &bodies[places[i].body.0];
        (b.node, b.frame.then(&frame_of::<S>(&places[i])))
    })
}

type Steps<S> = Vec<Option<Vec<Step<S>>>>;

fn checked_steps<S: Space>(blueprint: &Blueprint<S::T>) -> Result<Steps<S>, BuildError> {
    let joints = blueprint.joints.iter().enumerate();
    joints
        .map(|(j, joint)| {
            let id = JointId(j);
            let is_coupler = matches!(joint.kind, JointKind::Coupler { .. });
            match &joint.places {
                None if !is_coupler => return Err(BuildError::Places(id)),
                Some(_) if is_coupler => return Err(BuildError::Places(id)),
                Some(p) if p.iter().any(|p| p.body.0 >= blueprint.bodies.len()) => {
                    return Err(BuildError::Dangling(id));
                }
                _ => {}
            }
            steps_of::<S>(id, &joint.kind)
        })
        .collect()
}

fn edges<S: Space>(blueprint: &Blueprint<S::T>, steps: &Steps<S>) -> Vec<Edge> {
    let mut edges = Vec::new();
    for (joint, (j, steps)) in blueprint.joints.iter().zip(steps).enumerate() {
        if let (Some(places), Some(steps)) = (&j.places, steps) {
            let dofs: usize = steps.iter().map(|s| s.motion.dofs()).sum();
            // A coupled coordinate counts its turns without end only in the tree; so does a flexible body's shape.
            let deforms = matches!(j.kind, JointKind::Elastic | JointKind::Modes { .. });
            let cost = if deforms { 0 } else { 1 + 2 * dofs - usize::from(dofs > 0 && is_coupled(blueprint, joint)) };
            edges.push(Edge { joint, bodies: [places[0].body.0, places[1].body.0], cost });
        }
    }
    edges
}

fn is_coupled<T>(blueprint: &Blueprint<T>, joint: usize) -> bool {
    let uses =
        |k: &JointKind<T>| matches!(k, JointKind::Coupler { a, b, .. } if a.joint.0 == joint || b.joint.0 == joint);
    blueprint.joints.iter().any(|j| uses(&j.kind))
}

pub(crate) fn frame_of<S: Space>(place: &Place<S::T>) -> Frame<S> {
    Frame::from_spatial(&place.position, &place.rotation)
}

struct Builder<'a, S: Space> {
    blueprint: &'a Blueprint<S::T>,
    nodes: Vec<Node<S>>,
    bodies: Vec<Option<Carried<S>>>,
    tree_joint: Vec<Option<TreeJoint>>,
    first_node: Vec<Option<usize>>,
    nq: usize,
    nv: usize,
}

impl<'a, S: Space> Builder<'a, S> {
    fn new(blueprint: &'a Blueprint<S::T>) -> Self {
        let ground = Node {
            parent: 0,
            place: Frame::identity(),
            motion: Motion::Fixed,
            sign: S::T::one(),
            q: 0,
            v: 0,
            joint: None,
            inertia: None,
        };
        let mut bodies = vec![None; blueprint.bodies.len()];
        if let Some(b) = bodies.first_mut() {
            *b = Some(Carried { node: 0, frame: Frame::identity(), center: S::Vector::default() });
        }
        let joints = blueprint.joints.len();
        Self {
            blueprint,
            nodes: vec![ground],
            bodies,
            tree_joint: vec![None; joints],
            first_node: vec![None; joints],
            nq: 0,
            nv: 0,
        }
    }

    fn grow(&mut self, branch: &Branch, steps: &Steps<S>) -> Result<(), BuildError> {
        let floating;
        let (steps, first, second, reversed) = match branch.joint {
            Some(j) => {
                let joint = &self.blueprint.joints[j];
                let (Some(places), Some(steps)) = (&joint.places, &steps[j]) else {
                    return Err(BuildError::Places(JointId(j)));
                };
                let reversed = places[0].body.0 == branch.child;
                (steps, frame_of::<S>(&places[0]), frame_of::<S>(&places[1]), reversed)
            }
            None => {
                floating = steps_of::<S>(JointId(usize::MAX), &JointKind::Free)?.unwrap_or_default();
                (&floating, Frame::identity(), Frame::identity(), false)
            }
        };
        let joint = branch.joint.map(JointId);
        let last = self.chain(branch.parent, joint, steps, if reversed { second } else { first }, reversed);
        let far = if reversed { first } else { second };
        let end = if reversed { steps.first() } else { steps.last() };
        let align = end.map_or_else(S::identity, |s| s.align);
        let frame = turned::<S>(&S::transpose(&align)).then(&far.inverse());
        self.carry(branch.child, last, frame);
        if let Some(j) = branch.joint {
            self.tree_joint[j] = Some(TreeJoint { last, reversed });
        }
        Ok(())
    }

    /// Appends the nodes of a joint; the last one is returned.
    fn chain(
        &mut self,
        parent: usize,
        joint: Option<JointId>,
        steps: &[Step<S>],
        near: Frame<S>,
        reversed: bool,
    ) -> usize {
        let carried = self.bodies[parent].map_or((0, Frame::identity()), |c| (c.node, c.frame));
        let (mut at, mut place) = (carried.0, carried.1.then(&near));
        if let Some(j) = joint {
            self.first_node[j.0] = Some(self.nodes.len());
        }
        let mut before = S::identity();
        let order: Box<dyn Iterator<Item = &Step<S>>> =
            if reversed { Box::new(steps.iter().rev()) } else { Box::new(steps.iter()) };
        for step in order {
            place = place.then(&turned::<S>(&S::compose(&S::transpose(&before), &step.align)));
            let sign = S::T::from_f64(if reversed { -step.sign } else { step.sign });
            let node =
                Node { parent: at, place, motion: step.motion, sign, q: self.nq, v: self.nv, joint, inertia: None };
            at = self.nodes.len();
            self.nq += step.motion.numbers();
            self.nv += step.motion.dofs();
            self.nodes.push(node);
            (place, before) = (Frame::identity(), step.align);
        }
        at
    }

    fn carry(&mut self, body: usize, node: usize, frame: Frame<S>) {
        let b = &self.blueprint.bodies[body];
        let center = frame.at(S::vector(&b.center));
        self.bodies[body] = Some(Carried { node, frame, center });
        let about_center = S::turn_inertia(&S::inertia(&b.inertia), &frame.rotation);
        let massive = !b.mass.is_zero() || b.inertia.iter().flatten().any(|x| !x.is_zero());
        if massive {
            self.nodes[node].inertia = Some(Inertia { mass: b.mass, center, about_center });
        }
    }

    fn finish(self, tree: Vec<Branch>) -> Result<Mechanism<S>, BuildError> {
        let bodies: Vec<Carried<S>> = self
            .bodies
            .iter()
            .map(|b| b.unwrap_or(Carried { node: 0, frame: Frame::identity(), center: S::Vector::default() }))
            .collect();
        let parents: Vec<usize> = self.nodes.iter().map(|n| n.parent).collect();
        let mut links = Vec::new();
        let mut link_index = vec![None; self.blueprint.joints.len()];
        for (j, joint) in self.blueprint.joints.iter().enumerate() {
            if let Some(places) = &joint.places {
                link_index[j] = Some(links.len());
                let in_tree = self.tree_joint[j].is_some();
                links.push(self.link(JointId(j), &joint.kind, places, &bodies, &parents, in_tree)?);
            }
        }
        let sources = self.sources(&link_index);
        let couplings = self.couplings(&sources)?;
        let mut closing = Vec::new();
        let mut link_rows = 0;
        for (k, link) in links.iter_mut().enumerate() {
            if !link.rows.is_empty() {
                link.first_row = link_rows;
                link_rows += link.rows.len();
                closing.push(k);
            }
        }
        let elements = crate::forces::elements_of(self.blueprint, &bodies, &sources)?;
        let flexible = crate::flexible::deforming_of(self.blueprint, &bodies, &sources)?;
        Ok(Mechanism {
            tree,
            gravity: S::vector(&self.blueprint.gravity),
            size: typical_size(self.blueprint),
            inputs: self.blueprint.inputs,
            nodes: self.nodes,
            bodies,
            links,
            closing,
            link_of: link_index,
            tree_joint: self.tree_joint,
            couplings,
            sources,
            elements,
            flexible,
            nq: self.nq,
            nv: self.nv,
            link_rows,
        })
    }

    fn link(
        &self,
        id: JointId,
        kind: &JointKind<S::T>,
        places: &[Place<S::T>; 2],
        bodies: &[Carried<S>],
        parents: &[usize],
        in_tree: bool,
    ) -> Result<Link<S>, BuildError> {
        let ends = ends_of(places, bodies);
        let path = path_between(parents, ends[0].0, ends[1].0);
        let mut link = link_of::<S>(id, kind, ends)?;
        if in_tree {
            link.rows.clear();
        }
        link.set_path(path, |n| (self.nodes[n].motion.dofs(), self.nodes[n].v));
        Ok(link)
    }

    fn sources(&self, link_index: &[Option<usize>]) -> Vec<Vec<Source>> {
        let joints = self.blueprint.joints.iter().enumerate();
        joints.map(|(j, joint)| self.sources_of(j, joint, link_index[j])).collect()
    }

    fn sources_of(&self, j: usize, joint: &Joint<S::T>, link: Option<usize>) -> Vec<Source> {
        let count = coordinate_count(&joint.kind, S::DIM == 2);
        (0..count)
            .filter_map(|i| {
                let measure = Measure::of::<S>(&joint.kind, i);
                match self.tree_joint[j] {
                    Some(t) if !measure.is_attitude() => {
                        let first = self.first_node[j]?;
                        Some(Source::Node(if t.reversed { t.last - i } else { first + i }))
                    }
                    _ => Some(Source::Measured { link: link?, measure }),
                }
            })
            .collect()
    }

    fn couplings(&self, sources: &[Vec<Source>]) -> Result<Vec<Coupling<S::T>>, BuildError> {
        let mut couplings = Vec::new();
        for (j, joint) in self.blueprint.joints.iter().enumerate() {
            if let JointKind::Coupler { a, b, ratio, offset } = &joint.kind {
                let find = |c: &Coordinate| {
                    sources.get(c.joint.0).and_then(|s| s.get(c.index)).copied().ok_or(BuildError::Dangling(JointId(j)))
                };
                let (sa, sb) = (find(a)?, find(b)?);
                for (c, s) in [(a, sa), (b, sb)] {
                    if matches!(s, Source::Measured { measure, .. } if measure.is_attitude()) {
                        return Err(BuildError::Attitude(*c));
                    }
                }
                couplings.push(Coupling { joint: JointId(j), a: sa, b: sb, ratio: *ratio, offset: *offset });
            }
        }
        Ok(couplings)
    }
}

fn turned<S: Space>(r: &S::Rotation) -> Frame<S> {
    Frame { rotation: *r, origin: S::Vector::default() }
}

/// Mean distance between places on one body, over bodies; 1 m where there is none.
fn typical_size<T: Real>(blueprint: &Blueprint<T>) -> f64 {
    let mut seen: Vec<Option<[f64; 3]>> = vec![None; blueprint.bodies.len()];
    let (mut sum, mut count) = (0.0, 0);
    for place in blueprint.joints.iter().filter_map(|j| j.places.as_ref()).flatten() {
        let p = place.position.map(Real::value);
        match seen.get_mut(place.body.0) {
            Some(slot @ None) => *slot = Some(p),
            Some(Some(o)) => {
                let d = (0..3).map(|i| (p[i] - o[i]).powi(2)).sum::<f64>().sqrt();
                if d > 0.0 {
                    sum += d;
                    count += 1;
                }
            }
            None => {}
        }
    }
    if count > 0 && f64::is_finite(sum) { sum / f64::from(count) } else { 1.0 }
}
