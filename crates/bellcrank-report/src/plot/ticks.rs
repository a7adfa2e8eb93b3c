//! Where the marks of an axis stand.

use crate::number;

/// Marks of an axis and the span they cover, display numbers.
pub(crate) struct Ticks {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) marks: Vec<f64>,
    step: f64,
}

impl Ticks {
    /// About `count` marks over `from … to`, which may be narrowed or empty.
    pub(crate) fn new(span: (f64, f64), count: f64, unit: &str) -> Self {
        let (from, to) = span;
        let step = step((to - from) / count, unit);
        let first = (from / step - 1e-9).ceil();
        let marks = (0..64)
            .map(|index| (first + f64::from(index)) * step)
            .take_while(|mark| *mark <= to + 1e-9 * step)
            .collect();
        Self { from, to, marks, step }
    }

    /// From mark to mark.
    pub(crate) fn step(&self) -> f64 {
        self.step
    }

    /// The text at a mark.
    pub(crate) fn text(&self, mark: f64) -> String {
        let size = self.from.abs().max(self.to.abs());
        if !(1e-4..1e7).contains(&size) {
            let digits = 1 + (size / self.step).log10().max(0.0).ceil() as usize;
            let zero = mark.abs() < 1e-9 * self.step;
            let text = number::significant(if zero { 0.0 } else { mark }, digits);
            return number::typeset(&text);
        }
        let decimals = (-self.step.log10() - 1e-9).ceil().clamp(0.0, 12.0) as usize;
        let text = number::aligned(mark, Some(decimals));
        number::typeset(&text)
    }
}

/// The span of finite `values`, widened so that lines do not lie on the frame.
pub(crate) fn span(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return (-1.0, 1.0);
    }
    let middle = f64::midpoint(low, high);
    // What varies only by rounding is drawn as the constant it is.
    let half = (high - low) / 2.0;
    if half < 1e-9 * middle.abs().max(1e-3) {
        let half = if middle.abs() < 1e-9 { 1.0 } else { 0.1 * middle.abs() };
        return (middle - half, middle + half);
    }
    (low - margin * half * 2.0, high + margin * half * 2.0)
}

/// The round step next above `raw`; angles in degrees step by parts of a turn.
fn step(raw: f64, unit: &str) -> f64 {
    const DEGREES: [f64; 7] = [10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0];
    let angle = DEGREES.into_iter().find(|step| *step >= raw);
    match angle {
        Some(step) if unit == "deg" && raw > 5.0 => step,
        _ => round_step(raw),
    }
}

fn round_step(raw: f64) -> f64 {
    let power = 10_f64.powf(raw.log10().floor());
    let lead = [1.0, 2.0, 5.0].into_iter().find(|lead| lead * power >= raw * (1.0 - 1e-9));
    lead.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(span: (f64, f64), unit: &str) -> Vec<String> {
        let ticks = Ticks::new(span, 6.0, unit);
        ticks.marks.iter().map(|mark| ticks.text(*mark)).collect()
    }

    #[test]
    fn marks_are_round() {
        assert_eq!(texts((-30.0, 30.0), "deg"), ["−30", "−20", "−10", "0", "10", "20", "30"]);
        assert_eq!(texts((0.0, 360.0), "deg"), ["0", "60", "120", "180", "240", "300", "360"]);
        assert_eq!(texts((0.0, 5.0), ""), ["0", "1", "2", "3", "4", "5"]);
        assert_eq!(texts((0.0, 0.6), ""), ["0.0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6"]);
        assert_eq!(texts((0.0, 1.1), "s"), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(texts((0.0, 3e-9), "m"), ["0", "5e−10", "1e−9", "1.5e−9", "2e−9", "2.5e−9", "3e−9"]);
    }

    #[test]
    fn flat_and_empty_spans_are_opened() {
        assert_eq!(span([5.0, 5.0].into_iter(), 0.05), (4.5, 5.5));
        assert_eq!(span([1e-17, -1e-17].into_iter(), 0.05), (-1.0, 1.0));
        assert_eq!(span([f64::NAN].into_iter(), 0.05), (-1.0, 1.0));
    }
}
