//! Cylinders against a duty.

use crate::pneumatic::checks::Trial;
use crate::pneumatic::force::{pull, push, working_pressures};
use crate::pneumatic::{Conditions, Cylinder, WorkingPressure, air, force};
use crate::{Candidate, Check, Duty, Requirement, Selection, SizingError, Stroke};

/// Free air a cylinder takes, with its full stroke: what the duty leaves unused is dead volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Air {
    /// Of one double stroke, m³ ANR.
    pub per_double_stroke: f64,
    /// On average, m³/s ANR; `None` without a cycle rate.
    pub mean_flow: Option<f64>,
    /// While the full piston moves at the largest speed under supply pressure, m³/s ANR; 0 in a duty without speed.
    pub peak_flow: f64,
}

/// A cylinder that was checked, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct CylinderCandidate {
    /// The cylinder.
    pub cylinder: Cylinder,
    /// The stroke to order.
    pub stroke: Stroke,
    /// Theoretical push at supply pressure, N.
    pub push: f64,
    /// Theoretical pull at supply pressure, N.
    pub pull: f64,
    /// Largest gauge pressure that the duty needs, Pa.
    pub working_pressure: f64,
    /// Smallest gauge pressure of the supply at which the forces suffice, Pa: working pressure / load factor.
    pub needed_supply: f64,
    /// Length of the buckling column, m.
    pub column: f64,
    /// Euler's load of it, N.
    pub critical_load: f64,
    /// Free air it takes.
    pub air: Air,
    /// Its checks: push, pull, stroke, buckling, pressure, speed, cushion, valve.
    pub checks: Vec<Check>,
}

impl CylinderCandidate {
    /// The working pressure over the stroke, one value a row of the duty.
    pub fn working_pressures(&self, duty: &Duty, efficiency: f64) -> Vec<WorkingPressure> {
        working_pressures(duty, self.cylinder.bore, self.cylinder.rod, efficiency)
    }
}

impl Candidate for CylinderCandidate {
    fn name(&self) -> &str {
        &self.cylinder.name
    }
    fn checks(&self) -> &[Check] {
        &self.checks
    }
    fn size(&self) -> [f64; 3] {
        [self.cylinder.bore, self.cylinder.rod, self.stroke.length()]
    }
}

/// One cylinder against a duty. Fails at a cylinder or conditions that cannot be.
pub fn evaluate(duty: &Duty, cylinder: &Cylinder, conditions: &Conditions) -> Result<CylinderCandidate, SizingError> {
    conditions.validate()?;
    judge(duty, &Requirement::of(duty), cylinder, conditions)
}

/// All cylinders against a duty: those that pass first, smallest bore first. Fails at a cylinder or conditions that
/// cannot be, and without any cylinder.
pub fn select(
    duty: &Duty,
    cylinders: &[Cylinder],
    conditions: &Conditions,
) -> Result<Selection<CylinderCandidate>, SizingError> {
    if cylinders.is_empty() {
        return Err(SizingError::NoCandidates);
    }
    conditions.validate()?;
    let requirement = Requirement::of(duty);
    let judged: Result<Vec<_>, _> = cylinders.iter().map(|c| judge(duty, &requirement, c, conditions)).collect();
    Ok(Selection::new(judged?))
}

fn judge(
    duty: &Duty,
    requirement: &Requirement,
    cylinder: &Cylinder,
    conditions: &Conditions,
) -> Result<CylinderCandidate, SizingError> {
    cylinder.validate()?;
    let Cylinder { bore, rod, .. } = *cylinder;
    let stroke =
        Stroke::of(&cylinder.strokes, cylinder.max_stroke, requirement.stroke + 2.0 * conditions.stroke_reserve);
    let trial = Trial { cylinder, conditions, duty, requirement, stroke };
    let pressures = working_pressures(duty, bore, rod, conditions.efficiency);
    let working_pressure = pressures.iter().map(|row| row.pressure).fold(0.0, f64::max);
    Ok(CylinderCandidate {
        cylinder: cylinder.clone(),
        stroke,
        push: push(bore, conditions.supply.pressure),
        pull: pull(bore, rod, conditions.supply.pressure),
        working_pressure,
        needed_supply: working_pressure / conditions.load_factor,
        column: trial.column(),
        critical_load: trial.critical_load(),
        air: consumption(cylinder, stroke.length(), conditions, requirement.speed.value),
        checks: trial.checks(),
    })
}

fn consumption(cylinder: &Cylinder, stroke: f64, conditions: &Conditions, speed: f64) -> Air {
    let Cylinder { bore, rod, .. } = *cylinder;
    let Conditions { supply, dead_volume, cycle_rate, .. } = *conditions;
    let per_double_stroke = air::per_double_stroke(bore, rod, stroke, supply.pressure, supply.atmosphere, dead_volume);
    Air {
        per_double_stroke,
        mean_flow: cycle_rate.map(|rate| rate * per_double_stroke),
        peak_flow: air::filling_flow(force::piston_area(bore), speed, supply.absolute()),
    }
}
