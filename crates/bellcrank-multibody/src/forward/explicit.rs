//! Steps of the explicit method of order 8, with projection on the constraints at their ends.
//!
//! The slopes solve the constraints for accelerations only; what drifts off within a step is brought back at its end,
//! which leaves the order (Hairer, Lubich & Wanner, Geometric Numerical Integration, §IV.4).

use super::door::{Method, Surroundings};
use super::dop853::{ERROR_3, ERROR_5, NODES, SLOPES, SOLUTION, STAGE, STAGES};
use super::flight::Flight;
use super::poses::{FADING, GAP, NEAR, ROUNDING, SHORT_OF};
use super::state::{error_norm, worst_number};
use super::step::Between;
use crate::solver::Machine;
use crate::{Coordinate, JointId, MechanismError};
use bellcrank_math::Space;

/// Steps below this part of the time passed (or of a second) have collapsed.
const SMALLEST: f64 = 1e-13;
/// A step's projection may move a state by this many tolerances; more means another branch may be near.
const LARGEST_PROJECTION: f64 = 100.0;
/// Length of the stable part of the negative real axis (Hairer & Wanner II, §IV.2: 6.1 for this method).
const STABLE: f64 = 6.1;
/// Part of the tolerance that one step may use up: errors of many steps add up.
pub(crate) const SHARE: f64 = 0.1;
/// Signs of stiffness in a row that are believed.
const STIFF: usize = 15;

/// What is known of a pose ahead where constraints fade.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Pose {
    Unknown,
    /// So far ahead, s; the step is to pass it.
    Over(f64),
    /// So far ahead, s; the step is to end before it.
    Before(f64),
}

/// How a trial of a step ended.
enum Trial {
    Accepted {
        error: f64,
    },
    /// Try a part of it.
    Rejected {
        part: f64,
    },
}

impl<S: Space<T = f64>> Machine<S> {
    /// One step from the end of the last one, not beyond `limit`.
    pub(crate) fn step_explicitly(
        &mut self,
        f: &mut Flight<S>,
        limit: f64,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        f.step.go_on();
        self.freshen(f, around)?;
        if f.step.wished <= 0.0 {
            f.step.wished = self.first_length(f, limit, around)?;
        }
        let mut pose = Pose::Unknown;
        loop {
            let (h, wished) = self.choose_explicit(f, limit, pose);
            f.step.over = matches!(pose, Pose::Over(_));
            match self.try_explicit(f, h, around)? {
                Trial::Accepted { error } => {
                    f.effort.steps += 1;
                    f.step.projects = f.saddle.weakest < NEAR;
                    let factor = if error > 0.0 { (0.9 * error.powf(-0.125)).clamp(0.333, 6.0) } else { 6.0 };
                    // A step cut short by a limit says nothing against the length wished before.
                    f.step.wished = if h < wished { f.step.wished.max(h * factor) } else { h * factor };
                    self.watch_stiffness(f, h);
                    return Ok(());
                }
                Trial::Rejected { part } => {
                    f.effort.rejected += 1;
                    f.step.wished = h * part;
                    let fixed = f.dynamics.fixed_step.is_some();
                    if f.step.wished < SMALLEST * f.step.t0.abs().max(1e-3) || fixed {
                        return Err(self.collapsed(f, h * part));
                    }
                    pose = self.after_rejection(f, pose, h, around)?;
                }
            }
        }
    }

    /// Length of the next trial, and the length wished without limits.
    fn choose_explicit(&self, f: &mut Flight<S>, limit: f64, pose: Pose) -> (f64, f64) {
        let fixed = f.dynamics.fixed_step;
        let wished = match pose {
            Pose::Over(d) => d / GAP,
            Pose::Before(d) => f.step.wished.min(SHORT_OF * d),
            Pose::Unknown => fixed.unwrap_or(f.step.wished),
        };
        let wished = wished.min(f.dynamics.largest_step);
        let left = limit - f.step.t0;
        // The last step before a limit is not a sliver.
        let h = if wished >= left * 0.999 {
            left
        } else if fixed.is_none() && wished > 0.5 * left && pose == Pose::Unknown {
            0.5 * left
        } else {
            wished
        };
        f.step.t1 = if h == left { limit } else { f.step.t0 + h };
        (h, wished)
    }

    /// Where slopes near a pose of fading constraints spoiled the step, the next one is to pass it or keep away.
    fn after_rejection(
        &mut self,
        f: &mut Flight<S>,
        pose: Pose,
        h: f64,
        around: &mut dyn Surroundings,
    ) -> Result<Pose, MechanismError> {
        f.step.projects |= f.saddle.weakest < FADING;
        match pose {
            Pose::Over(d) => Ok(Pose::Before(d)),
            Pose::Before(_) => Ok(pose),
            Pose::Unknown if f.saddle.weakest < FADING => {
                let ahead = self.time_to_pose(f, 2.0 * h, around)?;
                Ok(ahead.map_or(pose, |d| if d / GAP <= 2.0 * h { Pose::Over(d) } else { Pose::Before(d) }))
            }
            Pose::Unknown => Ok(pose),
        }
    }

    /// The slope at the beginning where events or breaks made it stale.
    pub(crate) fn freshen(&mut self, f: &mut Flight<S>, around: &mut dyn Surroundings) -> Result<(), MechanismError> {
        if f.step.stale {
            f.step.y.copy_from_slice(&f.step.y0);
            self.load(f);
            self.time = after(f.step.t0);
            self.accelerate(f, around)?;
            self.slope_into(f.step.slope_mut(0));
            f.step.stale = false;
        }
        Ok(())
    }

    fn try_explicit(
        &mut self,
        f: &mut Flight<S>,
        h: f64,
        around: &mut dyn Surroundings,
    ) -> Result<Trial, MechanismError> {
        f.saddle.watch_weakness();
        for s in 1..STAGES {
            f.step.combine(h, STAGE[s]);
            if s == STAGES - 1 {
                f.step.last_argument.clone_from_slice(&f.step.y);
            }
            if !self.slope_at(f, NODES[s], h, s, around)? {
                return Ok(Trial::Rejected { part: 0.25 });
            }
        }
        f.step.combine(h, SOLUTION);
        f.step.raw.copy_from_slice(&f.step.y);
        let error = if f.dynamics.fixed_step.is_some() { 0.0 } else { self.explicit_error(f, h) };
        let allowed = if f.step.over { (ROUNDING / (SHARE * f.dynamics.tolerance)).max(1.0) } else { 1.0 };
        if error.is_nan() || error > allowed {
            let part = if error.is_finite() { (0.9 * error.powf(-0.125)).max(0.2) } else { 0.1 };
            return Ok(Trial::Rejected { part });
        }
        self.land(f, around)
            .map(|landed| if landed { Trial::Accepted { error } } else { Trial::Rejected { part: 0.25 } })
    }

    /// Slope number `s` at `f.step.y`; false where there is none, so that a shorter step is tried.
    fn slope_at(
        &mut self,
        f: &mut Flight<S>,
        node: f64,
        h: f64,
        s: usize,
        around: &mut dyn Surroundings,
    ) -> Result<bool, MechanismError> {
        self.load(f);
        self.time = if node == 1.0 { before(f.step.t1) } else { f.step.t0 + node * h };
        if node == 0.0 {
            self.time = after(f.step.t0);
        }
        if f.step.projects && !self.project_stage(f, around)? {
            return Ok(false);
        }
        match self.accelerate(f, around) {
            Err(error) if h <= 1e-9 * f.step.t0.abs().max(1e-3) => return Err(error),
            Err(_) => return Ok(false),
            Ok(()) => {}
        }
        self.slope_into(f.step.slope_mut(s));
        Ok(f.step.slope(s).iter().all(|x| x.is_finite()))
    }

    /// Both error estimates together, in tolerances.
    fn explicit_error(&self, f: &Flight<S>, h: f64) -> f64 {
        let (step, tolerance) = (&f.step, SHARE * f.dynamics.tolerance);
        let n = step.y0.len();
        let norm = |row: super::dop853::Row| {
            // The slope at the end does not enter: its weights are zero.
            let sum = |i: usize| row.iter().map(|&(s, c)| c * step.slopes[s * n + i]).sum::<f64>();
            error_norm((0..n).map(sum), &step.unit, [&step.y0, &step.raw], self.mech.nq, tolerance)
        };
        let (five, three) = (norm(ERROR_5), norm(ERROR_3));
        let both = five * five + 0.01 * three * three;
        if both > 0.0 { h * five * five / both.sqrt() } else { five }
    }

    /// Takes the end of a step: projection, and the slope there. False where it lies too far from the constraints.
    pub(crate) fn land(&mut self, f: &mut Flight<S>, around: &mut dyn Surroundings) -> Result<bool, MechanismError> {
        self.load(f);
        self.time = before(f.step.t1);
        self.take_drives(f, around)?;
        let Some(moved) = self.project_positions(f) else { return Ok(false) };
        let allowed = LARGEST_PROJECTION * f.dynamics.tolerance * self.mech.size.max(1.0);
        if f.dynamics.fixed_step.is_none() && moved > allowed {
            return Ok(false);
        }
        self.project_velocities(f, 2);
        if self.accelerate(f, around).is_err() {
            return Ok(false);
        }
        self.store(&mut f.step.y1);
        self.slope_into(f.step.slope_mut(STAGES));
        f.step.between = Between::Extension { ready: false };
        self.note_unwrapped();
        Ok(f.step.slope(STAGES).iter().all(|x| x.is_finite()))
    }

    /// Slopes of the continuous extension of the last step.
    pub(crate) fn extend_step(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        if f.step.between != (Between::Extension { ready: false }) {
            return Ok(());
        }
        let h = f.step.t1 - f.step.t0;
        for s in STAGES + 1..SLOPES {
            f.step.combine(h, STAGE[s]);
            if !self.slope_at(f, NODES[s], h, s, around)? {
                f.step.between = Between::Hermite;
                return Ok(());
            }
        }
        f.step.extend();
        Ok(())
    }

    /// Length of the first step (Hairer, Nørsett & Wanner I, §II.4).
    pub(crate) fn first_length(
        &mut self,
        f: &mut Flight<S>,
        limit: f64,
        around: &mut dyn Surroundings,
    ) -> Result<f64, MechanismError> {
        let n = f.step.y0.len();
        let norm = |values: &mut dyn Iterator<Item = f64>, f: &Flight<S>, nq: usize| {
            error_norm(values, &f.step.unit, [&f.step.y0, &f.step.y0], nq, 1.0)
        };
        let nq = self.mech.nq;
        let speed = norm(&mut (0..n).map(|i| f.step.slopes[i]), f, nq);
        let most = (limit - f.step.t0).min(f.dynamics.largest_step);
        let trial = if speed > 1e-10 { (1e-3 / speed).min(most) } else { (1e-3_f64).min(most) };
        f.step.combine(trial, &[(0, 1.0)]);
        f.step.t1 = f.step.t0 + trial;
        self.load(f);
        self.time = f.step.t0 + trial;
        if self.accelerate(f, around).is_err() {
            return Ok(1e-3 * trial);
        }
        self.slope_into(f.step.slope_mut(1));
        let bend = norm(&mut (0..n).map(|i| (f.step.slopes[n + i] - f.step.slopes[i]) / trial), f, nq);
        let steep = speed.max(bend.sqrt()).max(bend);
        let length = if steep > 1e-12 { (0.01 / steep).powf(0.5).min(1.0 / steep.sqrt()) } else { most };
        Ok(length.min(100.0 * trial).min(most).max(1e-9))
    }

    /// Believes in stiffness when the steps are held down by stability many times in a row.
    fn watch_stiffness(&mut self, f: &mut Flight<S>, h: f64) {
        if f.dynamics.method != Method::Automatic {
            return;
        }
        let step = &mut f.step;
        let n = step.y0.len();
        let (mut slopes, mut arguments) = (0.0, 0.0);
        for i in 0..n {
            let dk = step.slopes[STAGES * n + i] - step.slopes[(STAGES - 1) * n + i];
            let dy = step.y1[i] - step.last_argument[i];
            slopes += dk * dk;
            arguments += dy * dy;
        }
        let stretched = if arguments > 0.0 { h * (slopes / arguments).sqrt() } else { 0.0 };
        if stretched > STABLE {
            step.calm = 0;
            step.stiff += 1;
        } else {
            step.calm += 1;
            if step.calm >= 6 {
                step.stiff = 0;
            }
        }
        if step.stiff >= STIFF {
            step.implicit = true;
        }
    }

    pub(crate) fn collapsed(&self, f: &Flight<S>, h: f64) -> MechanismError {
        let n = f.step.y0.len();
        let change = (0..n).map(|i| f.step.slopes[(STAGES - 1) * n + i] - f.step.slopes[i]);
        let worst = worst_number(change, &f.step.unit);
        MechanismError::StepCollapse { time: f.step.t0, step: h, coordinate: self.coordinate_of_number(worst) }
    }

    /// A coordinate that shows number `i` of y.
    fn coordinate_of_number(&self, i: usize) -> Coordinate {
        let nq = self.mech.nq;
        let of = |n: &&crate::mechanism::Node<S>| {
            let (q, v) = (n.q..n.q + n.motion.numbers(), nq + n.v..nq + n.v + n.motion.dofs());
            q.contains(&i) || v.contains(&i)
        };
        let joint = self.mech.nodes.iter().find(of).and_then(|n| n.joint).unwrap_or(JointId(0));
        let node = self.mech.nodes.iter().position(|n| of(&n));
        let index =
            self.mech.sources.get(joint.0).and_then(|s| {
                s.iter().position(|s| matches!(s, crate::mechanism::Source::Node(n) if Some(*n) == node))
            });
        Coordinate { joint, index: index.unwrap_or(0) }
    }
}

/// Just after a time: drives that break there show what comes.
pub(crate) fn after(t: f64) -> f64 {
    t + 1e-13 * t.abs().max(1e-2)
}

/// Just before a time.
pub(crate) fn before(t: f64) -> f64 {
    t - 1e-13 * t.abs().max(1e-2)
}
