//! What happened during a study in time.

use crate::Unit;

/// Events that are kept; the others are counted.
const MOST: usize = 10_000;

/// What happened, in the order of time.
#[derive(Clone, Debug)]
pub struct Events {
    /// Unit of all times.
    pub unit: Unit,
    /// The first ones.
    pub list: Vec<Event>,
    /// How many there were beyond the list.
    pub more: usize,
    /// What ended the study before its time.
    pub ended: Option<Ended>,
}

/// A condition that ended a study.
#[derive(Clone, Debug)]
pub struct Ended {
    /// s.
    pub time: f64,
    /// The condition as written.
    pub by: String,
}

/// Something that happened.
#[derive(Clone, Debug)]
pub struct Event {
    /// s.
    pub time: f64,
    /// What sort of thing.
    pub kind: EventKind,
    /// The force element, or the condition as written.
    pub name: String,
    /// The joint coordinate; empty without one.
    pub joint: String,
    /// `upper` or `lower` limit, or `up` or `down`; empty where there are no sides.
    pub side: &'static str,
    /// What belongs to it: name, SI value, unit.
    pub numbers: Vec<(&'static str, f64, Unit)>,
}

/// Sorts of events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// A hard stop was hit and threw the joint back.
    Impact,
    /// A stop is touched.
    Contact,
    /// A stop is left.
    Release,
    /// Friction holds.
    Stick,
    /// Friction gives way.
    Slip,
    /// A condition of the study became true.
    Condition,
}

impl EventKind {
    /// One word.
    pub fn word(self) -> &'static str {
        match self {
            EventKind::Impact => "impact",
            EventKind::Contact => "contact",
            EventKind::Release => "release",
            EventKind::Stick => "stick",
            EventKind::Slip => "slip",
            EventKind::Condition => "condition",
        }
    }
}

impl Events {
    /// Nothing yet; `unit` is that of the times.
    pub fn none(unit: Unit) -> Self {
        Self { unit, list: Vec::new(), more: 0, ended: None }
    }

    /// One more, which is counted only when there are too many.
    pub fn push(&mut self, event: Event) {
        if self.list.len() < MOST { self.list.push(event) } else { self.more += 1 }
    }

    /// How many there were.
    pub fn count(&self) -> usize {
        self.list.len() + self.more
    }
}
