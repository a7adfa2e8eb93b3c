//! Reads Gmsh's mesh files, versions 4.1 and 2.2, as text.

mod build;
mod elements;
mod entities;
mod tokens;

use std::collections::BTreeMap;

use super::error::Errors;
use super::{FileError, FileFault, Imported, Note};
use crate::Shape;
use tokens::Tokens;

pub(super) use elements::order;

/// Elements of one entity and one kind.
#[derive(Debug)]
struct Group {
    dimension: u8,
    entity: i64,
    /// Physical groups that the elements say themselves (version 2.2).
    physical: Vec<i64>,
    kind: Kind,
    /// Labels of the nodes, one element after another.
    nodes: Vec<u64>,
    line: usize,
}

/// A kind of element, from Gmsh's number for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Kind {
    number: u32,
    nodes: usize,
    solid: Option<Shape>,
}

/// What a file says.
#[derive(Default)]
struct Raw {
    nodes: Vec<(u64, [f64; 3], (usize, usize))>,
    groups: Vec<Group>,
    /// Names of physical groups by dimension and number.
    names: BTreeMap<(u8, i64), String>,
    /// Physical groups of entities by dimension and tag (version 4.1).
    physical: BTreeMap<(u8, i64), Vec<i64>>,
    notes: Vec<Note>,
    errors: Errors,
    end: (usize, usize),
}

/// Reads a Gmsh mesh: volume groups become blocks, surface groups face sets and node sets, curve and point groups node
/// sets. Groups without a name are called `physical.DIMENSION.NUMBER`.
///
/// # Errors
///
/// Every fault of the file, at most fifty, with its place; the reading of a section stops at its first one.
pub fn read_msh(bytes: &[u8]) -> Result<Imported, Vec<FileError>> {
    build::build(parse(bytes), false)
}

/// The same, and every surface of the geometry becomes a face set `face.TAG`, in a group or not.
///
/// # Errors
///
/// As [`read_msh`].
pub fn read_msh_entities(bytes: &[u8]) -> Result<Imported, Vec<FileError>> {
    build::build(parse(bytes), true)
}

fn parse(bytes: &[u8]) -> Raw {
    let mut raw = Raw::default();
    let mut tokens = Tokens::of(bytes);
    if let Err((at, fault)) = sections(&mut raw, &mut tokens) {
        raw.errors.push(at, fault);
    }
    raw.end = tokens.place();
    raw
}

/// Where reading stops, and why.
type Stop = ((usize, usize), FileFault);

fn sections(raw: &mut Raw, tokens: &mut Tokens) -> Result<(), Stop> {
    let version = header(tokens)?;
    while let Some(section) = tokens.word() {
        let name = String::from_utf8_lossy(section.text).into_owned();
        match (name.as_str(), version) {
            ("$PhysicalNames", _) => entities::physical_names(raw, tokens)?,
            ("$Entities", Version::New) => entities::entities(raw, tokens)?,
            ("$Nodes", Version::New) => elements::nodes_4(raw, tokens)?,
            ("$Nodes", Version::Old) => elements::nodes_2(raw, tokens)?,
            ("$Elements", Version::New) => elements::elements_4(raw, tokens)?,
            ("$Elements", Version::Old) => elements::elements_2(raw, tokens)?,
            (other, _) if other.starts_with('$') => {
                raw.notes.push(Note::Skipped { card: name.clone(), count: 1, line: section.at.0 });
                tokens.skip_to(&format!("$End{}", &other[1..]))?;
                continue;
            }
            _ => {
                return Err((
                    section.at,
                    FileFault::Expected { expected: "a section that begins with `$`", found: name },
                ));
            }
        }
        tokens.expect(&format!("$End{}", &name[1..]))?;
    }
    Ok(())
}

#[derive(Clone, Copy, PartialEq)]
enum Version {
    Old,
    New,
}

fn header(tokens: &mut Tokens) -> Result<Version, Stop> {
    tokens.expect("$MeshFormat")?;
    let version = tokens.take("the version of the format")?;
    let found = String::from_utf8_lossy(version.text).into_owned();
    let kind = match found.as_str() {
        "4.1" => Version::New,
        "2.2" | "2.1" | "2" => Version::Old,
        _ => return Err((version.at, FileFault::Version { found })),
    };
    let (binary, at) = tokens.integer("0 for a text file")?;
    if binary != 0 {
        return Err((at, FileFault::Binary));
    }
    tokens.integer("the size of a number")?;
    tokens.expect("$EndMeshFormat")?;
    Ok(kind)
}
