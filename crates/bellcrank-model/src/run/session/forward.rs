//! A session whose machine is let go, or rung.

use bellcrank_multibody::{
    Advance, Begun, Blueprint, Coordinate, Dynamics, Linearized, MechanismError, MechanismError as E, Readings,
    SolverEffort,
};
use bellcrank_results::Failure;

use super::Session;
use crate::design::{ForceShape, Joint, Load, StopWhen};
use crate::run::End;
use crate::run::course::{Course, Laws, Targets};
use crate::run::inputs::Evaluated;
use crate::run::surroundings::{Around, Suspect};
use crate::signals::Signal;

/// An amplitude below this, against a largest one of 1, is none.
const ROUNDING: f64 = 1e-8;

impl<'d> Session<'d> {
    /// What the engine asks for while it steps.
    pub(in crate::run) fn surroundings(
        &self,
        laws: Laws<'d>,
        course: &Course<'d>,
        conditions: (&'d [StopWhen], &[Signal]),
    ) -> Around<'d> {
        let driven = course.actuation.position.clone();
        Around::new(self.design, self.study, self.built.geometry.clone(), (laws, driven), conditions)
    }

    pub(in crate::run) fn blueprint(&self) -> &Blueprint<f64> {
        &self.built.blueprint
    }

    pub(in crate::run) fn readings(&self) -> &dyn Readings<f64> {
        &*self.engine
    }

    /// Bends flexible bodies by what they carry at time 0, where the drives say how everything moves; else they stay
    /// as they are.
    pub(in crate::run) fn settle_at_start(&mut self, course: &Course<'d>, laws: &Laws<'d>) {
        if self.built.flexible.is_empty() || self.engine.prepare(&course.actuation).is_err() {
            return;
        }
        let mut at = Targets::default();
        laws.prescribe(0.0, &mut at);
        let of = Evaluated { design: self.design, values: &self.study.values, geometry: &self.built.geometry };
        let inputs = &mut self.inputs;
        let moved = self.engine.move_to(0.0, &at.position).is_ok();
        let settled = moved
            && self.engine.set_rates(&at.velocity, &at.acceleration).is_ok()
            && self.engine.solve_forces(&mut |at, values| inputs.evaluate(at, of, values)).is_ok();
        if !settled {
            let message = "the flexible bodies begin as they are: nothing bends them so that they carry their loads";
            self.result.warnings.push(message.to_owned());
        }
    }

    /// Consistent velocities, accelerations and forces at time 0.
    pub(in crate::run) fn let_go(&mut self, dynamics: &Dynamics, around: &mut Around<'d>) -> Result<Begun, End> {
        let begun = self.engine.begin(dynamics, around);
        begun.map_err(|error| self.blamed(&error, 0.0, around))
    }

    /// On to a time, or to the next event before it.
    pub(in crate::run) fn advance(&mut self, until: f64, around: &mut Around<'d>) -> Result<Advance, End> {
        let advance = self.engine.advance(until, around);
        advance.map_err(|error| self.blamed(&error, self.engine.time(), around))
    }

    /// Natural frequencies about the present position.
    pub(in crate::run) fn linearize(
        &mut self,
        driven: &[Coordinate],
        around: &mut Around<'d>,
    ) -> Result<Linearized, End> {
        // Nothing can move: there is nothing to linearize.
        let freedom = self.engine.freedom();
        if freedom.degrees + freedom.shapes <= driven.len() {
            return Ok(Linearized::default());
        }
        let found = self.engine.linearize(driven, around);
        found.map_err(|error| self.blamed(&error, 0.0, around))
    }

    /// Amplitudes of some coordinates in a mode: real and imaginary parts.
    pub(in crate::run) fn shape(&mut self, mode: usize, of: &[Coordinate]) -> Vec<[f64; 2]> {
        let mut at = |phase: f64| -> Vec<f64> {
            self.engine.show_mode(mode, phase);
            of.iter().map(|&c| self.engine.coordinate(c).velocity).collect()
        };
        // Of φ e^(iωt) the real part is seen: a quarter later the imaginary one, downwards. The largest is 1.
        let (real, imaginary) = (at(0.0), at(std::f64::consts::FRAC_PI_2));
        let clean = |x: f64| if x.abs() < ROUNDING { 0.0 } else { x };
        real.into_iter().zip(imaginary).map(|(re, im)| [clean(re), clean(-im)]).collect()
    }

    /// Adds the present state, all of it known, to the rows.
    pub(in crate::run) fn record_all(&mut self) {
        self.record(crate::signals::Level::Force);
    }

    /// Tells the work of the integration in place of that of a walk through positions.
    pub(in crate::run) fn tell_effort(&mut self) {
        let of: SolverEffort = self.engine.solver_effort();
        let count = |name: &str, value: usize| (name.to_owned(), value as f64);
        self.result.effort = vec![
            count("steps", of.steps),
            count("implicit_steps", of.implicit_steps),
            count("rejected", of.rejected),
            count("evaluations", of.evaluations),
            count("newton_iterations", of.newton_iterations),
            count("jacobians", of.jacobians),
            count("factorizations", of.factorizations),
            count("projections", of.projections),
            count("assembly_iterations", self.effort.iterations),
            count("assembly_restarts", self.effort.restarts),
        ];
    }

    /// Steps accepted and rejected so far.
    pub(in crate::run) fn steps(&self) -> usize {
        let of = self.engine.solver_effort();
        of.steps + of.rejected
    }

    /// The failure of steps that have become too small to come on.
    pub(in crate::run) fn stalled(&self, step: f64, around: &Around<'d>) -> End {
        let time = self.engine.time();
        let design = self.design;
        let of = |(joint, of): (usize, &Joint)| {
            let joint = bellcrank_multibody::JointId(joint);
            (0..of.coordinates(design.planar).len()).map(move |index| Coordinate { joint, index })
        };
        let all = design.joints.iter().enumerate().flat_map(of);
        let change = |c: &Coordinate| self.engine.coordinate(*c).acceleration.abs();
        let fastest = all.max_by(|a, b| change(a).total_cmp(&change(b)));
        let coordinate = fastest.unwrap_or(Coordinate { joint: bellcrank_multibody::JointId(0), index: 0 });
        self.blamed(&MechanismError::StepCollapse { time, step, coordinate }, time, around)
    }

    /// The failure of a step, with the force value it is due to where one is known.
    fn blamed(&self, error: &MechanismError, time: f64, around: &Around<'d>) -> End {
        let tells_time = matches!(error, E::StepCollapse { .. } | E::EventStorm { .. } | E::Blocked { .. });
        let place = if tells_time || time == 0.0 { String::new() } else { self.namer().time(time) };
        let failure = self.failed(error, &place);
        let numeric = matches!(error, E::StepCollapse { .. } | E::NotFinite(_));
        let Some(suspect) = around.suspect(time).filter(|_| numeric) else { return failure };
        self.force_failed(suspect).map_or(failure, Box::new)
    }

    fn force_failed(&self, suspect: Suspect) -> Option<Failure> {
        let Suspect { input, value, time } = suspect;
        let expression = &self.design.inputs.get(input)?.expression;
        let uses = |shape: &ForceShape| {
            let mut uses = false;
            shape.each_load(&mut |load| uses |= matches!(load, Load::Input(index) if *index == input));
            uses
        };
        let force = self.design.forces.iter().find(|force| uses(&force.shape))?;
        let written = expression.written().trim();
        let what = match value.is_finite() {
            true => format!("grows without bound: `{written}`"),
            false => format!("is not finite: `{written}` gives {value}"),
        };
        let (study, time) = (&self.study.name, self.namer().time(time));
        Some(Failure {
            message: format!("study `{study}`, {time}: force `{}` {what}", force.name),
            hints: vec!["look for a division by zero, a root of a negative number, a power that grows".to_owned()],
        })
    }
}
