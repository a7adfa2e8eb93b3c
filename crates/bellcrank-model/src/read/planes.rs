//! Bodies of planar files in a spatial machine: each stays in the plane of its file.
//!
//! Hinges, slides, welds and planar joints keep the plane. A body that only rods, couplers, lines or forces hold in it
//! has nothing in space to keep it there, and gets a planar joint.

use std::collections::HashMap;

use super::{Machine, PartReader};
use crate::design::{Joint, JointShape, PointRef};

/// Adds the planar joints that are missing.
pub(super) fn hold(parts: &[PartReader<'_>], machine: &mut Machine) {
    let mut kept = Kept::of(machine);
    for (index, part) in parts.iter().enumerate() {
        let of_spatial = part.part.parent.is_none_or(|parent| !parts[parent].is_embedded());
        if part.is_embedded() && of_spatial {
            hold_plane(*part, index, machine, &mut kept);
        }
    }
}

/// All bodies of a planar file and of those it includes, whose names have its prefix.
fn hold_plane(part: PartReader<'_>, index: usize, machine: &mut Machine, kept: &mut Kept) {
    let bodies: Vec<usize> =
        (1..machine.bodies.len()).filter(|&body| machine.bodies[body].name.starts_with(part.prefix())).collect();
    let mut plane = machine.mounts.get(index).copied().flatten().or_else(|| first_point(machine, 0, part.prefix()));
    for body in bodies {
        let Some(own) = first_point(machine, body, "") else { continue };
        // A file without a ground has the plane of its first body.
        let plane = *plane.get_or_insert(own);
        if kept.root(body) != kept.root(plane.body) {
            kept.join(body, plane.body);
            add(machine, plane, own);
        }
    }
}

fn first_point(machine: &Machine, body: usize, prefix: &str) -> Option<PointRef> {
    let points = &machine.bodies[body].points;
    let point = points.iter().position(|point| point.name.starts_with(prefix))?;
    Some(PointRef { body, point })
}

fn add(machine: &mut Machine, plane: PointRef, own: PointRef) {
    let body = &machine.bodies[own.body];
    let joint = Joint {
        name: format!("{}.plane", body.name),
        span: body.span,
        kind: "planar",
        shape: JointShape::Planar,
        connects: Some([plane, own]),
        start: Vec::new(),
        start_velocity: Vec::new(),
        at_start: false,
        planar: true,
    };
    machine.joint_names.insert(&joint.name, machine.joints.len());
    machine.joints.push(joint);
}

/// Bodies that joints keep in one plane.
struct Kept {
    parents: HashMap<usize, usize>,
}

impl Kept {
    fn of(machine: &Machine) -> Kept {
        let mut kept = Kept { parents: HashMap::new() };
        for joint in machine.joints.iter().filter(|joint| joint.planar) {
            let keeps = matches!(
                joint.shape,
                JointShape::Revolute { .. } | JointShape::Prismatic { .. } | JointShape::Planar | JointShape::Weld
            );
            if let (true, Some([a, b])) = (keeps, joint.connects) {
                kept.join(a.body, b.body);
            }
        }
        kept
    }

    fn root(&mut self, body: usize) -> usize {
        let mut root = body;
        while let Some(&parent) = self.parents.get(&root) {
            root = parent;
        }
        // Flat from here on.
        if root != body {
            self.parents.insert(body, root);
        }
        root
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        if a != b {
            self.parents.insert(a, b);
        }
    }
}
