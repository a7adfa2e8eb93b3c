//! Pieces of a mesh that share no node.

use crate::freedom::{Counting, Freedom};
use crate::numbering::nodes_of;
use crate::{Coupling, CouplingKind, Fault, Part, Support};

/// Pieces that can move on their own: rigid couplings join what they take hold of.
pub(crate) fn loose(part: &Part<'_>) -> Vec<Fault> {
    let pieces = Pieces::new(part);
    if pieces.count < 2 {
        return Vec::new();
    }
    let loose = |piece: &u32| !Freedom::new(&pieces.held(part, *piece), Counting::Matrix).free.is_empty();
    let found = (0..pieces.count as u32).find(loose);
    let node_of = |piece: u32| pieces.of.iter().position(|&of| of == Some(piece)).unwrap_or(0) as u32;
    found.map(|piece| Fault::Pieces { pieces: pieces.count, node: node_of(piece) }).into_iter().collect()
}

struct Pieces {
    /// The piece of each node; none for nodes of no element.
    of: Vec<Option<u32>>,
    count: usize,
}

impl Pieces {
    fn new(part: &Part<'_>) -> Self {
        let mut parent: Vec<u32> = (0..part.mesh.nodes.len() as u32).collect();
        let mut used = vec![false; parent.len()];
        for block in &part.mesh.blocks {
            for element in block.elements() {
                element.iter().for_each(|&node| used[node as usize] = true);
                join(&mut parent, element);
            }
        }
        for coupling in part.couplings.iter().filter(|coupling| coupling.kind == CouplingKind::Rigid) {
            join(&mut parent, &nodes_of(part, &coupling.region));
        }
        let mut number = vec![None; parent.len()];
        let mut count = 0;
        let of = (0..parent.len() as u32).map(|node| {
            let root = root(&mut parent, node) as usize;
            used[node as usize].then(|| {
                *number[root].get_or_insert_with(|| {
                    count += 1;
                    count as u32 - 1
                })
            })
        });
        Self { of: of.collect(), count }
    }

    /// The part with the supports of one piece only.
    fn held<'a>(&self, part: &Part<'a>, piece: u32) -> Part<'a> {
        let own = |nodes: &[u32]| -> Vec<u32> {
            nodes.iter().copied().filter(|&node| self.of[node as usize] == Some(piece)).collect()
        };
        let support = |support: &Support| match support {
            Support::Fixed { nodes, axes, values } => {
                Support::Fixed { nodes: own(nodes), axes: *axes, values: *values }
            }
            Support::Spring { nodes, stiffness } => Support::Spring { nodes: own(nodes), stiffness: *stiffness },
        };
        let touches = |coupling: &&Coupling| !own(&nodes_of(part, &coupling.region)).is_empty();
        Part {
            mesh: part.mesh,
            materials: Vec::new(),
            supports: part.supports.iter().map(support).collect(),
            couplings: part.couplings.iter().filter(touches).cloned().collect(),
        }
    }
}

fn join(parent: &mut [u32], nodes: &[u32]) {
    for pair in nodes.windows(2) {
        let (a, b) = (root(parent, pair[0]), root(parent, pair[1]));
        parent[a.max(b) as usize] = a.min(b);
    }
}

fn root(parent: &mut [u32], mut node: u32) -> u32 {
    while parent[node as usize] != node {
        parent[node as usize] = parent[parent[node as usize] as usize];
        node = parent[node as usize];
    }
    node
}
