//! Linear elasticity on a mesh.
//!
//! Reading order: [`Part`] (mesh, materials, supports, couplings), [`Load`], [`Statics`] (one factorization, any
//! number of load cases), [`Modes`], [`Stress`] (smoothed, with its error), [`reduce`] (a part as a flexible body),
//! [`beam`] (one without a mesh), [`fatigue`] (what a history of stress does). All in SI and in the axes of the mesh.
//! No joints, no files, no units; threads as many as the caller says.

#![expect(clippy::needless_range_loop, reason = "indices of components are how the formulas are written down")]

mod adapt;
mod assemble;
mod balance;
pub mod beam;
mod check;
mod element;
pub mod fatigue;
mod fault;
mod field;
mod freedom;
mod integrals;
mod load;
mod material;
mod modes;
mod numbering;
mod part;
mod pieces;
mod recovery;
pub mod reduce;
mod settings;
mod shortening;
mod solver;
mod statics;
pub mod stress;
mod surface;
mod vector;

pub use adapt::{SizeField, element_sizes, element_stress_errors, wanted_sizes};
pub use balance::nodal_forces;
pub use fault::{Fault, FreeMotion};
pub use integrals::ShapeIntegrals;
pub use load::Load;
pub use material::{Material, MaterialFault, Six, principal, von_mises};
pub use modes::Modes;
pub use part::{Coupling, CouplingKind, Part, Region, Support};
pub use reduce::{Interface, Keep, Reduction, ReductionChecks};
pub use settings::Settings;
pub use shortening::Shortening;
pub use statics::{Effort, Free, Solution, Statics};
pub use stress::{Peak, Stress};
