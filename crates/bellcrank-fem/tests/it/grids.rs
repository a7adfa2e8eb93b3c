//! Meshes for tests: a block of cells of every shape, bent by a map.

use std::collections::HashMap;

use bellcrank_mesh::{Block, Face, Mesh, Shape};

/// A mesh of nx × ny × nz cells of the unit cube, every node moved by a map. Wedges are two a cell, tetrahedra six.
pub(crate) fn grid(shape: Shape, [nx, ny, nz]: [usize; 3], map: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh {
    let mut builder = Builder { lookup: HashMap::new(), places: Vec::new() };
    let step = [2 * nx, 2 * ny, 2 * nz];
    let mut nodes = Vec::new();
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                for cell in cells(shape) {
                    let corners: Vec<[usize; 3]> =
                        cell.iter().map(|c| [2 * (i + c[0]), 2 * (j + c[1]), 2 * (k + c[2])]).collect();
                    nodes.extend(corners.iter().map(|&at| builder.node(at)));
                    if shape.quadratic() {
                        for ends in shape.edges() {
                            let [a, b] = ends.map(|end| corners[end as usize]);
                            nodes.push(builder.node(std::array::from_fn(|c| (a[c] + b[c]) / 2)));
                        }
                    }
                }
            }
        }
    }
    let place = |at: &[usize; 3]| map(std::array::from_fn(|c| at[c] as f64 / step[c] as f64));
    let places = builder.places.iter().map(place).collect();
    let block = Block { name: "all".to_owned(), shape, nodes };
    Mesh { nodes: places, blocks: vec![block], ..Mesh::default() }
}

struct Builder {
    lookup: HashMap<[usize; 3], u32>,
    places: Vec<[usize; 3]>,
}

impl Builder {
    fn node(&mut self, at: [usize; 3]) -> u32 {
        let next = self.places.len() as u32;
        *self.lookup.entry(at).or_insert_with(|| {
            self.places.push(at);
            next
        })
    }
}

/// Corners of the elements that fill the unit cell.
fn cells(shape: Shape) -> Vec<Vec<[usize; 3]>> {
    let cube = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
    let pick = |list: &[usize]| list.iter().map(|&k| cube[k]).collect::<Vec<_>>();
    match shape.corners() {
        8 => vec![pick(&[0, 1, 2, 3, 4, 5, 6, 7])],
        6 => vec![pick(&[0, 1, 2, 4, 5, 6]), pick(&[0, 2, 3, 4, 6, 7])],
        _ => [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]]
            .iter()
            .map(|tet| pick(tet))
            .collect(),
    }
}

/// Nodes whose place before the map would be asked for: by a test on the mapped place.
pub(crate) fn nodes_where(mesh: &Mesh, test: impl Fn([f64; 3]) -> bool) -> Vec<u32> {
    (0..mesh.nodes.len() as u32).filter(|&node| test(mesh.nodes[node as usize])).collect()
}

/// Faces all of whose nodes pass a test.
pub(crate) fn faces_where(mesh: &Mesh, test: impl Fn([f64; 3]) -> bool) -> Vec<Face> {
    let mut found = Vec::new();
    for (block, elements) in mesh.blocks.iter().enumerate() {
        for element in 0..elements.len() {
            for face in 0..elements.shape.faces().len() {
                let face = Face { block: block as u32, element: element as u32, face: face as u8 };
                if mesh.face_nodes(face).all(|node| test(mesh.nodes[node as usize])) {
                    found.push(face);
                }
            }
        }
    }
    found
}
