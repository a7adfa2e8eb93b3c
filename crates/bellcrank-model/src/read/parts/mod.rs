//! Studies of bodies as elastic parts: [`PartKeys`] are what one study says, [`parts`] makes a
//! [`crate::design::Parts`] of them.

mod acting;
mod finish;
mod keys;

pub(crate) use finish::parts;
pub(crate) use keys::{PartKeys, mesh};
