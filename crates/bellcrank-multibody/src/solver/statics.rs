//! Equilibrium at rest of a mechanism that is not fully held.
use super::machine::Machine;
use crate::{Coordinate, Engine, Equilibrium, MechanismError};
use bellcrank_math::Space;
impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn find_equilibrium(
        &mut self,
        _hold: &[(Coordinate, f64)],
        _inputs: &mut dyn FnMut(&dyn Engine, &mut [f64]),
    ) -> Result<Equilibrium, MechanismError> {
        Err(MechanismError::NotFinite("equilibrium"))
    }
}
