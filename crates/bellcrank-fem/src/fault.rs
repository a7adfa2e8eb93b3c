//! What is wrong with a part or its loads.

use crate::MaterialFault;
use crate::vector::V3;

/// A fault; ids are places in the lists of the part, vectors are in the axes of the mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// The mesh has no elements.
    NoElements,
    /// The number of materials is not the number of blocks.
    Materials {
        /// Blocks of the mesh.
        blocks: usize,
        /// Materials given.
        materials: usize,
    },
    /// A material that is none.
    Material {
        /// Block it belongs to.
        block: usize,
        /// What is wrong with it.
        fault: MaterialFault,
    },
    /// An element that is turned inside out, or flat.
    Inverted {
        /// Block of the element.
        block: usize,
        /// Element in the block.
        element: usize,
        /// Smallest determinant of the Jacobian at its integration points, m³.
        determinant: f64,
    },
    /// A support without nodes.
    EmptySupport(usize),
    /// A coupling without nodes or area.
    EmptyCoupling(usize),
    /// A distributing coupling whose points lie on one line: it carries no moment about it.
    CouplingOnLine(usize),
    /// A load without nodes or area: its place in the list of loads.
    EmptyLoad(usize),
    /// Supports that want different displacements of one node.
    SupportsDisagree {
        /// The later one.
        support: usize,
        /// Node.
        node: u32,
    },
    /// A node that belongs to two rigid couplings.
    TwiceCoupled {
        /// Node.
        node: u32,
        /// The two.
        couplings: [usize; 2],
    },
    /// A node that belongs to a rigid coupling and to a support.
    CoupledAndHeld {
        /// Node.
        node: u32,
        /// Coupling.
        coupling: usize,
    },
    /// A part that is to be reduced has supports or couplings: its interfaces are all that may take hold of it.
    ReducedPartHeld,
    /// A part that is to be reduced has no interface.
    NoInterface,
    /// An interface without nodes or area.
    EmptyInterface(usize),
    /// An interface whose points lie on one line: it carries no moment about it.
    InterfaceOnLine(usize),
    /// A node that belongs to two interfaces.
    InterfacesOverlap {
        /// Node.
        node: u32,
        /// The two.
        interfaces: [usize; 2],
    },
    /// More modes were asked for than the part has with its interfaces held.
    TooManyModes {
        /// Asked.
        asked: usize,
        /// Unknowns that are free.
        available: usize,
    },
    /// The supports leave the part free to move as a whole.
    UnderSupported(Vec<FreeMotion>),
    /// The mesh falls into pieces that share no node, and one of them is not held by supports of its own.
    Pieces {
        /// How many there are.
        pieces: usize,
        /// A node of one that is loose.
        node: u32,
    },
    /// Some piece of the mesh can move without being deformed; found when the matrix was factored.
    Loose {
        /// A node of it.
        node: u32,
        /// Direction in which it yields: 0, 1, 2 of the free ones.
        component: usize,
    },
    /// A mode of a part held by distributing couplings was asked for.
    ModesWithDistributingSupport(usize),
    /// More memory is needed than there is, bytes.
    Memory {
        /// Needed, an estimate.
        needed: usize,
        /// What the caller allowed.
        allowed: usize,
    },
    /// The caller asked to stop.
    Interrupted,
    /// Conjugate gradients did not converge: the part is too slender or too badly meshed for them.
    Stagnated {
        /// Residual they got to, relative to the loads.
        residual: f64,
    },
    /// The eigenvalue iteration did not converge.
    NotConverged {
        /// How many modes it found.
        found: usize,
    },
}

/// A motion of the whole part that nothing resists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FreeMotion {
    /// Along a direction of length one.
    Along(V3),
    /// About an axis through a point.
    About {
        /// Direction of the axis, of length one.
        axis: V3,
        /// A point on it, m.
        point: V3,
        /// Advance along the axis a radian, m.
        pitch: f64,
    },
}

impl Fault {
    /// Faults of one kind are told once a place.
    pub(crate) fn kind(&self) -> (std::mem::Discriminant<Fault>, usize) {
        let place = match self {
            Fault::SupportsDisagree { support, .. } => *support,
            Fault::TwiceCoupled { couplings, .. } => couplings[1],
            Fault::CoupledAndHeld { coupling, .. } => *coupling,
            _ => 0,
        };
        (std::mem::discriminant(self), place)
    }
}
