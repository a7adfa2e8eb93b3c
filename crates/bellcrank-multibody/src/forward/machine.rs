//! The door, on a machine.

use super::door::{Advance, Begun, Dynamics, Forward, Linearized, SolverEffort, Surroundings};
use crate::solver::Machine;
use crate::{Coordinate, MechanismError};
use bellcrank_math::Space;

impl<S: Space<T = f64>> Forward for Machine<S> {
    fn begin(&mut self, _dynamics: &Dynamics, _around: &mut dyn Surroundings) -> Result<Begun, MechanismError> {
        Err(MechanismError::NotFinite("forward dynamics"))
    }
    fn advance(&mut self, _until: f64, _around: &mut dyn Surroundings) -> Result<Advance, MechanismError> {
        Err(MechanismError::NotFinite("forward dynamics"))
    }
    fn solver_effort(&self) -> SolverEffort {
        SolverEffort::default()
    }
    fn linearize(
        &mut self,
        _driven: &[Coordinate],
        _around: &mut dyn Surroundings,
    ) -> Result<Linearized, MechanismError> {
        Err(MechanismError::NotFinite("forward dynamics"))
    }
    fn show_mode(&mut self, _mode: usize, _phase: f64) {}
}
