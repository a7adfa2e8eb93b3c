//! The triangulation of the plane: circumcentres of triangles that are too large are inserted, then smoothed.

use spade::{ConstrainedDelaunayTriangulation, Point2, PositionInTriangulation, Triangulation};

use super::MesherError;
use super::field::Field;
use super::outline::{Outline, Segment};
use super::plan::Plan;
use super::smoothing::{self, area};

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// Triangles between the segments of the outline, where something is filled.
pub(super) struct Plane {
    /// Those of the outline first, in its order.
    pub(super) points: Vec<[f64; 2]>,
    /// Counter-clockwise corners.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Pattern of each triangle.
    pub(super) patterns: Vec<usize>,
    pub(super) segments: Vec<Segment>,
}

/// A triangle is divided when its circumradius is more than this part of the wanted size; 0.58 is equilateral.
const LARGE: f64 = 0.72;
/// A point is inserted only this far, in wanted sizes, from other points and from segments.
const FREE: f64 = 0.62;
const FREE_OF_SEGMENTS: f64 = 0.45;
const INSERTIONS: usize = 40;
const SMOOTHINGS: usize = 8;

pub(super) fn triangulate(plan: &Plan, outline: &Outline, field: &Field) -> Result<Plane, MesherError> {
    let mut points = outline.points.clone();
    for sweep in 0..3 {
        insert(plan, &mut points, outline, field)?;
        for _ in 0..SMOOTHINGS / (1 + sweep) {
            let plane = connect(plan, outline, &points)?;
            points = smoothing::smooth(&plane, outline.points.len(), field);
        }
    }
    Ok(connect(plan, outline, &points)?.renumbered())
}

/// Triangles between the points of the outline alone.
pub(super) fn coarse(plan: &Plan, outline: &Outline) -> Result<Plane, MesherError> {
    connect(plan, outline, &outline.points)
}

fn spade_points(points: &[[f64; 2]]) -> Vec<Point2<f64>> {
    // Spade refuses numbers that underflow in its predicates.
    let tidy = |c: f64| if c.abs() < 1e-30 { 0.0 } else { c };
    points.iter().map(|p| Point2::new(tidy(p[0]), tidy(p[1]))).collect()
}

fn constrained(points: &[[f64; 2]], outline: &Outline) -> Result<Cdt, MesherError> {
    let edges = outline.segments.iter().map(|segment| segment.ends.map(|end| end as usize)).collect();
    let mut conflict = None;
    let made = Cdt::try_bulk_load_cdt(spade_points(points), edges, |edge| conflict = Some(edge));
    let place = |edge: Option<[usize; 2]>| points[edge.map_or(0, |edge| edge[0].min(points.len() - 1))];
    let cdt = made.map_err(|_| MesherError::Crossing(place(None)))?;
    if conflict.is_some() || cdt.num_vertices() != points.len() {
        return Err(MesherError::Crossing(place(conflict)));
    }
    Ok(cdt)
}

/// Inserts circumcentres of triangles that are too large, the largest first, until none can be.
fn insert(plan: &Plan, points: &mut Vec<[f64; 2]>, outline: &Outline, field: &Field) -> Result<(), MesherError> {
    let mut cdt = constrained(points, outline)?;
    let fences = Fences::new(outline);
    for _ in 0..INSERTIONS {
        let patterns = flood(plan, outline, &cdt);
        let mut large: Vec<(f64, Point2<f64>)> = Vec::new();
        for face in cdt.inner_faces().filter(|face| patterns[face.fix().index()] > 0) {
            let (center, square) = face.circumcircle();
            let (at, middle) = ([center.x, center.y], face.center());
            let size = field.at(at);
            let ratio = square.sqrt() / size;
            let too_large = ratio > LARGE && fences.clear(at, FREE_OF_SEGMENTS * size);
            if too_large && !fences.between(at, [middle.x, middle.y]) {
                large.push((ratio, center));
            }
        }
        large.sort_by(|a, b| b.0.total_cmp(&a.0));
        let before = cdt.num_vertices();
        for (_, center) in large {
            let free = FREE * field.at([center.x, center.y]);
            if far(&cdt, center, free) {
                cdt.insert(center).map_err(|_| MesherError::Crossing([center.x, center.y]))?;
            }
        }
        if cdt.num_vertices() == before {
            break;
        }
    }
    let inserted = cdt.vertices().skip(points.len()).map(|vertex| vertex.position());
    let inserted: Vec<[f64; 2]> = inserted.map(|p| [p.x, p.y]).collect();
    points.extend(inserted);
    Ok(())
}

/// Whether a place is that far from the corners of its triangle and of the triangles beside it.
fn far(cdt: &Cdt, at: Point2<f64>, distance: f64) -> bool {
    let PositionInTriangulation::OnFace(face) = cdt.locate(at) else { return false };
    let clear = |p: Point2<f64>| p.distance_2(at) >= distance * distance;
    cdt.face(face).adjacent_edges().iter().all(|edge| {
        let across = edge.rev().opposite_vertex().is_none_or(|vertex| clear(vertex.position()));
        across && clear(edge.from().position())
    })
}

/// Segments of the outline, for distances and for what can be seen from where.
struct Fences {
    chords: Vec<[[f64; 2]; 2]>,
}

impl Fences {
    fn new(outline: &Outline) -> Fences {
        let chord = |segment: &Segment| segment.ends.map(|end| outline.points[end as usize]);
        Fences { chords: outline.segments.iter().map(chord).collect() }
    }

    /// Whether a place is at least that far from all segments.
    fn clear(&self, at: [f64; 2], distance: f64) -> bool {
        self.chords.iter().all(|[a, b]| {
            let way = [b[0] - a[0], b[1] - a[1]];
            let from = [at[0] - a[0], at[1] - a[1]];
            let along = (from[0] * way[0] + from[1] * way[1]) / (way[0] * way[0] + way[1] * way[1]);
            let t = along.clamp(0.0, 1.0);
            let off = [from[0] - t * way[0], from[1] - t * way[1]];
            off[0] * off[0] + off[1] * off[1] >= distance * distance
        })
    }

    /// Whether a segment separates two places.
    fn between(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let side = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| area([a, b, c]);
        self.chords
            .iter()
            .any(|&[a, b]| side(a, b, from) * side(a, b, to) < 0.0 && side(from, to, a) * side(from, to, b) <= 0.0)
    }
}

/// Triangles between the points, with what is filled over each.
fn connect(plan: &Plan, outline: &Outline, points: &[[f64; 2]]) -> Result<Plane, MesherError> {
    let cdt = constrained(points, outline)?;
    let patterns = flood(plan, outline, &cdt);
    let filled = cdt.inner_faces().filter_map(|face| {
        let pattern = patterns[face.fix().index()];
        (pattern > 0).then(|| (face.vertices().map(|vertex| vertex.fix().index() as u32), pattern))
    });
    let (triangles, patterns) = filled.unzip();
    Ok(Plane { points: points.to_vec(), triangles, patterns, segments: outline.segments.clone() })
}

/// Pattern of every face of the triangulation, by its index; 0 outside.
fn flood(plan: &Plan, outline: &Outline, cdt: &Cdt) -> Vec<usize> {
    let mut patterns: Vec<Option<usize>> = vec![None; cdt.num_all_faces()];
    let mut queue = Vec::new();
    for segment in &outline.segments {
        let [a, b] = segment.ends.map(|end| spade::handles::FixedVertexHandle::from_index(end as usize));
        let Some(edge) = cdt.get_edge_from_neighbors(a, b) else { continue };
        for (side, pattern) in [edge, edge.rev()].into_iter().zip(plan.sides[segment.edge]) {
            if patterns[side.face().fix().index()].replace(pattern).is_none() {
                queue.push(side.face().fix());
            }
        }
    }
    while let Some(face) = queue.pop() {
        let pattern = patterns[face.index()];
        let Some(inner) = cdt.face(face).as_inner() else { continue };
        for edge in inner.adjacent_edges() {
            let next = edge.rev().face().fix();
            if !edge.is_constraint_edge() && patterns[next.index()].is_none() {
                patterns[next.index()] = pattern;
                queue.push(next);
            }
        }
    }
    patterns.into_iter().map(|pattern| pattern.unwrap_or(0)).collect()
}

impl Plane {
    /// The same triangles with points numbered so that neighbours are close (Cuthill & McKee, 1969), in ascending order.
    fn renumbered(self) -> Plane {
        let rank = ranks(&self);
        let count = rank.iter().filter(|&&rank| rank != u32::MAX).count();
        let mut points = vec![[0.0; 2]; count];
        for (point, &rank) in rank.iter().enumerate().filter(|(_, rank)| **rank != u32::MAX) {
            points[rank as usize] = self.points[point];
        }
        let renamed = self.triangles.iter().map(|corners| corners.map(|corner| rank[corner as usize]));
        let mut rows: Vec<([u32; 3], usize)> = renamed.zip(self.patterns).collect();
        rows.sort_by_key(|(corners, _)| {
            let mut sorted = *corners;
            sorted.sort_unstable();
            sorted
        });
        let (triangles, patterns) = rows.into_iter().unzip();
        let mut segments = self.segments;
        segments.iter_mut().for_each(|segment| segment.ends = segment.ends.map(|end| rank[end as usize]));
        Plane { points, triangles, patterns, segments }
    }
}

/// Breadth-first from the leftmost point of each connected part; `u32::MAX` for points that no triangle has.
fn ranks(plane: &Plane) -> Vec<u32> {
    let mut neighbours: Vec<Vec<u32>> = vec![Vec::new(); plane.points.len()];
    for &[a, b, c] in &plane.triangles {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            neighbours[p as usize].push(q);
            neighbours[q as usize].push(p);
        }
    }
    let mut order: Vec<usize> = (0..plane.points.len()).filter(|&p| !neighbours[p].is_empty()).collect();
    order.sort_by(|&p, &q| plane.points[p][0].total_cmp(&plane.points[q][0]));
    let (mut rank, mut next) = (vec![u32::MAX; plane.points.len()], 0);
    let mut queue = std::collections::VecDeque::new();
    for start in order {
        queue.push_back(start as u32);
        while let Some(point) = queue.pop_front() {
            if rank[point as usize] == u32::MAX {
                rank[point as usize] = next;
                next += 1;
                queue.extend(neighbours[point as usize].iter().filter(|&&q| rank[q as usize] == u32::MAX));
            }
        }
    }
    rank
}
