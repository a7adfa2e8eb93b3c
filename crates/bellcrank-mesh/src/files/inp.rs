//! Reads the mesh of an Abaqus or CalculiX input file: nodes, solid elements, sets, surfaces.

mod build;
mod cards;

use std::collections::BTreeMap;

use super::error::Errors;
use super::{FileError, FileFault, Imported, Note};
use crate::Shape;
use cards::{Card, Lines};

/// Place in a text: line and column, from 1.
type Place = (usize, usize);

/// One entry of a set: a label, or the name of another set.
#[derive(Clone, Debug)]
struct Entry {
    text: String,
    at: Place,
}

/// A set as the file says it; cards of one name add up.
#[derive(Clone, Debug, Default)]
struct RawSet {
    name: String,
    labels: Vec<u64>,
    entries: Vec<Entry>,
}

/// A surface as the file says it: elements or sets, and the face.
#[derive(Clone, Debug, Default)]
struct RawSurface {
    name: String,
    of_nodes: bool,
    rows: Vec<(Entry, Option<Entry>)>,
}

/// An element with the labels of its nodes.
#[derive(Clone, Debug)]
struct RawElement {
    label: u64,
    nodes: Vec<u64>,
    at: Place,
}

/// Elements of one card or of several of one type and set.
#[derive(Clone, Debug)]
struct RawElements {
    name: String,
    kind: Kind,
    elements: Vec<RawElement>,
}

/// What an element type is to us.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Solid(Shape),
    /// Shells, membranes and plane elements mark faces of solids.
    Surface,
    Other,
}

/// All that was understood of a file. Sets go by their name in capitals.
#[derive(Default)]
struct Raw {
    nodes: Vec<(u64, [f64; 3], Place)>,
    elements: Vec<RawElements>,
    node_sets: BTreeMap<String, RawSet>,
    element_sets: BTreeMap<String, RawSet>,
    surfaces: BTreeMap<String, RawSurface>,
    notes: Vec<Note>,
    errors: Errors,
    end: Place,
}

/// Reads the mesh of an Abaqus or CalculiX input file.
///
/// Sets of nodes and surfaces become sets of the mesh; sets that element cards name become blocks, and shells or
/// membranes in them face sets. What says nothing about the mesh is skipped and told. Reduced integration, incompatible
/// modes and hybrid elements are read as fully integrated ones, which a note tells.
///
/// # Errors
///
/// Every fault of the file, at most fifty, with its place.
pub fn read_inp(bytes: &[u8]) -> Result<Imported, Vec<FileError>> {
    let text = String::from_utf8_lossy(bytes);
    let mut raw = Raw::default();
    let mut lines = Lines::of(&text);
    while let Some(card) = lines.next_card(&mut raw.errors) {
        read_card(&mut raw, &card, &mut lines);
        if raw.errors.full() {
            break;
        }
    }
    raw.end = lines.end();
    build::build(raw)
}

/// Cards that change nodes or elements that were read: leaving them out would give another mesh.
const CHANGING: [&str; 10] =
    ["INCLUDE", "NGEN", "NCOPY", "NFILL", "NMAP", "ELGEN", "ELCOPY", "SYSTEM", "SUBSTRUCTURE GENERATE", "MANIFEST"];
/// Cards round the mesh that need no mention.
const SILENT: [&str; 8] =
    ["HEADING", "PREPRINT", "PART", "END PART", "ASSEMBLY", "END ASSEMBLY", "INSTANCE", "END INSTANCE"];

fn read_card(raw: &mut Raw, card: &Card, lines: &mut Lines) {
    match card.name.as_str() {
        "NODE" => nodes(raw, card, lines),
        "ELEMENT" => elements(raw, card, lines),
        "NSET" => set(raw, card, lines, "NSET"),
        "ELSET" => set(raw, card, lines, "ELSET"),
        "SURFACE" => surface(raw, card, lines),
        "INSTANCE" => {
            if let Some(row) = lines.next_row() {
                raw.errors.push((row.line, 1), FileFault::Unsupported { card: "INSTANCE with a position".to_owned() });
            }
            lines.skip_rows();
        }
        name if CHANGING.contains(&name) => {
            raw.errors.push(card.at, FileFault::Unsupported { card: name.to_owned() });
            lines.skip_rows();
        }
        name => {
            if !SILENT.contains(&name) {
                raw.skipped(name, card.at.0);
            }
            lines.skip_rows();
        }
    }
}

impl Raw {
    fn skipped(&mut self, name: &str, at: usize) {
        let name = format!("*{name}");
        let same = self.notes.iter_mut().find_map(|note| match note {
            Note::Skipped { card, count, .. } if *card == name => Some(count),
            _ => None,
        });
        match same {
            Some(count) => *count += 1,
            None => self.notes.push(Note::Skipped { card: name, count: 1, line: at }),
        }
    }

    fn number(&mut self, entry: &Entry, expected: &'static str) -> Option<f64> {
        // Fortran writes 1.5D-3, too.
        let tidy = entry.text.replace(['d', 'D'], "e");
        let value = tidy.parse::<f64>().ok().filter(|value| value.is_finite());
        if value.is_none() {
            self.errors.push(entry.at, FileFault::Expected { expected, found: entry.text.clone() });
        }
        value
    }

    fn label(&mut self, entry: &Entry, expected: &'static str) -> Option<u64> {
        let value = entry.text.parse::<u64>().ok();
        if value.is_none() {
            self.errors.push(entry.at, FileFault::Expected { expected, found: entry.text.clone() });
        }
        value
    }
}

fn nodes(raw: &mut Raw, card: &Card, lines: &mut Lines) {
    let mut labels = Vec::new();
    while let Some(row) = lines.next_row() {
        let entries = row.entries();
        let Some(label) = entries.first().and_then(|entry| raw.label(entry, "the number of a node")) else { continue };
        if entries.len() < 3 && lines.at_end() {
            raw.errors.push(row.end(), FileFault::EndsEarly { within: "the coordinates of a node" });
            continue;
        }
        let mut place = [0.0; 3];
        for (c, entry) in place.iter_mut().zip(entries.iter().skip(1).filter(|entry| !entry.text.is_empty())) {
            *c = raw.number(entry, "a coordinate").unwrap_or(0.0);
        }
        raw.nodes.push((label, place, (row.line, 1)));
        labels.push(label);
    }
    if let Some(name) = card.value("NSET") {
        named(&mut raw.node_sets, name).labels.extend(labels);
    }
}

fn named<'a>(sets: &'a mut BTreeMap<String, RawSet>, name: &str) -> &'a mut RawSet {
    sets.entry(name.to_uppercase()).or_insert_with(|| RawSet { name: name.to_owned(), ..RawSet::default() })
}

/// Number of nodes of an element type, as far as a row of unknown length needs it.
fn kind_of(name: &str) -> Option<(Kind, usize)> {
    let solid = |shape: Shape| Some((Kind::Solid(shape), shape.nodes()));
    let base = name.strip_prefix("DC3D").or_else(|| name.strip_prefix("C3D")).or_else(|| name.strip_prefix('F'));
    if let Some(rest) = base.filter(|_| name.starts_with("C3D")) {
        let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
        return match digits.as_str() {
            "4" => solid(Shape::Tet4),
            "10" => solid(Shape::Tet10),
            "6" => solid(Shape::Wedge6),
            "15" => solid(Shape::Wedge15),
            "8" => solid(Shape::Hex8),
            "20" => solid(Shape::Hex20),
            _ => None,
        };
    }
    let families = ["CPS", "CPE", "CAX", "M3D", "SFM3D", "STRI", "DS", "S"];
    let Some(rest) = families.iter().find_map(|family| name.strip_prefix(family)) else {
        return Some((Kind::Other, 0));
    };
    let digits: String = rest.chars().take_while(char::is_ascii_digit).collect();
    match digits.as_str() {
        "3" => Some((Kind::Surface, 3)),
        "4" => Some((Kind::Surface, 4)),
        "6" | "65" => Some((Kind::Surface, 6)),
        "8" => Some((Kind::Surface, 8)),
        "9" => Some((Kind::Surface, 9)),
        _ => Some((Kind::Other, 0)),
    }
}

fn elements(raw: &mut Raw, card: &Card, lines: &mut Lines) {
    let Some(name) = card.value("TYPE").map(str::to_uppercase) else {
        raw.errors.push(card.at, FileFault::Parameter { card: "ELEMENT".to_owned(), parameter: "TYPE" });
        return lines.skip_rows();
    };
    let Some((kind, count)) = kind_of(&name) else {
        raw.errors.push(card.at, FileFault::Shape { name });
        return lines.skip_rows();
    };
    let mut read = Vec::new();
    while let Some(row) = lines.next_row() {
        let (mut entries, mut end) = (row.entries(), row.end());
        let mut open = row.open();
        while if count > 0 { entries.len() < count + 1 } else { open } {
            let Some(more) = lines.next_row() else { break };
            entries.extend(more.entries());
            (end, open) = (more.end(), more.open());
        }
        if count > 0 && entries.len() < count + 1 {
            let fault = if lines.at_end() {
                FileFault::EndsEarly { within: "the nodes of an element" }
            } else {
                FileFault::Expected { expected: "more nodes of the element", found: "another card".to_owned() }
            };
            raw.errors.push(end, fault);
            continue;
        }
        if let Some(extra) = entries.get(count + 1).filter(|_| count > 0) {
            let expected = "the end of the element";
            raw.errors.push(extra.at, FileFault::Expected { expected, found: extra.text.clone() });
        }
        let expected = |k: usize| if k == 0 { "the number of an element" } else { "the number of a node" };
        let row_labels: Option<Vec<u64>> =
            entries.iter().take(count + 1).enumerate().map(|(k, entry)| raw.label(entry, expected(k))).collect();
        if let Some([label, nodes @ ..]) = row_labels.as_deref() {
            read.push(RawElement { label: *label, nodes: nodes.to_vec(), at: (row.line, 1) });
        }
        if raw.errors.full() {
            return;
        }
    }
    notes_of(raw, &name, kind, read.len(), card.at.0);
    let set = card.value("ELSET").unwrap_or_default();
    if !set.is_empty() {
        named(&mut raw.element_sets, set).labels.extend(read.iter().map(|element| element.label));
    }
    let same = |other: &&mut RawElements| other.kind == kind && other.name.eq_ignore_ascii_case(set);
    match raw.elements.iter_mut().find(same) {
        Some(other) => other.elements.extend(read),
        None => raw.elements.push(RawElements { name: set.to_owned(), kind, elements: read }),
    }
}

fn notes_of(raw: &mut Raw, name: &str, kind: Kind, read: usize, line: usize) {
    match kind {
        Kind::Solid(shape) if shape.abaqus() != name => {
            let known = |note: &Note| matches!(note, Note::ReadAs { name: other, .. } if other == name);
            if !raw.notes.iter().any(known) {
                raw.notes.push(Note::ReadAs { name: name.to_owned(), shape: shape.abaqus(), line });
            }
        }
        Kind::Solid(_) => {}
        Kind::Surface | Kind::Other => {
            let same = raw.notes.iter_mut().find_map(|note| match note {
                Note::ElementsLeftOut { name: other, count, .. } if other == name => Some(count),
                _ => None,
            });
            match same {
                Some(count) => *count += read,
                None => raw.notes.push(Note::ElementsLeftOut { name: name.to_owned(), count: read, line }),
            }
        }
    }
}

fn set(raw: &mut Raw, card: &Card, lines: &mut Lines, parameter: &'static str) {
    let Some(name) = card.value(parameter) else {
        raw.errors.push(card.at, FileFault::Parameter { card: card.name.clone(), parameter });
        return lines.skip_rows();
    };
    let mut read = RawSet { name: name.to_owned(), ..RawSet::default() };
    while let Some(row) = lines.next_row() {
        let entries: Vec<Entry> = row.entries().into_iter().filter(|entry| !entry.text.is_empty()).collect();
        if card.has("GENERATE") {
            generate(raw, &entries, row.end(), &mut read.labels);
        } else {
            for entry in entries {
                match entry.text.parse::<u64>() {
                    Ok(label) => read.labels.push(label),
                    Err(_) => read.entries.push(entry),
                }
            }
        }
    }
    // Sets of an unsorted mixture keep the place of their entries by name only; a label's place is its card's.
    let sets = if parameter == "NSET" { &mut raw.node_sets } else { &mut raw.element_sets };
    let set = named(sets, name);
    set.labels.append(&mut read.labels);
    set.entries.append(&mut read.entries);
}

/// Most labels that one row may generate.
const MOST_GENERATED: u64 = 100_000_000;

fn generate(raw: &mut Raw, entries: &[Entry], end: Place, labels: &mut Vec<u64>) {
    let expected = "the first label, the last, and the step";
    let read: Option<Vec<u64>> = entries.iter().map(|entry| raw.label(entry, expected)).collect();
    let (first, last, step) = match read.as_deref() {
        Some(&[first, last]) => (first, last, 1),
        Some(&[first, last, step]) => (first, last, step),
        Some(_) => {
            let found = entries.last().map_or_else(String::new, |entry| entry.text.clone());
            return raw.errors.push(end, FileFault::Expected { expected, found });
        }
        None => return,
    };
    if step == 0 || last < first || (last - first) / step > MOST_GENERATED {
        let found = format!("{first}, {last}, {step}");
        return raw.errors.push(entries[0].at, FileFault::Expected { expected, found });
    }
    labels.extend((first..=last).step_by(step as usize));
}

fn surface(raw: &mut Raw, card: &Card, lines: &mut Lines) {
    let Some(name) = card.value("NAME") else {
        raw.errors.push(card.at, FileFault::Parameter { card: "SURFACE".to_owned(), parameter: "NAME" });
        return lines.skip_rows();
    };
    let kind = card.value("TYPE").map_or_else(|| "ELEMENT".to_owned(), str::to_uppercase);
    if kind != "ELEMENT" && kind != "NODE" {
        raw.skipped(&format!("SURFACE, TYPE={kind}"), card.at.0);
        return lines.skip_rows();
    }
    let mut rows = Vec::new();
    while let Some(row) = lines.next_row() {
        let mut entries = row.entries().into_iter();
        if let Some(first) = entries.next().filter(|entry| !entry.text.is_empty()) {
            rows.push((first, entries.next().filter(|entry| !entry.text.is_empty())));
        }
    }
    let surface = raw.surfaces.entry(name.to_uppercase()).or_default();
    surface.name = name.to_owned();
    surface.of_nodes = kind == "NODE";
    surface.rows.extend(rows);
}
