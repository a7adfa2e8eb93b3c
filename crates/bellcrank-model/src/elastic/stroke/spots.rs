//! Hot spots: the largest stress of each region over the rows, its history and its error.

use bellcrank_fem::{Part, Six, Solution, Stress, principal, von_mises};
use bellcrank_results::SpotHistory;

use super::Body;
use super::recovery::{Largest, Recovered, displacement, history};
use crate::elastic::regions::Doubt;
use crate::elastic::{End, material_of};

/// A hot spot.
pub(super) struct Spot {
    pub(super) region: usize,
    pub(super) node: u32,
    /// Von Mises stress at its node in every row, Pa.
    pub(super) history: Vec<f64>,
    /// All components there.
    pub(super) stresses: Vec<Six>,
    pub(super) found: SpotHistory,
}

/// The largest of each region among what can be trusted, and what is above it among the rest.
pub(super) fn spots(body: &Body<'_>, recovered: &Recovered, places: &[String]) -> Result<Vec<Spot>, End> {
    let (_, strength) = material_of(body.design, body.values, body.deforming.body, &body.solid)?;
    let mut all = Vec::new();
    for (region, [sure, unsure]) in recovered.largest.iter().enumerate() {
        let above = |one: &Largest| sure.is_none_or(|sure| one.value > sure.value);
        for largest in sure.iter().chain(unsure.iter().filter(|one| above(one))) {
            all.push(one(body, recovered, region, largest, places, strength));
        }
    }
    errors(body, &mut all)?;
    Ok(all)
}

fn one(
    body: &Body<'_>,
    recovered: &Recovered,
    region: usize,
    largest: &Largest,
    places: &[String],
    strength: Option<f64>,
) -> Spot {
    let stresses = history(body, largest.node);
    let [first, _, last] = principal(&stresses[largest.row]);
    let found = SpotHistory {
        region: recovered.regions[region].name.clone(),
        at: body.reduced.mesh.nodes[largest.node as usize],
        value: largest.value,
        row: largest.row,
        place: places.get(largest.row).cloned().unwrap_or_default(),
        error: None,
        principal: [first, last],
        margin: strength.filter(|_| largest.value > 0.0).map(|strength| strength / largest.value - 1.0),
        singular: largest.doubt.map(Doubt::words),
        signal: String::new(),
        fatigue: None,
    };
    Spot { region, node: largest.node, history: stresses.iter().map(von_mises).collect(), stresses, found }
}

/// Smoothed stress is a sum of columns, its error is not: that of the worst rows is estimated anew.
fn errors(body: &Body<'_>, spots: &mut [Spot]) -> Result<(), End> {
    let mesh = &body.reduced.mesh;
    let (material, _) = material_of(body.design, body.values, body.deforming.body, &body.solid)?;
    let materials = vec![material; mesh.blocks.len()];
    let part = Part { mesh, materials, supports: Vec::new(), couplings: Vec::new() };
    let mut rows: Vec<usize> = spots.iter().map(|spot| spot.found.row).collect();
    rows.sort_unstable();
    rows.dedup();
    for row in rows {
        let displacement = displacement(body, body.rows.row(row));
        let stress = Stress::new(&part, &Solution { displacement, ..Solution::default() });
        for spot in spots.iter_mut().filter(|spot| spot.found.row == row) {
            spot.found.error = Some(stress.spread[spot.node as usize]);
        }
    }
    Ok(())
}

/// The largest that can be trusted.
pub(super) fn peak(spots: &[Spot]) -> Option<usize> {
    let sure = spots.iter().enumerate().filter(|(_, spot)| spot.found.singular.is_none());
    sure.max_by(|a, b| a.1.found.value.total_cmp(&b.1.found.value)).map(|(index, _)| index)
}
