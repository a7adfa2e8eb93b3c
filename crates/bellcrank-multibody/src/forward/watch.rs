//! Functions of the state whose change of sign is an event, and where they change it.

use super::door::Surroundings;
use super::flight::Flight;
use super::locks::Act;
use crate::forces::{Element, Present, holding_effort, read};
use crate::mechanism::Source;
use crate::solver::Machine;
use crate::topology::Motion;
use crate::{MechanismError, kinematics};
use bellcrank_math::Space;

/// Where in a step the functions are looked at, beside its ends.
const SAMPLES: [f64; 4] = [0.25, 0.5, 0.75, 1.0];
/// Halvings that locate a change of sign: down to rounding.
const HALVINGS: usize = 60;

/// A function that is watched.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Watch {
    /// Distance from a limit of a stop; of a closed hard stop the force that it takes.
    Limit { element: usize, upper: bool },
    /// Slip of a friction in its direction; of one that sticks the effort that is left before it gives way.
    Slip { element: usize },
    /// One of the surroundings'.
    User { index: usize },
}

/// What is watched, and the values at the last looks.
#[derive(Clone, Debug, Default)]
pub(crate) struct Watching {
    pub(crate) list: Vec<Watch>,
    /// Changes below these do not count.
    pub(crate) slack: Vec<f64>,
    /// At the beginning of the interval at hand.
    pub(crate) first: Vec<f64>,
    pub(crate) last: Vec<f64>,
    /// The change that ended the last step went from below zero to above.
    pub(crate) rising: bool,
    user: Vec<f64>,
}

impl Watching {
    pub(crate) fn new(list: Vec<Watch>, slack: Vec<f64>, users: usize) -> Self {
        let n = list.len();
        Self { list, slack, first: vec![0.0; n], last: vec![0.0; n], rising: false, user: vec![0.0; users] }
    }
}

impl<S: Space<T = f64>> Machine<S> {
    /// Everything that is watched in this machine.
    pub(crate) fn watches(&self, users: usize) -> Watching {
        let mut list = Vec::new();
        let mut slack = Vec::new();
        for (element, e) in self.mech.elements.iter().enumerate() {
            match e {
                Element::Stop { source, min, max, .. } => {
                    for (upper, limit) in [(false, min), (true, max)] {
                        if limit.is_some() {
                            list.push(Watch::Limit { element, upper });
                            slack.push(1e-12 * self.unit_of(*source));
                        }
                    }
                }
                Element::Friction(f) if f.smoothing_velocity.is_none() => {
                    list.push(Watch::Slip { element });
                    slack.push(1e-11 * self.unit_of(f.source));
                }
                _ => {}
            }
        }
        list.extend((0..users).map(|index| Watch::User { index }));
        slack.resize(list.len(), 0.0);
        Watching::new(list, slack, users)
    }

    /// 1 rad, or the machine's size.
    pub(crate) fn unit_of(&self, source: Source) -> f64 {
        let turns = match source {
            Source::Node(n) => self.mech.nodes[n].motion != Motion::Slide,
            Source::Measured { measure, .. } => measure.is_angle(),
        };
        if turns { 1.0 } else { self.mech.size.max(1e-9) }
    }

    /// State at a time of the last step, with accelerations and forces where something watched needs them.
    fn look_at(&mut self, f: &mut Flight<S>, time: f64, around: &mut dyn Surroundings) -> Result<(), MechanismError> {
        f.step.interpolate(time);
        self.load(f);
        self.time = time;
        self.take_drives(f, around)?;
        // What is watched must be what the state will be: between the ends it lies off the constraints by the tolerance.
        let _ = self.project_positions(f);
        if self.watches_forces(f) {
            self.accelerate(f, around)?;
            self.answer_forces(f);
        } else {
            self.update_positions();
            kinematics::velocities(&self.mech, &self.v, &mut self.x);
        }
        Ok(())
    }

    fn watches_forces(&self, f: &Flight<S>) -> bool {
        !f.locks.is_empty() || f.dynamics.switches > 0
    }

    /// Values of all that is watched in the present state.
    pub(crate) fn watch_into(&mut self, f: &mut Flight<S>, around: &mut dyn Surroundings) {
        let mut watching = std::mem::take(&mut f.watching);
        if !watching.user.is_empty() {
            around.switches(self, &mut watching.user);
        }
        for (k, watch) in watching.list.iter().enumerate() {
            watching.last[k] = match *watch {
                Watch::Limit { element, upper } => self.limit_value(f, element, upper),
                Watch::Slip { element } => self.slip_value(f, element),
                Watch::User { index } => watching.user[index],
            };
        }
        f.watching = watching;
    }

    fn limit_value(&self, f: &Flight<S>, element: usize, upper: bool) -> f64 {
        if f.acts[element] == (Act::Closed { upper }) {
            let effort = self.outputs[element].effort;
            return if upper { -effort } else { effort };
        }
        self.gap(element, upper)
    }

    /// Distance of a stop's coordinate from one of its limits, positive inside.
    pub(crate) fn gap(&self, element: usize, upper: bool) -> f64 {
        let Element::Stop { source, min, max, .. } = &self.mech.elements[element] else { return f64::INFINITY };
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        let q = self.place_of(*source);
        match (upper, min, max) {
            (false, Some(min), _) => q - now.value(*min),
            (true, _, Some(max)) => now.value(*max) - q,
            _ => f64::INFINITY,
        }
    }

    /// Position of a coordinate; of measured angles with the turns they have made.
    pub(crate) fn place_of(&self, source: Source) -> f64 {
        let raw = read(&self.mech, &self.x, &self.q, &self.v, source).0;
        let Source::Measured { link, measure } = source else { return raw };
        let turned = self.measured_angles.iter().find(|m| m.2 == link && m.3 == measure);
        turned.map_or(raw, |&(j, i, ..)| {
            let last = self.unwrapped[j][i];
            last + crate::attitude::wrap(raw - last)
        })
    }

    fn slip_value(&mut self, f: &Flight<S>, element: usize) -> f64 {
        let Element::Friction(law) = self.mech.elements[element].clone() else { return 1.0 };
        let rate = read(&self.mech, &self.x, &self.q, &self.v, law.source).1;
        match f.acts[element] {
            Act::Slip { up } => {
                if up {
                    rate
                } else {
                    -rate
                }
            }
            Act::Stick => {
                let normal = self.passes(&f.saddle.prescribed).normal_force(&law);
                let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
                holding_effort(&now, &law, normal) - self.outputs[element].effort.abs()
            }
            _ => rate,
        }
    }

    /// Does a function fire between two looks?
    fn fires(&self, f: &Flight<S>, k: usize, a: f64, b: f64) -> bool {
        let slack = f.watching.slack[k];
        if self.falls_only(f, k) { a >= -slack && b < -slack } else { (a >= 0.0) != (b >= 0.0) }
    }

    /// Functions of both directions beside `k` that have changed their sign with it, and whether from below.
    pub(crate) fn changed_beside(&self, f: &Flight<S>, k: usize) -> Vec<(usize, bool)> {
        let Watching { first, last, .. } = &f.watching;
        let changed = |&j: &usize| j != k && !self.falls_only(f, j) && (first[j] >= 0.0) != (last[j] >= 0.0);
        (0..first.len()).filter(changed).map(|j| (j, first[j] < 0.0)).collect()
    }

    /// Only a fall through zero is an event.
    fn falls_only(&self, f: &Flight<S>, k: usize) -> bool {
        match f.watching.list[k] {
            Watch::Limit { element, .. } => self.is_hard(element),
            Watch::Slip { element } => matches!(f.acts[element], Act::Slip { .. } | Act::Stick),
            Watch::User { .. } => false,
        }
    }

    pub(crate) fn is_hard(&self, element: usize) -> bool {
        matches!(self.mech.elements[element], Element::Stop { restitution: Some(_), .. })
    }

    /// Looks for the first event in the last step, and lets the step end there.
    pub(crate) fn find_crossing(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        f.step.end_whole();
        if f.watching.list.is_empty() {
            return Ok(());
        }
        self.extend_step(f, around)?;
        let (t0, h) = (f.step.t0, f.step.t1 - f.step.t0);
        let mut from = t0;
        for sample in SAMPLES {
            let to = if sample == 1.0 { f.step.t1 } else { t0 + sample * h };
            self.look_at(f, to, around)?;
            self.watch_into(f, around);
            let changed: Vec<usize> = (0..f.watching.list.len())
                .filter(|&k| self.fires(f, k, f.watching.first[k], f.watching.last[k]))
                .collect();
            if !changed.is_empty() {
                return self.end_at_first(f, &changed, from, to, around);
            }
            let Watching { first, last, .. } = &mut f.watching;
            std::mem::swap(first, last);
            from = to;
        }
        Ok(())
    }

    /// The earliest of the changes between two times ends the step.
    fn end_at_first(
        &mut self,
        f: &mut Flight<S>,
        changed: &[usize],
        from: f64,
        to: f64,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        let first: Vec<f64> = f.watching.first.clone();
        let mut earliest = (to, changed[0]);
        for &k in changed {
            let at = self.locate(f, k, first[k], from, earliest.0, around)?;
            if at < earliest.0 || k == earliest.1 {
                earliest = (at, k);
            }
        }
        f.watching.rising = first[earliest.1] < 0.0;
        self.look_at(f, earliest.0, around)?;
        self.take_drives(f, around)?;
        if self.project_positions(f).is_some() {
            self.project_velocities(f, 2);
        }
        f.step.end = earliest.0;
        let mut y = std::mem::take(&mut f.step.y_end);
        self.store(&mut y);
        f.step.y_end = y;
        f.step.crossing = Some(earliest.1);
        f.step.stale = true;
        Ok(())
    }

    /// Time right after function `k`, of value `a` at `from`, has changed its sign before `to`.
    fn locate(
        &mut self,
        f: &mut Flight<S>,
        k: usize,
        a: f64,
        from: f64,
        to: f64,
        around: &mut dyn Surroundings,
    ) -> Result<f64, MechanismError> {
        let (mut low, mut high) = (from, to);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high || high - low <= 1e-15 * high.abs() {
                break;
            }
            self.look_at(f, middle, around)?;
            self.watch_into(f, around);
            if self.fires(f, k, a, f.watching.last[k]) { high = middle } else { low = middle }
        }
        Ok(high)
    }
}
