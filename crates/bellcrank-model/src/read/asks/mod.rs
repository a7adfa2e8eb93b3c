//! Studies that ask something of another study: [`AskKeys`] are what one study says, [`ask`] makes an
//! [`crate::design::Ask`] of them once the study that is asked is known.
//!
//! Another question is a variant of [`crate::design::Question`], a schema of its keys, their reading in `keys.rs`,
//! and a file here that checks them.

mod designs;
mod finish;
mod given;
mod keys;
mod objective;
mod optimize;
mod sizing;
mod sizing_of;
mod source;
mod sweep;
mod table;
#[cfg(test)]
mod tests;
mod tolerance;
mod tolerance_of;

pub(crate) use finish::{Asking, ask};
pub(crate) use keys::AskKeys;
pub(crate) use sizing::CatalogueFiles;
pub(crate) use source::Asked;
pub(crate) use table::{DesignTable, design_table};
