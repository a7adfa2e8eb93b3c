//! From a model file to a mechanism, and from a study to results: the only place where text meets
//! mechanics.
//!
//! [`load`] reads a file and checks everything in it; a [`Model`] answers what it is
//! ([`Model::check`]) and runs its studies ([`Model::run`], [`Model::run_all`]). [`schema`] and
//! [`starter`] are the format in other clothes.

mod ask;
mod build;
mod catalogue;
mod check;
mod converge;
#[cfg(test)]
mod derivatives;
mod design;
mod disk;
mod drawing;
mod elastic;
mod error;
mod flex;
mod geometry;
mod improve;
mod keyed;
mod load;
mod measure;
mod model;
mod motion;
mod mounts;
mod names;
mod options;
mod parts;
mod progress;
mod provenance;
mod read;
mod run;
mod scalar;
mod schema;
mod signals;
mod starter;
mod trial;
pub mod verify;
mod written;

pub use check::{BodyFact, Check, JointFact, SolidFact, solid_table};
pub use converge::Converge;
pub use error::RunError;
pub use improve::{ImproveError, Improved};
pub use load::{Loaded, load};
pub use model::{Model, StudyInfo};
pub use options::{MeshFormats, RunOptions};
pub use parts::{PartFile, PartFormat};
pub use progress::{Progress, Silent};
pub use schema::schema;
pub use starter::starter;
