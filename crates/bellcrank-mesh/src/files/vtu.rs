//! Writes VTK's unstructured grids for ParaView, with the numbers appended raw.
//!
//! An own writer of a hundred lines: the format is one XML header and little-endian arrays, and `vtkio` would bring
//! thirty crates for it.

use std::fmt::Write;

use crate::{Mesh, Shape};

/// A quantity at the nodes or in the elements.
#[derive(Clone, Debug)]
pub struct VtuField<'a> {
    /// Its name, with the unit.
    pub name: &'a str,
    /// Numbers of one node or element: 1 for a scalar, 3 for a vector, 6 for a symmetric tensor (xx, yy, zz, xy, yz,
    /// xz).
    pub components: usize,
    /// Numbers of one node or element after another; elements in the order of the blocks.
    pub values: &'a [f64],
}

/// VTK's number for a shape.
fn cell_type(shape: Shape) -> u8 {
    match shape {
        Shape::Tet4 => 10,
        Shape::Hex8 => 12,
        Shape::Wedge6 => 13,
        Shape::Tet10 => 24,
        Shape::Hex20 => 25,
        Shape::Wedge15 => 26,
    }
}

/// Header and data of the arrays so far.
#[derive(Default)]
struct Vtu {
    header: String,
    data: Vec<u8>,
}

impl Vtu {
    fn array(&mut self, kind: &str, name: &str, components: usize, bytes: &[u8]) {
        let offset = self.data.len();
        let _ = writeln!(
            self.header,
            "<DataArray type=\"{kind}\" Name=\"{}\" NumberOfComponents=\"{components}\" format=\"appended\" \
             offset=\"{offset}\"/>",
            escaped(name)
        );
        self.data.extend((bytes.len() as u64).to_le_bytes());
        self.data.extend(bytes);
    }

    fn fields(&mut self, section: &str, fields: &[VtuField]) {
        let _ = writeln!(self.header, "<{section}>");
        for field in fields {
            let bytes: Vec<u8> = field.values.iter().flat_map(|value| value.to_le_bytes()).collect();
            self.array("Float64", field.name, field.components, &bytes);
        }
    }
}

fn escaped(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A mesh with quantities as a `.vtu` file. The number of the block of each element goes with it as `block`.
pub fn write_vtu(mesh: &Mesh, at_nodes: &[VtuField], in_elements: &[VtuField]) -> Vec<u8> {
    let mut vtu = Vtu::default();
    let (points, cells) = (mesh.nodes.len(), mesh.element_count());
    vtu.header.push_str(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\">\n<UnstructuredGrid>\n",
    );
    let _ = writeln!(vtu.header, "<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">");
    vtu.fields("PointData", at_nodes);
    vtu.header.push_str("</PointData>\n");
    vtu.fields("CellData", in_elements);
    let blocks: Vec<u8> = each_element(mesh, |block| block as i32).flat_map(i32::to_le_bytes).collect();
    vtu.array("Int32", "block", 1, &blocks);
    vtu.header.push_str("</CellData>\n<Points>\n");
    let places: Vec<u8> = mesh.nodes.iter().flatten().flat_map(|c| c.to_le_bytes()).collect();
    vtu.array("Float64", "Points", 3, &places);
    vtu.header.push_str("</Points>\n<Cells>\n");
    connectivity(&mut vtu, mesh);
    vtu.header.push_str("</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
    let mut bytes = vtu.header.into_bytes();
    bytes.extend(vtu.data);
    bytes.extend(b"\n</AppendedData>\n</VTKFile>\n");
    bytes
}

/// A number for each element, from its block.
fn each_element<T: Copy>(mesh: &Mesh, of: impl Fn(usize) -> T) -> impl Iterator<Item = T> {
    mesh.blocks.iter().enumerate().flat_map(move |(k, block)| std::iter::repeat_n(of(k), block.len()))
}

fn connectivity(vtu: &mut Vtu, mesh: &Mesh) {
    let elements = mesh.blocks.iter().flat_map(|block| block.elements());
    let nodes: Vec<u8> = elements.flatten().flat_map(|&node| i64::from(node).to_le_bytes()).collect();
    vtu.array("Int64", "connectivity", 1, &nodes);
    let mut end = 0;
    let ends = each_element(mesh, |block| mesh.blocks[block].shape.nodes() as i64).flat_map(|count| {
        end += count;
        end.to_le_bytes()
    });
    let ends: Vec<u8> = ends.collect();
    vtu.array("Int64", "offsets", 1, &ends);
    let types: Vec<u8> = each_element(mesh, |block| cell_type(mesh.blocks[block].shape)).collect();
    vtu.array("UInt8", "types", 1, &types);
}
