//! `tolerances` and `limits`.

use bellcrank_doc::{Diagnostic, Distribution, Expression, NoSignals, Value, ValueKind};

use super::given::{Given, Told, told};
use crate::design::Scattered;
use crate::keyed::Keyed;
use crate::read::study_keys::Referred;
use crate::schema::{LIMITS, SCATTER};

pub(super) fn read_tolerances(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<Scattered>> {
    let what = keyed.named("tolerances");
    let told = told(of.part, value, &what)?;
    Some(told.into_iter().filter_map(|one| scattered(&one, &format!("`{}` in {what}", one.name), of)).collect())
}

/// What the study says of one parameter: a half width, a table, or nothing.
fn scattered(one: &Told<'_>, what: &str, of: Referred<'_>) -> Option<Scattered> {
    let mut scattered = Scattered::of(one.parameter, one.span);
    let Some(value) = one.value else { return Some(scattered) };
    let dimension = of.part.reader.parameters().all().get(one.parameter)?.dimension;
    if value.as_table().is_none() {
        scattered.half_width = Some(of.part.reader.difference(value, what, dimension)?);
        return Some(scattered);
    }
    let keyed = Keyed::new(of.part.reader.fields(value, what)?, &SCATTER, of.part.space());
    let width = |key| {
        Given::key(&keyed, key, |value| of.part.reader.difference(value, &keyed.named(key), dimension)).optional()
    };
    let (half_width, sigma) = (width("tolerance"), width("sigma"));
    let distribution = Given::key(&keyed, "distribution", |_| {
        keyed.choice("distribution").and_then(|name| Distribution::named(name.value))
    });
    let distribution = distribution.optional();
    keyed.finish();
    (scattered.half_width, scattered.sigma, scattered.distribution) = (half_width?, sigma?, distribution?);
    Some(scattered)
}

/// Lower and upper limit; their dimension is asked once the response is known.
pub(super) fn read_limits(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<[Option<Expression>; 2]> {
    let what = keyed.named("limits");
    let read = |value: &Value, what: &str| of.part.reader.any_quantity(value, what, &mut NoSignals);
    let hint = "`limits = [\"4 kN\", \"5 kN\"]`, or one side alone: `limits = { max = \"5 kN\" }`";
    match &value.kind {
        ValueKind::Faulty => None,
        ValueKind::List(sides) => {
            let [lower, upper] = sides.as_slice() else {
                let message = format!("{what} needs two values, lower and upper; found {}", sides.len());
                keyed.report(Diagnostic::error("wrong-length", value.span, message).hint(hint));
                return None;
            };
            let (lower, upper) = (read(lower, &what), read(upper, &what));
            Some([Some(lower?), Some(upper?)])
        }
        ValueKind::Table(_) => {
            let sides = Keyed::new(of.part.reader.fields(value, &what)?, &LIMITS, of.part.space());
            let side = |key| Given::key(&sides, key, |value| read(value, &sides.named(key))).optional();
            let (lower, upper) = (side("min"), side("max"));
            let empty = !sides.has("min") && !sides.has("max");
            sides.finish();
            if empty {
                let message = format!("{what} has neither `min` nor `max`");
                keyed.report(Diagnostic::error("missing-key", value.span, message).hint(hint));
                return None;
            }
            Some([lower?, upper?])
        }
        _ => {
            let message = format!("{what} needs two values, lower and upper; found {}", value.describe());
            keyed.report(Diagnostic::error("wrong-type", value.span, message).hint(hint));
            None
        }
    }
}
