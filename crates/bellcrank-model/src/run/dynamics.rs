//! Motion from forces: from row to row and from event to event. Flexible bodies of a machine whose drives take all
//! other freedom begin bent by what they carry; others begin undeformed.

use bellcrank_multibody::{Advance, Coordinate, Dynamics as LetGo, Event, EventKind, Method};
use bellcrank_results::{Ended, Events};

use super::course::{Course, Laws, Path};
use super::session::Session;
use super::surroundings::Around;
use super::{End, energy, events, explain, motion};
use crate::design::{Dynamics, Quantity, Stepping};
use crate::measure::Measure;
use crate::progress::Progress;

/// Spectral radius unless given: steps that are not resolved are damped, the others hardly.
const SPECTRAL_RADIUS: f64 = 0.8;
const TOLERANCE: f64 = 1e-6;
/// Part of a step from row to row within which two times are one.
const NEAR: f64 = 1e-6;

pub(super) fn run<'d>(session: &mut Session<'d>, of: &'d Dynamics, progress: &mut dyn Progress) -> Result<(), End> {
    progress.at(0.0, "assembling");
    let course = session.begin(Path::Free(of), &of.holds, &of.motions)?;
    session.carry(course.actuation.effort.clone());
    session.expect_rows(course.rows, true)?;
    session.result.axis = vec![session.axis_name()];
    let unit = session.design.units.of(Measure::Time);
    session.result.events = Some(Events::none(unit));
    let laws: Laws<'_> = session.laws(&course);
    let duration = laws.axis(course.rows.saturating_sub(1) as f64);
    if let Some(programme) = laws.programme() {
        motion::tell_of_motions(session, programme, duration);
    }
    // No step passes over the end either, nor over what comes behind it.
    let mut breaks = laws.breaks();
    breaks.retain(|time| *time > 0.0 && *time < duration);
    breaks.push(duration);
    let plan = plan(session, of, &course, breaks);
    session.settle_at_start(&course, &laws);
    let around = session.surroundings(laws, &course, (&of.stop_when, &of.signals));
    let mut walk = Walk { session, of, around, rows: course.rows, duration, pace: Pace::default(), progress };
    let outcome = walk.all(&plan);
    session.tell_effort();
    if of.motions.is_empty() && energy::conserves(session.blueprint()) {
        let drift = energy::drift(session.recorded("energy.total"));
        let joule = session.design.units.of(Measure::Energy);
        session.result.scalars.extend(drift.map(|drift| ("energy.drift".to_owned(), drift, joule)));
    }
    outcome
}

/// How the machine is let go.
fn plan(session: &Session<'_>, of: &Dynamics, course: &Course<'_>, breaks: Vec<f64>) -> LetGo {
    let values = &session.study.values;
    let number = |quantity: &Option<Quantity>, otherwise: f64| {
        quantity.as_ref().map_or(otherwise, |quantity| quantity.eval(values))
    };
    let driven = course.actuation.position.clone();
    LetGo {
        velocities: velocities(session, &driven),
        driven,
        tolerance: number(&of.tolerance, TOLERANCE),
        method: match of.method {
            Stepping::Automatic => Method::Automatic,
            Stepping::Explicit => Method::Explicit,
            Stepping::GeneralizedAlpha => {
                Method::GeneralizedAlpha { spectral_radius: number(&of.spectral_radius, SPECTRAL_RADIUS) }
            }
        },
        fixed_step: of.step.as_ref().map(|step| step.eval(values)),
        largest_step: number(&of.largest_step, f64::INFINITY),
        breaks,
        switches: of.stop_when.len(),
    }
}

/// Those that the file gives, of coordinates that nothing drives.
fn velocities(session: &Session<'_>, driven: &[Coordinate]) -> Vec<(Coordinate, f64)> {
    let mut found = Vec::new();
    for (joint, of) in session.design.joints.iter().enumerate() {
        for (index, given) in of.start_velocity.iter().enumerate() {
            let c = Coordinate { joint: bellcrank_multibody::JointId(joint), index };
            let value = given.as_ref().map(|given| given.eval(&session.study.values));
            found.extend(value.filter(|_| !driven.contains(&c)).map(|value| (c, value)));
        }
    }
    found
}

/// The machine on its way.
struct Walk<'s, 'd> {
    session: &'s mut Session<'d>,
    of: &'d Dynamics,
    around: Around<'d>,
    rows: usize,
    duration: f64,
    pace: Pace,
    progress: &'s mut dyn Progress,
}

/// How fast it comes on between rows.
#[derive(Default)]
struct Pace {
    /// Steps and time when it was looked at last.
    steps: usize,
    time: f64,
}

/// Steps over which the pace is judged.
const JUDGED: usize = 5000;
/// A study that would take more steps than this does not come to an end.
const ENDLESS: f64 = 1e11;

impl Pace {
    /// The length of the steps when they have become hopelessly small: then they hold on to rounding.
    fn hopeless(&mut self, steps: usize, time: f64, duration: f64) -> Option<f64> {
        let taken = steps.saturating_sub(self.steps);
        if taken < JUDGED {
            return None;
        }
        let step = (time - self.time) / taken as f64;
        *self = Pace { steps, time };
        (step < duration / ENDLESS).then_some(step)
    }
}

impl Walk<'_, '_> {
    fn all(&mut self, plan: &LetGo) -> Result<(), End> {
        self.session.let_go(plan, &mut self.around)?;
        self.row();
        self.warn_of_early_conditions();
        for row in 1..self.rows {
            if self.go_on(row)? {
                return Ok(());
            }
            self.row();
        }
        self.progress.at(1.0, "done");
        Ok(())
    }

    fn row(&mut self) {
        self.session.record_all();
        self.around.settle();
    }

    /// Goes on to a row; says whether a condition ended the study before it.
    fn go_on(&mut self, row: usize) -> Result<bool, End> {
        let until = self.around.time_of(row);
        loop {
            self.watch(row)?;
            match self.session.advance(until, &mut self.around)? {
                Advance::Reached => return Ok(false),
                Advance::Working => self.refuse_to_stall()?,
                Advance::Event(event) if self.ends(&event) => {
                    self.end(&event);
                    return Ok(true);
                }
                Advance::Event(event) => self.tell(&event),
            }
        }
    }

    fn refuse_to_stall(&mut self) -> Result<(), End> {
        let (steps, time) = (self.session.steps(), self.session.readings().time());
        match self.pace.hopeless(steps, time, self.duration) {
            Some(step) => Err(self.session.stalled(step, &self.around)),
            None => Ok(()),
        }
    }

    fn watch(&mut self, row: usize) -> Result<(), End> {
        let time = self.session.readings().time();
        self.progress.at((time / self.duration).clamp(0.0, 1.0), "moving");
        if self.progress.cancelled() { Err(explain::cancelled(row)) } else { Ok(()) }
    }

    /// Whether the event is a condition that became true, not one that ceased to be.
    fn ends(&self, event: &Event) -> bool {
        use bellcrank_doc::Comparison as C;
        let EventKind::Switch { index, rising } = event.kind else { return false };
        self.of.stop_when.get(index).is_some_and(|stop| match stop.comparison {
            C::Greater | C::GreaterOrEqual => rising,
            C::Less | C::LessOrEqual => !rising,
            C::Equal => true,
        })
    }

    fn end(&mut self, event: &Event) {
        self.tell_of(event);
        // An event at the time of a row is that row, but for what the search for it leaves.
        let near = NEAR * self.duration / self.rows as f64;
        if self.session.recorded("time").last().is_none_or(|last| *last < event.time - near) {
            self.row();
        }
        if let (Some(events), EventKind::Switch { index, .. }) = (&mut self.session.result.events, event.kind)
            && let Some(stop) = self.of.stop_when.get(index)
        {
            events.ended = Some(Ended { time: event.time, by: stop.written.clone() });
        }
        self.progress.at(1.0, "done");
    }

    /// A condition that ceases to hold is nothing to tell.
    fn tell(&mut self, event: &Event) {
        if !matches!(event.kind, EventKind::Switch { .. }) {
            self.tell_of(event);
        }
    }

    fn tell_of(&mut self, event: &Event) {
        let told = events::told(self.session.design, &self.of.stop_when, event);
        if let Some(events) = &mut self.session.result.events {
            events.push(told);
        }
    }

    /// A condition that holds at the start ends nothing until it becomes true anew.
    fn warn_of_early_conditions(&mut self) {
        let held = self.around.held(self.session.readings());
        for (stop, _) in self.of.stop_when.iter().zip(held).filter(|(_, held)| *held) {
            let message =
                format!("`stop_when` holds at the start: `{}` ends the study when it becomes true anew", stop.written);
            self.session.result.warnings.push(message);
        }
    }
}
