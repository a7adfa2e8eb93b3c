//! Flexible bodies row by row as files for ParaView: an unstructured grid of the surface for each row (`.vtu`), and a
//! collection (`.pvd`) that gives each its time.
//!
//! Places are those of the undeformed body where its floating frame is, world axes, so that several bodies stand
//! together and `Warp By Vector` deforms them as much as wanted.

use std::io::{self, Write};

use crate::FlexibleMotion;
use crate::solid::vector::{place, turned};

/// One file of a collection.
#[derive(Clone, Debug, PartialEq)]
pub struct PvdEntry {
    /// Time, or what else the rows are counted by.
    pub at: f64,
    /// Body, counted from 0.
    pub part: usize,
    /// Its name.
    pub name: String,
    /// Path of the file, as seen from the collection.
    pub file: String,
}

/// Writes the collection.
///
/// # Errors
/// What `out` fails with.
pub fn write_pvd(entries: &[PvdEntry], out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">"
    )?;
    writeln!(out, "<Collection>")?;
    for entry in entries {
        let (name, file) = (escaped(&entry.name), escaped(&entry.file));
        writeln!(
            out,
            "<DataSet timestep=\"{}\" group=\"\" part=\"{}\" name=\"{name}\" file=\"{file}\"/>",
            entry.at, entry.part
        )?;
    }
    writeln!(out, "</Collection>\n</VTKFile>")
}

/// Writes the body in one of its rows: `displacement [m]` against its floating frame (world axes), `von Mises stress
/// [Pa]`, `stress [Pa]` (xx, yy, zz, xy, yz, xz, axes of the body), and the largest von Mises stress of all rows.
/// Numbers are in single precision.
///
/// # Errors
/// What `out` fails with.
pub fn write_vtu_row(motion: &FlexibleMotion, at: usize, out: &mut dyn Write) -> io::Result<()> {
    let Some(pose) = motion.poses.get(at) else { return Err(io::Error::other("no such row")) };
    let nodes = 0..motion.nodes.len();
    let places = motion.nodes.iter().flat_map(|p| place(pose, p.map(f64::from)));
    let moves = nodes.clone().flat_map(|node| turned(pose.quaternion, motion.displacement(at, node)));
    let stresses: Vec<[f64; 6]> = nodes.clone().map(|node| motion.stress(at, node)).collect();
    let mises = nodes.map(|node| motion.von_mises(at, node));
    let mut grid = Grid::default();
    grid.open("PointData");
    grid.floats("displacement [m]", 3, moves);
    grid.floats("von Mises stress [Pa]", 1, mises);
    grid.floats("stress [Pa]", 6, stresses.into_iter().flatten());
    grid.floats("largest von Mises stress of all rows [Pa]", 1, motion.envelope.iter().copied().map(f64::from));
    grid.close("PointData");
    grid.open("Points");
    grid.floats("Points", 3, places);
    grid.close("Points");
    grid.triangles(&motion.triangles);
    grid.write(motion.nodes.len(), motion.triangles.len(), out)
}

/// Headers of arrays, and their numbers, which follow all headers raw.
#[derive(Default)]
struct Grid {
    header: String,
    data: Vec<u8>,
}

impl Grid {
    fn open(&mut self, section: &str) {
        self.header.push_str(&format!("<{section}>\n"));
    }

    fn close(&mut self, section: &str) {
        self.header.push_str(&format!("</{section}>\n"));
    }

    fn array(&mut self, kind: &str, name: &str, components: usize, bytes: &[u8]) {
        let offset = self.data.len();
        self.header.push_str(&format!(
            "<DataArray type=\"{kind}\" Name=\"{}\" NumberOfComponents=\"{components}\" format=\"appended\" \
             offset=\"{offset}\"/>\n",
            escaped(name)
        ));
        self.data.extend((bytes.len() as u64).to_le_bytes());
        self.data.extend(bytes);
    }

    fn floats(&mut self, name: &str, components: usize, numbers: impl Iterator<Item = f64>) {
        let bytes: Vec<u8> = numbers.flat_map(|x| (x as f32).to_le_bytes()).collect();
        self.array("Float32", name, components, &bytes);
    }

    fn triangles(&mut self, triangles: &[[u32; 3]]) {
        /// VTK's number for a triangle.
        const TRIANGLE: u8 = 5;
        let corners: Vec<u8> =
            triangles.as_flattened().iter().flat_map(|node| i64::from(*node).to_le_bytes()).collect();
        let ends: Vec<u8> = (1..=triangles.len()).flat_map(|k| (3 * k as i64).to_le_bytes()).collect();
        self.open("Cells");
        self.array("Int64", "connectivity", 1, &corners);
        self.array("Int64", "offsets", 1, &ends);
        self.array("UInt8", "types", 1, &vec![TRIANGLE; triangles.len()]);
        self.close("Cells");
    }

    fn write(&self, points: usize, cells: usize, out: &mut dyn Write) -> io::Result<()> {
        write!(
            out,
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">\n{}\
             </Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_",
            self.header
        )?;
        out.write_all(&self.data)?;
        out.write_all(b"\n</AppendedData>\n</VTKFile>\n")
    }
}

fn escaped(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::tests::motion;

    /// The numbers of an array of floats, found by its header.
    fn floats(file: &[u8], name: &str) -> Vec<f32> {
        let text = String::from_utf8_lossy(file);
        let head = text.find(&format!("Name=\"{name}\"")).expect("its header");
        let offset = text[head..].split("offset=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("an offset");
        let marker = b"<AppendedData encoding=\"raw\">\n_";
        let start = file.windows(marker.len()).position(|w| w == marker).expect("data") + marker.len();
        let at = start + offset.parse::<usize>().expect("a number");
        let length = u64::from_le_bytes(file[at..at + 8].try_into().expect("eight bytes")) as usize;
        file[at + 8..at + 8 + length].as_chunks::<4>().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()
    }

    #[test]
    fn a_row_holds_the_body_where_it_is() {
        let mut of = motion();
        // A quarter turn about z: x becomes y.
        let half = std::f64::consts::FRAC_1_SQRT_2;
        of.poses[1] = crate::Pose { position: [10.0, 20.0, 30.0], quaternion: [half, 0.0, 0.0, half] };
        let mut file = Vec::new();
        write_vtu_row(&of, 1, &mut file).expect("memory takes it");
        let near = |found: &[f32], expected: &[f64]| {
            assert_eq!(found.len(), expected.len());
            assert!(
                found.iter().zip(expected).all(|(a, b)| (f64::from(*a) - b).abs() < 1e-5),
                "{found:?} {expected:?}"
            );
        };
        near(&floats(&file, "Points")[..3], &[9.8, 20.1, 30.3]);
        near(&floats(&file, "displacement [m]")[..3], &[5.5, 1.875, 1.75]);
        near(&floats(&file, "stress [Pa]")[6..12], &of.stress(1, 1));
        near(&floats(&file, "von Mises stress [Pa]")[1..2], &[of.von_mises(1, 1)]);
        assert!(write_vtu_row(&of, 2, &mut Vec::new()).is_err());
    }

    #[test]
    fn names_cannot_break_a_collection() {
        let entry = PvdEntry { at: 0.25, part: 1, name: "a\"<b".to_owned(), file: "a/a_0001.vtu".to_owned() };
        let mut file = Vec::new();
        write_pvd(&[entry], &mut file).expect("memory takes it");
        let text = String::from_utf8(file).expect("text");
        assert!(text.contains("timestep=\"0.25\" group=\"\" part=\"1\" name=\"a&quot;&lt;b\" file=\"a/a_0001.vtu\""));
    }
}
