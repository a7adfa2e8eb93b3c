//! The keys of a study that chooses a drive.

use std::path::Path;

use bellcrank_doc::{Diagnostic, Expression, NoSignals, Span, Spanned};
use bellcrank_multibody::Coordinate;
use bellcrank_sizing::pneumatic::{BucklingLoad, EndCondition, Mount};

use super::given::{Given, one_in_brackets};
use crate::catalogue::Stock;
use crate::design::Valve;
use crate::keyed::Keyed;
use crate::measure::Motion;
use crate::read::study_keys::Referred;

/// Reads the catalogue of a file that a place names.
pub(crate) type CatalogueFiles<'a> = dyn Fn(&Path, Span) -> Result<Stock, Vec<Diagnostic>> + 'a;

/// What the keys of a study of kind `sizing` say.
#[derive(Clone, Debug, Default)]
pub(crate) struct SizingKeys {
    pub(super) drive: Given<Spanned<(Coordinate, Motion)>>,
    pub(super) actuator: Given<Spanned<&'static str>>,
    pub(super) reversed: Given<bool>,
    pub(super) stroke_reserve: Given<Expression>,
    pub(super) catalogue: Given<Spanned<Stock>>,
    pub(super) builtin: Given<Spanned<bool>>,
    pub(super) supply: Given<Expression>,
    pub(super) atmosphere: Given<Expression>,
    pub(super) load_factor: Given<Expression>,
    pub(super) efficiency: Given<Expression>,
    pub(super) standards: Given<Spanned<Vec<Spanned<String>>>>,
    pub(super) mounting: Given<Mount>,
    pub(super) ends: Given<EndCondition>,
    pub(super) offset: Given<Expression>,
    pub(super) buckling_safety: Given<Expression>,
    pub(super) buckling_load: Given<BucklingLoad>,
    pub(super) moved_mass: Given<Expression>,
    pub(super) arrival_speed: Given<Expression>,
    pub(super) cycles: Given<Expression>,
    pub(super) dead_volume: Given<Expression>,
    pub(super) valve: Given<Valve>,
    pub(super) safety: Given<Expression>,
    pub(super) cycle_time: Given<Expression>,
}

impl SizingKeys {
    pub(super) fn read(keyed: &Keyed<'_>, of: Referred<'_>) -> SizingKeys {
        let quantity = |key| Given::key(keyed, key, |_| keyed.quantity(key));
        SizingKeys {
            drive: Given::key(keyed, "drive", |_| {
                let name = keyed.text("drive")?;
                Some(Spanned { value: of.part.coordinate(of.machine, name)?, span: name.span })
            }),
            actuator: Given::key(keyed, "actuator", |_| keyed.choice("actuator")),
            reversed: Given::key(keyed, "reversed", |_| keyed.boolean("reversed").map(|truth| truth.value)),
            stroke_reserve: Given::key(keyed, "stroke_reserve", |value| {
                of.part.reader.any_quantity(value, &keyed.named("stroke_reserve"), &mut NoSignals)
            }),
            catalogue: Given::key(keyed, "catalogue", |_| read_catalogue(keyed, of)),
            builtin: Given::key(keyed, "builtin", |_| keyed.boolean("builtin")),
            supply: quantity("supply"),
            atmosphere: quantity("atmosphere"),
            load_factor: quantity("load_factor"),
            efficiency: quantity("efficiency"),
            standards: Given::key(keyed, "standards", |value| {
                let names = keyed
                    .reader()
                    .strings(one_in_brackets(of.part, value, &keyed.named("standards"))?, &keyed.named("standards"))?;
                let owned = |name: Spanned<&str>| Spanned { value: name.value.to_owned(), span: name.span };
                Some(Spanned { value: names.into_iter().map(owned).collect(), span: value.span })
            }),
            mounting: Given::key(keyed, "mounting", |_| {
                let word = keyed.choice("mounting")?.value;
                Mount::ALL.into_iter().find(|mount| mount.key() == word)
            }),
            ends: Given::key(keyed, "ends", |_| {
                let word = keyed.choice("ends")?.value;
                EndCondition::ALL.into_iter().find(|end| end.key() == word)
            }),
            offset: quantity("offset"),
            buckling_safety: quantity("buckling_safety"),
            buckling_load: Given::key(keyed, "buckling_load", |_| {
                let full = keyed.choice("buckling_load")?.value == "supply";
                Some(if full { BucklingLoad::Supply } else { BucklingLoad::Duty })
            }),
            moved_mass: quantity("moved_mass"),
            arrival_speed: quantity("arrival_speed"),
            cycles: quantity("cycles"),
            dead_volume: quantity("dead_volume"),
            valve: Given::key(keyed, "valve", |_| read_valve(keyed)),
            safety: quantity("safety"),
            cycle_time: quantity("cycle_time"),
        }
    }

    /// These keys, and those of `beneath` where there are none. Another actuator hides nothing: what does not go with
    /// it is not asked.
    pub(super) fn over(self, beneath: SizingKeys) -> SizingKeys {
        SizingKeys {
            drive: self.drive.or(beneath.drive),
            actuator: self.actuator.or(beneath.actuator),
            reversed: self.reversed.or(beneath.reversed),
            stroke_reserve: self.stroke_reserve.or(beneath.stroke_reserve),
            catalogue: self.catalogue.or(beneath.catalogue),
            builtin: self.builtin.or(beneath.builtin),
            supply: self.supply.or(beneath.supply),
            atmosphere: self.atmosphere.or(beneath.atmosphere),
            load_factor: self.load_factor.or(beneath.load_factor),
            efficiency: self.efficiency.or(beneath.efficiency),
            standards: self.standards.or(beneath.standards),
            mounting: self.mounting.or(beneath.mounting),
            ends: self.ends.or(beneath.ends),
            offset: self.offset.or(beneath.offset),
            buckling_safety: self.buckling_safety.or(beneath.buckling_safety),
            buckling_load: self.buckling_load.or(beneath.buckling_load),
            moved_mass: self.moved_mass.or(beneath.moved_mass),
            arrival_speed: self.arrival_speed.or(beneath.arrival_speed),
            cycles: self.cycles.or(beneath.cycles),
            dead_volume: self.dead_volume.or(beneath.dead_volume),
            valve: self.valve.or(beneath.valve),
            safety: self.safety.or(beneath.safety),
            cycle_time: self.cycle_time.or(beneath.cycle_time),
        }
    }
}

/// The catalogue that the key names; what is wrong with it is said in the file.
fn read_catalogue(keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Spanned<Stock>> {
    let file = keyed.text("catalogue")?;
    match (of.catalogues)(&of.part.part.folder.join(file.value), file.span) {
        Ok(value) => Some(Spanned { value, span: file.span }),
        Err(reports) => {
            reports.into_iter().for_each(|report| keyed.report(report));
            None
        }
    }
}

fn read_valve(keyed: &Keyed<'_>) -> Option<Valve> {
    let valve = keyed.table("valve")?;
    let sonic = valve.quantity("sonic_conductance");
    let critical_ratio = valve.quantity("critical_ratio");
    let index = Given::key(&valve, "subsonic_index", |_| valve.quantity("subsonic_index")).optional();
    valve.finish();
    Some(Valve { sonic: sonic?, critical_ratio: critical_ratio?, index: index? })
}
