//! From many samples to the few points that draw the same line.

use super::svg::push_px;

/// Largest distance, in pixels, between the samples and the drawn line.
const TOLERANCE: f64 = 0.1;

/// Path data of a line through `points` (px); samples that are not finite break it.
pub(crate) fn path(points: &[(f64, f64)]) -> String {
    let mut text = String::new();
    for run in points.split(|(x, y)| !(x.is_finite() && y.is_finite())) {
        push_run(&mut text, run);
    }
    text
}

fn push_run(text: &mut String, run: &[(f64, f64)]) {
    for (index, (x, y)) in thinned(run).into_iter().enumerate() {
        text.push(if index == 0 { 'M' } else { 'L' });
        push_px(text, x);
        text.push(' ');
        push_px(text, y);
    }
}

/// Keeps the points where the line turns: a Douglas–Peucker subdivision with its own stack.
fn thinned(run: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let Some(last) = run.len().checked_sub(1) else { return Vec::new() };
    let mut keep = vec![false; run.len()];
    keep[0] = true;
    keep[last] = true;
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        if let Some(turn) = turn(run, from, to) {
            keep[turn] = true;
            open.extend([(from, turn), (turn, to)]);
        }
    }
    run.iter().zip(keep).filter_map(|(point, keep)| keep.then_some(*point)).collect()
}

/// The sample between `from` and `to` farthest from their chord, if it lies off the line.
fn turn(run: &[(f64, f64)], from: usize, to: usize) -> Option<usize> {
    let (a, b) = (run[from], run[to]);
    let chord = (b.0 - a.0, b.1 - a.1);
    let length = chord.0.hypot(chord.1);
    let distance = |p: (f64, f64)| {
        let d = (p.0 - a.0, p.1 - a.1);
        // A closed loop has no chord: then the distance is that to its start.
        if length < TOLERANCE { d.0.hypot(d.1) } else { (chord.0 * d.1 - chord.1 * d.0).abs() / length }
    };
    let inner = (from + 1..to).map(|index| (index, distance(run[index])));
    let (index, far) = inner.max_by(|a, b| a.1.total_cmp(&b.1))?;
    (far > TOLERANCE).then_some(index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn straight_samples_become_one_line() {
        let points: Vec<_> = (0..100).map(|i| (f64::from(i), 2.0 * f64::from(i))).collect();
        assert_eq!(path(&points), "M0 0L99 198");
    }

    #[test]
    fn a_circle_keeps_its_shape_with_few_points() {
        let circle: Vec<_> = (0..=600)
            .map(|i| f64::from(i) * std::f64::consts::TAU / 600.0)
            .map(|a| (100.0 * a.cos(), 100.0 * a.sin()))
            .collect();
        let kept = thinned(&circle).len();
        assert!((40..160).contains(&kept), "{kept}");
    }

    #[test]
    fn undefined_samples_break_the_line() {
        let gap = [(0.0, 0.0), (1.0, 0.0), (2.0, f64::NAN), (3.0, 1.0), (4.0, 1.0)];
        assert_eq!(path(&gap), "M0 0L1 0M3 1L4 1");
        assert_eq!(path(&[]), "");
    }
}
