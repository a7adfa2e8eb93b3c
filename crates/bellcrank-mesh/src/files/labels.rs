//! From nodes with labels to a mesh: renumbering, dropping what nothing uses, faces by their corners.

use std::collections::HashMap;

use super::{Imported, Note};
use crate::boundary::Hasher;
use crate::{Face, Mesh};

/// Drops nodes that no element has, from the sets too.
pub(super) fn drop_unused(imported: &mut Imported) {
    let mesh = &mut imported.mesh;
    let mut number = vec![u32::MAX; mesh.nodes.len()];
    mesh.blocks.iter().flat_map(|block| &block.nodes).for_each(|&node| number[node as usize] = 0);
    let kept: Vec<usize> = (0..number.len()).filter(|&node| number[node] == 0).collect();
    if kept.len() == mesh.nodes.len() {
        return;
    }
    kept.iter().enumerate().for_each(|(new, &old)| number[old] = new as u32);
    imported.notes.push(Note::NodesLeftOut { count: mesh.nodes.len() - kept.len() });
    mesh.nodes = kept.iter().map(|&old| mesh.nodes[old]).collect();
    imported.node_labels = kept.iter().map(|&old| imported.node_labels[old]).collect();
    mesh.blocks.iter_mut().flat_map(|block| &mut block.nodes).for_each(|node| *node = number[*node as usize]);
    for set in mesh.node_sets.values_mut() {
        let renamed = set.iter().map(|&node| number[node as usize]).filter(|&node| node != u32::MAX);
        *set = renamed.collect();
    }
}

/// Outer faces by their corners in ascending order.
pub(super) struct Outside(HashMap<[u32; 4], Face, Hasher>);

impl Outside {
    pub(super) fn of(mesh: &Mesh) -> Outside {
        Outside(mesh.boundary().into_iter().map(|face| (mesh.corners_of(face), face)).collect())
    }

    /// The face with these corners, three or four.
    pub(super) fn face(&self, corners: &[u32]) -> Option<Face> {
        let mut key = [u32::MAX; 4];
        key.iter_mut().zip(corners).for_each(|(slot, &corner)| *slot = corner);
        key.sort_unstable();
        self.0.get(&key).copied()
    }
}

/// Number of corners of a surface element by its number of nodes.
pub(super) fn surface_corners(nodes: usize) -> Option<usize> {
    match nodes {
        3 | 6 | 7 => Some(3),
        4 | 8 | 9 => Some(4),
        _ => None,
    }
}

/// Ascending, each once.
pub(super) fn tidy<T: Ord>(list: &mut Vec<T>) {
    list.sort_unstable();
    list.dedup();
}
