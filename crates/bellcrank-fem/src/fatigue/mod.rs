//! Fatigue of a place under a history of stress: a first check by nominal rules.
//!
//! Reading order: [`Equivalent`] (six components to one number), [`Rainflow`] (its cycles), [`MeanStress`] (the same
//! damage at R = −1), [`Woehler`] (how many of them it stands), [`Fatigue`] (all of it: damage by Miner's sum).
//!
//! Assumed: stress is elastic (no yield that would rearrange it), temperature and time do not matter, order of cycles does
//! not matter, and the Wöhler line is that of the place with its surface, size and notch.

mod damage;
mod equivalent;
mod mean;
mod rainflow;
mod woehler;

pub use damage::{Damage, Fatigue};
pub use equivalent::Equivalent;
pub use mean::{MeanStress, MetalGroup};
pub use rainflow::{Cycle, Rainflow, Residue, spectrum};
pub use woehler::{Beyond, Woehler, WoehlerFault};
