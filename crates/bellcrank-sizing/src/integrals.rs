//! Integrals over rows; between two rows a quantity is a straight line.

use crate::Row;

/// Neighbouring rows.
pub(crate) fn steps(rows: &[Row]) -> impl Iterator<Item = (&Row, &Row)> {
    rows.iter().zip(rows.iter().skip(1))
}

/// Time of each step, s, from dt = dx / v with v the mean of both ends: exact at constant acceleration. `None` where
/// the speed does not lead from one row to the next.
pub(crate) fn durations(rows: &[Row]) -> Option<Vec<f64>> {
    steps(rows).map(|(a, b)| duration(b.position - a.position, (a.velocity + b.velocity) / 2.0)).collect()
}

fn duration(travel: f64, speed: f64) -> Option<f64> {
    if travel == 0.0 {
        return Some(0.0);
    }
    Some(travel / speed).filter(|time| time.is_finite() && *time > 0.0)
}

/// Mean square of a line from `a` to `b`: (a² + a b + b²) / 3.
pub(crate) fn mean_square(a: f64, b: f64) -> f64 {
    (a * a + a * b + b * b) / 3.0
}

/// Mean of a line from `a` to `b` where it is above zero.
pub(crate) fn mean_above(a: f64, b: f64) -> f64 {
    let (low, high) = (a.min(b), a.max(b));
    if low >= 0.0 {
        (a + b) / 2.0
    } else if high <= 0.0 {
        0.0
    } else {
        high * high / (2.0 * (high - low))
    }
}

/// Weighted mean of `f` over the steps; of the only row with itself where there is no step.
pub(crate) fn mean(rows: &[Row], weights: &[f64], f: impl Fn(&Row, &Row) -> f64) -> f64 {
    let total: f64 = weights.iter().sum();
    if total > 0.0 {
        steps(rows).zip(weights).map(|((a, b), weight)| weight / total * f(a, b)).sum()
    } else {
        rows.first().map_or(0.0, |row| f(row, row))
    }
}
