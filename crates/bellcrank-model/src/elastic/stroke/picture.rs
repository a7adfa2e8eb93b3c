//! What the moving picture of a flexible body is drawn from.

use bellcrank_results::{Animation, FlexibleMotion, MotionMark};

use super::Body;
use super::recovery::Recovered;
use super::spots::{Spot, peak};
use crate::elastic::pictures::Picture;
use crate::measure::Measure;

/// The body in the rows of the animation; nothing where there is none.
pub(super) fn motion(
    body: &Body<'_>,
    picture: &Picture<'_>,
    recovered: &Recovered,
    spots: &[Spot],
    animation: Option<&Animation>,
) -> Option<FlexibleMotion> {
    let rows: Vec<usize> = animation?.rows.iter().copied().filter(|row| *row < body.rows.poses.len()).collect();
    let reduced = body.reduced;
    let surface = picture.contour(body.design.bodies[body.deforming.body].name.clone());
    let nodes: Vec<usize> = surface.numbers.iter().map(|number| *number as usize - 1).collect();
    let columns = &body.deforming.columns;
    let narrow = |of: &[f64; 3]| of.map(|x| x as f32);
    let displaced =
        |column: &usize| nodes.iter().map(|&node| narrow(&reduced.reduction.shapes[*column][node])).collect();
    let stressed = |column: &usize| nodes.iter().map(|&node| reduced.stress[*column][node].map(|x| x as f32)).collect();
    let peak = peak(spots).map(|index| &spots[index]);
    let ceiling = peak.map(|spot| spot.found.value as f32);
    let worst = peak.map_or(0, |spot| nearest(&rows, spot.found.row));
    Some(FlexibleMotion {
        body: surface.title,
        nodes: surface.nodes,
        numbers: surface.numbers,
        triangles: surface.triangles,
        edges: surface.edges,
        displacements: columns.iter().map(displaced).collect(),
        stresses: columns.iter().map(stressed).collect(),
        coordinates: rows.iter().map(|&row| body.rows.row(row).to_vec()).collect(),
        poses: rows.iter().map(|&row| body.rows.poses[row]).collect(),
        envelope: nodes.iter().map(|&node| recovered.envelope[node] as f32).collect(),
        worst,
        ceiling,
        marks: spots.iter().filter_map(|spot| mark(spot, &nodes, &rows)).collect(),
        rows,
        unit: body.design.units.of(Measure::Stress),
        length: body.design.units.of(Measure::Length),
    })
}

/// Place in a rising list of the entry nearest to a row.
fn nearest(rows: &[usize], row: usize) -> usize {
    (0..rows.len()).min_by_key(|&k| rows[k].abs_diff(row)).unwrap_or(0)
}

fn mark(spot: &Spot, nodes: &[usize], rows: &[usize]) -> Option<MotionMark> {
    let node = nodes.iter().position(|node| *node == spot.node as usize)? as u32;
    let history = rows.iter().map(|&row| spot.history[row]).collect();
    Some(MotionMark { label: spot.found.region.clone(), node, history, doubtful: spot.found.singular.is_some() })
}
