//! Scatter of a response from tolerances.

use serde_json::{Map, Value, json};

use super::super::values::{maybe, object, shown};
use crate::{HistogramBin, MonteCarlo, SobolIndices, Tolerance, ToleranceInput, Unit, Yield};

pub(super) fn keys(found: &Tolerance) -> Map<String, Value> {
    let unit = &found.unit;
    let ends =
        |(low, high): (f64, f64)| json!({ "min": shown(low, unit), "max": shown(high, unit), "unit": unit.symbol });
    object([
        ("of", json!(found.of)),
        ("response", response(found)),
        ("limits", limits(found)),
        ("worst_case", ends(found.worst_case)),
        ("worst_case_exact", found.worst_case_exact.map_or(Value::Null, ends)),
        ("linear", linear(found)),
        ("tolerances", Value::Object(found.inputs.iter().map(input).collect())),
        ("monte_carlo", found.monte_carlo.as_ref().map_or(Value::Null, |run| monte_carlo(run, unit))),
        ("cp", json!(found.capability.0)),
        ("cpk", json!(found.capability.1)),
    ])
}

fn response(found: &Tolerance) -> Value {
    json!({
        "value": shown(found.nominal, &found.unit),
        "unit": found.unit.symbol,
        "expression": found.response,
    })
}

fn limits(found: &Tolerance) -> Value {
    let (low, high) = found.limits;
    json!({ "min": maybe(low, &found.unit), "max": maybe(high, &found.unit), "unit": found.unit.symbol })
}

/// The linear estimate has the nominal value as its mean.
fn linear(found: &Tolerance) -> Value {
    json!({
        "mean": shown(found.nominal, &found.unit),
        "deviation": shown(found.linear_deviation, &found.unit),
        "unit": found.unit.symbol,
        "yield": found.linear_yield,
    })
}

fn input(of: &ToleranceInput) -> (String, Value) {
    let value = json!({
        "nominal": shown(of.nominal, &of.unit),
        "unit": of.unit.symbol,
        "half_width": shown(of.half_width, &of.unit),
        "distribution": of.distribution,
        "deviation": shown(of.deviation, &of.unit),
        "derivative": shown(of.derivative, &of.derivative_unit),
        "derivative_unit": of.derivative_unit.symbol,
        "variance_share": of.variance_share,
        "worst_share": of.worst_share,
        "sobol": of.sobol.map(sobol),
    });
    (of.name.clone(), value)
}

fn sobol(of: SobolIndices) -> Value {
    let index = |(value, error): (f64, f64)| json!({ "value": value, "error": error });
    json!({ "first": index(of.first), "total": index(of.total) })
}

fn monte_carlo(run: &MonteCarlo, unit: &Unit) -> Value {
    let quantile = |(share, si): &(f64, f64)| (share.to_string(), shown(*si, unit));
    json!({
        "samples": run.samples,
        "seed": run.seed,
        "failed": run.failed,
        "unit": unit.symbol,
        "mean": shown(run.mean.0, unit),
        "mean_error": shown(run.mean.1, unit),
        "deviation": shown(run.deviation.0, unit),
        "deviation_error": shown(run.deviation.1, unit),
        "min": shown(run.range.0, unit),
        "max": shown(run.range.1, unit),
        "quantiles": run.quantiles.iter().map(quantile).collect::<Map<_, _>>(),
        "yield": run.within.map(within),
        "histogram": run.histogram.iter().map(|bin| of_bin(bin, unit)).collect::<Vec<_>>(),
    })
}

fn within(of: Yield) -> Value {
    json!({ "share": of.share, "low": of.interval.0, "high": of.interval.1 })
}

fn of_bin(bin: &HistogramBin, unit: &Unit) -> Value {
    json!({ "from": shown(bin.from, unit), "to": shown(bin.to, unit), "count": bin.count })
}
