//! Numbers and names as JSON values.

use serde_json::{Map, Value, json};

use crate::Unit;

/// Names and what belongs to them, in their order.
pub(super) fn named<T>(pairs: &[(String, T)], value: impl Fn(&T) -> Value) -> Value {
    Value::Object(pairs.iter().map(|(name, of)| (name.clone(), value(of))).collect())
}

/// An object of keys known here.
pub(super) fn object<const N: usize>(pairs: [(&str, Value); N]) -> Map<String, Value> {
    pairs.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

/// A count without a decimal point, any other number as it is.
pub(super) fn whole(value: f64) -> Value {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    if value.fract() == 0.0 && value.abs() < EXACT { json!(value as i64) } else { json!(value) }
}

/// An SI value in `unit`; `null` where it is not finite.
///
/// Converted numbers are rounded to 15 digits: that is all a conversion leaves, and it makes
/// −30 degrees read `-30.0`, not `-29.999999999999996`.
pub(super) fn shown(si: f64, unit: &Unit) -> Value {
    json!(rounded(si, unit))
}

/// The number behind [`shown`].
pub(crate) fn rounded(si: f64, unit: &Unit) -> f64 {
    let value = unit.show(si);
    if unit.factor == 1.0 || !value.is_finite() {
        return value;
    }
    let rounded = format!("{value:.14e}");
    rounded.parse().unwrap_or(value)
}

/// A value with its unit.
pub(crate) fn quantity(si: f64, unit: &Unit) -> Value {
    json!({ "value": shown(si, unit), "unit": unit.symbol })
}

/// An SI value that may be missing.
pub(super) fn maybe(si: Option<f64>, unit: &Unit) -> Value {
    si.map_or(Value::Null, |si| shown(si, unit))
}

/// By how much a number has changed, as a share of where it began; not finite where it began at zero.
pub(crate) fn change(start: f64, value: f64) -> f64 {
    if start == 0.0 { f64::NAN } else { (value - start) / start.abs() }
}
