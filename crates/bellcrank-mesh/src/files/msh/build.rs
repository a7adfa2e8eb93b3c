//! From what a Gmsh file says to a mesh.

use std::collections::HashMap;

use super::super::labels::{Outside, drop_unused, surface_corners, tidy};
use super::super::{FileError, FileFault, Imported, Note};
use super::elements::order;
use super::{Group, Raw};
use crate::boundary::Hasher;
use crate::{Block, Face};

type Numbers = HashMap<u64, u32, Hasher>;

pub(super) fn build(mut raw: Raw, entities: bool) -> Result<Imported, Vec<FileError>> {
    let mut imported = Imported { notes: std::mem::take(&mut raw.notes), ..Imported::default() };
    let numbers = number_nodes(&mut raw, &mut imported);
    let groups = std::mem::take(&mut raw.groups);
    let known = groups.into_iter().filter_map(|group| known_nodes(&mut raw, &numbers, group));
    let groups: Vec<(Group, Vec<u32>)> = known.collect();
    if raw.errors.0.is_empty() && !groups.iter().any(|(group, _)| group.kind.solid.is_some()) {
        raw.errors.push(raw.end, FileFault::EndsEarly { within: "the mesh: there is no solid element" });
    }
    if !raw.errors.0.is_empty() {
        return Err(raw.errors.0);
    }
    for (group, nodes) in &groups {
        solids(&raw, group, nodes, &mut imported);
    }
    let outside = Outside::of(&imported.mesh);
    for (group, nodes) in &groups {
        match group.dimension {
            2 => surfaces(&raw, group, nodes, &outside, entities, &mut imported),
            0 | 1 => {
                for name in names(&raw, group) {
                    imported.mesh.node_sets.entry(name).or_default().extend(nodes);
                }
            }
            _ => {}
        }
    }
    imported.mesh.node_sets.values_mut().for_each(tidy);
    imported.mesh.face_sets.values_mut().for_each(tidy);
    drop_unused(&mut imported);
    Ok(imported)
}

fn number_nodes(raw: &mut Raw, imported: &mut Imported) -> Numbers {
    let mut numbers = Numbers::default();
    for &(label, place, at) in &raw.nodes {
        if numbers.insert(label, imported.mesh.nodes.len() as u32).is_some() {
            raw.errors.push(at, FileFault::Twice { what: "node", label });
        }
        imported.mesh.nodes.push(place);
        imported.node_labels.push(label);
    }
    numbers
}

/// A group with the numbers of its nodes, when all of them exist.
fn known_nodes(raw: &mut Raw, numbers: &Numbers, group: Group) -> Option<(Group, Vec<u32>)> {
    let missing = group.nodes.iter().find(|label| !numbers.contains_key(label));
    if let Some(label) = missing {
        raw.errors.push((group.line, 1), FileFault::Unknown { what: "node", name: label.to_string() });
        return None;
    }
    let nodes = group.nodes.iter().map(|label| numbers[label]).collect();
    Some((group, nodes))
}

/// Names of the physical groups that a group of elements is in.
fn names(raw: &Raw, group: &Group) -> Vec<String> {
    let key = (group.dimension, group.entity);
    let of_entity = raw.physical.get(&key).into_iter().flatten();
    let numbers = of_entity.chain(&group.physical).filter(|&&number| number != 0);
    let name = |&number: &i64| {
        // A negative number marks the surface seen from its other side.
        let key = (group.dimension, number.abs());
        raw.names.get(&key).cloned().unwrap_or_else(|| format!("physical.{}.{}", key.0, key.1))
    };
    let mut names: Vec<String> = numbers.map(name).collect();
    tidy(&mut names);
    names
}

fn solids(raw: &Raw, group: &Group, nodes: &[u32], imported: &mut Imported) {
    let Some(shape) = group.kind.solid else { return };
    let names = names(raw, group);
    let name = names.first().cloned().unwrap_or_default();
    let blocks = &mut imported.mesh.blocks;
    let same = |block: &Block| block.shape == shape && block.name == name;
    let place = blocks.iter().position(same).unwrap_or_else(|| {
        blocks.push(Block { name: name.clone(), shape, nodes: Vec::new() });
        blocks.len() - 1
    });
    let order = order(shape);
    let first = blocks[place].len() as u32;
    for element in nodes.chunks_exact(shape.nodes()) {
        blocks[place].nodes.extend(order.iter().map(|&theirs| element[theirs]));
    }
    let last = blocks[place].len() as u32;
    for name in names {
        let set = imported.element_sets.entry(name).or_default();
        set.extend((first..last).map(|element| (place as u32, element)));
    }
}

fn surfaces(raw: &Raw, group: &Group, nodes: &[u32], outside: &Outside, entities: bool, imported: &mut Imported) {
    let mut names = names(raw, group);
    if entities {
        names.push(format!("face.{}", group.entity));
    }
    let Some(corners) = surface_corners(group.kind.nodes) else { return };
    let elements = nodes.chunks_exact(group.kind.nodes);
    let faces: Vec<Face> = elements.filter_map(|element| outside.face(&element[..corners])).collect();
    let lost = nodes.len() / group.kind.nodes - faces.len();
    for name in names {
        if lost > 0 {
            imported.notes.push(Note::FacesLeftOut { set: name.clone(), count: lost });
        }
        imported.mesh.face_sets.entry(name.clone()).or_default().extend(&faces);
        imported.mesh.node_sets.entry(name).or_default().extend(nodes);
    }
}
