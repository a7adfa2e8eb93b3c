//! Where the extremes in a response lie, in words.

use bellcrank_results::ActivePlace;

use super::Asking;
use crate::measure::{Measure, Motion};
use crate::run::Namer;
use crate::trial::Trial;

/// The places of all extremes that a response depends on.
pub(super) fn active_places(asking: &Asking<'_>, trial: &Trial<'_>, index: usize) -> Vec<ActivePlace> {
    let (axis, unit) = match asking.of.axis() {
        Some(c) => {
            let namer = Namer::new(asking.design);
            let motion = asking.design.joints.get(c.joint.0).map(|joint| joint.coordinates(asking.design.planar));
            let motion = motion.and_then(|motions| motions.get(c.index).copied()).unwrap_or(Motion::Slide);
            (namer.signal(c), asking.design.units.of(Measure::position(motion)))
        }
        None => ("time".to_owned(), asking.design.units.of(Measure::Time)),
    };
    let place = |(reduction, row): (String, f64)| ActivePlace {
        reduction,
        axis: axis.clone(),
        place: trial.place(row),
        unit: unit.clone(),
        between_rows: row.fract() != 0.0,
    };
    trial.active_rows(index).into_iter().map(place).collect()
}
