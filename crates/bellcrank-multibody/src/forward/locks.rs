//! Stops that close and open, friction that sticks and slips: what an event does to the machine.
//!
//! A coordinate that is held joins the prescribed ones; its effort is the friction or the force of the stop. Impacts
//! change velocities by an impulse along the coordinate (Newton's restitution); other locks hold through it.

use super::door::{Event, EventKind, Surroundings};
use super::flight::{Flight, Lock};
use super::saddle::Saddle;
use super::watch::Watch;
use crate::forces::{Element, Present, read};
use crate::mechanism::Source;
use crate::solver::Machine;
use crate::{ForceId, MechanismError, kinematics};
use bellcrank_math::Space;

/// A hop shorter than this, s, is none: the stop stays closed.
const SHORTEST_HOP: f64 = 1e-8;

/// What a force element does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Act {
    /// Its law holds everywhere.
    Passive,
    /// A hard stop that is not touched.
    Open,
    /// A hard stop that is touched at its lower or upper limit.
    Closed { upper: bool },
    /// Friction of a coordinate that moves up or down.
    Slip { up: bool },
    /// Friction that holds.
    Stick,
}

impl<S: Space<T = f64>> Machine<S> {
    /// The system of what is driven and locked now.
    pub(crate) fn rebuild(&mut self, f: &mut Flight<S>) {
        let sources: Vec<Source> = f.driven.iter().copied().chain(f.locks.iter().map(|l| l.source)).collect();
        f.saddle = Saddle::new(&self.mech, &self.rows, &f.mass, &sources, f.redundant);
        let n = sources.len();
        for list in [&mut f.target, &mut f.velocity, &mut f.acceleration] {
            list.resize(n, 0.0);
        }
        f.gamma.resize(f.saddle.rows, 0.0);
        f.mu.resize(f.saddle.rows, 0.0);
        if self.lambda.len() < f.saddle.rows {
            self.lambda.resize(f.saddle.rows, 0.0);
        }
        self.grow_scratch(f.saddle.rows);
        self.update_positions();
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        f.mass.evaluate(&self.mech, &self.x);
        f.saddle.fill(&self.mech, &self.rows, &f.mass, &self.x);
        f.saddle.rescale();
        f.saddle.fill(&self.mech, &self.rows, &f.mass, &self.x);
        self.error_units(f);
        f.jacobian.forget();
        f.alpha.forget();
    }

    fn grow_scratch(&mut self, rows: usize) {
        for list in [&mut self.scratch.rhs, &mut self.scratch.product] {
            if list.len() < rows {
                list.resize(rows, 0.0);
            }
        }
    }

    /// What happens at the end of the last step, where function `k` changed its sign. Events are added to the pending
    /// ones, the last one first.
    pub(crate) fn act_on(
        &mut self,
        f: &mut Flight<S>,
        k: usize,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        f.step.y.copy_from_slice(&f.step.y_end);
        self.load(f);
        self.time = f.step.end;
        self.accelerate(f, around)?;
        self.answer_forces(f);
        self.note_unwrapped();
        self.watch_into(f, around);
        let beside = self.changed_beside(f, k);
        let mut happened = Vec::new();
        self.act_on_one(f, k, f.watching.rising, around, &mut happened)?;
        for (other, rising) in beside {
            self.act_on_one(f, other, rising, around, &mut happened)?;
        }
        self.settle_locks(f, around, &mut happened)?;
        self.begin_anew(f, around, &happened)
    }

    fn act_on_one(
        &mut self,
        f: &mut Flight<S>,
        k: usize,
        rising: bool,
        around: &mut dyn Surroundings,
        happened: &mut Vec<EventKind>,
    ) -> Result<(), MechanismError> {
        match f.watching.list[k] {
            Watch::User { index } => happened.push(EventKind::Switch { index, rising }),
            Watch::Limit { element, upper } if !self.is_hard(element) => {
                let force = ForceId(element);
                let release = EventKind::Release { force, upper };
                happened.push(if rising { release } else { EventKind::Contact { force, upper } });
            }
            Watch::Limit { element, upper } => {
                if f.acts[element] == (Act::Closed { upper }) {
                    self.unlock(f, element, Act::Open);
                    happened.push(EventKind::Release { force: ForceId(element), upper });
                } else {
                    self.hit(f, element, upper, around, happened)?;
                }
            }
            Watch::Slip { element } => self.slip_event(f, element, rising, around, happened)?,
        }
        Ok(())
    }

    /// After velocities or locks have changed: the state at the end of the step, and the events to tell.
    pub(crate) fn begin_anew(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
        happened: &[EventKind],
    ) -> Result<(), MechanismError> {
        let mut y = std::mem::take(&mut f.step.y_end);
        self.store(&mut y);
        f.step.y_end = y;
        f.step.stale = true;
        f.step.crossing = None;
        self.watch_into(f, around);
        f.watching.first.clone_from(&f.watching.last);
        self.limit_hop(f);
        let time = f.step.end;
        let storm = f.storm.count(time, happened.len());
        f.pending.extend(happened.iter().rev().map(|&kind| Event { time, kind }));
        if storm { Err(self.storm(f, happened)) } else { Ok(()) }
    }

    fn storm(&self, f: &Flight<S>, happened: &[EventKind]) -> MechanismError {
        let force = |kind: &EventKind| match *kind {
            EventKind::Impact { force, .. }
            | EventKind::Contact { force, .. }
            | EventKind::Release { force, .. }
            | EventKind::Stick { force }
            | EventKind::Slip { force, .. } => Some(force),
            EventKind::Switch { .. } => None,
        };
        MechanismError::EventStorm { time: f.step.end, forces: happened.iter().filter_map(force).collect() }
    }

    /// A body that hops off a stop comes back soon: the next step must not miss it.
    fn limit_hop(&mut self, f: &mut Flight<S>) {
        for (k, watch) in f.watching.list.iter().enumerate() {
            let Watch::Limit { element, upper } = *watch else { continue };
            if f.acts[element] != Act::Open || f.watching.last[k] > 1e3 * f.watching.slack[k] {
                continue;
            }
            let (rate, acceleration) = self.leaving(element, upper);
            if rate > 0.0 && acceleration < 0.0 {
                f.step.wished = f.step.wished.min(-rate / acceleration);
            }
        }
    }

    /// Speed and acceleration away from a limit.
    fn leaving(&self, element: usize, upper: bool) -> (f64, f64) {
        let Element::Stop { source, .. } = &self.mech.elements[element] else { return (0.0, 0.0) };
        let (rate, acceleration) = self.rates_of_source(*source);
        if upper { (-rate, -acceleration) } else { (rate, acceleration) }
    }

    fn rates_of_source(&self, source: Source) -> (f64, f64) {
        match source {
            Source::Node(n) => (self.v[self.mech.nodes[n].v], self.a[self.mech.nodes[n].v]),
            Source::Measured { link, measure } => {
                let link = &self.mech.links[link];
                let pose = link.pose(&self.x);
                link.measure_rates(measure, &pose, &link.motion(&self.x, &pose))
            }
        }
    }

    /// An impact at a hard stop: thrown back, or closed where the hop would be none.
    fn hit(
        &mut self,
        f: &mut Flight<S>,
        element: usize,
        upper: bool,
        around: &mut dyn Surroundings,
        happened: &mut Vec<EventKind>,
    ) -> Result<(), MechanismError> {
        let Element::Stop { source, restitution: Some(e), .. } = self.mech.elements[element].clone() else {
            return Ok(());
        };
        let force = ForceId(element);
        if !f.movable[element] {
            return Err(MechanismError::Blocked { force, time: self.time });
        }
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        let e = now.value(e).clamp(0.0, 1.0);
        let speed = -self.leaving(element, upper).0;
        let away = if upper { -1.0 } else { 1.0 };
        let mut impulse = self.push_to(f, source, away * e * speed.max(0.0))?;
        self.accelerate(f, around)?;
        self.answer_forces(f);
        let (rate, acceleration) = self.leaving(element, upper);
        let hops = acceleration >= 0.0 && rate > 0.0 || 2.0 * rate > -acceleration * SHORTEST_HOP;
        if !hops && acceleration < 0.0 {
            impulse += self.push_to(f, source, 0.0)?;
            self.lock(f, element, source, Act::Closed { upper });
        }
        if speed > 0.0 {
            happened.push(EventKind::Impact { force, upper, speed, impulse: impulse.abs() });
        }
        if !hops && acceleration < 0.0 {
            happened.push(EventKind::Contact { force, upper });
        }
        Ok(())
    }

    /// Changes velocities by an impulse along a coordinate so that its rate is `rate`; the impulse is returned.
    fn push_to(&mut self, f: &mut Flight<S>, source: Source, rate: f64) -> Result<f64, MechanismError> {
        let mut saddle = f.saddle.with_row(&self.mech, &self.rows, &f.mass, source);
        saddle.fill(&self.mech, &self.rows, &f.mass, &self.x);
        if !saddle.factor() {
            return Err(MechanismError::NotFinite("the impulse of a stop"));
        }
        f.effort.factorizations += 1;
        let row = saddle.rows - 1;
        let (mut gamma, mut mu) = (vec![0.0; saddle.rows], vec![0.0; saddle.rows]);
        gamma[row] = rate - read(&self.mech, &self.x, &self.q, &self.v, source).1;
        f.load.fill(0.0);
        self.scratch.delta.fill(0.0);
        saddle.solve(&f.load, &gamma, &mut self.scratch.delta, &mut mu);
        self.v.iter_mut().zip(&self.scratch.delta).for_each(|(v, d)| *v += d);
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        Ok(-mu[row])
    }

    /// Slip that comes to rest, or a hold that gives way.
    fn slip_event(
        &mut self,
        f: &mut Flight<S>,
        element: usize,
        rising: bool,
        around: &mut dyn Surroundings,
        happened: &mut Vec<EventKind>,
    ) -> Result<(), MechanismError> {
        let Element::Friction(law) = self.mech.elements[element].clone() else { return Ok(()) };
        let force = ForceId(element);
        let act = f.acts[element];
        match act {
            Act::Stick => self.give_way(f, element, happened),
            Act::Slip { up } if self.turns_round(f, element, law.source, !up, around) => {
                happened.push(EventKind::Slip { force, rising: !up });
            }
            Act::Slip { .. } => {
                self.push_to(f, law.source, 0.0)?;
                self.lock(f, element, law.source, Act::Stick);
                self.accelerate(f, around)?;
                self.answer_forces(f);
                if self.watch_margin(f, element) >= 0.0 {
                    happened.push(EventKind::Stick { force });
                } else {
                    self.give_way(f, element, happened);
                }
            }
            _ => happened.push(EventKind::Slip { force, rising }),
        }
        Ok(())
    }

    /// Does the coordinate go on the other way against the friction of that way? At a dead position of the machine it
    /// does, whatever would hold it. The friction slips that way then.
    fn turns_round(
        &mut self,
        f: &mut Flight<S>,
        element: usize,
        source: Source,
        up: bool,
        around: &mut dyn Surroundings,
    ) -> bool {
        let before = std::mem::replace(&mut f.acts[element], Act::Slip { up });
        let goes_on = self.accelerate(f, around).is_ok() && {
            self.answer_forces(f);
            let acceleration = self.rates_of_source(source).1;
            (acceleration > 0.0) == up && acceleration.abs() > 1e-9 * self.unit_of(source)
        };
        if !goes_on {
            f.acts[element] = before;
        }
        goes_on
    }

    fn watch_margin(&mut self, f: &Flight<S>, element: usize) -> f64 {
        let Element::Friction(law) = self.mech.elements[element].clone() else { return 0.0 };
        let normal = self.passes(&f.saddle.prescribed).normal_force(&law);
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        crate::forces::holding_effort(&now, &law, normal) - self.outputs[element].effort.abs()
    }

    /// The coordinate goes where the hold pushed against.
    fn give_way(&mut self, f: &mut Flight<S>, element: usize, happened: &mut Vec<EventKind>) {
        let up = self.outputs[element].effort < 0.0;
        self.unlock(f, element, Act::Slip { up });
        happened.push(EventKind::Slip { force: ForceId(element), rising: up });
    }

    fn lock(&mut self, f: &mut Flight<S>, element: usize, source: Source, act: Act) {
        let at = match act {
            Act::Closed { upper } => {
                let gap = self.gap(element, upper);
                self.place_of(source) + if upper { gap } else { -gap }
            }
            _ => self.place_of(source),
        };
        f.acts[element] = act;
        self.friction[element] = 0.0;
        if f.locks.iter().any(|l| l.source == source) {
            // It is held already.
            return;
        }
        f.locks.push(Lock { element, source, at });
        self.rebuild(f);
    }

    fn unlock(&mut self, f: &mut Flight<S>, element: usize, act: Act) {
        f.acts[element] = act;
        f.locks.retain(|l| l.element != element);
        self.rebuild(f);
    }

    /// Lets go, one after another, what cannot be held: friction beyond its limit, stops that would have to pull.
    pub(crate) fn settle_locks(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
        happened: &mut Vec<EventKind>,
    ) -> Result<(), MechanismError> {
        for _ in 0..=2 * self.mech.elements.len() {
            self.accelerate(f, around)?;
            self.answer_forces(f);
            let Some(element) = self.weakest_lock(f) else { return Ok(()) };
            match f.acts[element] {
                Act::Closed { upper } => {
                    self.unlock(f, element, Act::Open);
                    happened.push(EventKind::Release { force: ForceId(element), upper });
                }
                _ => self.give_way(f, element, happened),
            }
        }
        Ok(())
    }

    /// The lock that is overloaded most, by the part of its effort.
    fn weakest_lock(&mut self, f: &Flight<S>) -> Option<usize> {
        let mut worst = (None, -1e-9);
        for i in 0..f.locks.len() {
            let element = f.locks[i].element;
            let effort = self.outputs[element].effort;
            let margin = match f.acts[element] {
                Act::Closed { upper } => {
                    if upper {
                        -effort
                    } else {
                        effort
                    }
                }
                _ => self.watch_margin(f, element),
            };
            let relative = margin / effort.abs().max(1e-12);
            if relative < worst.1 {
                worst = (Some(element), relative);
            }
        }
        worst.0
    }

    /// At the start: friction that rests holds as long as it can, stops that are touched are closed.
    pub(crate) fn first_locks(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        self.accelerate(f, around)?;
        self.answer_forces(f);
        for element in 0..self.mech.elements.len() {
            match self.mech.elements[element].clone() {
                Element::Friction(law) if law.smoothing_velocity.is_none() && f.movable[element] => {
                    let rate = read(&self.mech, &self.x, &self.q, &self.v, law.source).1;
                    if rate.abs() <= 1e-11 * self.unit_of(law.source) {
                        self.push_to(f, law.source, 0.0)?;
                        self.lock(f, element, law.source, Act::Stick);
                    } else {
                        f.acts[element] = Act::Slip { up: rate > 0.0 };
                    }
                }
                Element::Stop { source, restitution: Some(_), .. } => {
                    f.acts[element] = Act::Open;
                    for upper in [false, true] {
                        let gap = self.gap(element, upper);
                        let slack = 1e-9 * self.unit_of(source);
                        if gap < -slack {
                            return Err(MechanismError::Blocked { force: ForceId(element), time: self.time });
                        }
                        if gap < slack && f.movable[element] && self.leaving(element, upper).0.abs() <= slack {
                            self.push_to(f, source, 0.0)?;
                            self.lock(f, element, source, Act::Closed { upper });
                        }
                    }
                }
                _ => {}
            }
        }
        let mut happened = Vec::new();
        self.settle_locks(f, around, &mut happened)
    }
}
