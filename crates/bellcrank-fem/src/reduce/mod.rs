//! Craig–Bampton reduction: a part as a body with a few coordinates.
//!
//! Reading order: [`Interface`], [`Keep`], [`Reduction`] (what comes out), [`reduce_matrices`] (the same for matrices
//! that are given). Hurty, AIAA Journal 3 (1965) 678; Craig & Bampton, AIAA Journal 6 (1968) 1313.

mod build;
mod columns;
mod free;
mod matrices;
mod problem;
mod products;
mod share;
mod stiffening;
mod stress;

pub(crate) use free::damping;
pub use free::natural_frequencies;
pub use matrices::{ReducedMatrices, reduce_matrices};
pub use stiffening::{SPIN_PAIRS, shortenings, spin_stiffness};
pub use stress::stress;

use crate::vector::V3;
use crate::{CouplingKind, Effort, Region, ShapeIntegrals};

/// Where a part is joined to something, or loaded: a surface and the frame that stands for it.
#[derive(Clone, Debug)]
pub struct Interface {
    /// What the frame takes hold of.
    pub region: Region,
    /// Origin of the frame in m; its axes are those of the mesh.
    pub point: [f64; 3],
    /// How the surface follows: with the frame as one rigid piece (RBE2), or such that the frame is its mean motion
    /// (RBE3).
    pub kind: CouplingKind,
}

/// Which fixed-interface modes are kept: those up to the frequency, and of these the lowest `count`; none where both
/// are `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Keep {
    /// How many at most.
    pub count: Option<usize>,
    /// Highest frequency, Hz.
    pub frequency: Option<f64>,
}

/// A reduced part. Its n coordinates are, for each interface in turn, the displacement of its frame along x, y, z (m)
/// and its rotation about them (rad), then those of the fixed-interface modes (kg^½·m).
///
/// Column e is the displacement of every node by coordinate e: an interface's moves that interface by 1 and holds all
/// others; a mode holds all interfaces, and has unit modal mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduction {
    /// Origin of each interface's frame, m.
    pub points: Vec<V3>,
    /// Number of fixed-interface modes.
    pub modes: usize,
    /// Their frequencies in Hz, ascending.
    pub frequencies: Vec<f64>,
    /// n × n by rows; zero between interfaces and modes, (2πf)² on the diagonal of the modes.
    pub stiffness: Vec<f64>,
    /// Integrals of the columns over the mass.
    pub inertia: ShapeIntegrals,
    /// The columns: displacement of every node, m a unit of the coordinate.
    pub shapes: Vec<Vec<V3>>,
    /// How exact all that is.
    pub checks: ReductionChecks,
    /// Size of the factor.
    pub effort: Effort,
}

/// What a reduction is known by to be right; numbers without unit unless one is said.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReductionChecks {
    /// All interfaces moved as one rigid body: largest difference of a node's displacement from that body's, relative to
    /// the largest displacement.
    pub rigid: f64,
    /// Largest force on an interface that such a motion leaves in the stiffness, relative to the sum of the sizes of what
    /// cancels there.
    pub unstrained: f64,
    /// Largest difference of the stiffness from its transpose before it was made symmetric, relative to the root of the
    /// product of its diagonal entries.
    pub symmetry: f64,
    /// Largest stiffness between an interface and a mode before it was made zero, relative likewise.
    pub coupling: f64,
    /// Largest residual of a constraint mode: force on a node that nothing holds, relative to the largest nodal force.
    pub static_residual: f64,
    /// Largest residual |K φ − λ M φ| / |λ M φ| of a fixed-interface mode.
    pub mode_residual: f64,
    /// Natural frequencies of the reduced body when nothing holds it, ascending, Hz; those of the six rigid motions come
    /// first and are zero but for rounding.
    pub free_frequencies: Vec<f64>,
}

impl Reduction {
    /// Number of coordinates.
    pub fn coordinates(&self) -> usize {
        6 * self.points.len() + self.modes
    }

    /// Mass matrix, n × n by rows.
    pub fn mass(&self) -> Vec<f64> {
        self.inertia.mass_matrix()
    }

    /// Damping matrix, n × n by rows, that gives every mode of the free reduced body the damping ratio `ratio`:
    /// D = M V diag(2 ζ ω) Vᵀ M. Motions as a rigid body are not damped.
    pub fn damping(&self, ratio: f64) -> Vec<f64> {
        free::damping(&self.stiffness, &self.mass(), &self.rigid_motions(), ratio)
    }

    /// Coordinates of the six motions of the whole as a rigid body: displacement along x, y, z, then rotation about
    /// axes through the origin.
    pub fn rigid_motions(&self) -> Vec<Vec<f64>> {
        let mut motions = vec![vec![0.0; self.coordinates()]; 6];
        for (interface, point) in self.points.iter().enumerate() {
            let fields = crate::numbering::rigid_motions(*point);
            for (k, (motion, field)) in motions.iter_mut().zip(fields).enumerate() {
                motion[6 * interface..6 * interface + 3].copy_from_slice(&field);
                if k >= 3 {
                    motion[6 * interface + k] = 1.0;
                }
            }
        }
        motions
    }
}
