//! The outside of a mesh as flat triangles, for pictures.

use crate::{Face, Mesh};

/// Triangles between the nodes of faces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Numbers of the nodes in the mesh, ascending: values at nodes are picked by them.
    pub nodes: Vec<u32>,
    /// Triangles by place in `nodes`, with the normal out of the material.
    pub triangles: Vec<[u32; 3]>,
    /// Face that each triangle is of.
    pub faces: Vec<Face>,
}

/// Corners and mid-sides of a face divided so that every node is used: 1, 4, 2 or 6 triangles.
fn parts(nodes: usize) -> &'static [[usize; 3]] {
    match nodes {
        3 => &[[0, 1, 2]],
        6 => &[[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]],
        4 => &[[0, 1, 2], [0, 2, 3]],
        _ => &[[0, 4, 7], [4, 1, 5], [5, 2, 6], [6, 3, 7], [4, 5, 7], [5, 6, 7]],
    }
}

impl Mesh {
    /// Triangles of faces. The boundary is what a picture shows: `mesh.surface(&mesh.boundary())`.
    pub fn surface(&self, faces: &[Face]) -> Surface {
        let nodes = self.nodes_of_faces(faces);
        let mut place = vec![0; self.nodes.len()];
        nodes.iter().enumerate().for_each(|(k, &node)| place[node as usize] = k as u32);
        let mut surface = Surface { nodes, ..Surface::default() };
        for &face in faces {
            let nodes: Vec<u32> = self.face_nodes(face).collect();
            let corner = |k: usize| place[nodes[k] as usize];
            let triangles = parts(nodes.len()).iter().map(|part| part.map(corner));
            surface.triangles.extend(triangles);
            surface.faces.resize(surface.triangles.len(), face);
        }
        surface
    }
}
