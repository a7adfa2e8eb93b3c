//! Whether the energy of a machine is constant, so that its drift is an error.

use bellcrank_multibody::{Blueprint, Force, Value};
use bellcrank_results::Reductions;

/// Largest change of the total energy since the start, J.
pub(super) fn drift(totals: &[f64]) -> Option<f64> {
    let found = Reductions::of(totals)?;
    Some((found.max.value - found.first).max(found.first - found.min.value))
}

/// No force of the machine takes or gives energy, and the total tells what all of them store. (Drives are not looked
/// at here.)
pub(super) fn conserves(blueprint: &Blueprint<f64>) -> bool {
    let keeps = |force: &Force<f64>| match force {
        Force::Point { vector, .. } | Force::Torque { vector, .. } => vector.iter().all(zero),
        Force::Effort { value, .. } => zero(value),
        Force::Spring { stiffness, damping, free_length: rest, preload, .. }
        | Force::JointSpring { stiffness, damping, free_position: rest, preload, .. } => {
            [stiffness, rest, preload].into_iter().all(constant) && zero(damping)
        }
        Force::Friction { coulomb, static_coefficient, viscous, .. } => {
            [Some(coulomb), static_coefficient.as_ref(), Some(viscous)].into_iter().flatten().all(zero)
        }
        Force::Stop { restitution: Some(restitution), .. } => *restitution == Value::Constant(1.0),
        Force::Stop { min, max, stiffness, damping, .. } => {
            [min, max].into_iter().flatten().all(constant) && constant(stiffness) && zero(damping)
        }
        // The moment of a bushing with several stiffnesses stores no energy that depends on the position alone.
        Force::Bushing { stiffness, damping, .. } => {
            stiffness[..3].iter().all(constant) && stiffness[3..].iter().all(zero) && damping.iter().all(zero)
        }
    };
    let elastic = blueprint.flexible.iter().all(|body| body.damping.iter().all(|entry| *entry == 0.0));
    elastic && blueprint.forces.iter().all(keeps)
}

fn zero(value: &Value<f64>) -> bool {
    *value == Value::Constant(0.0)
}

fn constant(value: &Value<f64>) -> bool {
    matches!(value, Value::Constant(_))
}
