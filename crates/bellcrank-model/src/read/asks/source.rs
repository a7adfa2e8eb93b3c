//! The study that is asked: what its rows run over, and which signals they tell.

use bellcrank_doc::{Diagnostic, Dimension, Reduction, Span};
use bellcrank_multibody::Coordinate;

use crate::design::moved;
use crate::measure::Motion;
use crate::read::study_keys::{Referred, StudyKeys};
use crate::schema::Along;
use crate::signals::{Level, Signal, Source};

/// A study with rows.
pub(crate) struct Asked<'a> {
    pub(crate) name: &'a str,
    pub(crate) kind: &'static str,
    pub(crate) keys: &'a StudyKeys,
    pub(crate) of: Referred<'a>,
}

impl Asked<'_> {
    /// Reports what the study does not tell; whether there was anything.
    pub(super) fn refuses(&self, reductions: &[Reduction], signals: &[Signal]) -> bool {
        let mut faults = Vec::new();
        for reduction in reductions {
            faults.extend(self.place(reduction));
            let used = reduction.curve.signals();
            let used = used.iter().filter_map(|&index| signals.get(index));
            faults.extend(used.filter_map(|&signal| self.fault(signal, reduction.curve.span())));
        }
        let refuses = !faults.is_empty();
        faults.into_iter().for_each(|fault| self.of.part.reader.report(fault));
        refuses
    }

    /// What is wrong with the place of an `at`.
    fn place(&self, reduction: &Reduction) -> Option<Diagnostic> {
        let place = reduction.place.as_ref()?;
        let Some(axis) = self.axis() else {
            let message = format!("`at` has no place in study `{}`: it has one row", self.name);
            let hint = "take `last(...)`, or give that study a `sweep`";
            return Some(Diagnostic::error("no-signal", place.span(), message).hint(hint));
        };
        let fault = reduction.check_place(axis).err()?;
        Some(fault.hint(format!("study `{}` goes over {}", self.name, self.goes_over())))
    }

    /// What is wrong with asking for a signal.
    pub(super) fn fault(&self, signal: Signal, span: Span) -> Option<Diagnostic> {
        let column = self.of.catalogue.column(signal)?;
        let error = |message: String| Diagnostic::error("no-signal", span, message);
        let (signal_name, study) = (&column.name, self.name);
        if column.level >= Level::Force && self.kind == "kinematics" {
            let message = format!("`{signal_name}` is not in study `{study}`: kinematics has no forces");
            return Some(error(message).hint(format!("make study `{study}` one of kind `inverse-dynamics`")));
        }
        match signal.source {
            Source::Time if !self.has_time() => {
                let message = format!("`time` is not in study `{study}`, which goes over {}", self.goes_over());
                Some(
                    error(message).hint(format!("time runs where a study has `duration`; here use {}", self.instead())),
                )
            }
            Source::Drive(c) if !self.drives().contains(&c) => {
                let message =
                    format!("`{signal_name}` is not in study `{study}`: nothing drives that coordinate there");
                Some(error(message).hint(self.what_drives()))
            }
            _ => None,
        }
    }

    fn has_time(&self) -> bool {
        self.kind == "dynamics" || self.keys.duration.is_some()
    }

    /// What the rows run over; `None` of one row.
    fn axis(&self) -> Option<Dimension> {
        if self.has_time() {
            return Some(Dimension::TIME);
        }
        self.keys.sweep.as_ref().map(|(_, motion)| Along::Position.dimension(*motion))
    }

    fn goes_over(&self) -> String {
        match &self.keys.sweep {
            _ if self.has_time() => "time".to_owned(),
            Some((sweep, _)) => format!("`{}`", self.signal(Source::Joint(sweep.coordinate))),
            None => "one position".to_owned(),
        }
    }

    fn instead(&self) -> String {
        match &self.keys.sweep {
            Some((sweep, _)) => format!("`{}`", self.signal(Source::Joint(sweep.coordinate))),
            None => "the signals of joints and points".to_owned(),
        }
    }

    /// Coordinates that carry efforts there, as the run chooses them.
    pub(super) fn drives(&self) -> Vec<Coordinate> {
        let keys = self.keys;
        let motions = &self.of.motions.list;
        let of_motions = |indices: Vec<usize>| moved(indices.into_iter().filter_map(|i| motions.get(i)));
        let mut drives = match &keys.sweep {
            _ if self.has_time() => keys
                .drives
                .clone()
                .unwrap_or_else(|| of_motions(keys.motions.clone().unwrap_or_else(|| (0..motions.len()).collect()))),
            Some((sweep, _)) if self.kind != "statics" => {
                vec![keys.drive.as_ref().and_then(|drive| drive.coordinate).unwrap_or(sweep.coordinate)]
            }
            swept => {
                let mut all = of_motions(keys.motions.clone().unwrap_or_default());
                all.extend(swept.as_ref().map(|(sweep, _)| sweep.coordinate));
                all
            }
        };
        drives.extend(keys.holds.iter().flatten().map(|hold| hold.coordinate));
        drives
    }

    fn what_drives(&self) -> String {
        let names: Vec<String> =
            self.drives().into_iter().map(|c| format!("`{}`", self.signal(Source::Drive(c)))).collect();
        match names.as_slice() {
            [] => format!("study `{}` has no drives", self.name),
            names => format!("drives of study `{}`: {}", self.name, names.join(", ")),
        }
    }

    /// The one drive among several that does not only hold; else the one there is.
    pub(super) fn only_drive<'d>(&self, all: &'d [Coordinate]) -> &'d [Coordinate] {
        let held = self.keys.holds.iter().flatten().count();
        match all.len() - held {
            0 => all,
            moving => &all[..moving],
        }
    }

    /// What a coordinate counts.
    pub(super) fn motion(&self, c: Coordinate) -> Motion {
        let joint = self.of.machine.joints.get(c.joint.0).map(|joint| joint.coordinates(self.of.part.planar));
        joint.and_then(|motions| motions.get(c.index).copied()).unwrap_or(Motion::Slide)
    }

    /// `slide`, or `J.1` for one of several.
    pub(super) fn coordinate(&self, c: Coordinate) -> String {
        let Some(joint) = self.of.machine.joints.get(c.joint.0) else { return String::new() };
        let several = joint.coordinates(self.of.part.planar).len() > 1;
        if several { format!("{}.{}", joint.name, c.index) } else { joint.name.clone() }
    }

    /// The name of the first signal of a source.
    fn signal(&self, source: Source) -> String {
        self.of.catalogue.columns(source).into_iter().next().map_or_else(String::new, |column| column.name)
    }
}
