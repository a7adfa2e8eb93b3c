//! `sizing`: which drive to take.

use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Expression, Span, Spanned, nearest};
use bellcrank_multibody::Coordinate;
use bellcrank_sizing::electric::Kind;
use bellcrank_sizing::pneumatic::{BucklingLoad, EndCondition, Mount};

use super::finish::Asking;
use super::given::Given;
use super::sizing::SizingKeys;
use crate::catalogue::{Allowed, Stock};
use crate::design::{Actuator, Electric, Pneumatic, Sizing, Valve};
use crate::measure::Motion;
use crate::schema::{Along, ELECTRIC_KEYS, PNEUMATIC_KEYS};
use crate::signals::{Signal, Source};

pub(super) fn sizing(asking: &Asking<'_>, keys: SizingKeys) -> Option<Sizing> {
    use Allowed::{BelowOne, NotNegative, Positive, Share};
    let number = |given: Given<Expression>, key, allowed| checked(asking, given, key, allowed);
    // All are checked before giving up.
    let supply = number(keys.supply, "supply", Positive);
    let atmosphere = number(keys.atmosphere, "atmosphere", NotNegative);
    let load_factor = number(keys.load_factor, "load_factor", Share);
    let efficiency = number(keys.efficiency, "efficiency", Share);
    let offset = number(keys.offset, "offset", NotNegative);
    let buckling_safety = number(keys.buckling_safety, "buckling_safety", Positive);
    let moved_mass = number(keys.moved_mass, "moved_mass", NotNegative);
    let arrival_speed = number(keys.arrival_speed, "arrival_speed", NotNegative);
    let cycles = number(keys.cycles, "cycles", NotNegative);
    let dead_volume = number(keys.dead_volume, "dead_volume", NotNegative);
    let safety = number(keys.safety, "safety", Positive);
    let cycle_time = number(keys.cycle_time, "cycle_time", Positive);
    let reserve = number(keys.stroke_reserve, "stroke_reserve", NotNegative);
    let valve = keys.valve.optional().and_then(|valve| {
        let Some(Valve { sonic, critical_ratio, index }) = valve else { return Some(None) };
        let sonic = number(Given::Is(sonic), "sonic_conductance", Positive);
        let critical_ratio = number(Given::Is(critical_ratio), "critical_ratio", BelowOne);
        let index = number(index.map_or(Given::No, Given::Is), "subsonic_index", Positive);
        Some(Some(Valve { sonic: sonic??, critical_ratio: critical_ratio??, index: index? }))
    });
    let (drive, motion) = drive(asking, keys.drive)?;
    let reserve = reserve.and_then(|reserve| along(asking, reserve, motion));
    let electric = electric(asking, keys.actuator, drive, motion)?;
    let fits = own_keys_fit(asking, electric, drive, motion);
    let stock = Choice { asking, own: keys.catalogue, builtin: keys.builtin };
    let actuator = if electric {
        let kind = if motion == Motion::Slide { Kind::Linear } else { Kind::Rotary };
        let drives = stock.drives(kind);
        Actuator::Electric(Electric { kind, safety: safety?, cycle_time: cycle_time?, drives: drives? })
    } else {
        let cylinders = stock.cylinders(keys.standards);
        let supply = match supply? {
            Some(supply) => Some(supply),
            None => {
                let message = format!("`supply` is missing in study `{}`", asking.entry.key);
                let hint = "write `supply = \"6 bar\"`, the gauge pressure at the valve; without compressed air \
                            `actuator = \"electric\"`";
                asking.error("missing-key", asking.entry.key_span, message, hint);
                None
            }
        };
        Actuator::Pneumatic(Box::new(Pneumatic {
            supply: supply?,
            atmosphere: atmosphere?,
            load_factor: load_factor?,
            efficiency: efficiency?,
            mounting: keys.mounting.or_else(|| Mount::Rear)?,
            ends: keys.ends.or_else(|| EndCondition::PinnedPinned)?,
            offset: offset?,
            buckling_safety: buckling_safety?,
            buckling_load: keys.buckling_load.or_else(|| BucklingLoad::Duty)?,
            moved_mass: moved_mass?,
            arrival_speed: arrival_speed?,
            cycles: cycles?,
            dead_volume: dead_volume?,
            valve: valve?,
            cylinders: cylinders?,
        }))
    };
    fits.then_some(())?;
    Some(Sizing { drive, reversed: keys.reversed.or_else(|| false)?, stroke_reserve: reserve?, actuator })
}

/// A number that may be absent; the outer `None` after an error.
fn checked(
    asking: &Asking<'_>,
    given: Given<Expression>,
    key: &'static str,
    allowed: Allowed,
) -> Option<Option<Expression>> {
    let Some(expression) = given.optional()? else { return Some(None) };
    let value = asking.number(&expression)?;
    if allowed.holds(value) {
        return Some(Some(expression));
    }
    let message = format!("`{key}` of study `{}` must be {}", asking.entry.key, allowed.words());
    let report = Diagnostic::error("out-of-range", expression.span(), message);
    let percent = allowed == Allowed::Share && value > 1.0 && value <= 100.0;
    asking.report(if percent { report.hint(format!("{value} % is `{}`", value / 100.0)) } else { report });
    None
}

/// The reserve is a length where the drive slides, an angle where it turns.
fn along(asking: &Asking<'_>, reserve: Option<Expression>, motion: Motion) -> Option<Option<Expression>> {
    let Some(reserve) = reserve else { return Some(None) };
    let wanted = Along::Position.dimension(motion);
    if reserve.fits(wanted) {
        return Some(Some(reserve));
    }
    let found = reserve.dimension();
    let message = format!("`stroke_reserve` needs {}, found {}", wanted.phrase(), found.phrase());
    asking.report(Diagnostic::error("dimension", reserve.span(), message).label(found.phrase()));
    None
}

/// The coordinate whose drive is chosen: one that carries an effort in the study that is asked.
fn drive(asking: &Asking<'_>, given: Given<Spanned<(Coordinate, Motion)>>) -> Option<(Coordinate, Motion)> {
    let asked = asking.asked;
    if let Some(named) = given.optional()? {
        let signal = Signal { source: Source::Drive(named.value.0), part: 0 };
        if let Some(fault) = asked.fault(signal, named.span) {
            asking.report(fault);
            return None;
        }
        return Some(named.value);
    }
    let span = asking.entry.key_span;
    let all = asked.drives();
    let [one] = asked.only_drive(&all) else {
        let message = match all.as_slice() {
            [] => format!("nothing is driven in study `{}`, so there is no drive to choose", asked.name),
            _ => format!("study `{}` does not say which drive of study `{}` it is about", asking.entry.key, asked.name),
        };
        let names: Vec<String> = all.iter().map(|&c| format!("`drive = \"{}\"`", asked.coordinate(c))).collect();
        let hint = match names.as_slice() {
            [] => "give that study a `sweep`, a motion or a `hold`".to_owned(),
            names => format!("write {}", names.join(" or ")),
        };
        asking.error("which-drive", span, message, hint);
        return None;
    };
    if let Some(fault) = asked.fault(Signal { source: Source::Drive(*one), part: 0 }, span) {
        asking.report(fault);
        return None;
    }
    Some((*one, asked.motion(*one)))
}

/// Whether the drive is electric; a cylinder cannot turn anything.
fn electric(
    asking: &Asking<'_>,
    given: Given<Spanned<&'static str>>,
    drive: Coordinate,
    motion: Motion,
) -> Option<bool> {
    let Some(word) = given.optional()? else { return Some(motion == Motion::Turn) };
    let electric = word.value == "electric";
    if !electric && motion == Motion::Turn {
        let name = asking.asked.coordinate(drive);
        let message = format!("`{name}` turns, and a pneumatic cylinder pushes");
        let hint = "take `actuator = \"electric\"`, or put a cylinder into the machine: a joint of kind `distance` \
                    without `length`, or a prismatic one";
        asking.error("wrong-actuator", word.span, message, hint);
        return None;
    }
    Some(electric)
}

/// Reports keys of this very study that mean nothing for its drive; inherited ones are left alone.
fn own_keys_fit(asking: &Asking<'_>, electric: bool, drive: Coordinate, motion: Motion) -> bool {
    let (foreign, what) = match electric {
        true => (PNEUMATIC_KEYS, "an electric drive"),
        false => (ELECTRIC_KEYS, "a cylinder"),
    };
    let name = asking.asked.coordinate(drive);
    let hint = match (electric, motion) {
        (true, Motion::Turn) => format!("`{name}` turns, so its drive is electric"),
        (true, Motion::Slide) => "for a cylinder take `actuator = \"pneumatic\"`".to_owned(),
        (false, _) => format!("`{name}` slides: a cylinder unless there is `actuator = \"electric\"`"),
    };
    let own = asking.entry.value.as_table().into_iter().flat_map(|table| table.iter());
    let wrong: Vec<_> = own.filter(|entry| foreign.contains(&entry.key.as_str())).collect();
    for entry in &wrong {
        let message = format!("`{}` means nothing for {what}", entry.key);
        asking.error("unfit-key", entry.key_span, message, hint.as_str());
    }
    wrong.is_empty()
}

/// What there is to choose from.
struct Choice<'a> {
    asking: &'a Asking<'a>,
    own: Given<Spanned<Stock>>,
    builtin: Given<Spanned<bool>>,
}

impl Choice<'_> {
    /// The built-in entries and those of the user, and where to report that none is left.
    fn stock(self) -> Option<(Stock, Span)> {
        let own = self.own.optional();
        let builtin = self.builtin.optional()?;
        let alone = builtin.filter(|builtin| !builtin.value).map(|builtin| builtin.span);
        let own = own?;
        let span = own.as_ref().map(|own| own.span).or(alone).unwrap_or(self.asking.entry.key_span);
        if let (Some(alone), None) = (alone, &own) {
            let message = "without the built-in catalogue there is nothing to choose from".to_owned();
            let hint = "name a file with entries of your own: `catalogue = \"my-cylinders.toml\"`";
            self.asking.error("no-entries", alone, message, hint);
            return None;
        }
        let mut stock = if alone.is_some() { Stock::default() } else { Stock::builtin().clone() };
        stock.add(own.map(|own| own.value).unwrap_or_default());
        Some((stock, span))
    }

    fn drives(self, kind: Kind) -> Option<Arc<[bellcrank_sizing::electric::Drive]>> {
        let asking = self.asking;
        let (stock, span) = self.stock()?;
        let drives: Arc<[_]> = stock.drives.into_iter().filter(|drive| drive.kind == kind).collect();
        if drives.is_empty() {
            let word = if kind == Kind::Linear { "linear" } else { "rotary" };
            let message = format!("the catalogue has no {word} drive");
            asking.error("no-entries", span, message, format!("an entry: `[drives.NAME]` with `kind = \"{word}\"`"));
            return None;
        }
        Some(drives)
    }

    fn cylinders(
        self,
        standards: Given<Spanned<Vec<Spanned<String>>>>,
    ) -> Option<Arc<[bellcrank_sizing::pneumatic::Cylinder]>> {
        let asking = self.asking;
        let standards = standards.optional();
        let (stock, span) = self.stock()?;
        let mut cylinders = stock.cylinders;
        if cylinders.is_empty() {
            let message = "the catalogue has no cylinder".to_owned();
            asking.error("no-entries", span, message, "an entry: `[cylinders.NAME]` with `bore` and `rod`");
            return None;
        }
        let Some(standards) = standards? else { return Some(cylinders.into()) };
        let mut known: Vec<&str> = cylinders.iter().map(|c| c.standard.as_str()).filter(|s| !s.is_empty()).collect();
        known.sort_unstable();
        known.dedup();
        let unknown: Vec<_> = standards.value.iter().filter(|name| !known.contains(&name.value.as_str())).collect();
        for name in &unknown {
            let message = format!("no cylinder of the catalogue is to `{}`", name.value);
            let report = Diagnostic::error("unknown-name", name.span, message);
            let report = report.did_you_mean(nearest(&name.value, known.iter().copied()));
            let listed: Vec<String> = known.iter().map(|name| format!("`{name}`")).collect();
            asking.report(report.hint(format!("standards there: {}", listed.join(", "))));
        }
        if !unknown.is_empty() {
            return None;
        }
        let wanted = |name: &str| name.is_empty() || standards.value.iter().any(|one| one.value == name);
        cylinders.retain(|cylinder| wanted(&cylinder.standard));
        if cylinders.is_empty() {
            let message = "`standards` names none, so no cylinder is left".to_owned();
            asking.error("wrong-length", standards.span, message, "leave `standards` out for all of them");
            return None;
        }
        Some(cylinders.into())
    }
}
