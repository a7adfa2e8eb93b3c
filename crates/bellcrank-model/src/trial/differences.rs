//! Derivatives by parameters that no exact one goes through: each value of theirs makes another mesh, and another
//! reduction of a flexible body.

use super::machine::{Trial, Undefined};
use crate::design::ScopeId;
use crate::flex;

/// Half the width of a difference, of the value: another mesh changes a stiffness by some 1e-4 whatever the step, so a
/// narrow one would show the mesh.
const STEP: f64 = 0.01;
/// The same of a parameter that is 0, SI.
const STEP_AT_ZERO: f64 = 1e-5;

impl Trial<'_> {
    /// Places in `by` of parameters that change a reduction.
    pub(super) fn remeshed(&self, by: &[usize]) -> Vec<usize> {
        let changes = |place: &usize| self.flexible && flex::changes(self.design, self.parameters, by[*place]);
        (0..by.len()).filter(changes).collect()
    }

    /// Slopes of all responses by a parameter, by central differences; the design run last is the same afterwards.
    pub(super) fn differences(&mut self, parameter: usize) -> Result<Vec<f64>, Undefined> {
        let fixed = self.fixed.clone();
        let at = self.values.of(ScopeId(0))[parameter];
        let half = if at == 0.0 { STEP_AT_ZERO } else { STEP * at.abs() };
        let others = fixed.iter().copied().filter(|(index, _)| *index != parameter);
        let with = |value: f64| -> Vec<(usize, f64)> { others.clone().chain([(parameter, value)]).collect() };
        let up = self.run(&with(at + half))?.to_vec();
        let down = self.run(&with(at - half))?.to_vec();
        self.run(&fixed)?;
        Ok(up.iter().zip(&down).map(|(up, down)| (up - down) / (2.0 * half)).collect())
    }
}
