//! In the plane, links that meet at a pin lie one behind the other.

use std::collections::BTreeMap;

use crate::{Drawing, SpaceKind};

/// Which layer each body lies in, 0 in the middle.
pub(super) struct Layers {
    of: Vec<i32>,
}

impl Layers {
    pub(super) fn of(drawing: &Drawing) -> Layers {
        let count = drawing.bodies.len();
        if !matches!(drawing.space, SpaceKind::Planar) {
            return Layers { of: vec![0; count] };
        }
        let groups = groups(drawing);
        let meets = meetings(drawing, &groups);
        let mut of: Vec<Option<i32>> = vec![None; count];
        // Real forms are where they are.
        let real = |body: &usize| drawing.bodies[*body].surface.is_some();
        (1..count).filter(real).for_each(|body| of[groups[body]] = Some(0));
        for group in (1..count).filter(|body| groups[*body] == *body) {
            if of[group].is_some() {
                continue;
            }
            let taken: Vec<i32> = meets[group].iter().filter_map(|other| of[*other]).collect();
            of[group] = nearest_free(&taken);
        }
        Layers { of: groups.iter().map(|group| of[*group].unwrap_or(0)).collect() }
    }

    /// Layer of a body; that of the ground says nothing.
    pub(super) fn layer(&self, body: usize) -> i32 {
        self.of.get(body).copied().unwrap_or(0)
    }

    /// The layer behind all others.
    pub(super) fn back(&self) -> i32 {
        self.of.iter().skip(1).copied().min().unwrap_or(0) - 1
    }
}

/// 0, 1, -1, 2, -2, ...
fn nearest_free(taken: &[i32]) -> Option<i32> {
    (0..).flat_map(|k| if k == 0 { vec![0] } else { vec![k, -k] }).find(|layer| !taken.contains(layer))
}

/// Bodies that slide in each other lie in one layer: for each body the first one of its group.
fn groups(drawing: &Drawing) -> Vec<usize> {
    let mut groups: Vec<usize> = (0..drawing.bodies.len()).collect();
    for joint in drawing.joints.iter().filter(|joint| matches!(joint.kind.as_str(), "prismatic" | "weld")) {
        let (a, b) = (groups.get(joint.first.0).copied(), groups.get(joint.second.0).copied());
        let (Some(a), Some(b)) = (a, b) else { continue };
        if a == 0 || b == 0 {
            continue;
        }
        let (low, high) = (a.min(b), a.max(b));
        groups.iter_mut().filter(|group| **group == high).for_each(|group| *group = low);
    }
    groups
}

/// For each group the groups that it meets in a joint, or at a pin that goes through both.
fn meetings(drawing: &Drawing, groups: &[usize]) -> Vec<Vec<usize>> {
    let mut pins: BTreeMap<(usize, [i64; 3]), Vec<usize>> = BTreeMap::new();
    for joint in &drawing.joints {
        for (here, other) in [(joint.first, joint.second), (joint.second, joint.first)] {
            let at = here.1.map(|x| (x * 1e6).round() as i64);
            pins.entry((here.0, at)).or_insert_with(|| vec![here.0]).push(other.0);
        }
    }
    let mut meets = vec![Vec::new(); groups.len()];
    for bodies in pins.values() {
        let at_pin: Vec<usize> = bodies.iter().filter_map(|body| groups.get(*body).copied()).collect();
        for (k, &a) in at_pin.iter().enumerate() {
            for &b in at_pin[..k].iter().filter(|b| **b != a && **b != 0 && a != 0) {
                meets[a].push(b);
                meets[b].push(a);
            }
        }
    }
    meets
}
