//! A triangulated profile swept round its axis: tetrahedra, three of each wedge, fewer where it ends on the axis.

use std::collections::HashMap;
use std::f64::consts::TAU;

use bellcrank_solid::{Cell, Curve, Edge, Stack};

use super::super::plane::Plane;
use super::super::{MesherError, Sizes, field, outline, plan, plane, walls};
use crate::{Block, Mesh, Shape};

/// Fewest sectors of a turn.
const LEAST: f64 = 12.0;

/// Places round the axis, in half sectors.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
struct Place {
    /// Ends of a side of the plane, the lower first; a corner twice.
    side: [u32; 2],
    /// Angle in half sectors; 0 on the axis.
    half: u32,
}

pub(super) fn sweep(profile: &[[f64; 2]], shape: Shape, sizes: &Sizes) -> Result<Mesh, MesherError> {
    let stack = flat(profile);
    let plan = plan::Plan::of(&stack)?;
    let walls = walls::measure(&plan);
    let coarse = sizes.scale * sizes.size.unwrap_or_else(|| walls::default_size(&plan, &walls));
    // What is wanted anywhere round the axis: eight places a turn are asked.
    let around = sizes.background.map(|wanted| {
        move |[r, h, _]: [f64; 3]| {
            let ask = |k: i32| {
                let angle = TAU * f64::from(k) / 8.0;
                wanted([r * angle.cos(), r * angle.sin(), h])
            };
            (0..8).map(ask).fold(f64::INFINITY, f64::min)
        }
    });
    let background = around.as_ref().map(|wanted| wanted as &dyn Fn([f64; 3]) -> f64);
    let field = field::of_plan(&plan, &walls, coarse, &Sizes { background, ..*sizes });
    let sectors = sectors(profile, coarse, sizes);
    let quadratic = shape.quadratic();
    let limit = sizes.most_nodes / (sectors * if quadratic { 4 } else { 1 }).max(1);
    let too_large = |error| match error {
        MesherError::TooLarge { estimate, .. } => {
            let estimate = estimate * sectors * if quadratic { 4 } else { 1 };
            MesherError::TooLarge { estimate, limit: sizes.most_nodes }
        }
        other => other,
    };
    super::super::estimate::check_outline(&plan, &field, limit).map_err(too_large)?;
    let outline = outline::divide(&plan, &field)?;
    let flat_levels = super::super::heights::single();
    super::super::estimate::check(&plan, &outline, &field, &flat_levels, Shape::Tet4, limit).map_err(too_large)?;
    let plane = plane::triangulate(&plan, &outline, &field)?;
    Ok(turn(&plane, sectors, quadratic))
}

/// As many sectors as give the outermost elements the coarse size, within what arcs of fillets ask for.
fn sectors(profile: &[[f64; 2]], coarse: f64, sizes: &Sizes) -> usize {
    let outer = profile.iter().fold(0.0_f64, |most, corner| most.max(corner[0]));
    let turn = TAU * outer;
    let wanted = (turn / coarse).max(LEAST).min((turn / sizes.at_fillets.on(outer)).max(LEAST));
    wanted.ceil() as usize
}

/// The profile as a stack of one layer.
fn flat(profile: &[[f64; 2]]) -> Stack<f64> {
    let count = profile.len();
    let side = |k: usize| Edge { ends: [k, (k + 1) % count], curve: Curve::Line, cells: [Some(0), None] };
    Stack {
        vertices: profile.to_vec(),
        edges: (0..count).map(side).collect(),
        cells: vec![Cell { loops: Vec::new(), filled: vec![true] }],
        levels: vec![0.0, 1.0],
        ..super::empty()
    }
}

/// Elements of every triangle and sector.
fn turn(plane: &Plane, sectors: usize, quadratic: bool) -> Mesh {
    let on_axis: Vec<bool> = plane.points.iter().map(|point| point[0] == 0.0).collect();
    let shape = if quadratic { Shape::Tet10 } else { Shape::Tet4 };
    let mut numbers: HashMap<Place, u32> = HashMap::new();
    let mut mesh = Mesh::default();
    let mut nodes = Vec::new();
    for &triangle in &plane.triangles {
        for sector in 0..sectors {
            for tet in tetrahedra(triangle, &on_axis) {
                let corner = |k: usize| tet[k];
                let ends = (0..4).map(|k| [k, k]).chain(shape.edges().iter().map(|e| e.map(usize::from)));
                let count = shape.nodes();
                for [i, j] in ends.take(count) {
                    let place = between(corner(i), corner(j), sector, sectors, &on_axis);
                    let number = *numbers.entry(place).or_insert_with(|| {
                        mesh.nodes.push(position(plane, place, sectors));
                        mesh.nodes.len() as u32 - 1
                    });
                    nodes.push(number);
                }
            }
        }
    }
    mesh.blocks.push(Block { name: String::new(), shape, nodes });
    mesh.face_sets.insert("surface".to_owned(), mesh.boundary());
    let sharp = mesh.sharp_nodes(5.0);
    if !sharp.is_empty() {
        mesh.node_sets.insert("sharp".to_owned(), sharp);
    }
    mesh
}

/// A corner of an element: point of the plane, and 0 or 1 for the beginning or the end of the sector.
type Corner = (u32, u32);

fn between(a: Corner, b: Corner, sector: usize, sectors: usize, on_axis: &[bool]) -> Place {
    let half = (2 * sector as u32 + a.1 + b.1) % (2 * sectors as u32);
    let axis = on_axis[a.0 as usize] && on_axis[b.0 as usize];
    // Halves of a corner off the axis with one on it belong to the one off it.
    let half = match (on_axis[a.0 as usize], on_axis[b.0 as usize]) {
        (true, false) => (2 * (sector as u32 + b.1)) % (2 * sectors as u32),
        (false, true) => (2 * (sector as u32 + a.1)) % (2 * sectors as u32),
        _ => half,
    };
    Place { side: [a.0.min(b.0), a.0.max(b.0)], half: if axis { 0 } else { half } }
}

fn position(plane: &Plane, place: Place, sectors: usize) -> [f64; 3] {
    let [a, b] = place.side.map(|point| plane.points[point as usize]);
    let (r, h) = ((a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0);
    let angle = std::f64::consts::PI * f64::from(place.half) / sectors as f64;
    [r * angle.cos(), r * angle.sin(), h]
}

/// Tetrahedra of a wedge between two half planes; diagonals start at the lower point, so neighbours agree on them.
///
/// Points on the axis are one node at both ends, and tetrahedra that have one twice are left out.
fn tetrahedra([p, q, r]: [u32; 3], on_axis: &[bool]) -> Vec<[Corner; 4]> {
    let lowest = p.min(q).min(r);
    let [a, q, r] = if lowest == p {
        [p, q, r]
    } else if lowest == q {
        [q, r, p]
    } else {
        [r, p, q]
    };
    let (b, c, even) = if q < r { (q, r, true) } else { (r, q, false) };
    let all = [[(a, 0), (b, 0), (c, 0), (c, 1)], [(a, 0), (b, 0), (c, 1), (b, 1)], [(a, 0), (a, 1), (b, 1), (c, 1)]];
    let same = |x: Corner, y: Corner| x.0 == y.0 && (x.1 == y.1 || on_axis[x.0 as usize]);
    let whole = |tet: &[Corner; 4]| (0..4).all(|i| (0..i).all(|j| !same(tet[i], tet[j])));
    let mut tets: Vec<[Corner; 4]> = all.into_iter().filter(whole).collect();
    // Seen from above, r and h turn about the axis the other way than x and y.
    if even {
        tets.iter_mut().for_each(|tet| tet.swap(0, 1));
    }
    tets
}
