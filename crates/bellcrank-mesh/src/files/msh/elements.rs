//! Nodes and elements of both versions.

use super::super::FileFault;
use super::tokens::Tokens;
use super::{Group, Kind, Raw, Stop};
use crate::Shape;

pub(super) fn nodes_4(raw: &mut Raw, tokens: &mut Tokens) -> Result<(), Stop> {
    let blocks = tokens.natural("the number of blocks of nodes")?;
    for expected in ["the number of nodes", "the lowest label", "the highest label"] {
        tokens.natural(expected)?;
    }
    for _ in 0..blocks {
        let dimension = tokens.natural("the dimension of an entity")?;
        tokens.integer("the tag of an entity")?;
        let parametric = tokens.natural("0, or 1 for parametric nodes")?;
        let count = tokens.natural("the number of nodes")?;
        let mut labels = Vec::new();
        for _ in 0..count {
            let label = tokens.natural("the label of a node")?;
            labels.push((label, tokens.place()));
        }
        for (label, at) in labels {
            let place = place(tokens)?;
            for _ in 0..if parametric == 1 { dimension } else { 0 } {
                tokens.real("a parameter of a node")?;
            }
            raw.nodes.push((label, place, at));
        }
    }
    Ok(())
}

fn place(tokens: &mut Tokens) -> Result<[f64; 3], Stop> {
    let mut place = [0.0; 3];
    for c in &mut place {
        *c = tokens.real("a coordinate of a node")?;
    }
    Ok(place)
}

pub(super) fn nodes_2(raw: &mut Raw, tokens: &mut Tokens) -> Result<(), Stop> {
    for _ in 0..tokens.natural("the number of nodes")? {
        let label = tokens.natural("the label of a node")?;
        let at = tokens.place();
        raw.nodes.push((label, place(tokens)?, at));
    }
    Ok(())
}

pub(super) fn elements_4(raw: &mut Raw, tokens: &mut Tokens) -> Result<(), Stop> {
    let blocks = tokens.natural("the number of blocks of elements")?;
    for expected in ["the number of elements", "the lowest label", "the highest label"] {
        tokens.natural(expected)?;
    }
    for _ in 0..blocks {
        let dimension = tokens.natural("the dimension of an entity")?.min(3) as u8;
        let (entity, at) = tokens.integer("the tag of an entity")?;
        let kind = kind(tokens)?;
        let count = tokens.natural("the number of elements")?;
        let mut group = Group { dimension, entity, physical: Vec::new(), kind, nodes: Vec::new(), line: at.0 };
        for _ in 0..count {
            tokens.natural("the label of an element")?;
            labels(tokens, kind, &mut group.nodes)?;
        }
        raw.groups.push(group);
    }
    Ok(())
}

fn labels(tokens: &mut Tokens, kind: Kind, nodes: &mut Vec<u64>) -> Result<(), Stop> {
    for _ in 0..kind.nodes {
        nodes.push(tokens.natural("the label of a node of an element")?);
    }
    Ok(())
}

pub(super) fn elements_2(raw: &mut Raw, tokens: &mut Tokens) -> Result<(), Stop> {
    for _ in 0..tokens.natural("the number of elements")? {
        tokens.natural("the label of an element")?;
        let at = tokens.place();
        let kind = kind(tokens)?;
        let mut tags = Vec::new();
        for _ in 0..tokens.natural("the number of tags")? {
            tags.push(tokens.integer("a tag")?.0);
        }
        let (physical, entity) = (tags.first().copied().unwrap_or(0), tags.get(1).copied().unwrap_or(0));
        let dimension = dimension(kind.number);
        let same = |group: &&mut Group| {
            (group.dimension, group.entity, group.kind) == (dimension, entity, kind) && group.physical == [physical]
        };
        if raw.groups.last_mut().filter(same).is_none() {
            let line = at.0;
            raw.groups.push(Group { dimension, entity, physical: vec![physical], kind, nodes: Vec::new(), line });
        }
        let Some(group) = raw.groups.last_mut() else { continue };
        labels(tokens, kind, &mut group.nodes)?;
    }
    Ok(())
}

/// Gmsh's numbers of elements that have nodes: (number, dimension, nodes).
const KINDS: [(u32, u8, usize); 19] = [
    (1, 1, 2),
    (2, 2, 3),
    (3, 2, 4),
    (4, 3, 4),
    (5, 3, 8),
    (6, 3, 6),
    (7, 3, 5),
    (8, 1, 3),
    (9, 2, 6),
    (10, 2, 9),
    (11, 3, 10),
    (12, 3, 27),
    (13, 3, 18),
    (14, 3, 14),
    (15, 0, 1),
    (16, 2, 8),
    (17, 3, 20),
    (18, 3, 15),
    (19, 3, 13),
];

fn dimension(number: u32) -> u8 {
    KINDS.iter().find(|kind| kind.0 == number).map_or(3, |kind| kind.1)
}

fn kind(tokens: &mut Tokens) -> Result<Kind, Stop> {
    let (number, at) = tokens.integer("the type of an element")?;
    let known = KINDS.iter().find(|kind| i64::from(kind.0) == number);
    let solid = match number {
        4 => Some(Shape::Tet4),
        5 => Some(Shape::Hex8),
        6 => Some(Shape::Wedge6),
        11 => Some(Shape::Tet10),
        17 => Some(Shape::Hex20),
        18 => Some(Shape::Wedge15),
        _ => None,
    };
    match known {
        Some(&(number, dimension, nodes)) if dimension < 3 || solid.is_some() => Ok(Kind { number, nodes, solid }),
        _ => Err((at, FileFault::Shape { name: format!("{number} (Gmsh)") })),
    }
}

/// For each node of ours, the place among Gmsh's nodes.
pub(in super::super) fn order(shape: Shape) -> Vec<usize> {
    let theirs: &[[u8; 2]] = match shape {
        Shape::Tet10 => &[[0, 1], [1, 2], [2, 0], [3, 0], [2, 3], [1, 3]],
        Shape::Wedge15 => &[[0, 1], [0, 2], [0, 3], [1, 2], [1, 4], [2, 5], [3, 4], [3, 5], [4, 5]],
        Shape::Hex20 => {
            &[[0, 1], [0, 3], [0, 4], [1, 2], [1, 5], [2, 3], [2, 6], [3, 7], [4, 5], [4, 7], [5, 6], [6, 7]]
        }
        _ => &[],
    };
    let corners = shape.corners();
    let place = |&[a, b]: &[u8; 2]| theirs.iter().position(|&edge| edge == [a, b] || edge == [b, a]);
    let middles = if shape.quadratic() { shape.edges() } else { &[] };
    (0..corners).chain(middles.iter().filter_map(place).map(|edge| corners + edge)).collect()
}
