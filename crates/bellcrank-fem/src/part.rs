//! A part to be analysed: its mesh, materials, supports and couplings.

use bellcrank_mesh::{Face, Mesh};

use crate::Material;

/// What is analysed. Positions, displacements and vectors are in the axes of the mesh; SI.
#[derive(Clone, Debug)]
pub struct Part<'a> {
    /// Nodes and elements.
    pub mesh: &'a Mesh,
    /// A material for each block of the mesh.
    pub materials: Vec<Material>,
    /// What holds it.
    pub supports: Vec<Support>,
    /// Surfaces or nodes that move, or are loaded, as one.
    pub couplings: Vec<Coupling>,
}

/// What holds nodes.
#[derive(Clone, Debug)]
pub enum Support {
    /// Displacement components prescribed.
    Fixed {
        /// Which nodes.
        nodes: Vec<u32>,
        /// Directions of the components, as rows, of length one and perpendicular.
        axes: [[f64; 3]; 3],
        /// Displacement along each axis in m; `None` leaves it free.
        values: [Option<f64>; 3],
    },
    /// Springs to ground, spread evenly over nodes.
    Spring {
        /// Which nodes.
        nodes: Vec<u32>,
        /// Stiffness of all together along x, y, z in N/m.
        stiffness: [f64; 3],
    },
}

/// Where a coupling takes hold.
#[derive(Clone, Debug)]
pub enum Region {
    /// Faces of elements: areas count.
    Faces(Vec<Face>),
    /// Nodes, each as much as any other.
    Nodes(Vec<u32>),
}

/// Ties a surface to a frame that loads, supports and other bodies act on.
#[derive(Clone, Debug)]
pub struct Coupling {
    /// What it takes hold of.
    pub region: Region,
    /// Origin of the frame, m.
    pub reference: [f64; 3],
    /// How.
    pub kind: CouplingKind,
    /// Prescribed motion of the frame: displacement along x, y, z in m, then rotation about them in rad; `None` is
    /// free.
    pub held: [Option<f64>; 6],
}

/// How a surface follows its frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CouplingKind {
    /// Every node moves with the frame (RBE2): the surface cannot deform.
    Rigid,
    /// The frame is the mean displacement and the mean rotation of the surface (RBE3); a force on it is a traction
    /// that is linear over the surface. The surface stays as soft as it is.
    Distributing,
}

impl Coupling {
    /// A coupling whose frame is free.
    pub fn free(region: Region, reference: [f64; 3], kind: CouplingKind) -> Self {
        Self { region, reference, kind, held: [None; 6] }
    }
}

impl Support {
    /// Nodes that do not move.
    pub fn clamped(nodes: Vec<u32>) -> Self {
        Self::along(nodes, [Some(0.0); 3])
    }

    /// Prescribed components along x, y, z.
    pub fn along(nodes: Vec<u32>, values: [Option<f64>; 3]) -> Self {
        Support::Fixed { nodes, axes: IDENTITY, values }
    }
}

pub(crate) const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
