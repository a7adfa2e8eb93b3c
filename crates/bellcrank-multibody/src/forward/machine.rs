//! The door, on a machine: from output to output, whatever the steps between.

use super::door::{Advance, Begun, Dynamics, Forward, Linearized, SolverEffort, Surroundings};
use super::flight::Flight;
use crate::solver::Machine;
use crate::{Coordinate, MechanismError};
use bellcrank_math::Space;

/// Steps after which the caller is asked whether to go on.
const PATIENCE: usize = 200;

impl<S: Space<T = f64>> Forward for Machine<S> {
    fn begin(&mut self, dynamics: &Dynamics, around: &mut dyn Surroundings) -> Result<Begun, MechanismError> {
        self.flight = None;
        self.prepared = None;
        let (flight, begun) = self.take_off(dynamics, around)?;
        self.flight = Some(Box::new(flight));
        Ok(begun)
    }

    fn advance(&mut self, until: f64, around: &mut dyn Surroundings) -> Result<Advance, MechanismError> {
        let Some(mut flight) = self.flight.take() else {
            return Err(MechanismError::NotFinite("a run that was not begun"));
        };
        let result = self.go_on_to(&mut flight, until, around);
        self.flight = Some(flight);
        result
    }

    fn solver_effort(&self) -> SolverEffort {
        self.flight.as_ref().map_or_else(SolverEffort::default, |f| f.effort)
    }

    fn linearize(
        &mut self,
        driven: &[Coordinate],
        around: &mut dyn Surroundings,
    ) -> Result<Linearized, MechanismError> {
        self.find_modes(driven, around)
    }

    fn show_mode(&mut self, mode: usize, phase: f64) {
        self.put_mode(mode, phase);
    }
}

impl<S: Space<T = f64>> Machine<S> {
    fn go_on_to(
        &mut self,
        f: &mut Flight<S>,
        until: f64,
        around: &mut dyn Surroundings,
    ) -> Result<Advance, MechanismError> {
        for _ in 0..PATIENCE {
            if let Some(event) = f.pending.pop() {
                self.show_end(f, around)?;
                return Ok(Advance::Event(event));
            }
            if until <= f.step.end {
                self.show(f, until, around)?;
                return Ok(Advance::Reached);
            }
            match f.step.crossing.take() {
                Some(k) => self.act_on(f, k, around)?,
                None => self.step_once(f, until, around)?,
            }
        }
        Ok(Advance::Working)
    }

    /// One step, not over the next break.
    fn step_once(
        &mut self,
        f: &mut Flight<S>,
        until: f64,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        let here = f.step.end;
        let ahead = |b: &&f64| **b > here + 1e-12 * here.abs().max(1e-3);
        let next_break = f.dynamics.breaks.iter().find(ahead).copied().unwrap_or(f64::INFINITY);
        // Steps run on beyond the output: what lies between is interpolated.
        let limit = if next_break.is_finite() { next_break } else { until + (until - here) + 1.0 };
        if f.step.implicit {
            self.step_implicitly(f, limit, around)?;
        } else {
            self.step_explicitly(f, limit, around)?;
        }
        self.find_crossing(f, around)?;
        if f.step.end >= next_break {
            f.step.stale = true;
        }
        Ok(())
    }

    /// The state at a time of the last step, on the constraints, with all that follows from it.
    fn show(&mut self, f: &mut Flight<S>, time: f64, around: &mut dyn Surroundings) -> Result<(), MechanismError> {
        if time >= f.step.end || f.step.end <= f.step.t0 {
            return self.show_end_at(f, time, around);
        }
        self.extend_step(f, around)?;
        f.step.interpolate(time);
        self.settle_at(f, time, around)
    }

    fn show_end(&mut self, f: &mut Flight<S>, around: &mut dyn Surroundings) -> Result<(), MechanismError> {
        self.show_end_at(f, f.step.end, around)
    }

    fn show_end_at(
        &mut self,
        f: &mut Flight<S>,
        time: f64,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        f.step.y.copy_from_slice(&f.step.y_end);
        self.settle_at(f, time, around)
    }

    /// `f.step.y` onto the constraints; accelerations and forces there.
    fn settle_at(&mut self, f: &mut Flight<S>, time: f64, around: &mut dyn Surroundings) -> Result<(), MechanismError> {
        self.load(f);
        self.time = time;
        if f.saddle.rows == 0 {
            self.accelerate(f, around)?;
        } else {
            self.accelerate_on_constraints(f, around)?;
        }
        self.answer_forces(f);
        self.note_unwrapped();
        Ok(())
    }
}
