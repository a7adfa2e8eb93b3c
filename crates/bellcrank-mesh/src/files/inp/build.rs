//! From what an input file says to a mesh.

use std::collections::{BTreeMap, HashMap};

use super::super::labels::{Outside, drop_unused, surface_corners, tidy};
use super::super::{FileError, FileFault, Imported, Note};
use super::{Entry, Kind, Raw, RawSet};
use crate::boundary::Hasher;
use crate::{Block, Face};

/// Places of labelled things.
type Numbers<T> = HashMap<u64, T, Hasher>;

pub(super) fn build(mut raw: Raw) -> Result<Imported, Vec<FileError>> {
    let mut imported = Imported { notes: std::mem::take(&mut raw.notes), ..Imported::default() };
    let nodes = number_nodes(&mut raw, &mut imported);
    let elements = number_elements(&mut raw, &nodes, &mut imported);
    if imported.mesh.blocks.is_empty() && raw.errors.0.is_empty() {
        raw.errors.push(raw.end, FileFault::EndsEarly { within: "the mesh: there is no solid `*ELEMENT`" });
    }
    for key in raw.node_sets.keys().cloned().collect::<Vec<_>>() {
        let labels = labels_of(&mut raw, Sort::Nodes, &key, &mut Vec::new());
        let found = look_up(&mut raw, &labels, &nodes, "node");
        imported.mesh.node_sets.insert(raw.node_sets[&key].name.clone(), found);
    }
    let mut element_sets: BTreeMap<String, Vec<(u32, u32)>> = BTreeMap::new();
    for key in raw.element_sets.keys().cloned().collect::<Vec<_>>() {
        let labels = labels_of(&mut raw, Sort::Elements, &key, &mut Vec::new());
        let found = look_up(&mut raw, &labels, &elements, "element");
        let mut solid: Vec<(u32, u32)> = found.into_iter().flatten().collect();
        tidy(&mut solid);
        element_sets.insert(key, solid);
    }
    if raw.errors.0.is_empty() {
        surfaces(&mut raw, &nodes, &elements, &element_sets, &mut imported);
    }
    if !raw.errors.0.is_empty() {
        raw.errors.0.sort_by_key(|error| (error.line, error.column));
        return Err(raw.errors.0);
    }
    marked_faces(&raw, &nodes, &mut imported);
    let named = element_sets.into_iter().filter(|(_, set)| !set.is_empty());
    imported.element_sets = named.map(|(key, set)| (raw.element_sets[&key].name.clone(), set)).collect();
    drop_unused(&mut imported);
    Ok(imported)
}

fn number_nodes(raw: &mut Raw, imported: &mut Imported) -> Numbers<u32> {
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

/// Places of elements; `None` for those that are no solids.
fn number_elements(raw: &mut Raw, nodes: &Numbers<u32>, imported: &mut Imported) -> Numbers<Option<(u32, u32)>> {
    let mut numbers = Numbers::default();
    for group in &raw.elements {
        let mut block = match group.kind {
            Kind::Solid(shape) => Some(Block { name: group.name.clone(), shape, nodes: Vec::new() }),
            _ => None,
        };
        let number = imported.mesh.blocks.len() as u32;
        for (k, element) in group.elements.iter().enumerate() {
            let place = block.is_some().then_some((number, k as u32));
            if numbers.insert(element.label, place).is_some() {
                raw.errors.push(element.at, FileFault::Twice { what: "element", label: element.label });
            }
            let Some(block) = &mut block else { continue };
            for label in &element.nodes {
                match nodes.get(label) {
                    Some(&node) => block.nodes.push(node),
                    None => raw.errors.push(element.at, unknown("node", label)),
                }
            }
        }
        imported.mesh.blocks.extend(block.filter(|block| !block.is_empty()));
    }
    numbers
}

fn unknown(what: &'static str, name: impl ToString) -> FileFault {
    FileFault::Unknown { what, name: name.to_string() }
}

#[derive(Clone, Copy, PartialEq)]
enum Sort {
    Nodes,
    Elements,
}

impl Raw {
    fn sets(&self, sort: Sort) -> &BTreeMap<String, RawSet> {
        match sort {
            Sort::Nodes => &self.node_sets,
            Sort::Elements => &self.element_sets,
        }
    }
}

/// Labels of a set and of the sets in it; `open` are the sets on the way.
fn labels_of(raw: &mut Raw, sort: Sort, key: &str, open: &mut Vec<String>) -> Vec<u64> {
    let set = raw.sets(sort)[key].clone();
    let mut labels = set.labels;
    open.push(key.to_owned());
    for entry in &set.entries {
        let inner = entry.text.to_uppercase();
        if open.contains(&inner) {
            raw.errors.push(entry.at, FileFault::Circular { set: entry.text.clone() });
        } else if raw.sets(sort).contains_key(&inner) {
            let more = labels_of(raw, sort, &inner, open);
            labels.extend(more);
        } else if sort == Sort::Nodes && raw.element_sets.contains_key(&inner) {
            // `*NSET, ELSET=` has no entries; a set of elements among nodes is a mistake.
            raw.errors.push(entry.at, unknown("node set", &entry.text));
        } else {
            raw.errors.push(entry.at, unknown("set", &entry.text));
        }
    }
    open.pop();
    labels
}

fn look_up<T: Copy + Ord>(raw: &mut Raw, labels: &[u64], numbers: &Numbers<T>, what: &'static str) -> Vec<T> {
    let mut found = Vec::with_capacity(labels.len());
    let mut missing = None;
    for label in labels {
        match numbers.get(label) {
            Some(&number) => found.push(number),
            None => missing = missing.or(Some(*label)),
        }
    }
    if let Some(label) = missing {
        raw.errors.push(raw.end, unknown(what, label));
    }
    tidy(&mut found);
    found
}

fn surfaces(
    raw: &mut Raw,
    nodes: &Numbers<u32>,
    elements: &Numbers<Option<(u32, u32)>>,
    sets: &BTreeMap<String, Vec<(u32, u32)>>,
    imported: &mut Imported,
) {
    let mut outside: Option<Vec<Face>> = None;
    for (_, surface) in std::mem::take(&mut raw.surfaces) {
        if surface.of_nodes {
            let mut set = Vec::new();
            for (entry, _) in &surface.rows {
                nodes_of_row(raw, nodes, entry, imported, &mut set);
            }
            tidy(&mut set);
            imported.mesh.node_sets.insert(surface.name, set);
            continue;
        }
        let mut faces = Vec::new();
        for (entry, face) in &surface.rows {
            let Some(members) = members(raw, elements, sets, entry) else { continue };
            match face {
                Some(face) => faces.extend(one_face(raw, imported, &members, face)),
                None => {
                    let outside = outside.get_or_insert_with(|| imported.mesh.boundary());
                    let inside = |face: &&Face| members.binary_search(&(face.block, face.element)).is_ok();
                    faces.extend(outside.iter().filter(inside));
                }
            }
        }
        tidy(&mut faces);
        imported.mesh.face_sets.insert(surface.name, faces);
    }
}

fn nodes_of_row(raw: &mut Raw, nodes: &Numbers<u32>, entry: &Entry, imported: &Imported, set: &mut Vec<u32>) {
    if let Ok(label) = entry.text.parse::<u64>() {
        match nodes.get(&label) {
            Some(&node) => set.push(node),
            None => raw.errors.push(entry.at, unknown("node", label)),
        }
        return;
    }
    let found =
        raw.node_sets.get(&entry.text.to_uppercase()).and_then(|inner| imported.mesh.node_sets.get(&inner.name));
    match found {
        Some(inner) => set.extend(inner),
        None => raw.errors.push(entry.at, unknown("node set", &entry.text)),
    }
}

/// Elements that a row of a surface names, ascending.
fn members(
    raw: &mut Raw,
    elements: &Numbers<Option<(u32, u32)>>,
    sets: &BTreeMap<String, Vec<(u32, u32)>>,
    entry: &Entry,
) -> Option<Vec<(u32, u32)>> {
    let found = match entry.text.parse::<u64>() {
        Ok(label) => elements.get(&label).map(|element| element.iter().copied().collect()),
        Err(_) => sets.get(&entry.text.to_uppercase()).cloned(),
    };
    if found.is_none() {
        raw.errors.push(entry.at, unknown("element or set", &entry.text));
    }
    found
}

fn one_face(raw: &mut Raw, imported: &Imported, members: &[(u32, u32)], face: &Entry) -> Vec<Face> {
    let number = face.text.strip_prefix(['S', 's']).and_then(|digits| digits.parse::<u8>().ok());
    let mut faces = Vec::new();
    for &(block, element) in members {
        let shape = imported.mesh.blocks[block as usize].shape;
        match number.filter(|&number| number > 0 && usize::from(number) <= shape.faces().len()) {
            Some(number) => faces.push(Face { block, element, face: number - 1 }),
            None => {
                let fault = FileFault::NoFace { face: face.text.clone(), shape: shape.abaqus() };
                raw.errors.push(face.at, fault);
                break;
            }
        }
    }
    faces
}

/// Shells and plane elements in named sets mark faces of solids.
fn marked_faces(raw: &Raw, nodes: &Numbers<u32>, imported: &mut Imported) {
    let mut corners: Numbers<Vec<u32>> = Numbers::default();
    for group in raw.elements.iter().filter(|group| group.kind == Kind::Surface) {
        for element in &group.elements {
            let count = surface_corners(element.nodes.len()).unwrap_or(0);
            let found: Option<Vec<u32>> =
                element.nodes[..count].iter().map(|label| nodes.get(label).copied()).collect();
            corners.insert(element.label, found.unwrap_or_default());
        }
    }
    if corners.is_empty() {
        return;
    }
    let outside = Outside::of(&imported.mesh);
    for set in raw.element_sets.values() {
        let marks: Vec<&Vec<u32>> = set.labels.iter().filter_map(|label| corners.get(label)).collect();
        if marks.is_empty() {
            continue;
        }
        let mut faces: Vec<Face> = marks.iter().filter_map(|corners| outside.face(corners)).collect();
        if faces.len() < marks.len() {
            imported.notes.push(Note::FacesLeftOut { set: set.name.clone(), count: marks.len() - faces.len() });
        }
        tidy(&mut faces);
        imported.mesh.face_sets.entry(set.name.clone()).or_insert(faces);
    }
}
