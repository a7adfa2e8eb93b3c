//! Constrained optimization, sampling and statistics of plain functions.
//!
//! Everything in here is numbers in, numbers out: no mechanics, no files, no units, no clock. Reading order: [`nlp`]
//! (minimize a smooth or minimax function under constraints), [`sampling`] (which points to look
//! at), [`statistics`] (what the answers say).

pub mod nlp;
pub mod sampling;
pub mod statistics;
