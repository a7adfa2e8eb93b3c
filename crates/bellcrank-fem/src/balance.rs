//! Forces that the stresses of a solution are in balance with.

use crate::field;
use crate::vector::V3;
use crate::{Part, Solution};

/// The force from outside on every node, N: loads, what holds it, springs, and the inertia that balanced what was left.
/// Thermal strain is in the stresses and gives none.
pub fn nodal_forces(part: &Part<'_>, solution: &Solution) -> Vec<V3> {
    field::internal(part, &solution.displacement, solution.temperature.as_deref()).0
}
