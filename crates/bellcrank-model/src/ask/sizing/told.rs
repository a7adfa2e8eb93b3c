//! What a choice found, in the units and words of results.

use bellcrank_results::{Check, Property, Sizing as Told, Unit};
use bellcrank_sizing::{Candidate, Quantity, Selection, Subject};

use super::Loads;
use crate::ask::Asking;
use crate::design::Sizing;
use crate::measure::Measure;
use crate::run::Namer;

/// Units of a study that chooses a drive: those of the file, and for compressed air what engineers buy in.
#[derive(Clone, Copy)]
pub(super) struct Units<'d> {
    asking: Asking<'d>,
}

impl<'d> Units<'d> {
    pub(super) fn new(asking: &Asking<'d>) -> Units<'d> {
        Units { asking: *asking }
    }

    pub(super) fn of(&self, quantity: Quantity) -> Unit {
        let shown = |measure| self.asking.design.units.of(measure);
        match quantity {
            Quantity::Force => shown(Measure::Force),
            Quantity::Torque => shown(Measure::Moment),
            Quantity::Length => shown(Measure::Length),
            Quantity::Angle => shown(Measure::Angle),
            Quantity::Speed => shown(Measure::Velocity),
            Quantity::AngularSpeed => Unit::new("rpm", std::f64::consts::PI / 30.0),
            Quantity::Pressure => Unit::new("bar", 1e5),
            Quantity::Energy => shown(Measure::Energy),
            Quantity::Power => shown(Measure::Power),
            Quantity::Flow => Unit::new("L/min", 1e-3 / 60.0),
        }
    }

    pub(super) fn time(&self) -> Unit {
        self.asking.design.units.of(Measure::Time)
    }

    pub(super) fn mass(&self) -> Unit {
        self.asking.design.units.of(Measure::Mass)
    }

    pub(super) fn property(&self, key: &str, label: &str, value: f64, quantity: Quantity) -> Property {
        property(key, label, value, self.of(quantity))
    }

    fn check(&self, of: &bellcrank_sizing::Check) -> Check {
        Check {
            key: of.subject.key().to_owned(),
            needed: of.needed,
            available: of.available,
            unit: self.of(of.quantity),
            passes: of.passes(),
            // That it was not checked stands beside it.
            reason: of.reason.strip_prefix("not checked: ").unwrap_or(&of.reason).to_owned(),
        }
    }

    /// A candidate with its checks; `name` is what one orders.
    pub(super) fn candidate<C: Candidate>(
        &self,
        of: &C,
        name: String,
        mut properties: Vec<Property>,
    ) -> bellcrank_results::Candidate {
        // A stroke and a pressure limit are meant to be used up.
        let loaded = of.checks().iter().filter(|check| !matches!(check.subject, Subject::Stroke | Subject::Pressure));
        let known = loaded.filter(|check| check.utilization().is_finite());
        if let Some(most) = known.max_by(|a, b| a.utilization().total_cmp(&b.utilization())) {
            let label = format!("utilization ({})", most.subject.key().replace('_', " "));
            properties.insert(0, property("utilization", &label, most.utilization(), percent()));
        }
        let checks = of.checks().iter().map(|check| self.check(check)).collect();
        bellcrank_results::Candidate { name, passes: of.passes(), properties, checks }
    }

    /// `160 mm`, as reasons write it.
    pub(super) fn shown(value: f64, unit: &Unit) -> String {
        crate::run::shown(value, unit)
    }
}

pub(super) fn percent() -> Unit {
    Unit::new("%", 0.01)
}

pub(super) fn property(key: &str, label: &str, value: f64, unit: Unit) -> Property {
    Property { key: key.to_owned(), label: label.to_owned(), value, unit }
}

/// The finding, without its candidates.
pub(super) fn finding<C: Candidate>(
    asking: &Asking<'_>,
    question: &Sizing,
    kind: &str,
    selection: &Selection<C>,
    told: impl Fn(&C) -> bellcrank_results::Candidate,
) -> Told {
    let place = |found: Option<&C>| {
        let found = found?;
        selection.candidates.iter().position(|candidate| std::ptr::eq(candidate, found))
    };
    let chosen = place(selection.chosen());
    Told {
        of: asking.of.name.clone(),
        drive: Namer::new(asking.design).coordinate(question.drive),
        kind: kind.to_owned(),
        requirements: Vec::new(),
        conditions: Vec::new(),
        candidates: selection.candidates.iter().map(told).collect(),
        chosen,
        nearest: if chosen.is_none() { place(selection.nearest()) } else { None },
    }
}

/// Power, and how long it takes, as far as that is known.
pub(super) fn power(units: &Units<'_>, loads: &Loads) -> Vec<Property> {
    let of = &loads.requirement;
    let mut told = Vec::new();
    if of.power.value > 0.0 {
        told.push(units.property("power", "peak power", of.power.value, Quantity::Power));
    }
    if of.braking_power.value > 0.0 {
        told.push(units.property("braking_power", "peak braking power", of.braking_power.value, Quantity::Power));
    }
    if let Some(mean) = of.mean_power.filter(|mean| *mean > 0.0) {
        told.push(units.property("mean_power", "mean power", mean, Quantity::Power));
    }
    told.extend(of.duration.map(|duration| property("duration", "duration", duration, units.time())));
    told
}
