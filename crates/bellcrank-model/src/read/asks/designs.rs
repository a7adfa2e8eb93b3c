//! `vary`: parameters and the values they take.

use bellcrank_doc::{Diagnostic, Dimension, Expression, Span, Value, ValueKind};

use super::given::{Given, Told, told};
use crate::design::{Levels, Varied};
use crate::keyed::Keyed;
use crate::read::study_keys::Referred;
use crate::schema::RANGE;

/// Levels of a range in a grid, unless given.
const LEVELS: usize = 11;
const MOST_LEVELS: i64 = 1_000_000;

/// The values of one parameter, and where their number is given.
#[derive(Clone, Debug)]
pub(crate) struct ReadLevels {
    pub(super) name: String,
    pub(super) varied: Varied,
    pub(super) points: Option<Span>,
}

impl ReadLevels {
    pub(super) fn without_points(&mut self) {
        self.points = None;
        if let Levels::Range { points, .. } = &mut self.varied.levels {
            *points = LEVELS;
        }
    }
}

pub(super) fn read_vary(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<ReadLevels>> {
    let what = keyed.named("vary");
    let told = told(of.part, value, &what)?;
    Some(
        told.into_iter()
            .filter_map(|one| {
                let what = format!("`{}` in {what}", one.name);
                let (levels, points) = levels(&one, &what, of)?;
                let varied = Varied { parameter: one.parameter, span: one.span, levels };
                Some(ReadLevels { name: one.name.to_owned(), varied, points })
            })
            .collect(),
    )
}

/// The values of a parameter: a table, a list, a number of levels, or its own bounds.
fn levels(one: &Told<'_>, what: &str, of: Referred<'_>) -> Option<(Levels, Option<Span>)> {
    let reader = of.part.reader;
    let range = |points| Levels::Range { from: None, to: None, points };
    let Some(value) = one.value else { return Some((range(LEVELS), None)) };
    let dimension = reader.parameters().all().get(one.parameter)?.dimension;
    match &value.kind {
        ValueKind::Faulty => None,
        ValueKind::Integer(_) => {
            let points = reader.integer(value, &format!("{what} is a number of levels and"), 2..=MOST_LEVELS)?;
            Some((range(usize::try_from(points.value).ok()?), Some(value.span)))
        }
        ValueKind::List(values) => Some((Levels::List(list(value, values, what, dimension, of)?), None)),
        ValueKind::Table(_) => table(value, what, dimension, of),
        _ => {
            let message =
                format!("{what} needs a range, a list of values or a number of levels, found {}", value.describe());
            let hint =
                format!("`{{ from = ..., to = ..., points = {LEVELS} }}`, `[\"900 mm\", \"950 mm\"]`, or `{LEVELS}`");
            reader.report(Diagnostic::error("wrong-type", value.span, message).hint(hint));
            None
        }
    }
}

fn list(
    value: &Value,
    values: &[Value],
    what: &str,
    dimension: Dimension,
    of: Referred<'_>,
) -> Option<Vec<Expression>> {
    if values.is_empty() {
        of.part.reader.report(Diagnostic::error("wrong-length", value.span, format!("{what} lists no value")));
        return None;
    }
    of.part.reader.vector(value, what, &vec![dimension; values.len()])
}

fn table(value: &Value, what: &str, dimension: Dimension, of: Referred<'_>) -> Option<(Levels, Option<Span>)> {
    let keyed = Keyed::new(of.part.reader.fields(value, what)?, &RANGE, of.part.space());
    let (from, to) = (end(&keyed, ["from", "min"], dimension), end(&keyed, ["to", "max"], dimension));
    let points = super::given::whole(&keyed, "points").optional();
    keyed.finish();
    let (from, to, points) = (from?, to?, points?);
    let count = points.map_or(Some(LEVELS), |points| usize::try_from(points.value).ok())?;
    Some((Levels::Range { from, to, points: count }, points.map(|points| points.span)))
}

/// One end of a range, by one of two words; the outer `None` after an error.
fn end(keyed: &Keyed<'_>, words: [&'static str; 2], dimension: Dimension) -> Option<Option<Expression>> {
    let read = words.map(|word| Given::key(keyed, word, |_| keyed.free(word, dimension)));
    if let [Some(first), Some(second)] = words.map(|word| keyed.value(word)) {
        let message = format!("`{}` and `{}` are two words for one end; give one", words[0], words[1]);
        keyed.report(Diagnostic::error("conflicting-keys", second.span, message).also(first.span, "and this"));
        return None;
    }
    let [first, second] = read;
    first.or(second).optional()
}
