//! Numbers of a study's summary, by their path.

use serde_json::Value;

/// A value of a summary and the units that stand around it, the nearest first.
pub(super) struct Place<'v> {
    pub(super) value: &'v Value,
    pub(super) units: Vec<&'v str>,
}

impl Place<'_> {
    /// A number as it is, true and false as 1 and 0, nothing (`null`) as NaN; no number for anything else.
    pub(super) fn number(&self) -> Option<f64> {
        match self.value {
            Value::Number(number) => number.as_f64(),
            Value::Bool(truth) => Some(f64::from(u8::from(*truth))),
            Value::Null => Some(f64::NAN),
            _ => None,
        }
    }
}

/// Follows a path of keys and places in lists, separated by dots. Keys may hold dots, too (`quantiles.0.5`): the longest
/// that leads to the end is taken.
pub(super) fn find<'v>(value: &'v Value, path: &str) -> Option<Place<'v>> {
    if path.is_empty() {
        return Some(Place { value, units: Vec::new() });
    }
    let mut place = match value {
        Value::Object(object) => {
            let rest = |key: &str| {
                let rest = path.strip_prefix(key)?;
                if rest.is_empty() { Some(rest) } else { rest.strip_prefix('.').filter(|rest| !rest.is_empty()) }
            };
            let mut ways: Vec<(&str, &Value)> =
                object.iter().filter_map(|(key, inner)| rest(key).map(|rest| (rest, inner))).collect();
            ways.sort_by_key(|(rest, _)| rest.len());
            ways.into_iter().find_map(|(rest, inner)| find(inner, rest))
        }
        Value::Array(list) => {
            let (index, rest) = path.split_once('.').unwrap_or((path, ""));
            find(list.get(index.parse::<usize>().ok()?)?, rest)
        }
        _ => None,
    }?;
    if let Value::Object(object) = value {
        let units = object.iter().filter(|(key, _)| *key == "unit" || key.ends_with("_unit"));
        place.units.extend(units.filter_map(|(_, unit)| unit.as_str()));
    }
    Some(place)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::find;

    #[test]
    fn paths_lead_through_keys_with_dots_and_lists() {
        let value = json!({
            "unit": "N", "quantiles": { "0.5": 7.5, "0": { "5": 1 } }, "starts": [{ "point": { "l5": 800.0 } }],
            "fine": true, "none": null, "name": "A",
        });
        let number = |path: &str| find(&value, path).and_then(|place| place.number());
        assert_eq!(number("quantiles.0.5"), Some(7.5));
        assert_eq!(number("quantiles.0.5.5"), None);
        assert_eq!(number("starts.0.point.l5"), Some(800.0));
        assert_eq!((number("fine"), number("name"), number("starts.1")), (Some(1.0), None, None));
        assert!(number("none").is_some_and(f64::is_nan));
        assert_eq!(find(&value, "quantiles.0.5").map(|place| place.units), Some(vec!["N"]));
        assert!(find(&value, "quantiles.").is_none() && find(&value, "").is_some());
    }
}
