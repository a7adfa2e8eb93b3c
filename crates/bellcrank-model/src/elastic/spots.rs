//! Hot spots: the largest stress of each region, with its error.

use bellcrank_fem::{Stress, principal, von_mises};
use bellcrank_mesh::Mesh;
use bellcrank_results::HotSpot;

use super::regions::{Doubtful, Region};

/// A hot spot that is found again on the next mesh by its region and by whether it can be trusted.
#[derive(Clone, Debug)]
pub(super) struct Spot {
    pub(super) region: usize,
    pub(super) node: u32,
    pub(super) found: HotSpot,
}

/// The largest stress of each region among what can be trusted, and what is above it among the rest.
pub(super) fn spots(mesh: &Mesh, stress: &Stress, regions: &[Region], doubtful: &Doubtful, place: &str) -> Vec<Spot> {
    let mut all = Vec::new();
    for (index, region) in regions.iter().enumerate() {
        let doubts: Vec<_> = region.nodes.iter().map(|&node| doubtful.at(mesh.nodes[node as usize])).collect();
        let pick = |trusted: bool| {
            let nodes = region.nodes.iter().zip(&doubts).filter(|(_, doubt)| doubt.is_none() == trusted);
            let value = |node: u32| von_mises(&stress.nodal[node as usize]);
            nodes.map(|(&node, doubt)| (value(node), node, *doubt)).max_by(|a, b| a.0.total_cmp(&b.0))
        };
        let (sure, unsure) = (pick(true), pick(false));
        let mut add = |(value, node, doubt): (f64, u32, Option<super::regions::Doubt>)| {
            let [first, _, last] = principal(&stress.nodal[node as usize]);
            let found = HotSpot {
                region: region.name.clone(),
                at: mesh.nodes[node as usize],
                value,
                error: stress.spread[node as usize],
                principal: [first, last],
                margin: None,
                singular: doubt.map(super::regions::Doubt::words),
                place: place.to_owned(),
            };
            all.push(Spot { region: index, node, found });
        };
        let above = |one: &(f64, u32, _)| sure.is_none_or(|sure| one.0 > sure.0);
        let unsure = unsure.filter(above);
        sure.into_iter().for_each(&mut add);
        unsure.into_iter().for_each(&mut add);
    }
    all
}

/// The larger of the same spots of several positions.
pub(super) fn envelope(mut all: Vec<Spot>, more: Vec<Spot>) -> Vec<Spot> {
    for spot in more {
        let same = |known: &&mut Spot| {
            known.region == spot.region && known.found.singular.is_some() == spot.found.singular.is_some()
        };
        match all.iter_mut().find(same) {
            Some(known) if known.found.value < spot.found.value => *known = spot,
            Some(_) => {}
            None => all.push(spot),
        }
    }
    all.sort_by_key(|spot| (spot.region, spot.found.singular.is_some()));
    all
}

/// The error of a spot is the larger of what the mesh says and of the change from the mesh before.
pub(super) fn compared(spots: &mut [Spot], before: &[Spot]) {
    for spot in spots.iter_mut().filter(|spot| spot.found.singular.is_none()) {
        let same = before.iter().find(|old| old.region == spot.region && old.found.singular.is_none());
        if let Some(old) = same {
            spot.found.error = spot.found.error.max((spot.found.value - old.found.value).abs());
        }
    }
}

/// The place of the largest that can be trusted.
pub(super) fn peak(spots: &[Spot]) -> Option<usize> {
    let sure = spots.iter().enumerate().filter(|(_, spot)| spot.found.singular.is_none());
    sure.max_by(|a, b| a.1.found.value.total_cmp(&b.1.found.value)).map(|(index, _)| index)
}

/// Spots far below the peak do not decide anything: their errors count against this share of it.
pub(super) const LOW: f64 = 0.5;

/// The largest error of what can be trusted, relative to its stress, or to half of the peak where that is more.
pub(super) fn worst_error(spots: &[Spot]) -> f64 {
    let Some(peak) = peak(spots).map(|index| spots[index].found.value) else { return f64::NAN };
    let sure = spots.iter().filter(|spot| spot.found.singular.is_none());
    let relative = |spot: &Spot| if peak > 0.0 { spot.found.error / spot.found.value.max(LOW * peak) } else { 0.0 };
    sure.map(relative).fold(0.0, f64::max)
}
