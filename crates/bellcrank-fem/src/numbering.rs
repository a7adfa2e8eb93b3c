//! Which unknowns the motion of each node is made of.
//!
//! Nodes are tied to groups of unknowns: a free node to its own three, a supported one to those that are left, a node
//! of a rigid coupling to the six of its frame. u = Σ columns q + fixed.

use crate::vector::{self, V3};
use crate::{CouplingKind, Fault, Part, Region, Support};

/// How a node follows its group.
#[derive(Clone, Debug)]
pub(crate) struct Tie {
    /// The group.
    pub(crate) group: u32,
    /// Motion of the node for each unknown of the group; `None` where that is the identity.
    pub(crate) columns: Option<Box<[V3]>>,
    /// What is prescribed.
    pub(crate) fixed: V3,
}

/// Unknowns that belong together: consecutive equations.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Group {
    pub(crate) first: u32,
    pub(crate) count: u8,
}

#[derive(Clone, Debug)]
pub(crate) struct Numbering {
    pub(crate) ties: Vec<Tie>,
    pub(crate) groups: Vec<Group>,
    /// The group of each rigid coupling and which components of its frame are free.
    pub(crate) frames: Vec<Option<(u32, Vec<usize>)>>,
    pub(crate) equations: usize,
}

/// A direction in which a node is held, and where it is held.
type Hold = (V3, f64);

impl Numbering {
    /// `pins` are single components of nodes held beside the supports.
    pub(crate) fn new(part: &Part<'_>, pins: &[(u32, usize)]) -> Result<Self, Vec<Fault>> {
        let mut faults = Vec::new();
        let holds = holds(part, pins, &mut faults);
        let owner = owners(part, &holds, &mut faults);
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut numbering = Self {
            ties: Vec::with_capacity(part.mesh.nodes.len()),
            groups: Vec::new(),
            frames: Vec::new(),
            equations: 0,
        };
        for coupling in &part.couplings {
            let frame = matches!(coupling.kind, CouplingKind::Rigid).then(|| {
                let free: Vec<usize> = (0..6).filter(|&k| coupling.held[k].is_none()).collect();
                (numbering.add_group(free.len()), free)
            });
            numbering.frames.push(frame);
        }
        for (node, holds) in holds.iter().enumerate() {
            let tie = match owner[node] {
                Some(coupling) => numbering.slave(part, coupling, node),
                None => numbering.own(holds),
            };
            numbering.ties.push(tie);
        }
        Ok(numbering)
    }

    fn add_group(&mut self, count: usize) -> u32 {
        self.groups.push(Group { first: self.equations as u32, count: count as u8 });
        self.equations += count;
        (self.groups.len() - 1) as u32
    }

    fn own(&mut self, holds: &[Hold]) -> Tie {
        let columns = complement(holds);
        let group = self.add_group(columns.len());
        let mut fixed = [0.0; 3];
        for (direction, value) in holds {
            vector::accumulate(&mut fixed, vector::scale(*direction, *value));
        }
        Tie { group, columns: (!holds.is_empty()).then(|| columns.into_boxed_slice()), fixed }
    }

    fn slave(&self, part: &Part<'_>, coupling: usize, node: usize) -> Tie {
        let tied = &part.couplings[coupling];
        let arm = vector::sub(part.mesh.nodes[node], tied.reference);
        let motions = rigid_motions(arm);
        let mut fixed = [0.0; 3];
        for (motion, held) in motions.iter().zip(tied.held) {
            vector::accumulate(&mut fixed, vector::scale(*motion, held.unwrap_or(0.0)));
        }
        let (group, free) = self.frames[coupling].clone().unwrap_or_default();
        Tie { group, columns: Some(free.iter().map(|&k| motions[k]).collect()), fixed }
    }

    /// Displacement of every node, from the unknowns; `prescribed` scales what is prescribed (0 for a homogeneous
    /// solution).
    pub(crate) fn displacement(&self, q: &[f64], prescribed: f64) -> Vec<V3> {
        self.ties.iter().map(|tie| self.moved(tie, q, prescribed)).collect()
    }

    fn moved(&self, tie: &Tie, q: &[f64], prescribed: f64) -> V3 {
        let group = self.groups[tie.group as usize];
        let own = &q[group.first as usize..group.first as usize + group.count as usize];
        match &tie.columns {
            None => [own[0], own[1], own[2]],
            Some(columns) => {
                let mut u = vector::scale(tie.fixed, prescribed);
                columns.iter().zip(own).for_each(|(column, q)| vector::accumulate(&mut u, vector::scale(*column, *q)));
                u
            }
        }
    }

    /// Nodal forces (and those on frames) as forces on the unknowns.
    pub(crate) fn gather(&self, nodal: &[V3], frames: &[[f64; 6]], out: &mut [f64]) {
        out.fill(0.0);
        for (tie, force) in self.ties.iter().zip(nodal) {
            let first = self.groups[tie.group as usize].first as usize;
            match &tie.columns {
                None => (0..3).for_each(|i| out[first + i] += force[i]),
                Some(columns) => {
                    columns.iter().enumerate().for_each(|(k, column)| out[first + k] += vector::dot(*column, *force));
                }
            }
        }
        for (frame, force) in self.frames.iter().zip(frames) {
            if let Some((group, free)) = frame {
                let first = self.groups[*group as usize].first as usize;
                free.iter().enumerate().for_each(|(k, &component)| out[first + k] += force[component]);
            }
        }
    }

    /// The node (or coupling) and direction that an equation belongs to, for messages.
    pub(crate) fn owner(&self, equation: usize) -> (Option<usize>, usize) {
        let group = self.groups.partition_point(|group| group.first as usize <= equation).saturating_sub(1);
        let group = (0..=group).rev().find(|&g| self.groups[g].count > 0).unwrap_or(0);
        let component = equation - self.groups[group].first as usize;
        (self.ties.iter().position(|tie| tie.group as usize == group), component)
    }
}

/// Displacement at an arm from the frame for each of its six components: three displacements, three rotations.
pub(crate) fn rigid_motions(arm: V3) -> [V3; 6] {
    std::array::from_fn(|k| {
        let unit = std::array::from_fn(|i| f64::from(i == k % 3));
        if k < 3 { unit } else { vector::cross(unit, arm) }
    })
}

fn holds(part: &Part<'_>, pins: &[(u32, usize)], faults: &mut Vec<Fault>) -> Vec<Vec<Hold>> {
    let mut holds: Vec<Vec<Hold>> = vec![Vec::new(); part.mesh.nodes.len()];
    for (index, support) in part.supports.iter().enumerate() {
        if let Support::Fixed { nodes, axes, values } = support {
            for &node in nodes {
                for (axis, value) in axes.iter().zip(values) {
                    if let Some(value) = value
                        && !hold(&mut holds[node as usize], *axis, *value)
                    {
                        faults.push(Fault::SupportsDisagree { support: index, node });
                    }
                }
            }
        }
    }
    for &(node, component) in pins {
        hold(&mut holds[node as usize], std::array::from_fn(|i| f64::from(i == component)), 0.0);
    }
    holds
}

/// Adds a direction to those that hold a node; whether it agrees with them.
fn hold(holds: &mut Vec<Hold>, direction: V3, value: f64) -> bool {
    let (mut left, mut wanted) = (direction, value);
    for (held, at) in holds.iter() {
        let part = vector::dot(direction, *held);
        left = vector::sub(left, vector::scale(*held, part));
        wanted -= part * at;
    }
    let size = vector::norm(left);
    if size < 1e-9 {
        let scale = holds.iter().map(|(_, at)| at.abs()).fold(value.abs(), f64::max);
        return wanted.abs() <= 1e-9 * scale;
    }
    holds.push((vector::scale(left, 1.0 / size), wanted / size));
    true
}

/// Directions that are left free, of length one and perpendicular.
fn complement(holds: &[Hold]) -> Vec<V3> {
    let mut taken: Vec<V3> = holds.iter().map(|(direction, _)| *direction).collect();
    let mut free = Vec::new();
    while taken.len() < 3 {
        let left = |k: usize| {
            let unit = std::array::from_fn(|i| f64::from(i == k));
            taken.iter().fold(unit, |left: V3, e| vector::sub(left, vector::scale(*e, vector::dot(unit, *e))))
        };
        let longest = (0..3).map(left).max_by(|a, b| vector::norm(*a).total_cmp(&vector::norm(*b))).unwrap_or([0.0; 3]);
        let next = vector::scale(longest, 1.0 / vector::norm(longest));
        taken.push(next);
        free.push(next);
    }
    free
}

/// The rigid coupling that each node belongs to.
fn owners(part: &Part<'_>, holds: &[Vec<Hold>], faults: &mut Vec<Fault>) -> Vec<Option<usize>> {
    let mut owners = vec![None; part.mesh.nodes.len()];
    for (index, coupling) in part.couplings.iter().enumerate() {
        if coupling.kind != CouplingKind::Rigid {
            continue;
        }
        for node in nodes_of(part, &coupling.region) {
            let owner = &mut owners[node as usize];
            match owner {
                Some(other) if *other != index => {
                    faults.push(Fault::TwiceCoupled { node, couplings: [*other, index] });
                }
                _ if !holds[node as usize].is_empty() => faults.push(Fault::CoupledAndHeld { node, coupling: index }),
                _ => *owner = Some(index),
            }
        }
    }
    faults.dedup_by_key(|fault| fault.kind());
    owners
}

/// Nodes of a region, ascending.
pub(crate) fn nodes_of(part: &Part<'_>, region: &Region) -> Vec<u32> {
    let mut nodes = match region {
        Region::Nodes(nodes) => nodes.clone(),
        Region::Faces(faces) => faces.iter().flat_map(|&face| part.mesh.face_nodes(face)).collect(),
    };
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}
