//! STEP (ISO 10303-21, AP214): exact solids and where they stand, for other CAD programs. Lengths are written in mm.

mod assembly;
mod brep;
mod look;
mod text;

use super::Shell;
use assembly::Product;
use text::{File, text};

/// A part and the places it stands in.
#[derive(Clone, Debug)]
pub struct StepPart {
    /// Name of the product.
    pub name: String,
    /// Its boundary.
    pub shell: Shell,
    /// Red, green, blue from 0 to 1.
    pub color: Option<[f64; 3]>,
    /// Name of its material.
    pub material: Option<String>,
    /// Where it stands in the assembly; none for a part that does not.
    pub instances: Vec<Placement>,
}

/// Where the axes of a part are in those of the assembly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Columns are the directions of the part's x, y and z axes: `rotation[row][column]`.
    pub rotation: [[f64; 3]; 3],
    /// Its origin, in m.
    pub translation: [f64; 3],
}

impl Placement {
    /// Axes that coincide.
    pub const IDENTITY: Placement =
        Placement { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], translation: [0.0; 3] };
}

/// The text of a STEP file. One part that stands once at the origin is a part alone; anything else is an assembly of
/// this name. The same parts give the same text: the time in its header is `time` (ISO 8601).
pub fn write(name: &str, time: &str, parts: &[StepPart]) -> String {
    let mut file = File::default();
    let context = file.context();
    let products: Vec<Product> = parts.iter().map(|part| assembly::part(&mut file, &context, part)).collect();
    let alone = parts.len() == 1 && parts[0].instances == [Placement::IDENTITY];
    if !alone {
        assembly::assembly(&mut file, &context, name, parts, &products);
    }
    look::colors(&mut file, &context, parts, &products);
    header(name, time) + &file.entities + "ENDSEC;\nEND-ISO-10303-21;\n"
}

fn header(name: &str, time: &str) -> String {
    let (name, time) = (text(name), text(time));
    format!(
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n\
         FILE_NAME({name},{time},(''),(''),'bellcrank','bellcrank','');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n"
    )
}
