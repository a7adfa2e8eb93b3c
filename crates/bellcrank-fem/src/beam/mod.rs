//! Straight prismatic beams as reduced flexible bodies, in closed form.
//!
//! A [`Segment`] (length, place, [`Line`] of constants) becomes a [`Beam`]: the same data as the reduction of a solid, with
//! the two ends as its interfaces. [`Section`] makes the constants of common sections and the stress in them.
//!
//! Axes of a beam: x along it, y and z the principal axes of its section, through its centroid, which is its shear
//! centre too. A particle at (y, z) of the section at x moves by `(u, v, w) + θ × (0, y, z)`; sections stay plane, but
//! not perpendicular to the axis: shear strains are γ_y = v' − θ_z and γ_z = w' + θ_y.

mod bubbles;
mod forces;
mod quadrature;
mod reduce;
mod section;
mod segment;
mod shapes;

pub use crate::Shortening;
pub use forces::SectionForces;
pub use reduce::Beam;
pub use section::{Section, SectionFault, SectionPoint, ShearRule};
pub use segment::{BeamFault, Line, Segment, axes};
