//! The surface as it is drawn: deformed, with normals and its sharp edges.

use bellcrank_results::{Contour, ContourShape};

use super::vector::{V3, add, bounds, cross, dot, length, scaled, sub, unit};

/// Cosine of the angle between two faces above which the edge between them is drawn as one.
const SHARP: f32 = 0.82;

/// Edges at which the surface ends or turns sharply: pairs of nodes.
pub(crate) fn outline(contour: &Contour) -> Vec<[u32; 2]> {
    let normals = face_normals(contour, &contour.nodes);
    let sides = |(face, t): (usize, &[u32; 3])| [0, 1, 2].map(|k| (sorted(t[k], t[(k + 1) % 3]), face as u32));
    let mut all: Vec<([u32; 2], u32)> = contour.triangles.iter().enumerate().flat_map(sides).collect();
    all.sort_unstable();
    let same = all.chunk_by(|a, b| a.0 == b.0);
    let normal = |side: &([u32; 2], u32)| normals[side.1 as usize];
    let sharp = |sides: &&[([u32; 2], u32)]| match sides {
        [a, b] => dot(normal(a), normal(b)) < SHARP,
        _ => true,
    };
    same.filter(sharp).map(|sides| sides[0].0).collect()
}

fn sorted(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Nodes moved by `scale` times the displacement of a shape.
pub(crate) fn deformed(contour: &Contour, shape: &ContourShape, scale: f32) -> Vec<V3> {
    let moved = |(k, p): (usize, &V3)| {
        let u = shape.displacement.get(k).copied().unwrap_or_default();
        let u = if u.iter().all(|x| x.is_finite()) { u } else { [0.0; 3] };
        add(*p, scaled(u, scale))
    };
    contour.nodes.iter().enumerate().map(moved).collect()
}

/// Length one, outwards; zero for a triangle without area.
pub(crate) fn face_normals(contour: &Contour, nodes: &[V3]) -> Vec<V3> {
    let normal = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|node| nodes[node as usize]);
        unit(cross(sub(b, a), sub(c, a)))
    };
    contour.triangles.iter().map(normal).collect()
}

/// Normals at the corners of each triangle: of the faces around a node those that go on smoothly count.
pub(crate) fn corner_normals(contour: &Contour, nodes: &[V3]) -> Vec<[V3; 3]> {
    let faces = face_normals(contour, nodes);
    let (start, around) = faces_around(contour);
    let smooth = |node: u32, own: V3| {
        let here = &around[start[node as usize] as usize..start[node as usize + 1] as usize];
        let near = here.iter().map(|face| faces[*face as usize]).filter(|other| dot(*other, own) > SHARP);
        unit(near.fold(own, add))
    };
    contour.triangles.iter().zip(&faces).map(|(t, own)| t.map(|node| smooth(node, *own))).collect()
}

/// Faces at each node, one list after the other, and where each list starts.
fn faces_around(contour: &Contour) -> (Vec<u32>, Vec<u32>) {
    let mut start = vec![0_u32; contour.nodes.len() + 1];
    for node in contour.triangles.iter().flatten() {
        start[*node as usize + 1] += 1;
    }
    for k in 1..start.len() {
        start[k] += start[k - 1];
    }
    let mut next = start.clone();
    let mut around = vec![0; 3 * contour.triangles.len()];
    for (face, node) in contour.triangles.iter().enumerate().flat_map(|(face, t)| t.map(|node| (face, node))) {
        around[next[node as usize] as usize] = face as u32;
        next[node as usize] += 1;
    }
    (start, around)
}

/// Diagonal of the box around the part, m.
pub(crate) fn size(contour: &Contour) -> f32 {
    bounds(contour.nodes.iter().copied()).map_or(0.0, |(low, high)| length(sub(high, low)))
}

/// Largest displacement of a shape, m.
pub(crate) fn largest_displacement(shape: &ContourShape) -> f32 {
    shape.displacement.iter().map(|u| length(*u)).filter(|u| u.is_finite()).fold(0.0, f32::max)
}

/// How many times the displacement is drawn so that it is seen: a share of the size of the part. A state under
/// load is never drawn smaller than it is, and by a round factor.
pub(crate) fn usual_scale(contour: &Contour, shape: &ContourShape) -> f32 {
    let share = if shape.swings { 0.09 } else { 0.05 };
    let raw = share * size(contour) / largest_displacement(shape);
    match raw {
        raw if !raw.is_finite() => 1.0,
        raw if shape.swings => raw,
        raw => round_below(raw).max(1.0),
    }
}

/// The largest 1, 2 or 5 times a power of ten below.
fn round_below(raw: f32) -> f32 {
    let power = 10_f32.powf(raw.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|lead| lead * power).find(|round| *round <= raw).unwrap_or(power)
}

/// Node nearest to each place.
pub(crate) fn nearest(contour: &Contour, places: &[V3]) -> Vec<usize> {
    let far = |node: usize, place: &V3| {
        let d = sub(contour.nodes[node], *place);
        dot(d, d)
    };
    let all = || 0..contour.nodes.len();
    let nearest = |place: &V3| all().min_by(|a, b| far(*a, place).total_cmp(&far(*b, place))).unwrap_or(0);
    places.iter().map(nearest).collect()
}

/// Whether there is a surface, its nodes lie somewhere, and nothing points to nodes that are not there.
pub(crate) fn is_drawable(contour: &Contour) -> bool {
    let count = contour.nodes.len() as u32;
    let mut all = contour.triangles.iter().flatten().chain(contour.edges.iter().flatten());
    let lie = contour.nodes.iter().flatten().all(|x| x.is_finite());
    !contour.triangles.is_empty() && lie && all.all(|node| *node < count)
}
