//! Triangles on a shell.

use std::collections::{HashMap, HashSet, VecDeque};

use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

use super::space::{Place, across, any_across, cross, dot, norm, sub, unit};
use super::{Face, Form, Path, Shell, ShellEdge};

/// A closed surface of triangles; lengths in m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Places of the nodes.
    pub nodes: Vec<[f64; 3]>,
    /// Nodes of each triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Pieces of the edges of the solid that show: where two faces meet at an angle.
    pub edges: Vec<[u32; 2]>,
}

/// Largest angle that one chord of an arc spans, rad.
const WIDEST: f64 = std::f64::consts::PI / 9.0;
/// Edges whose faces meet at less than this do not show, rad.
const SMOOTH: f64 = 0.02;

impl Shell {
    /// Triangles that are nowhere further from the faces than the tolerance, in m. Where chords of that length would
    /// cross another edge, the surface is finer. Faces between edges that rounding cannot tell apart are left out.
    pub fn surface(&self, chord_tolerance: f64) -> Surface {
        let size = self.vertices.iter().flatten().fold(0.0, |a: f64, x| a.max(x.abs()));
        let mut tolerance = if chord_tolerance > 1e-7 * size { chord_tolerance } else { 1e-7 * size };
        for _ in 0..5 {
            if let Some(surface) = self.try_surface(tolerance, true) {
                return surface;
            }
            tolerance /= 4.0;
        }
        self.try_surface(tolerance, false).unwrap_or_default()
    }

    fn try_surface(&self, tolerance: f64, strict: bool) -> Option<Surface> {
        let mut surface = Surface { nodes: self.vertices.clone(), ..Surface::default() };
        let chains: Vec<Vec<u32>> = self.edges.iter().map(|edge| self.chain(edge, tolerance, &mut surface)).collect();
        for face in &self.faces {
            let loops: Vec<Vec<u32>> = face.loops.iter().map(|walk| nodes_along(walk, &chains)).collect();
            let rulings = self.rulings(face, &chains);
            match triangulate(&face.form, &loops, &rulings, &surface.nodes) {
                Some(triangles) => surface.triangles.extend(triangles),
                None if strict => return None,
                None => {}
            }
        }
        let folds = self.folds();
        let showing = chains.iter().zip(folds).filter(|(_, fold)| fold.abs() > SMOOTH);
        surface.edges = showing.flat_map(|(chain, _)| chain.windows(2).map(|pair| [pair[0], pair[1]])).collect();
        Some(surface)
    }

    /// Straight lines on a curved face between the two arcs that bound it, so that no triangle cuts a corner round it.
    fn rulings(&self, face: &Face, chains: &[Vec<u32>]) -> Vec<[u32; 2]> {
        let walk = face.loops.iter().flatten();
        let arcs: Vec<Vec<u32>> = walk
            .filter(|(edge, _)| matches!(self.edges[*edge].path, Path::Circle { .. }))
            .map(|(edge, forward)| {
                let chain = chains[*edge].iter().copied();
                if *forward { chain.collect() } else { chain.rev().collect() }
            })
            .collect();
        match (&face.form, &arcs[..]) {
            (Form::Cylinder { .. } | Form::Cone { .. }, [a, b]) if a.len() == b.len() => {
                let pairs = a.iter().zip(b.iter().rev()).map(|(a, b)| [*a, *b]);
                pairs.skip(1).take(a.len().saturating_sub(2)).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Nodes along an edge; those between its ends are new.
    fn chain(&self, edge: &ShellEdge, tolerance: f64, surface: &mut Surface) -> Vec<u32> {
        let pieces = match &edge.path {
            Path::Line => 1,
            Path::Circle { radius, .. } => {
                let widest = 2.0 * (1.0 - (tolerance / radius).min(1.0)).acos();
                (edge.sweep(&self.vertices) / widest.clamp(1e-3, WIDEST)).ceil().max(1.0) as usize
            }
        };
        let mut chain = vec![edge.ends[0] as u32];
        for i in 1..pieces {
            chain.push(surface.nodes.len() as u32);
            surface.nodes.push(edge.at(&self.vertices, i as f64 / pieces as f64));
        }
        chain.push(edge.ends[1] as u32);
        chain
    }
}

/// Nodes along a loop, each once.
fn nodes_along(walk: &[(usize, bool)], chains: &[Vec<u32>]) -> Vec<u32> {
    let mut nodes = Vec::new();
    for (edge, forward) in walk {
        let chain = &chains[*edge];
        let count = chain.len() - 1;
        if *forward {
            nodes.extend(&chain[..count]);
        } else {
            nodes.extend(chain.iter().rev().take(count));
        }
    }
    nodes
}

/// Triangles of a face between its loops; `None` where chords of two loops cross.
fn triangulate(form: &Form, loops: &[Vec<u32>], rulings: &[[u32; 2]], nodes: &[Place]) -> Option<Vec<[u32; 3]>> {
    let used: Vec<u32> = loops.iter().flatten().copied().collect();
    let flat = flattened(form, &used.iter().map(|n| nodes[*n as usize]).collect::<Vec<_>>());
    let mut mesh = Mesh::new();
    let mut names = Names::new();
    let mut places = HashMap::new();
    let mut handles = Vec::new();
    for (place, node) in flat.iter().zip(&used) {
        let handle = mesh.insert(Point2::new(place[0], place[1])).ok()?;
        // Two nodes at one place: the chords are too coarse, or a loop touches itself there.
        if *names.entry(handle).or_insert(*node) != *node {
            return None;
        }
        handles.push(handle);
        places.insert(*node, handle);
    }
    let mut bounds = HashSet::new();
    let mut start = 0;
    for walk in loops {
        let around = &handles[start..start + walk.len()];
        for (a, b) in around.iter().zip(around.iter().cycle().skip(1)) {
            if !mesh.can_add_constraint(*a, *b) {
                return None;
            }
            mesh.add_constraint(*a, *b);
            bounds.extend([(*a, *b), (*b, *a)]);
        }
        start += walk.len();
    }
    for [a, b] in rulings.iter().map(|ends| ends.map(|node| places[&node])) {
        if mesh.can_add_constraint(a, b) {
            mesh.add_constraint(a, b);
        }
    }
    Some(inner_triangles(&mesh, &names, &bounds))
}

type Handle = spade::handles::FixedVertexHandle;
type Mesh = ConstrainedDelaunayTriangulation<Point2<f64>>;
type Names = HashMap<Handle, u32>;

/// Triangles that an odd number of chords separates from the outside.
fn inner_triangles(mesh: &Mesh, names: &Names, bounds: &HashSet<(Handle, Handle)>) -> Vec<[u32; 3]> {
    let mut inside = vec![None; mesh.num_all_faces()];
    let outer = mesh.outer_face().fix();
    inside[outer.index()] = Some(false);
    let mut open: VecDeque<_> = mesh.convex_hull().map(|edge| (edge.fix(), false)).collect();
    while let Some((edge, here)) = open.pop_front() {
        let edge = mesh.directed_edge(edge);
        let there = edge.rev().face();
        let [a, b] = edge.vertices().map(|v| v.fix());
        let within = here != bounds.contains(&(a, b));
        if inside[there.fix().index()].is_some() {
            continue;
        }
        inside[there.fix().index()] = Some(within);
        if let Some(face) = there.as_inner() {
            open.extend(face.adjacent_edges().map(|edge| (edge.fix(), within)));
        }
    }
    let filled = mesh.inner_faces().filter(|face| inside[face.fix().index()] == Some(true));
    filled.map(|face| face.vertices().map(|v| names[&v.fix()])).collect()
}

/// Places of a surface laid flat without stretching, so that the outside is on top.
fn flattened(form: &Form, places: &[Place]) -> Vec<[f64; 2]> {
    match form {
        Form::Plane { point, normal } => {
            let u = any_across(*normal);
            let v = cross(*normal, u);
            places.iter().map(|p| sub(*p, *point)).map(|p| [dot(p, u), dot(p, v)]).collect()
        }
        Form::Cylinder { point, axis, radius, convex } => {
            let angle = angles(*point, *axis, places);
            let side = if *convex { 1.0 } else { -1.0 };
            let height = places.iter().map(|p| dot(sub(*p, *point), *axis));
            angle.into_iter().zip(height).map(|(angle, h)| [side * radius * angle, h]).collect()
        }
        Form::Cone { apex, axis, slope, convex } => {
            let sine = slope / slope.hypot(1.0);
            let side = if *convex { -1.0 } else { 1.0 };
            let angle = angles(*apex, *axis, places);
            let slant = places.iter().map(|p| norm(sub(*p, *apex)));
            let polar = angle.into_iter().map(|angle| (side * angle * sine).sin_cos());
            polar.zip(slant).map(|((s, c), slant)| [slant * c, slant * s]).collect()
        }
    }
}

/// Angles of places about an axis, from the middle of them all.
fn angles(point: Place, axis: Place, places: &[Place]) -> Vec<f64> {
    let out: Vec<Place> = places.iter().map(|p| across(sub(*p, point), axis)).collect();
    let middle = unit(out.iter().fold([0.0; 3], |sum, o| std::array::from_fn(|k| sum[k] + o[k])));
    let aside = cross(axis, middle);
    out.iter().map(|o| dot(*o, aside).atan2(dot(*o, middle))).collect()
}
