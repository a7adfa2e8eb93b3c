//! What can be wrong with a mesh that another program made.

use std::fmt;

use crate::Mesh;

/// A fault of a mesh. Blocks, elements and nodes count from 0.
#[derive(Clone, Debug, PartialEq)]
pub enum MeshFault {
    /// There is no element.
    Empty,
    /// A block's list of nodes ends within an element.
    Ragged {
        /// The block.
        block: u32,
    },
    /// An element names a node that there is not.
    NodeOutOfRange {
        /// Block and element.
        element: (u32, u32),
        /// The node.
        node: u32,
    },
    /// An element has a node twice.
    NodeTwice {
        /// Block and element.
        element: (u32, u32),
        /// The node.
        node: u32,
    },
    /// A node's place is not finite.
    NodeNotFinite {
        /// The node.
        node: u32,
    },
    /// No element has this node.
    NodeUnused {
        /// The node.
        node: u32,
    },
    /// The determinant of an element is not positive at an integration point.
    Inverted {
        /// Block and element.
        element: (u32, u32),
        /// Middle of its corners in m.
        at: [f64; 3],
    },
    /// A face of a set is not one of the mesh.
    FaceOutOfRange {
        /// Name of the set.
        set: String,
    },
    /// A set of nodes names one that there is not.
    SetNodeOutOfRange {
        /// Name of the set.
        set: String,
        /// The node.
        node: u32,
    },
    /// A set has nothing in it.
    SetEmpty {
        /// Name of the set.
        set: String,
    },
}

impl fmt::Display for MeshFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MeshFault::Empty => write!(f, "the mesh has no element"),
            MeshFault::Ragged { block } => write!(f, "block {} ends within an element", block + 1),
            MeshFault::NodeOutOfRange { element, node } => {
                write!(
                    f,
                    "element {} of block {} has node {}, which does not exist",
                    element.1 + 1,
                    element.0 + 1,
                    node + 1
                )
            }
            MeshFault::NodeTwice { element, node } => {
                write!(f, "element {} of block {} has node {} twice", element.1 + 1, element.0 + 1, node + 1)
            }
            MeshFault::NodeNotFinite { node } => write!(f, "the place of node {} is not a finite number", node + 1),
            MeshFault::NodeUnused { node } => write!(f, "node {} belongs to no element", node + 1),
            MeshFault::Inverted { element, at: [x, y, z] } => {
                write!(f, "element {} of block {} is inverted, near ({x}, {y}, {z}) m", element.1 + 1, element.0 + 1)
            }
            MeshFault::FaceOutOfRange { set } => write!(f, "the set `{set}` has a face that does not exist"),
            MeshFault::SetNodeOutOfRange { set, node } => {
                write!(f, "the set `{set}` has node {}, which does not exist", node + 1)
            }
            MeshFault::SetEmpty { set } => write!(f, "the set `{set}` is empty"),
        }
    }
}

impl Mesh {
    /// Every fault of the mesh; inverted elements are looked for when all numbers are in range.
    pub fn check(&self) -> Vec<MeshFault> {
        let mut faults = Vec::new();
        if self.element_count() == 0 {
            faults.push(MeshFault::Empty);
        }
        let sound = self.check_elements(&mut faults);
        self.check_nodes(&mut faults);
        self.check_sets(&mut faults);
        if sound {
            let inverted = self.quality().inverted;
            faults.extend(
                inverted.into_iter().map(|element| MeshFault::Inverted { element, at: self.center_of(element) }),
            );
        }
        faults
    }

    /// Whether every node of every element exists.
    fn check_elements(&self, faults: &mut Vec<MeshFault>) -> bool {
        let mut sound = true;
        for (block, contents) in self.blocks.iter().enumerate() {
            if !contents.nodes.len().is_multiple_of(contents.shape.nodes()) {
                faults.push(MeshFault::Ragged { block: block as u32 });
                sound = false;
            }
            for (element, nodes) in contents.elements().enumerate() {
                let element = (block as u32, element as u32);
                for (k, &node) in nodes.iter().enumerate() {
                    if node as usize >= self.nodes.len() {
                        faults.push(MeshFault::NodeOutOfRange { element, node });
                        sound = false;
                    }
                    if nodes[..k].contains(&node) {
                        faults.push(MeshFault::NodeTwice { element, node });
                    }
                }
            }
        }
        sound
    }

    fn check_nodes(&self, faults: &mut Vec<MeshFault>) {
        let mut used = vec![false; self.nodes.len()];
        for &node in self.blocks.iter().flat_map(|block| &block.nodes) {
            if let Some(used) = used.get_mut(node as usize) {
                *used = true;
            }
        }
        for (node, (place, used)) in self.nodes.iter().zip(used).enumerate() {
            let node = node as u32;
            if !place.iter().all(|c| c.is_finite()) {
                faults.push(MeshFault::NodeNotFinite { node });
            }
            if !used {
                faults.push(MeshFault::NodeUnused { node });
            }
        }
    }

    fn check_sets(&self, faults: &mut Vec<MeshFault>) {
        for (set, nodes) in &self.node_sets {
            if nodes.is_empty() {
                faults.push(MeshFault::SetEmpty { set: set.clone() });
            }
            if let Some(&node) = nodes.iter().find(|&&node| node as usize >= self.nodes.len()) {
                faults.push(MeshFault::SetNodeOutOfRange { set: set.clone(), node });
            }
        }
        for (set, faces) in &self.face_sets {
            if faces.is_empty() {
                faults.push(MeshFault::SetEmpty { set: set.clone() });
            }
            let exists = |face: &crate::Face| {
                self.blocks.get(face.block as usize).is_some_and(|block| {
                    (face.element as usize) < block.len() && usize::from(face.face) < block.shape.faces().len()
                })
            };
            if !faces.iter().all(exists) {
                faults.push(MeshFault::FaceOutOfRange { set: set.clone() });
            }
        }
    }
}
