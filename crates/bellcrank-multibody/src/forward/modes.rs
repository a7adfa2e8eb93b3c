//! Modes.
use super::door::{Linearized, Surroundings};
use crate::solver::Machine;
use crate::{Coordinate, MechanismError};
use bellcrank_math::Space;

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn find_modes(
        &mut self,
        _driven: &[Coordinate],
        _around: &mut dyn Surroundings,
    ) -> Result<Linearized, MechanismError> {
        Err(MechanismError::NotFinite("modes"))
    }
    pub(crate) fn put_mode(&mut self, _mode: usize, _phase: f64) {}
}
