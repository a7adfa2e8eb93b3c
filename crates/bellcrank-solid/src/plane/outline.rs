//! Closed outlines: discs, quadrangles, hulls of discs, polygons with round corners.

use std::f64::consts::TAU;

use bellcrank_math::Real;

use super::segment::{Segment, arcs};
use super::vector::{Point, add, cross, distance, dot, left, norm, scale, sub, unit, values, wrap};

/// Segments one after another, closed from the last to the first.
pub(crate) type Outline<T> = Vec<Segment<T>>;

/// A disc, counter-clockwise.
pub(crate) fn disc<T: Real>(center: Point<T>, radius: T) -> Outline<T> {
    let start = add(center, [radius, T::zero()]);
    arcs(center, radius, start, start, TAU)
}

/// Straight sides through corners.
pub(crate) fn polygon<T: Real>(corners: &[Point<T>]) -> Outline<T> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| Segment::line(*a, *b)).collect()
}

/// A bar between two places with a width at each.
pub(crate) fn bar<T: Real>(ends: [Point<T>; 2], widths: [T; 2]) -> Outline<T> {
    let normal = left(unit(sub(ends[1], ends[0])));
    let half = widths.map(|w| scale(normal, w * T::from_f64(0.5)));
    polygon(&[sub(ends[0], half[0]), sub(ends[1], half[1]), add(ends[1], half[1]), add(ends[0], half[0])])
}

/// A line that touches two discs of a hull, which lies on its left.
struct Tangent<T> {
    discs: [usize; 2],
    /// Outward direction, and its angle.
    normal: Point<T>,
    angle: f64,
    length: f64,
}

/// Convex hull of discs, counter-clockwise; `None` where rounding leaves none.
pub(crate) fn hull<T: Real>(discs: &[(Point<T>, T)], tolerance: f64) -> Option<Outline<T>> {
    let mut tangents = tangents(discs, tolerance);
    if tangents.is_empty() {
        let largest = discs.iter().max_by(|a, b| a.1.value().total_cmp(&b.1.value()))?;
        return Some(disc(largest.0, largest.1));
    }
    tangents.sort_by(|a, b| a.angle.total_cmp(&b.angle));
    let chain = chain(tangents)?;
    let mut outline = Vec::new();
    for (tangent, next) in chain.iter().zip(chain.iter().cycle().skip(1)) {
        let touch = |disc: usize, t: &Tangent<T>| add(discs[disc].0, scale(t.normal, discs[disc].1));
        let [i, j] = tangent.discs;
        outline.push(Segment::line(touch(i, tangent), touch(j, tangent)));
        let sweep = (next.angle - tangent.angle).rem_euclid(TAU);
        if sweep * discs[j].1.value() > tolerance {
            outline.extend(arcs(discs[j].0, discs[j].1, touch(j, tangent), touch(j, next), sweep));
        }
    }
    Some(outline)
}

fn tangents<T: Real>(discs: &[(Point<T>, T)], tolerance: f64) -> Vec<Tangent<T>> {
    let pairs = (0..discs.len()).flat_map(|i| (0..discs.len()).map(move |j| [i, j]));
    pairs.filter_map(|pair| tangent(discs, pair, tolerance)).collect()
}

fn tangent<T: Real>(discs: &[(Point<T>, T)], [i, j]: [usize; 2], tolerance: f64) -> Option<Tangent<T>> {
    let ((a, ra), (b, rb)) = (discs[i], discs[j]);
    let length = distance(values(a), values(b));
    // A disc that lies in the other one has no tangent with it.
    if length <= tolerance || (ra.value() - rb.value()).abs() >= length - tolerance {
        return None;
    }
    let along = unit(sub(b, a));
    let sine = (ra - rb) / norm(sub(b, a));
    let cosine = (T::one() - sine * sine).sqrt();
    let normal = sub(scale(along, sine), scale(left(along), cosine));
    let reach = |(c, r): &(Point<T>, T)| dot(values(normal), values(*c)) + r.value();
    let level = reach(&discs[i]);
    let outermost = discs.iter().all(|disc| reach(disc) <= level + tolerance);
    let n = values(normal);
    outermost.then(|| Tangent { discs: [i, j], normal, angle: n[1].atan2(n[0]), length })
}

/// Of tangents sorted by angle: the longest of each angle, in an order in which each begins where the last one ends.
fn chain<T: Real>(sorted: Vec<Tangent<T>>) -> Option<Vec<Tangent<T>>> {
    let mut kept: Vec<Tangent<T>> = Vec::new();
    for tangent in sorted {
        match kept.iter_mut().find(|k| wrap(k.angle - tangent.angle).abs() < 1e-7) {
            Some(same) if same.length < tangent.length => *same = tangent,
            Some(_) => {}
            None => kept.push(tangent),
        }
    }
    let next = kept.iter().cycle().skip(1);
    let joined = kept.iter().zip(next).all(|(a, b)| a.discs[1] == b.discs[0]);
    joined.then_some(kept)
}

/// How much of the two sides at a corner its rounding takes, in m; `None` where the sides double back.
pub(crate) fn setback<T: Real>([before, at, after]: [Point<T>; 3], radius: T) -> Option<T> {
    let (u, v) = (unit(sub(at, before)), unit(sub(after, at)));
    let apart = T::one() + dot(u, v);
    (apart.value() > 1e-12).then(|| radius * cross(u, v).abs() / apart)
}

/// A polygon with rounded corners. The radii are known to fit.
pub(crate) fn rounded<T: Real>(corners: &[(Point<T>, T)]) -> Outline<T> {
    let n = corners.len();
    let places: Vec<[Point<T>; 3]> =
        (0..n).map(|i| [corners[(i + n - 1) % n].0, corners[i].0, corners[(i + 1) % n].0]).collect();
    let rounds: Vec<Outline<T>> = places.iter().zip(corners).map(|(p, c)| round(*p, c.1)).collect();
    let end = |i: usize, last: bool| {
        let arc = if last { rounds[i].last().map(|s| s.ends[1]) } else { rounds[i].first().map(|s| s.ends[0]) };
        arc.unwrap_or(corners[i].0)
    };
    let mut outline = Vec::new();
    for (i, round) in rounds.iter().enumerate() {
        outline.extend(round.iter().cloned());
        outline.push(Segment::line(end(i, true), end((i + 1) % n, false)));
    }
    outline
}

fn round<T: Real>(places: [Point<T>; 3], radius: T) -> Outline<T> {
    let [before, at, after] = places;
    let (u, v) = (unit(sub(at, before)), unit(sub(after, at)));
    let turn = cross(values(u), values(v)).atan2(dot(values(u), values(v)));
    let Some(back) = setback(places, radius).filter(|_| radius.value() > 0.0 && turn.abs() > 1e-6) else {
        return Vec::new();
    };
    let (from, to) = (sub(at, scale(u, back)), add(at, scale(v, back)));
    let side = T::from_f64(turn.signum());
    arcs(add(from, scale(left(u), radius * side)), radius, from, to, turn)
}

/// Twice the area within straight sides through these places, positive counter-clockwise.
pub(crate) fn doubled_area(corners: &[Point<f64>]) -> f64 {
    let Some(origin) = corners.first() else { return 0.0 };
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| cross(sub(*a, *origin), sub(*b, *origin))).sum()
}

/// Pairs of sides of a polygon that meet elsewhere than at the corner they share.
pub(crate) fn crossing_sides(corners: &[Point<f64>], tolerance: f64) -> Vec<[usize; 2]> {
    let n = corners.len();
    let side = |i: usize| Segment::line(corners[i], corners[(i + 1) % n]);
    let meet = |i: usize, j: usize| {
        let (a, b) = (side(i), side(j));
        if j == i + 1 || (i == 0 && j == n - 1) {
            return doubles_back(&a, &b, j == i + 1, tolerance);
        }
        !super::crossing::crossings(&a, &b, tolerance).is_empty()
            || a.ends.iter().any(|p| b.holds(*p, tolerance))
            || b.ends.iter().any(|p| a.holds(*p, tolerance))
    };
    (0..n).flat_map(|i| (i + 1..n).map(move |j| [i, j])).filter(|[i, j]| meet(*i, *j)).collect()
}

/// Whether one of two neighbours lies on the other.
fn doubles_back(a: &Segment<f64>, b: &Segment<f64>, a_first: bool, tolerance: f64) -> bool {
    let (first, second) = if a_first { (a, b) } else { (b, a) };
    first.holds(second.ends[1], tolerance) || second.holds(first.ends[0], tolerance)
}
