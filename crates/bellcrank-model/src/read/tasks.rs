//! From the keys of a study that asks no other one to what it does.

use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Entry, Span};
use bellcrank_multibody::Coordinate;

use super::parts;
use super::study_keys::{Referred, StudyKeys};
use crate::design::{Dynamics, Hold, Modes, Over, Stepping, StopWhen, Task};
use crate::schema::AVAILABLE;
use crate::signals::{Signal, Source};

/// One study, while its task is made.
pub(super) struct Tasks<'a> {
    pub(super) entry: &'a Entry,
    pub(super) kind: &'static str,
    pub(super) of: Referred<'a>,
    /// Signals of the conditions of all studies.
    pub(super) signals: &'a Arc<[Signal]>,
}

impl Tasks<'_> {
    /// What the study does; `None` after an error.
    pub(super) fn task(&self, keys: StudyKeys) -> Option<Task> {
        if !AVAILABLE.contains(&self.kind) {
            return Some(Task::Later);
        }
        if self.kind == "stress" || self.kind == "modes" && (self.own("body") || keys.parts.bodies.is_some()) {
            self.refuse_machine_keys();
            let parts = parts::parts(self.entry, self.kind, keys.parts, self.of)?;
            return Some(Task::Parts(Box::new(parts)));
        }
        self.refuse_body_keys();
        let holds = keys.holds.clone().unwrap_or_default();
        let task = match self.kind {
            "statics" => {
                let sweep = keys.sweep.map(|(sweep, _)| sweep);
                Task::Statics { sweep, holds, motions: keys.motions.unwrap_or_default() }
            }
            "dynamics" => Task::Dynamics(Box::new(self.dynamics(keys, holds)?)),
            "modes" => Task::Modes(Modes {
                equilibrium: keys.forward.equilibrium.unwrap_or(true),
                holds,
                motions: keys.motions.unwrap_or_default(),
                sweep: keys.sweep.map(|(sweep, _)| sweep),
                count: keys.forward.count,
            }),
            kind => Task::Motion { forces: kind == "inverse-dynamics", over: self.over(keys)?, holds },
        };
        self.prescribed_once(&task)?;
        Some(task)
    }

    fn report(&self, code: &'static str, message: String) {
        self.of.part.reader.report(Diagnostic::error(code, self.entry.key_span, message));
    }

    fn own(&self, key: &str) -> bool {
        self.entry.value.as_table().is_some_and(|table| table.get(key).is_some())
    }

    /// Keys of modes of a machine mean nothing for a body.
    fn refuse_machine_keys(&self) {
        let machine = ["hold", "sweep", "motions", "count", "equilibrium"];
        for key in machine.into_iter().filter(|key| self.kind == "modes" && self.own(key)) {
            let message = format!("`{key}` of study `{}` is for modes of the machine; it has a `body`", self.entry.key);
            self.report("conflicting-keys", message);
        }
    }

    /// And the other way round.
    fn refuse_body_keys(&self) {
        for key in ["modes", "fixed", "mesh"].into_iter().filter(|key| self.kind == "modes" && self.own(key)) {
            let message = format!("`{key}` of study `{}` is for modes of a body; it has no `body`", self.entry.key);
            self.report("conflicting-keys", message);
        }
    }

    fn all_motions(&self) -> Vec<usize> {
        (0..self.of.motions.list.len()).collect()
    }

    /// Positions or time; what is missing or too much is reported.
    fn over(&self, keys: StudyKeys) -> Option<Over> {
        let name = &self.entry.key;
        match (keys.sweep, keys.duration, keys.step) {
            (Some(_), Some(_), _) | (Some(_), _, Some(_)) => {
                let message = format!("study `{name}` goes over positions (`sweep`) and over time; give one");
                self.report("conflicting-keys", message);
                None
            }
            (Some((sweep, _)), None, None) => {
                let swept = sweep.coordinate;
                let drive = keys.drive;
                let coordinate: Coordinate = drive.as_ref().and_then(|drive| drive.coordinate).unwrap_or(swept);
                let (velocity, acceleration) = drive.map_or((None, None), |drive| (drive.velocity, drive.acceleration));
                Some(Over::Positions { sweep, drive: coordinate, velocity, acceleration })
            }
            (None, Some(duration), Some(step)) => {
                let motions = keys.motions.unwrap_or_else(|| self.all_motions());
                Some(Over::Time { duration, step, motions, drives: keys.drives })
            }
            (None, duration, step) => {
                let own = |key| self.own(key);
                let wrong = own("sweep") || duration.is_none() && own("duration") || step.is_none() && own("step");
                match (duration, step) {
                    // The key is there, and what is wrong with it has been told.
                    _ if wrong => {}
                    (Some(_), _) => self.report("missing-key", format!("`step` is missing in study `{name}`")),
                    (_, Some(_)) => self.report("missing-key", format!("`duration` is missing in study `{name}`")),
                    _ => self.report(
                        "missing-key",
                        format!("study `{name}` needs `sweep` (over positions), or `duration` and `step` (over time)"),
                    ),
                }
                None
            }
        }
    }

    fn dynamics(&self, keys: StudyKeys, holds: Vec<Hold>) -> Option<Dynamics> {
        let Some(duration) = keys.duration else {
            if !self.own("duration") {
                self.report("missing-key", format!("`duration` is missing in study `{}`", self.entry.key));
            }
            return None;
        };
        let forward = keys.forward;
        let dynamics = Dynamics {
            duration,
            output_step: forward.output_step,
            tolerance: forward.tolerance,
            method: forward.method.unwrap_or(Stepping::Automatic),
            spectral_radius: forward.spectral_radius,
            step: keys.step,
            largest_step: forward.largest_step,
            motions: keys.motions.unwrap_or_else(|| self.all_motions()),
            holds,
            stop_when: forward.stop_when.unwrap_or_default(),
            signals: self.signals.clone(),
        };
        let before = self.of.part.reader.errors();
        dynamics.stop_when.iter().for_each(|stop| self.check_signals(stop, &dynamics));
        (self.of.part.reader.errors() == before).then_some(dynamics)
    }

    /// A condition may ask for the drives of this study only.
    fn check_signals(&self, stop: &StopWhen, dynamics: &Dynamics) {
        let driven: Vec<Coordinate> = self.driven(&dynamics.motions, &dynamics.holds).map(|(c, _, _)| c).collect();
        let mut used: Vec<usize> =
            [&stop.left, &stop.right].iter().flat_map(|side| side.expression.signals()).collect();
        used.dedup();
        for signal in used.into_iter().filter_map(|index| self.signals.get(index)) {
            let Source::Drive(c) = signal.source else { continue };
            if driven.contains(&c) {
                continue;
            }
            let name = self.of.catalogue.column(*signal).map_or_else(String::new, |column| column.name);
            let message =
                format!("`{name}` is not in study `{}`: nothing drives that coordinate there", self.entry.key);
            let hint = "give the study a motion or a `hold` of that joint, or compare another signal";
            self.of.part.reader.report(Diagnostic::error("no-signal", stop.span, message).hint(hint));
        }
    }

    /// Coordinates that motions and holds prescribe, with what prescribes them and where that stands.
    fn driven<'s>(
        &'s self,
        motions: &'s [usize],
        holds: &'s [Hold],
    ) -> impl Iterator<Item = (Coordinate, String, Span)> + 's {
        let moved = motions.iter().filter_map(|&index| self.of.motions.list.get(index)).flat_map(|motion| {
            motion.coordinates.iter().map(|&c| (c, format!("motion `{}`", motion.name), motion.span))
        });
        moved.chain(holds.iter().map(|hold| (hold.coordinate, "`hold`".to_owned(), hold.span)))
    }

    /// Reports coordinates that a motion and `hold`, or `hold` twice, prescribe. Motions of one coordinate may follow
    /// each other.
    fn prescribed_once(&self, task: &Task) -> Option<()> {
        let (motions, holds) = task.prescribed();
        let all: Vec<(Coordinate, String, Span)> = self.driven(motions, holds).collect();
        let mut once = Some(());
        for (i, (coordinate, what, span)) in all.iter().enumerate() {
            let holds = i >= all.len() - holds.len();
            let before = all[..i].iter().find(|(other, ..)| other == coordinate);
            let Some((_, first, before)) = before.filter(|_| holds) else { continue };
            let name = self.name(*coordinate);
            let message = format!("`{name}` is prescribed twice in study `{}`: by {first} and {what}", self.entry.key);
            let report = Diagnostic::error("prescribed-twice", *span, message);
            let report = report.also(*before, "first here").also(self.entry.key_span, "in this study");
            let hint = match self.own("motions") {
                true => "a coordinate has one motion or one `hold`: take one out",
                false => "all motions act unless the study names its own: `motions = [\"...\"]`",
            };
            self.of.part.reader.report(report.hint(hint));
            once = None;
        }
        once
    }

    /// `slide`, or `J.1` for one of several.
    fn name(&self, c: Coordinate) -> String {
        let Some(joint) = self.of.machine.joints.get(c.joint.0) else { return String::new() };
        let several = joint.coordinates(self.of.part.planar).len() > 1;
        if several { format!("{}.{}", joint.name, c.index) } else { joint.name.clone() }
    }
}
