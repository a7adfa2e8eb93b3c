//! Division of the height into layers.

use super::Sizes;
use super::plan::Plan;

/// Elements may be this much wider than high where only the background asks for small ones.
const ASPECT: f64 = 4.0;

/// Layers of elements.
pub(super) struct Levels {
    /// Heights, ascending, one more than there are layers.
    pub(super) z: Vec<f64>,
    /// Interval of the stack that each layer lies in.
    pub(super) interval: Vec<usize>,
}

impl Levels {
    pub(super) fn layers(&self) -> usize {
        self.interval.len()
    }

    /// Height by half level: whole levels are even.
    pub(super) fn half(&self, half: usize) -> f64 {
        let low = self.z[half / 2];
        if half.is_multiple_of(2) { low } else { (low + self.z[half / 2 + 1]) / 2.0 }
    }
}

pub(super) fn levels(plan: &Plan, coarse: f64, sizes: &Sizes) -> Levels {
    let stack = plan.stack;
    let heights: Vec<f64> = stack.levels.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let size = |interval: usize| wanted(plan, interval, coarse, sizes);
    let mut counts: Vec<usize> = heights
        .iter()
        .enumerate()
        .map(|(i, height)| (height / size(i) - 1e-9).ceil().clamp(1.0, 1e4) as usize)
        .collect();
    for cell in &stack.cells {
        for run in runs(&cell.filled) {
            while run.clone().map(|i| counts[i]).sum::<usize>() < sizes.layers_across {
                let tallest = run
                    .clone()
                    .max_by(|&i, &j| (heights[i] / counts[i] as f64).total_cmp(&(heights[j] / counts[j] as f64)));
                counts[tallest.unwrap_or(run.start)] += 1;
            }
        }
    }
    let mut levels = Levels { z: stack.levels[..1].to_vec(), interval: Vec::new() };
    for (i, &count) in counts.iter().enumerate() {
        for k in 1..count {
            levels.z.push(stack.levels[i] + heights[i] * k as f64 / count as f64);
        }
        levels.z.push(stack.levels[i + 1]);
        levels.interval.extend(std::iter::repeat_n(i, count));
    }
    levels
}

/// Longest stretches of filled intervals.
fn runs(filled: &[bool]) -> Vec<std::ops::Range<usize>> {
    let mut runs: Vec<std::ops::Range<usize>> = Vec::new();
    for i in (0..filled.len()).filter(|&i| filled[i]) {
        match runs.last_mut() {
            Some(run) if run.end == i => run.end = i + 1,
            _ => runs.push(i..i + 1),
        }
    }
    runs
}

/// Places of an edge where the background is asked for the height of layers.
const ASKED: usize = 16;

/// Height of a layer that is wanted in an interval, asked along the edges: stresses are highest at the surface.
fn wanted(plan: &Plan, interval: usize, coarse: f64, sizes: &Sizes) -> f64 {
    let Some(background) = sizes.background else { return coarse };
    let [low, high] = [plan.stack.levels[interval], plan.stack.levels[interval + 1]];
    let here = |edge: &usize| plan.sides[*edge].iter().any(|&side| plan.patterns[side][interval]);
    let places = (0..plan.edges.len())
        .filter(here)
        .flat_map(|edge| (0..ASKED).map(move |k| plan.at(edge, k as f64 / ASKED as f64)));
    let heights = [low, (low + high) / 2.0, high];
    let all = places.flat_map(|[x, y]| heights.map(|z| background([x, y, z])));
    all.filter(|size| size.is_finite() && *size > 0.0).fold(coarse, |least, size| least.min(ASPECT * size))
}

/// One layer of one interval: a plane.
pub(super) fn single() -> Levels {
    Levels { z: vec![0.0, 1.0], interval: vec![0] }
}
