//! Writes a mesh as a Gmsh file, version 4.1, text.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::msh::order;
use crate::{Face, FaceShape, Mesh, Shape};

/// Gmsh's name for elements of one shape.
fn number(shape: Shape) -> u32 {
    match shape {
        Shape::Tet4 => 4,
        Shape::Hex8 => 5,
        Shape::Wedge6 => 6,
        Shape::Tet10 => 11,
        Shape::Hex20 => 17,
        Shape::Wedge15 => 18,
    }
}

fn face_number(shape: FaceShape) -> u32 {
    match shape {
        FaceShape::Tri3 => 2,
        FaceShape::Quad4 => 3,
        FaceShape::Tri6 => 9,
        FaceShape::Quad8 => 16,
    }
}

/// Elements of one entity and shape.
struct Group {
    dimension: u8,
    entity: usize,
    number: u32,
    elements: Vec<Vec<u32>>,
}

/// A mesh as a Gmsh file: blocks are volumes with a physical group of their name, face sets physical surfaces, node sets
/// that are not the nodes of a face set of the same name physical points.
pub fn write_msh(mesh: &Mesh) -> String {
    let mut names: Vec<(u8, String)> = Vec::new();
    let mut groups = volumes(mesh, &mut names);
    surfaces(mesh, &mut names, &mut groups);
    points(mesh, &mut names, &mut groups);
    let mut text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n".to_owned();
    physical_names(&mut text, &names);
    entities(&mut text, mesh, &names);
    nodes(&mut text, mesh);
    elements(&mut text, &groups);
    text
}

/// Entity of a name; entity and physical group have the same number.
fn entity(names: &mut Vec<(u8, String)>, dimension: u8, name: &str) -> usize {
    let same = |(d, n): &(u8, String)| *d == dimension && n == name;
    let place = names.iter().position(same).unwrap_or_else(|| {
        names.push((dimension, name.to_owned()));
        names.len() - 1
    });
    place + 1
}

fn volumes(mesh: &Mesh, names: &mut Vec<(u8, String)>) -> Vec<Group> {
    let group = |block: &crate::Block| {
        let order = order(block.shape);
        let mut theirs = vec![0; order.len()];
        order.iter().enumerate().for_each(|(ours, &place)| theirs[place] = ours);
        let elements = block.elements().map(|nodes| theirs.iter().map(|&ours| nodes[ours]).collect()).collect();
        Group { dimension: 3, entity: entity(names, 3, &block.name), number: number(block.shape), elements }
    };
    mesh.blocks.iter().map(group).collect()
}

fn surfaces(mesh: &Mesh, names: &mut Vec<(u8, String)>, groups: &mut Vec<Group>) {
    for (name, faces) in &mesh.face_sets {
        let entity = entity(names, 2, name);
        let mut by_shape: BTreeMap<u32, Vec<Vec<u32>>> = BTreeMap::new();
        for &face in faces {
            let nodes: Vec<u32> = mesh.face_nodes(face).collect();
            by_shape.entry(face_number(mesh.face_shape(face))).or_default().push(nodes);
        }
        groups.extend(by_shape.into_iter().map(|(number, elements)| Group { dimension: 2, entity, number, elements }));
    }
}

fn points(mesh: &Mesh, names: &mut Vec<(u8, String)>, groups: &mut Vec<Group>) {
    for (name, nodes) in &mesh.node_sets {
        let faces: &[Face] = mesh.face_sets.get(name).map_or(&[], Vec::as_slice);
        if !faces.is_empty() && mesh.nodes_of_faces(faces) == *nodes {
            continue;
        }
        let elements = nodes.iter().map(|&node| vec![node]).collect();
        groups.push(Group { dimension: 0, entity: entity(names, 0, name), number: 15, elements });
    }
}

fn line(text: &mut String, line: std::fmt::Arguments) {
    // Writing to a string does not fail.
    let _ = text.write_fmt(line);
    text.push('\n');
}

fn physical_names(text: &mut String, names: &[(u8, String)]) {
    let named: Vec<_> = names.iter().enumerate().filter(|(_, (_, name))| !name.is_empty()).collect();
    line(text, format_args!("$PhysicalNames\n{}", named.len()));
    for (place, (dimension, name)) in named {
        line(text, format_args!("{dimension} {} \"{name}\"", place + 1));
    }
    text.push_str("$EndPhysicalNames\n");
}

fn entities(text: &mut String, mesh: &Mesh, names: &[(u8, String)]) {
    let count = |dimension: u8| names.iter().filter(|(d, _)| *d == dimension).count();
    line(text, format_args!("$Entities\n{} {} {} {}", count(0), count(1), count(2), count(3)));
    let low: [f64; 3] = std::array::from_fn(|i| mesh.nodes.iter().map(|p| p[i]).fold(f64::INFINITY, f64::min));
    let high: [f64; 3] = std::array::from_fn(|i| mesh.nodes.iter().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max));
    let ([a, b, c], [d, e, f]) = if mesh.nodes.is_empty() { ([0.0; 3], [0.0; 3]) } else { (low, high) };
    for dimension in 0..4 {
        for (place, (_, name)) in names.iter().enumerate().filter(|(_, (d, _))| *d == dimension) {
            let tag = place + 1;
            let group = if name.is_empty() { "0".to_owned() } else { format!("1 {tag}") };
            if dimension == 0 {
                line(text, format_args!("{tag} {a} {b} {c} {group}"));
            } else {
                line(text, format_args!("{tag} {a} {b} {c} {d} {e} {f} {group} 0"));
            }
        }
    }
    text.push_str("$EndEntities\n");
}

fn nodes(text: &mut String, mesh: &Mesh) {
    let count = mesh.nodes.len();
    line(text, format_args!("$Nodes\n1 {count} 1 {count}\n3 1 0 {count}"));
    (1..=count).for_each(|label| line(text, format_args!("{label}")));
    mesh.nodes.iter().for_each(|[x, y, z]| line(text, format_args!("{x:?} {y:?} {z:?}")));
    text.push_str("$EndNodes\n");
}

fn elements(text: &mut String, groups: &[Group]) {
    let count: usize = groups.iter().map(|group| group.elements.len()).sum();
    line(text, format_args!("$Elements\n{} {count} 1 {count}", groups.len()));
    let mut label = 0;
    for Group { dimension, entity, number, elements } in groups {
        line(text, format_args!("{dimension} {entity} {number} {}", elements.len()));
        for nodes in elements {
            label += 1;
            let _ = write!(text, "{label}");
            nodes.iter().for_each(|node| {
                let _ = write!(text, " {}", node + 1);
            });
            text.push('\n');
        }
    }
    text.push_str("$EndElements\n");
}
