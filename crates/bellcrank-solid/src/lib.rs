//! Links as solids.
//!
//! Reading order: [`Link`] (what an engineer says: eyes, webs, plates, cuts), [`Stack`] (the solid as
//! layers of one plane arrangement of lines and arcs, from which mass properties, faces and meshes follow
//! without another boolean operation), [`Revolved`]. Everything is generic over the scalar, so that mass
//! properties carry exact derivatives by any parameter. No joints, no files, no units: lengths are in m.

mod build;
mod fault;
mod link;
mod moments;
mod plane;
mod revolved;
mod shell;
mod stack;

pub use fault::{Fault, Part, Quantity};
pub use link::{Bar, Corner, Cut, CutShape, Eye, Link, Plate, Profile, Web};
pub use moments::{MassProperties, Moments};
pub use revolved::Revolved;
pub use shell::{Face, Form, Path, SharpEdge, Shell, ShellEdge, Surface, step, stl};
pub use stack::{Bore, Cell, Curve, Edge, Stack};
