//! `tolerance`: scatter of a response.

use bellcrank_doc::{Diagnostic, Distribution, Expression, Response, Spread};

use super::AskKeys;
use super::finish::Asking;
use super::optimize::SEED;
use crate::design::{Scattered, Tolerance};

/// Machines that are drawn, unless given.
const SAMPLES: u64 = 10_000;

pub(super) fn tolerance(asking: &Asking<'_>, keys: AskKeys) -> Option<Tolerance> {
    let response = keys.response.optional().flatten();
    let limits = keys.limits.or_else(|| [None, None]);
    let limits = limits.and_then(|limits| checked_limits(asking, limits, response.as_ref()));
    let response = asking.response(response);
    let default = keys.distribution.optional();
    let scattered = match keys.tolerances.optional() {
        Some(None) => all_with_a_tolerance(asking),
        named => named.flatten(),
    };
    let in_doubt = default.flatten().unwrap_or(Distribution::Normal);
    let scattered = scattered
        .and_then(|scattered| super::keys::all(scattered.into_iter().map(|one| checked(asking, one, in_doubt))));
    default?;
    Some(Tolerance {
        response: response?,
        scattered: scattered?,
        limits: limits?,
        samples: keys.samples.optional()?.map_or(SAMPLES, |samples| samples.value),
        seed: keys.seed.optional()?.map_or(SEED, |seed| seed.value),
        sobol: keys.sobol.or_else(|| false)?,
    })
}

fn all_with_a_tolerance(asking: &Asking<'_>) -> Option<Vec<Scattered>> {
    let wide = |spread: Spread| spread.half_width.is_some() || spread.sigma.is_some();
    let all = asking.parameters.all().iter().enumerate().filter(|(_, parameter)| wide(parameter.spread));
    let all: Vec<Scattered> = all.map(|(index, parameter)| Scattered::of(index, parameter.span)).collect();
    if all.is_empty() && !asking.has_faulty_parameters() {
        let message = format!("study `{}` has no tolerances, and no parameter has one", asking.entry.key);
        let hint = "write `tolerances = { l5 = \"0.1 mm\" }` here, or `l5 = \"950 ± 0.1 mm\"` at the parameters";
        asking.error("no-tolerance", asking.entry.key_span, message, hint);
        return None;
    }
    Some(all)
}

/// Widths that are there, and fit the distribution; which distribution it is.
fn checked(asking: &Asking<'_>, mut one: Scattered, default: Distribution) -> Option<Scattered> {
    let parameter = asking.parameter(one.parameter)?;
    let name = &parameter.name;
    let widths = [("tolerance", &one.half_width), ("`sigma`", &one.sigma)];
    let good = widths.map(|(what, width)| not_negative(asking, width.as_ref(), &format!("the {what} of `{name}`")));
    if good.contains(&None) {
        return None;
    }
    let spread = one.spread(asking.parameters, asking.parameters.values());
    let distribution = spread.distribution.unwrap_or(default);
    let fault = |code, message: String, hint: String| {
        let report = Diagnostic::error(code, one.span, message);
        let report = if one.span == parameter.span { report } else { report.also(parameter.span, "defined here") };
        asking.report(report.hint(hint));
        None
    };
    match (spread.half_width, spread.sigma, distribution) {
        (None, None, _) => {
            let hint = format!("write `tolerances = {{ {name} = \"...\" }}`, or `tolerance` at the parameter");
            fault("no-tolerance", format!("`{name}` has no tolerance"), hint)
        }
        (_, Some(_), Distribution::Uniform) if one.sigma.is_some() || spread.half_width.is_none() => fault(
            "tolerance",
            format!("`{name}` is uniform and cannot have a `sigma`"),
            "a uniform distribution is as wide as the tolerance; `sigma` goes with `normal` and `truncated`".to_owned(),
        ),
        (None, _, Distribution::Truncated) => fault(
            "tolerance",
            format!("`{name}` is truncated, but has no tolerance to be cut off at"),
            "give `tolerance` beside `sigma`, or take `distribution = \"normal\"`".to_owned(),
        ),
        _ => {
            one.distribution = Some(distribution);
            Some(one)
        }
    }
}

fn not_negative(asking: &Asking<'_>, width: Option<&Expression>, what: &str) -> Option<()> {
    let value = asking.optional_number(width)?;
    match (value, width) {
        (Some(value), Some(width)) if value < 0.0 => {
            let report = Diagnostic::error("tolerance", width.span(), format!("{what} is negative"));
            asking.report(report.hint("it is a width: 0 or more"));
            None
        }
        _ => Some(()),
    }
}

/// Limits that measure what the response does, the lower below the upper.
fn checked_limits(
    asking: &Asking<'_>,
    limits: [Option<Expression>; 2],
    response: Option<&Response>,
) -> Option<[Option<Expression>; 2]> {
    let wanted = response?.value.dimension();
    let mut good = true;
    for limit in limits.iter().flatten().filter(|limit| !limit.fits(wanted)) {
        let found = limit.dimension();
        let message = format!("`limits` needs {}, found {}", wanted.phrase(), found.phrase());
        let report = Diagnostic::error("dimension", limit.span(), message).label(found.phrase());
        let of = response.map(|response| (response.span(), format!("the response is {}", wanted.phrase())));
        asking.report(of.into_iter().fold(report, |report, (span, label)| report.also(span, label)));
        good = false;
    }
    let values = [asking.optional_number(limits[0].as_ref()), asking.optional_number(limits[1].as_ref())];
    if !good {
        return None;
    }
    if let ([Some(Some(low)), Some(Some(high))], [Some(lower), Some(upper)]) = (values, &limits)
        && low > high
    {
        let message = "the lower limit is above the upper limit";
        let report = Diagnostic::error("bounds", lower.span(), message).label("lower limit");
        asking.report(report.also(upper.span(), "upper limit"));
        return None;
    }
    (values[0].is_some() && values[1].is_some()).then_some(limits)
}
