//! `[units]`: how results are shown.

use bellcrank_doc::{Diagnostic, unit};
use bellcrank_results::Unit;

use crate::keyed::Keyed;
use crate::measure::{DISPLAYED, DisplayUnits, Measure};

pub(crate) fn read(keyed: Keyed<'_>) -> DisplayUnits {
    let chosen: Vec<(usize, Unit)> = DISPLAYED
        .iter()
        .enumerate()
        .filter_map(|(index, (name, measure, _))| Some((index, one(&keyed, name, *measure)?)))
        .collect();
    keyed.finish();
    DisplayUnits::new(&chosen)
}

fn one(keyed: &Keyed<'_>, name: &'static str, measure: Measure) -> Option<Unit> {
    let written = keyed.text(name)?;
    let wanted = measure.dimension();
    match unit(written.value) {
        Ok(unit) if unit.dimension.agrees(wanted) && unit.offset == 0.0 => Some(Unit::new(written.value, unit.factor)),
        Ok(unit) => {
            let message = format!(
                "{} needs a unit of {}, found one of {}",
                keyed.named(name),
                wanted.phrase(),
                unit.dimension.phrase()
            );
            keyed.report(Diagnostic::error("wrong-dimension", written.span, message));
            None
        }
        Err(why) => {
            keyed.report(Diagnostic::error("unknown-unit", written.span, why));
            None
        }
    }
}
