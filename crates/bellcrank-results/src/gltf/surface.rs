//! Real forms as triangles: smooth where neighbours are nearly in one plane, sharp elsewhere.

use super::mesh::Mesh;
use crate::Surface;
use crate::solid::vector::{V3, cross, dot, norm, sub};

/// Cosine of the angle up to which neighbours meet smoothly, 30 degrees.
const SMOOTH: f64 = 0.866_025_403_784_438_6;

/// Adds a surface. A corner has the mean normal of the triangles around it that meet smoothly, by their angles there.
pub(super) fn push(mesh: &mut Mesh, surface: &Surface) {
    let corners = |triangle: &[u32; 3]| triangle.map(|k| surface.points.get(k as usize).copied());
    let whole = surface.triangles.iter().filter_map(|triangle| match corners(triangle) {
        [Some(a), Some(b), Some(c)] => Some((*triangle, [a, b, c])),
        _ => None,
    });
    let faces: Vec<Face> = whole.filter_map(|(triangle, corners)| Face::of(triangle, corners)).collect();
    let mut around: Vec<Vec<(usize, usize)>> = vec![Vec::new(); surface.points.len()];
    for (face, of) in faces.iter().enumerate() {
        of.triangle.iter().enumerate().for_each(|(corner, point)| around[*point as usize].push((face, corner)));
    }
    for face in &faces {
        let [a, b, c] = std::array::from_fn(|corner| {
            let point = face.triangle[corner] as usize;
            mesh.vertex(surface.points[point], normal(&faces, &around[point], face.normal))
        });
        mesh.triangle(a, b, c);
    }
}

struct Face {
    triangle: [u32; 3],
    normal: V3,
    /// At its corners, rad.
    angles: [f64; 3],
}

impl Face {
    /// Nothing for one without area.
    fn of(triangle: [u32; 3], [a, b, c]: [V3; 3]) -> Option<Face> {
        let normal = cross(sub(b, a), sub(c, a));
        let length = norm(normal);
        let angle = |at: V3, to: V3, other: V3| {
            norm(cross(sub(to, at), sub(other, at))).atan2(dot(sub(to, at), sub(other, at)))
        };
        let angles = [angle(a, b, c), angle(b, c, a), angle(c, a, b)];
        (length > 0.0).then(|| Face { triangle, normal: normal.map(|x| x / length), angles })
    }
}

fn normal(faces: &[Face], around: &[(usize, usize)], own: V3) -> V3 {
    let near = around.iter().filter(|(face, _)| dot(faces[*face].normal, own) >= SMOOTH);
    near.fold([0.0; 3], |sum, (face, corner)| {
        let face = &faces[*face];
        std::array::from_fn(|k| sum[k] + face.angles[*corner] * face.normal[k])
    })
}
