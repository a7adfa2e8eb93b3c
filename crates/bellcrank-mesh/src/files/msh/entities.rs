//! Sections that name things: physical groups and the entities in them.

use super::tokens::Tokens;
use super::{Raw, Stop};

pub(super) fn physical_names(raw: &mut Raw, tokens: &mut Tokens) -> Result<(), Stop> {
    for _ in 0..tokens.natural("the number of names")? {
        let dimension = tokens.natural("the dimension of a group")?.min(3) as u8;
        let number = tokens.integer("the number of a group")?.0;
        let name = tokens.name();
        raw.names.insert((dimension, number), name);
    }
    Ok(())
}

/// Points, curves, surfaces, volumes with their boxes, groups and boundaries.
pub(super) fn entities(raw: &mut Raw, tokens: &mut Tokens) -> Result<(), Stop> {
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = tokens.natural("the number of entities")?;
    }
    for (dimension, count) in counts.into_iter().enumerate() {
        for _ in 0..count {
            let tag = tokens.integer("the tag of an entity")?.0;
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                tokens.real("the box of an entity")?;
            }
            let mut groups = Vec::new();
            for _ in 0..tokens.natural("the number of groups")? {
                groups.push(tokens.integer("the number of a group")?.0);
            }
            raw.physical.insert((dimension as u8, tag), groups);
            if dimension > 0 {
                for _ in 0..tokens.natural("the number of bounding entities")? {
                    tokens.integer("the tag of an entity")?;
                }
            }
        }
    }
    Ok(())
}
