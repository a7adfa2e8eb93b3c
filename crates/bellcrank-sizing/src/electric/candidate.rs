//! Electric drives against a duty.

use crate::electric::checks::Trial;
use crate::electric::{Conditions, Drive, Kind};
use crate::{Candidate, Check, Duty, Requirement, Selection, SizingError, Stroke};

/// A drive that was checked, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct DriveCandidate {
    /// The drive.
    pub drive: Drive,
    /// The stroke to order, where it has strokes.
    pub stroke: Option<Stroke>,
    /// What the duty asks at the motor shaft, gear and own inertia counted.
    pub at_shaft: Requirement,
    /// Root mean square of the effort at the shaft over the cycle, with the safety.
    pub rms_effort: f64,
    /// Its checks: RMS effort, peak effort, speed, rated power, peak power, stroke.
    pub checks: Vec<Check>,
}

impl Candidate for DriveCandidate {
    fn name(&self) -> &str {
        &self.drive.name
    }
    fn checks(&self) -> &[Check] {
        &self.checks
    }
    /// By power, then effort at the output, then stroke.
    fn size(&self) -> [f64; 3] {
        let power = self.drive.rated_power.unwrap_or(self.drive.rated_effort * self.drive.max_speed);
        let stroke = self.stroke.map_or(0.0, Stroke::length);
        [power, self.drive.rated_effort * self.drive.ratio(), stroke]
    }
}

/// One drive against a duty. Fails at a drive or conditions that cannot be.
pub fn evaluate(duty: &Duty, drive: &Drive, conditions: &Conditions) -> Result<DriveCandidate, SizingError> {
    conditions.validate()?;
    drive.validate()?;
    let travel = Requirement::of(duty).stroke;
    let shaft = drive.shaft_duty(duty)?;
    let at_shaft = Requirement::of(&shaft);
    let stroke = stroke(drive, travel + 2.0 * conditions.stroke_reserve);
    let trial = Trial { drive, conditions, duty: &shaft, requirement: &at_shaft, travel, stroke };
    Ok(DriveCandidate {
        drive: drive.clone(),
        stroke,
        at_shaft,
        rms_effort: trial.rms_effort(),
        checks: trial.checks(),
    })
}

/// All drives of a kind against a duty: those that pass first, smallest power first. Fails at a drive or conditions
/// that cannot be, and without any drive of this kind.
pub fn select(
    duty: &Duty,
    kind: Kind,
    drives: &[Drive],
    conditions: &Conditions,
) -> Result<Selection<DriveCandidate>, SizingError> {
    let of_kind: Vec<&Drive> = drives.iter().filter(|drive| drive.kind == kind).collect();
    if of_kind.is_empty() {
        return Err(SizingError::NoCandidates);
    }
    let judged: Result<Vec<_>, _> = of_kind.into_iter().map(|drive| evaluate(duty, drive, conditions)).collect();
    Ok(Selection::new(judged?))
}

fn stroke(drive: &Drive, needed: f64) -> Option<Stroke> {
    let any = !drive.strokes.is_empty() || drive.max_stroke.is_some();
    any.then(|| Stroke::of(&drive.strokes, drive.max_stroke, needed))
}
