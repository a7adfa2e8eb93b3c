//! A curve through the points of a table with continuous second derivative.

use super::Jet;
use crate::scalar::Scalar;

/// A cubic spline with not-a-knot ends: cubics pass through it unchanged.
#[derive(Debug, PartialEq)]
pub(crate) struct Spline {
    times: Vec<f64>,
    values: Vec<f64>,
    /// Second derivatives at the points.
    bends: Vec<f64>,
}

impl Spline {
    /// Through the points; at least two, times increasing.
    pub(crate) fn through(times: Vec<f64>, values: Vec<f64>) -> Option<Spline> {
        let increasing = times.windows(2).all(|pair| pair[0] < pair[1]);
        if times.len() < 2 || times.len() != values.len() || !increasing {
            return None;
        }
        let bends = bends(&times, &values);
        Some(Spline { times, values, bends })
    }

    /// Time of the first and of the last point.
    pub(crate) fn span(&self) -> (f64, f64) {
        (self.times[0], self.times[self.times.len() - 1])
    }

    /// The last value.
    pub(crate) fn last(&self) -> f64 {
        self.values[self.values.len() - 1]
    }

    /// Value and derivatives; outside of the table the nearest end, at rest.
    pub(crate) fn at<T: Scalar>(&self, time: T) -> Jet<T> {
        let last = self.times.len() - 1;
        if time.value() < self.times[0] {
            return Jet::from(self.values[0]);
        }
        if time.value() > self.times[last] {
            return Jet::from(self.values[last]);
        }
        let i = self.times.partition_point(|&t| t <= time.value()).clamp(1, last);
        self.between(i - 1, time)
    }

    fn between<T: Scalar>(&self, i: usize, time: T) -> Jet<T> {
        let c = T::from_f64;
        let (from, to) = (c(self.times[i]), c(self.times[i + 1]));
        let h = to - from;
        let (a, b) = ((to - time) / h, (time - from) / h);
        let (y0, y1, m0, m1) = (c(self.values[i]), c(self.values[i + 1]), c(self.bends[i]), c(self.bends[i + 1]));
        let (one, three, six) = (c(1.0), c(3.0), c(6.0));
        Jet::new(
            a * y0 + b * y1 + h * h / six * (a * (a * a - one) * m0 + b * (b * b - one) * m1),
            (y1 - y0) / h + h / six * ((one - three * a * a) * m0 + (three * b * b - one) * m1),
            a * m0 + b * m1,
        )
    }
}

/// Second derivatives at the points: a tridiagonal system, its ends folded in.
fn bends(times: &[f64], values: &[f64]) -> Vec<f64> {
    let n = times.len();
    let h: Vec<f64> = times.windows(2).map(|t| t[1] - t[0]).collect();
    let slope: Vec<f64> = values.windows(2).zip(&h).map(|(y, h)| (y[1] - y[0]) / h).collect();
    match n {
        2 => vec![0.0; 2],
        3 => vec![2.0 * (slope[1] - slope[0]) / (h[0] + h[1]); 3],
        _ => not_a_knot(&h, &slope),
    }
}

fn not_a_knot(h: &[f64], slope: &[f64]) -> Vec<f64> {
    let n = h.len() + 1;
    let last = n - 2;
    let mut diagonal: Vec<f64> = (1..=last).map(|i| 2.0 * (h[i - 1] + h[i])).collect();
    let mut upper: Vec<f64> = (1..=last).map(|i| h[i]).collect();
    let mut lower: Vec<f64> = (1..=last).map(|i| h[i - 1]).collect();
    let mut right: Vec<f64> = (1..=last).map(|i| 6.0 * (slope[i] - slope[i - 1])).collect();
    // The third derivative is the same on both sides of the second and of the last but one point.
    let (first, end) = (h[0], h[last]);
    diagonal[0] += first * (1.0 + first / h[1]);
    upper[0] -= first * first / h[1];
    let m = diagonal.len() - 1;
    diagonal[m] += end * (1.0 + end / h[last - 1]);
    lower[m] -= end * end / h[last - 1];
    for i in 1..=m {
        let factor = lower[i] / diagonal[i - 1];
        diagonal[i] -= factor * upper[i - 1];
        right[i] -= factor * right[i - 1];
    }
    let mut bends = vec![0.0; n];
    for i in (0..=m).rev() {
        bends[i + 1] = (right[i] - upper[i] * if i < m { bends[i + 2] } else { 0.0 }) / diagonal[i];
    }
    bends[0] = bends[1] - first / h[1] * (bends[2] - bends[1]);
    bends[n - 1] = bends[n - 2] + end / h[last - 1] * (bends[n - 2] - bends[n - 3]);
    bends
}
