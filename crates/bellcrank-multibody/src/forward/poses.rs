//! Over poses where constraints fade, as in a stretched linkage.
//!
//! Off the constraints by e, the accelerations of index 1 make e grow like 1/t on the way to such a pose (`σ e = c₀ + c₁ t`
//! with σ ∝ t): slopes taken near it say nothing, steps with such slopes are rejected, and the more the smaller the
//! tolerance. So the pose is looked for, a step is taken that has it in the widest gap between its slopes, and the
//! slopes are taken on the constraints. (They are those of another equation with the same solutions, so the order stays.)

use super::door::Surroundings;
use super::flight::Flight;
use crate::MechanismError;
use crate::solver::Machine;
use bellcrank_math::Space;

/// Pivot ratios below this: constraints fade.
pub(crate) const FADING: f64 = 1e-4;
/// Below this they are near enough to such a pose for slopes on the constraints.
pub(crate) const NEAR: f64 = 1e-2;
/// Middle of the widest gap between slopes of the explicit method, 1/3 to 3/5 of a step.
pub(crate) const GAP: f64 = 0.4667;
/// A step over a pose may err by this (rad, machine sizes) where the tolerance asks for less: rounding grows there as
/// the inverse square of the distance, so no shorter step does better.
pub(crate) const ROUNDING: f64 = 1e-9;
/// A step that does not pass the pose keeps away from it by so much of the distance.
pub(crate) const SHORT_OF: f64 = 0.6;
/// Looks ahead, and refinements of the best.
const LOOKS: usize = 32;
const REFINEMENTS: usize = 30;

impl<S: Space<T = f64>> Machine<S> {
    /// Time from the beginning of the step to the pose ahead, s, where there is one within `horizon`; along the
    /// parabola of the beginning.
    pub(crate) fn time_to_pose(
        &mut self,
        f: &mut Flight<S>,
        horizon: f64,
        around: &mut dyn Surroundings,
    ) -> Result<Option<f64>, MechanismError> {
        let place = |k: usize| horizon * k as f64 / LOOKS as f64;
        let mut best = (0, self.ratio_ahead(f, 0.0, around)?);
        let begin = best.1;
        for k in 1..=LOOKS {
            let ratio = self.ratio_ahead(f, place(k), around)?;
            if ratio < best.1 {
                best = (k, ratio);
            }
        }
        if best.0 == 0 || best.0 == LOOKS || best.1 > 0.5 * begin {
            return Ok(None);
        }
        let (mut low, mut high) = (place(best.0 - 1), place(best.0 + 1));
        for _ in 0..REFINEMENTS {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if self.ratio_ahead(f, a, around)? < self.ratio_ahead(f, b, around)? { high = b } else { low = a }
        }
        Ok(Some(0.5 * (low + high)))
    }

    /// The argument of a slope onto the constraints; false where it does not get there.
    pub(crate) fn project_stage(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<bool, MechanismError> {
        self.take_drives(f, around)?;
        self.refactor(f)?;
        if self.project_positions(f).is_none() {
            return Ok(false);
        }
        self.project_velocities(f, 2);
        Ok(true)
    }

    /// Pivot ratio at a time after the beginning of the step.
    fn ratio_ahead(
        &mut self,
        f: &mut Flight<S>,
        ahead: f64,
        around: &mut dyn Surroundings,
    ) -> Result<f64, MechanismError> {
        let nq = self.mech.nq;
        self.q.copy_from_slice(&f.step.y0[..nq]);
        for i in 0..self.mech.nv {
            let (v, a) = (f.step.y0[nq + i], f.step.slope(0)[nq + i]);
            self.scratch.delta[i] = ahead * v + 0.5 * ahead * ahead * a;
        }
        self.step(1.0);
        self.time = f.step.t0 + ahead;
        self.take_drives(f, around)?;
        self.refactor(f)?;
        Ok(f.saddle.ratio)
    }
}
