//! Nodes, elements and named sets.

use std::collections::BTreeMap;

use crate::Shape;

/// A mesh of one part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Places of the nodes in m.
    pub nodes: Vec<[f64; 3]>,
    /// Elements, by shape and material.
    pub blocks: Vec<Block>,
    /// Named sets of nodes, ascending. The mesher makes `bore.NAME` for each eye.
    pub node_sets: BTreeMap<String, Vec<u32>>,
    /// Named sets of element faces: surfaces that pressures and bearing loads act on. The mesher makes `bore.NAME`.
    pub face_sets: BTreeMap<String, Vec<Face>>,
}

/// Elements of one shape and one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Name of the element set; empty where nothing names it.
    pub name: String,
    /// Shape of every element in it.
    pub shape: Shape,
    /// Nodes of the elements one after another, [`Shape::nodes`] each, in the order of Abaqus and CalculiX.
    pub nodes: Vec<u32>,
}

/// One face of one element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Face {
    /// Block of the element.
    pub block: u32,
    /// Element in the block.
    pub element: u32,
    /// Face of the element, in the order of Abaqus and CalculiX, from 0.
    pub face: u8,
}

impl Block {
    /// Number of elements.
    pub fn len(&self) -> usize {
        self.nodes.len() / self.shape.nodes()
    }

    /// Whether it has none.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Nodes of one element.
    pub fn element(&self, element: usize) -> &[u32] {
        let count = self.shape.nodes();
        &self.nodes[element * count..(element + 1) * count]
    }

    /// Nodes of every element in turn.
    pub fn elements(&self) -> std::slice::ChunksExact<'_, u32> {
        self.nodes.chunks_exact(self.shape.nodes())
    }
}

impl Mesh {
    /// Multiplies all places, for example by 0.001 when a file is in mm.
    pub fn scale(&mut self, factor: f64) {
        self.nodes.iter_mut().flatten().for_each(|c| *c *= factor);
    }

    /// Number of elements of all blocks.
    pub fn element_count(&self) -> usize {
        self.blocks.iter().map(Block::len).sum()
    }

    /// Nodes of a face: corners, then mid-sides, with the normal out of the element by the right-hand rule.
    pub fn face_nodes(&self, face: Face) -> impl Iterator<Item = u32> + '_ {
        let block = &self.blocks[face.block as usize];
        let nodes = block.element(face.element as usize);
        block.shape.faces()[face.face as usize].iter().map(move |&node| nodes[node as usize])
    }
}
