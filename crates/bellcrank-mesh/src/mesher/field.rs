//! The size field: the smallest of the sizes wanted anywhere, each growing with the distance from its place.

use super::plan::Plan;
use super::walls::Wall;
use super::{Division, Sizes};

/// Largest angle of an element on an arc that nothing else divides: 30°.
const PER_TURN: f64 = 12.0;

/// Sizes by place in plan.
pub(super) struct Field {
    /// x, y and size, ascending by size.
    sources: Vec<[f64; 3]>,
    /// Growth of the size with the distance.
    slope: f64,
    coarse: f64,
}

impl Field {
    /// Keeps the sources that say more than those before them.
    fn new(mut wanted: Vec<[f64; 3]>, slope: f64, coarse: f64) -> Field {
        wanted.sort_by(|a, b| a[2].total_cmp(&b[2]));
        let mut field = Field { sources: Vec::new(), slope, coarse };
        for source in wanted {
            if field.at([source[0], source[1]]) > 1.02 * source[2] {
                field.sources.push(source);
            }
        }
        field
    }

    pub(super) fn at(&self, [x, y]: [f64; 2]) -> f64 {
        let mut best = self.coarse;
        for &[u, v, size] in &self.sources {
            if size >= best {
                break;
            }
            let reach = (best - size) / self.slope;
            let square = (x - u) * (x - u) + (y - v) * (y - v);
            if square < reach * reach {
                best = size + self.slope * square.sqrt();
            }
        }
        best
    }
}

pub(super) fn of_plan(plan: &Plan, walls: &[Wall], coarse: f64, sizes: &Sizes) -> Field {
    let mut wanted = Vec::new();
    for edge in 0..plan.edges.len() {
        on_edge(plan, edge, coarse, sizes, &mut wanted);
    }
    wanted.extend(walls.iter().map(|wall| [wall.at[0], wall.at[1], across(wall.thickness, coarse, sizes)]));
    if let Some(background) = sizes.background {
        in_background(plan, coarse, background, &mut wanted);
    }
    wanted.retain(|source| source[2] < coarse);
    Field::new(wanted, sizes.growth - 1.0, coarse)
}

/// Several elements across a wall; one across the walls that are thinner than an eighth of the size.
fn across(thickness: f64, coarse: f64, sizes: &Sizes) -> f64 {
    (thickness / sizes.across_walls).max(thickness.min(coarse / 8.0))
}

fn on_edge(plan: &Plan, edge: usize, coarse: f64, sizes: &Sizes, wanted: &mut Vec<[f64; 3]>) {
    let length = plan.length(edge);
    let division = match plan.bores[edge] {
        Some(_) => sizes.at_bores,
        None if plan.concave(edge) => sizes.at_fillets,
        None => Division::PerTurn(PER_TURN),
    };
    let curve = match &plan.edge(edge).curve {
        bellcrank_solid::Curve::Line => coarse,
        bellcrank_solid::Curve::Arc { radius, .. } => division.on(*radius).min(Division::PerTurn(PER_TURN).on(*radius)),
    };
    let size = curve.min(coarse);
    let count = (2.0 * length / size).ceil().max(2.0) as usize;
    // A short edge stays whole: what lies round it starts from its length.
    let size = size.min(length);
    for sample in 0..=count.min(10_000) {
        let [x, y] = plan.at(edge, sample as f64 / count as f64);
        wanted.push([x, y, size]);
    }
}

/// Samples the wanted size on squares that are divided until they are as small as what is wanted in them.
fn in_background(plan: &Plan, coarse: f64, background: &dyn Fn([f64; 3]) -> f64, wanted: &mut Vec<[f64; 3]>) {
    let levels = &plan.stack.levels;
    let mut heights = levels.clone();
    heights.extend(levels.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0));
    let lowest = |[x, y]: [f64; 2]| {
        let sizes = heights.iter().map(|&z| background([x, y, z])).filter(|size| size.is_finite() && *size > 0.0);
        sizes.fold(f64::INFINITY, f64::min)
    };
    for edge in 0..plan.edges.len() {
        let count = (4.0 * plan.length(edge) / coarse).clamp(8.0, 1e4).ceil() as usize;
        let places = (0..=count).map(|sample| plan.at(edge, sample as f64 / count as f64));
        wanted.extend(places.map(|at| [at[0], at[1], lowest(at)]));
    }
    let ends: Vec<[f64; 2]> = (0..plan.edges.len()).flat_map(|edge| plan.ends(edge)).collect();
    let low: [f64; 2] = std::array::from_fn(|i| ends.iter().map(|end| end[i]).fold(f64::INFINITY, f64::min));
    let high: [f64; 2] = std::array::from_fn(|i| ends.iter().map(|end| end[i]).fold(f64::NEG_INFINITY, f64::max));
    let side = (coarse / 2.0).max(plan.extent / 200.0);
    let count = |i: usize| ((high[i] - low[i]) / side).ceil().max(1.0) as usize;
    let mut squares: Vec<([f64; 2], f64, u32)> = Vec::new();
    for i in 0..count(0) {
        for j in 0..count(1) {
            squares.push(([low[0] + (i as f64 + 0.5) * side, low[1] + (j as f64 + 0.5) * side], side, 0));
        }
    }
    while let Some((center, side, depth)) = squares.pop() {
        let size = lowest(center);
        wanted.push([center[0], center[1], size]);
        if size < side / 2.0 && depth < 6 {
            for (u, v) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
                squares.push(([center[0] + u * side / 4.0, center[1] + v * side / 4.0], side / 2.0, depth + 1));
            }
        }
    }
}
