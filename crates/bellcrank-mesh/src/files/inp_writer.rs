//! Writes a mesh as the first part of an Abaqus or CalculiX input file.

use std::fmt::Write;

use crate::{Face, Mesh};

/// Appends nodes, elements, sets and surfaces. Labels are the numbers of the mesh plus one; elements count on over the
/// blocks. Blocks with a name are written as element sets, and the element set `Eall` holds every element; node sets
/// follow as `*NSET`, face sets as `*SURFACE, TYPE=ELEMENT`. Materials, loads and steps are for the caller to append.
///
/// Numbers have at most 20 characters, because CalculiX reads no more of them: 13 digits where the shortest form that
/// reads back the same is longer.
pub fn write_inp(mesh: &Mesh, text: &mut String) {
    text.push_str("*NODE\n");
    for (number, [x, y, z]) in mesh.nodes.iter().enumerate() {
        row(text, format_args!("{}, {}, {}, {}", number + 1, short(*x), short(*y), short(*z)));
    }
    let first = first_labels(mesh);
    for (block, first) in mesh.blocks.iter().zip(&first) {
        let set = if block.name.is_empty() { String::new() } else { format!(", ELSET={}", block.name) };
        row(text, format_args!("*ELEMENT, TYPE={}{set}", block.shape.abaqus()));
        for (k, nodes) in block.elements().enumerate() {
            let labels = std::iter::once(first + k as u64).chain(nodes.iter().map(|&node| u64::from(node) + 1));
            list(text, labels, nodes.len() + 1);
        }
    }
    row(text, format_args!("*ELSET, ELSET=Eall, GENERATE\n1, {}, 1", mesh.element_count()));
    for (name, nodes) in &mesh.node_sets {
        row(text, format_args!("*NSET, NSET={name}"));
        list(text, nodes.iter().map(|&node| u64::from(node) + 1), nodes.len());
    }
    for (name, faces) in &mesh.face_sets {
        row(text, format_args!("*SURFACE, NAME={name}, TYPE=ELEMENT"));
        for Face { block, element, face } in faces {
            row(text, format_args!("{}, S{}", first[*block as usize] + u64::from(*element), face + 1));
        }
    }
}

/// Label of the first element of each block.
fn first_labels(mesh: &Mesh) -> Vec<u64> {
    let mut next = 1;
    let mut first = Vec::with_capacity(mesh.blocks.len());
    for block in &mesh.blocks {
        first.push(next);
        next += block.len() as u64;
    }
    first
}

fn row(text: &mut String, line: std::fmt::Arguments) {
    // Writing to a string does not fail.
    let _ = text.write_fmt(line);
    text.push('\n');
}

/// Labels, ten in a line; lines that go on end with a comma.
fn list(text: &mut String, labels: impl Iterator<Item = u64>, count: usize) {
    for (k, label) in labels.enumerate() {
        let end = if k + 1 == count {
            "\n"
        } else if k % 10 == 9 {
            ",\n"
        } else {
            ", "
        };
        let _ = write!(text, "{label}{end}");
    }
}

/// A number in at most 20 characters.
fn short(value: f64) -> String {
    let all = format!("{value:?}");
    if all.len() <= 20 { all } else { format!("{value:.12e}") }
}
