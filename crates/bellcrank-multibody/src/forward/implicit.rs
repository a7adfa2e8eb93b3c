//! Generalized-α.
use super::door::Surroundings;
use super::flight::Flight;
use crate::MechanismError;
use crate::solver::Machine;
use bellcrank_math::Space;

/// Tangents.
#[derive(Clone, Debug)]
pub(crate) struct Jacobian {}

impl Jacobian {
    pub(crate) fn new(_nv: usize) -> Self {
        Self {}
    }
    pub(crate) fn forget(&mut self) {}
}

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn step_implicitly(
        &mut self,
        f: &mut Flight<S>,
        limit: f64,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        self.step_explicitly(f, limit, around)
    }
}
