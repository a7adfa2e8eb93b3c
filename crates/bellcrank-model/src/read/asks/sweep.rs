//! `sweep`: responses over designs.

use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Span, Spanned, nearest};

use super::AskKeys;
use super::designs::ReadLevels;
use super::finish::Asking;
use super::given::Given;
use super::keys::{Named, Sides};
use super::optimize::SEED;
use super::table::DesignTable;
use crate::design::{Designs, Levels, Method, NamedResponse, Varied};

/// Designs that a study may have.
const MOST_DESIGNS: f64 = 1e9;

/// Columns beside those of parameters and responses.
const OWN_COLUMNS: [&str; 2] = ["design", "reason"];

/// How the designs lie, put together.
struct Plan {
    method: Method,
    vary: Vec<Varied>,
    /// Names of the columns of parameters.
    columns: Vec<String>,
    table: Arc<Vec<Vec<f64>>>,
    samples: u64,
}

pub(super) fn designs(asking: &Asking<'_>, keys: AskKeys) -> Option<Designs> {
    let AskKeys { responses, vary, method, table, samples, pareto, seed, .. } = keys;
    let responses = responses.optional().flatten().and_then(|all| answered(asking, all));
    let plan = plan(asking, vary, method, table, samples);
    let (responses, pareto) = match responses {
        Some(responses) => {
            let pareto = pareto.optional().and_then(|pareto| front(asking, pareto, &responses));
            (Some(responses), pareto)
        }
        None => (None, None),
    };
    let (plan, responses) = (plan?, responses?);
    no_common_names(asking, &plan.columns, &responses)?;
    Some(Designs {
        responses: responses.into_iter().map(|one| one.response).collect::<Vec<NamedResponse>>(),
        vary: plan.vary,
        method: plan.method,
        table: plan.table,
        samples: plan.samples,
        seed: seed.optional()?.map_or(SEED, |seed| seed.value),
        pareto: pareto?,
    })
}

fn answered(asking: &Asking<'_>, all: Vec<Named>) -> Option<Vec<Named>> {
    let good: Vec<bool> = all.iter().map(|one| asking.answers(&one.response.response.reductions)).collect();
    good.into_iter().all(|good| good).then_some(all)
}

/// Parameters and responses are columns of one table.
fn no_common_names(asking: &Asking<'_>, columns: &[String], responses: &[Named]) -> Option<()> {
    if let Some(one) = responses.iter().find(|one| OWN_COLUMNS.contains(&one.response.name.as_str())) {
        let message = format!("the response `{}` has the name of a column that every sweep has", one.response.name);
        asking.error("duplicate-name", one.name, message, "give the response another name");
        return None;
    }
    let common = responses.iter().find(|one| columns.contains(&one.response.name));
    let Some(one) = common else { return Some(()) };
    let message = format!("the response `{}` has the name of a parameter that this study varies", one.response.name);
    asking.error("duplicate-name", one.name, message, "both are columns of one table: give the response another name");
    None
}

fn plan(
    asking: &Asking<'_>,
    vary: Given<Spanned<Vec<ReadLevels>>>,
    method: Given<Spanned<Method>>,
    table: Given<Spanned<DesignTable>>,
    samples: Given<Spanned<u64>>,
) -> Option<Plan> {
    let implied = if table.is_no() { Method::Grid } else { Method::Table };
    let written = method.is().copied();
    // Nothing is said against what does not go with a method that could not be read.
    let method = method.optional().map(|method| method.map_or(implied, |method| method.value));
    let (vary, table, samples) = (vary.optional(), table.optional(), samples.optional());
    let ranges = vary.as_ref().map(|vary| vary.as_ref().map(|vary| ranges(asking, &vary.value, method)));
    let conflicts = match (&vary, &table) {
        (Some(vary), Some(table)) => conflicts(asking, written, vary.as_ref(), table.as_ref()),
        _ => None,
    };
    let (method, samples) = (method?, samples?);
    let samples = if conflicts.is_some() { number(asking, method, written, samples) } else { None };
    if let Some(table) = table? {
        conflicts?;
        let DesignTable { vary, names, rows } = table.value;
        return Some(Plan { method, vary, columns: names, table: rows, samples: samples? });
    }
    let vary = vary??;
    let count = if method == Method::Grid { grid(asking, &vary) } else { Some(()) };
    conflicts?;
    ranges???;
    count?;
    let columns = vary.value.iter().map(|one| one.name.clone()).collect();
    let vary = vary.value.into_iter().map(|one| one.varied).collect();
    Some(Plan { method, vary, columns, table: Arc::default(), samples: samples? })
}

/// `samples`, where the method takes it; 0 elsewhere.
fn number(
    asking: &Asking<'_>,
    method: Method,
    written: Option<Spanned<Method>>,
    samples: Option<Spanned<u64>>,
) -> Option<u64> {
    match (method, samples) {
        (Method::LatinHypercube | Method::Sobol, None) => {
            let message = format!("`samples` is missing in study `{}`", asking.entry.key);
            let hint = "the methods lhs and sobol need to know how many: `samples = 1000`";
            asking.error("missing-key", written.map_or(asking.entry.key_span, |m| m.span), message, hint);
            None
        }
        (Method::Grid, Some(samples)) => {
            let message = "a grid has no `samples`: its designs are all combinations of the levels".to_owned();
            let hint = "give levels, as `vary = { l5 = 21 }`, or take `method = \"lhs\"` or `\"sobol\"`";
            asking.error("conflicting-keys", samples.span, message, hint);
            None
        }
        (Method::Table, Some(samples)) => {
            let message = "`samples` does not go with a table: its lines are the designs".to_owned();
            asking.error("conflicting-keys", samples.span, message, "leave `samples` out");
            None
        }
        (_, samples) => Some(samples.map_or(0, |samples| samples.value)),
    }
}

/// A table of designs leaves nothing to vary.
fn conflicts(
    asking: &Asking<'_>,
    method: Option<Spanned<Method>>,
    vary: Option<&Spanned<Vec<ReadLevels>>>,
    table: Option<&Spanned<DesignTable>>,
) -> Option<()> {
    let conflict = |span: Span, other: Span, message: &str, hint: &str| {
        let report = Diagnostic::error("conflicting-keys", span, message).also(other, "and this");
        asking.report(report.hint(hint));
        None
    };
    match (method, vary, table) {
        (Some(method), _, Some(table)) if method.value != Method::Table => {
            conflict(method.span, table.span, "a table of designs and another `method`", "leave one of them out")
        }
        (_, Some(vary), Some(table)) => conflict(
            vary.span,
            table.span,
            "`vary` and a table of designs: the table says which parameters change, and how",
            "leave one of them out",
        ),
        (Some(method), Some(vary), None) if method.value == Method::Table => conflict(
            vary.span,
            method.span,
            "`vary` does not go with `method = \"table\"`",
            "give `table = \"designs.csv\"` instead, or another method",
        ),
        _ => Some(()),
    }
}

/// Every range has two ends; levels are those of a grid.
fn ranges(asking: &Asking<'_>, vary: &[ReadLevels], method: Option<Method>) -> Option<()> {
    let good: Vec<bool> = vary.iter().map(|one| range(asking, one, method).is_some()).collect();
    good.into_iter().all(|good| good).then_some(())
}

fn range(asking: &Asking<'_>, one: &ReadLevels, method: Option<Method>) -> Option<()> {
    let parameter = asking.parameter(one.varied.parameter)?;
    let name = &one.name;
    let levels = match (method, one.points) {
        (Some(Method::LatinHypercube | Method::Sobol), Some(span)) => {
            let message = format!("`{name}` has a number of levels, which only a grid has");
            let hint = "with lhs and sobol `samples` is the number of designs; leave the levels out";
            asking.error("conflicting-keys", span, message, hint);
            None
        }
        _ => Some(()),
    };
    let (from, to) = match &one.varied.levels {
        Levels::List(values) => {
            let read: Vec<Option<f64>> = values.iter().map(|value| asking.number(value)).collect();
            return read.into_iter().all(|value| value.is_some()).then_some(()).and(levels);
        }
        Levels::Range { from, to, .. } => (from, to),
    };
    let (first, last) = (asking.optional_number(from.as_ref())?, asking.optional_number(to.as_ref())?);
    let (first, last) = (first.or(parameter.min), last.or(parameter.max));
    let missing = match (first, last) {
        (None, None) => "no range",
        (None, _) => "no lower end",
        (_, None) => "no upper end",
        (Some(first), Some(last)) => {
            if first == last {
                let message = format!("the range of `{name}` begins and ends at one value");
                asking.report(Diagnostic::warning("no-sweep", one.varied.span, message));
            }
            return levels;
        }
    };
    let message = format!("`{name}` has {missing}");
    let report = Diagnostic::error("no-bounds", one.varied.span, message).also(parameter.span, "defined here");
    asking.report(report.hint(format!(
        "write `vary = {{ {name} = {{ from = ..., to = ... }} }}`, or give the parameter `min` and `max`"
    )));
    None
}

/// As many designs as combinations.
fn grid(asking: &Asking<'_>, vary: &Spanned<Vec<ReadLevels>>) -> Option<()> {
    let levels = |one: &ReadLevels| match &one.varied.levels {
        Levels::Range { points, .. } => *points,
        Levels::List(values) => values.len(),
    };
    let counts: Vec<usize> = vary.value.iter().map(levels).collect();
    let product: f64 = counts.iter().map(|&count| count as f64).product();
    if product <= MOST_DESIGNS {
        return Some(());
    }
    let factors: Vec<String> = counts.iter().map(usize::to_string).collect();
    let number = if product < 1e15 { format!("{product}") } else { format!("{product:.1e}") };
    let message = format!("this grid has {} = {number} designs; {MOST_DESIGNS} are allowed", factors.join(" x "));
    let hint = "give fewer `points`, or take `method = \"sobol\"` with `samples`";
    asking.error("out-of-range", vary.span, message, hint);
    None
}

/// The two responses that oppose each other; the outer `None` after an error.
fn front(asking: &Asking<'_>, pareto: Option<Sides>, responses: &[Named]) -> Option<Option<[(usize, bool); 2]>> {
    let Some(pareto) = pareto else { return Some(None) };
    let names = || responses.iter().map(|one| one.response.name.as_str());
    let find = |(name, small): &(Spanned<String>, bool)| {
        let found = names().position(|known| known == name.value);
        if found.is_none() {
            let message = format!("study `{}` has no response `{}`", asking.entry.key, name.value);
            let report = Diagnostic::error("unknown-name", name.span, message);
            let known: Vec<String> = names().map(|name| format!("`{name}`")).collect();
            asking.report(match nearest(&name.value, names()) {
                Some(near) => report.did_you_mean(Some(near)),
                None => report.hint(format!("its responses: {}", known.join(", "))),
            });
        }
        Some((found?, *small))
    };
    let found = super::keys::all(pareto.value.iter().map(find))?;
    if let Ok(two) = <[(usize, bool); 2]>::try_from(found.as_slice()) {
        return Some(Some(two));
    }
    let message = format!("`pareto` needs two responses, found {}", found.len());
    let hint = "two responses that oppose each other, as `pareto = { force = \"min\", stroke = \"max\" }`";
    asking.error("wrong-length", pareto.span, message, hint);
    None
}
