//! Thickness of walls in plan, measured layer by layer along the normals of their edges.

use bellcrank_solid::Curve;

use super::plan::Plan;

/// Thickness of the wall behind a place of an edge.
pub(super) struct Wall {
    pub(super) at: [f64; 2],
    pub(super) thickness: f64,
}

/// Samples on each edge, and no further apart than this part of the extent.
const SAMPLES: f64 = 4.0;
const SPACING: f64 = 1.0 / 60.0;

pub(super) fn measure(plan: &Plan) -> Vec<Wall> {
    let mut walls = Vec::new();
    for edge in 0..plan.edges.len() {
        let count = (plan.length(edge) / (SPACING * plan.extent)).clamp(SAMPLES, 200.0).ceil() as usize;
        for sample in 0..count {
            let fraction = (sample as f64 + 0.5) / count as f64;
            if let Some(thickness) = behind(plan, edge, fraction) {
                walls.push(Wall { at: plan.at(edge, fraction), thickness });
            }
        }
    }
    walls
}

/// Shortest way through the material of one layer to its opposite edge, over the layers that end here.
fn behind(plan: &Plan, edge: usize, fraction: f64) -> Option<f64> {
    let [left, right] = plan.sides[edge];
    let (at, normal) = (plan.at(edge, fraction), plan.left(edge, fraction));
    let layers = 0..plan.patterns[0].len();
    let ways = layers.filter_map(|layer| {
        let inward = match (plan.patterns[left][layer], plan.patterns[right][layer]) {
            (true, false) => normal,
            (false, true) => normal.map(|c| -c),
            _ => return None,
        };
        first_hit(plan, edge, layer, at, inward)
    });
    ways.reduce(f64::min)
}

fn first_hit(plan: &Plan, from: usize, layer: usize, at: [f64; 2], along: [f64; 2]) -> Option<f64> {
    let ends_here = |side: &[usize; 2]| plan.patterns[side[0]][layer] != plan.patterns[side[1]][layer];
    let others = (0..plan.edges.len()).filter(|&other| ends_here(&plan.sides[other]));
    let hits = others.filter_map(|other| {
        let way = hit(plan, other, at, along, if other == from { 1e-6 } else { 1e-9 })?;
        let [a, b] = [from, other].map(|edge| plan.edge(edge).ends);
        let corner = a.iter().any(|end| b.contains(end)) && !opposite(plan, other, at, along, way);
        (!corner).then_some(way)
    });
    hits.reduce(f64::min)
}

/// Whether an edge lies square enough to the ray that meets it: a wall, and not the other side of a corner.
fn opposite(plan: &Plan, edge: usize, at: [f64; 2], along: [f64; 2], way: f64) -> bool {
    let square = match &plan.edge(edge).curve {
        Curve::Arc { center, radius, .. } => {
            let from = [at[0] + way * along[0] - center[0], at[1] + way * along[1] - center[1]];
            (from[0] * along[0] + from[1] * along[1]) / radius
        }
        Curve::Line => {
            let normal = plan.left(edge, 0.0);
            normal[0] * along[0] + normal[1] * along[1]
        }
    };
    square.abs() > 0.8
}

/// Distance along a ray to an edge that it meets.
fn hit(plan: &Plan, edge: usize, at: [f64; 2], along: [f64; 2], skip: f64) -> Option<f64> {
    let [a, b] = plan.ends(edge);
    let least = skip * plan.extent;
    match (&plan.edge(edge).curve, plan.sweep(edge)) {
        (Curve::Arc { center, radius, .. }, Some(sweep)) => {
            let from = [at[0] - center[0], at[1] - center[1]];
            let half = from[0] * along[0] + from[1] * along[1];
            let root = half * half - (from[0] * from[0] + from[1] * from[1] - radius * radius);
            let root = (root > 0.0).then(|| root.sqrt())?;
            let start = (a[1] - center[1]).atan2(a[0] - center[0]);
            let on_arc = |t: &f64| {
                let angle = (from[1] + t * along[1]).atan2(from[0] + t * along[0]);
                let turned = if sweep > 0.0 { angle - start } else { start - angle };
                turned.rem_euclid(std::f64::consts::TAU) <= sweep.abs()
            };
            [-half - root, -half + root].into_iter().filter(|&t| t > least).find(on_arc)
        }
        _ => {
            let way = [b[0] - a[0], b[1] - a[1]];
            let from = [a[0] - at[0], a[1] - at[1]];
            let det = along[0] * way[1] - along[1] * way[0];
            let t = (from[0] * way[1] - from[1] * way[0]) / det;
            let s = (from[0] * along[1] - from[1] * along[0]) / det;
            (t > least && (0.0..=1.0).contains(&s)).then_some(t)
        }
    }
}

/// Two fifths of the median wall, within limits that the extent sets.
pub(super) fn default_size(plan: &Plan, walls: &[Wall]) -> f64 {
    let mut all: Vec<f64> = walls.iter().map(|wall| wall.thickness).collect();
    all.sort_by(f64::total_cmp);
    let median = all.get(all.len() / 2).copied().unwrap_or(plan.extent);
    (0.4 * median).clamp(plan.extent / 50.0, plan.extent / 10.0)
}
